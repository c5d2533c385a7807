"""Nothing moves unless asked, and what moves can be stopped, stepped through, and undone."""

import json

from playwright.sync_api import expect

from chr_notes.demos.base import Demo

from .parts import PageOf, Visit, each_demo, hold, let_pass, picture, slider, state_of


@each_demo
def test_nothing_moves_unless_asked(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    before = picture(page)
    page.wait_for_timeout(400)
    assert picture(page) == before


@each_demo
def test_play_moves_and_pause_stops(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    root = page.locator(".chr-demo")
    first = root.get_attribute("data-state")
    hold(page)
    page.get_by_role("button", name="Play").click()
    expect(page.locator(".chr-said")).not_to_have_text("")
    let_pass(page, 7_000)
    page.get_by_role("button", name="Pause").click()
    stopped = root.get_attribute("data-state")
    assert stopped != first
    let_pass(page, 60_000, frame=5_000)
    assert root.get_attribute("data-state") == stopped
    page.get_by_role("button", name="Go on").click()
    let_pass(page, 120_000, frame=500)
    expect(page.get_by_role("button", name="Play")).to_have_count(1)


@each_demo
def test_a_hand_on_a_slider_ends_the_story(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    hold(page)
    page.get_by_role("button", name="Play").click()
    let_pass(page, 7_000)
    page.locator("input").first.focus()
    page.keyboard.press("ArrowLeft")
    state = page.locator(".chr-demo").get_attribute("data-state")
    let_pass(page, 60_000, frame=5_000)
    assert page.locator(".chr-demo").get_attribute("data-state") == state
    expect(page.locator(".chr-said")).to_have_text("")


@each_demo
def test_where_less_motion_is_wanted_the_story_goes_step_by_step(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = visit(page_of(demo()), reduced_motion="reduce")
    root, said = page.locator(".chr-demo"), page.locator(".chr-said")
    page.get_by_role("button", name="Show me, step by step").click()
    texts = [said.text_content()]
    while page.get_by_role("button", name="Next step").count() > 0:
        page.get_by_role("button", name="Next step").click()
        state = root.get_attribute("data-state")
        page.wait_for_timeout(50)
        assert root.get_attribute("data-state") == state, "it moves"
        texts.append(said.text_content())
    assert len(set(texts)) == len(texts) > 3
    page.get_by_role("button", name="Reset").click()
    assert json.loads(str(root.get_attribute("data-state"))) == demo().state()
    expect(said).to_have_text("")


@each_demo
def test_a_wish_for_less_motion_is_heard_at_once(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = visit(page_of(demo()))
    page.get_by_role("button", name="Play").click()
    page.emulate_media(reduced_motion="reduce")
    expect(page.get_by_role("button", name="Show me, step by step")).to_have_count(1)
    state = state_of(page)
    page.wait_for_timeout(300)
    assert state_of(page) == state
    page.emulate_media(reduced_motion="no-preference")
    expect(page.get_by_role("button", name="Play")).to_have_count(1)


@each_demo
def test_reset_returns_to_the_state_of_the_page(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    opening = demo(**{name: demo.class_traits()[name].max for name in demo.controls}).state()
    page = visit(page_of(demo(**opening)))
    for name in demo.controls:
        slider(page, name).focus()
        page.keyboard.press("Home")
    assert state_of(page) != opening
    page.get_by_role("button", name="Reset").click()
    page.wait_for_function(
        "(start) => document.querySelector('.chr-demo').dataset.state === start",
        arg=json.dumps(opening, separators=(",", ":")).replace(".0", ""),
    )
