"""Nothing moves unless asked, and what moves can be stopped, stepped through, and undone."""

import json

from playwright.sync_api import Page, expect

from chr_notes.demos import DriftDemo, GimbalLockDemo
from chr_notes.demos.base import Demo

from .parts import PageOf, Visit, each_demo, each_kind, hold, let_pass, picture, slider, state_of

COUNT = """() => {
  window.announced = 0;
  new MutationObserver(() => { window.announced += 1; })
    .observe(document.querySelector("[aria-live=polite]"), { childList: true });
}"""


@each_kind
def test_what_moves_is_asked_for_and_told(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    """One page, whose time passes as the test has it."""
    page = visit(page_of(demo()), own=True)
    nothing_moves_unless_asked(page)
    page.evaluate(COUNT)
    hold(page)
    a_screen_reader_hears_once_the_reader_pauses(page, demo)
    play_tells_a_sentence_at_a_time_and_pause_stops(page)
    a_hand_on_a_slider_ends_the_story(page)
    a_wish_for_less_motion_is_heard_at_once(page)


def nothing_moves_unless_asked(page: Page) -> None:
    before = picture(page)
    page.wait_for_timeout(400)
    assert picture(page) == before


def a_screen_reader_hears_once_the_reader_pauses(page: Page, demo: type[Demo]) -> None:
    live = page.locator("[aria-live=polite]")
    assert page.locator("output:not([aria-live=off])").count() == 0
    assert live.text_content() == ""
    first = next(name for name in demo.controls if not demo.class_traits()[name].whole)
    up = demo().state()[first] < demo.class_traits()[first].max
    slider(page, first).focus()
    for _ in range(10):
        page.keyboard.press("ArrowRight" if up else "ArrowLeft")
        page.clock.fast_forward(200)
    assert page.evaluate("announced") == 0
    let_pass(page, 1_000)
    assert page.evaluate("announced") == 1
    expect(live).not_to_have_text("")


def play_tells_a_sentence_at_a_time_and_pause_stops(page: Page) -> None:
    page.get_by_role("button", name="Reset").click()
    let_pass(page, 2_000)
    page.evaluate("window.announced = 0")
    first = state_of(page)
    page.get_by_role("button", name="Play").click()
    expect(page.locator(".chr-said")).not_to_have_text("")
    # It glides for two seconds or more, waits for three and a half, and glides on.
    let_pass(page, 1_750, frame=250)
    assert page.evaluate("announced") == 0
    let_pass(page, 3_250, frame=250)
    assert page.evaluate("announced") == 1
    let_pass(page, 2_500, frame=250)
    page.get_by_role("button", name="Pause").click()
    stopped = state_of(page)
    assert stopped != first
    let_pass(page, 20_000, frame=5_000)
    assert state_of(page) == stopped
    page.get_by_role("button", name="Go on").click()
    let_pass(page, 120_000, frame=3_000)
    expect(page.get_by_role("button", name="Play")).to_have_count(1)


def a_hand_on_a_slider_ends_the_story(page: Page) -> None:
    page.get_by_role("button", name="Play").click()
    let_pass(page, 7_000, frame=1_000)
    page.locator("input").first.focus()
    page.keyboard.press("ArrowLeft")
    state = state_of(page)
    let_pass(page, 20_000, frame=5_000)
    assert state_of(page) == state
    expect(page.locator(".chr-said")).to_have_text("")


def a_wish_for_less_motion_is_heard_at_once(page: Page) -> None:
    page.get_by_role("button", name="Reset").click()
    let_pass(page, 2_000)
    page.get_by_role("button", name="Play").click()
    page.emulate_media(reduced_motion="reduce")
    expect(page.get_by_role("button", name="Show me, step by step")).to_have_count(1)
    state = state_of(page)
    let_pass(page, 3_000)
    assert state_of(page) == state
    page.emulate_media(reduced_motion="no-preference")
    expect(page.get_by_role("button", name="Play")).to_have_count(1)


def test_what_is_said_stands_below_the_picture_of_a_phone(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(pitch=60), DriftDemo()), width=390)
    # To the top, whatever it keeps clear of when it is brought into view.
    top = page.locator("[name='play']").first.evaluate("(each) => each.getBoundingClientRect().top")
    page.evaluate("(top) => scrollBy(0, top)", top)
    height = page.locator("canvas").first.evaluate("(each) => each.offsetHeight")
    scrolled = page.evaluate("(height) => { scrollBy(0, -height - 20); return scrollY; }", height)
    page.get_by_role("button", name="Play").first.click()
    canvas = page.locator("canvas").first.bounding_box()
    said = page.locator(".chr-said").first.bounding_box()
    assert canvas is not None
    assert said is not None
    assert canvas["y"] + canvas["height"] <= said["y"] + 1
    assert page.evaluate("scrollY") < scrolled


PLACES = """() => {
  scrollTo(0, 0);
  return [...document.querySelectorAll(".chr-demo :is(canvas, input, output)")]
    .map((each) => each.getBoundingClientRect().top);
}"""


@each_demo
def test_where_less_motion_is_wanted_the_story_goes_step_by_step(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    opening = demo(**{name: demo.class_traits()[name].max for name in demo.controls}).state()
    page = visit(page_of(demo(**opening)), width=500, reduced_motion="reduce")
    before = page.evaluate(PLACES)
    texts = the_story_by_keyboard(page)
    assert len(set(texts)) == len(texts) > 3
    nothing_moves_when_a_text_grows(page, demo, before)
    page.get_by_role("button", name="Reset").focus()
    page.keyboard.press("Enter")
    expect(page.locator(".chr-said")).to_have_text("")
    assert json.loads(str(page.locator(".chr-demo").get_attribute("data-state"))) == opening


def the_story_by_keyboard(page: Page) -> list[str | None]:
    root, said = page.locator(".chr-demo"), page.locator(".chr-said")
    page.get_by_role("button", name="Show me, step by step").focus()
    page.keyboard.press("Space")
    texts = [said.text_content()]
    while page.get_by_role("button", name="Next step").count() > 0:
        page.keyboard.press("Space")
        state = root.get_attribute("data-state")
        page.wait_for_timeout(50)
        assert root.get_attribute("data-state") == state, "it moves"
        texts.append(said.text_content())
    return texts


def nothing_moves_when_a_text_grows(page: Page, demo: type[Demo], before: list[float]) -> None:
    assert [round(place) for place in page.evaluate(PLACES)] == [round(place) for place in before]
    for control in demo.controls:
        for key in ("End", "Home"):
            slider(page, control).press(key)
            moved = [abs(a - b) for a, b in zip(page.evaluate(PLACES), before, strict=True)]
            assert max(moved) < 0.5, (control, key)
