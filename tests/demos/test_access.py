"""Everyone can use each demo: by keyboard, by ear, with what fits the page."""

import re

import pytest
from playwright.sync_api import Page, expect

from chr_notes.demos import TiltDemo
from chr_notes.demos.base import Demo

from .colours import channels, contrast, of_palette
from .parts import (
    FOLDED,
    HELD_BY_KEYS,
    KINDS,
    PICTURE,
    PageOf,
    Visit,
    changed,
    each_demo,
    field,
    picture,
    slider,
    state_of,
    unfold,
)

MINUS_ZERO = re.compile(r"[−-]0(?:\.0+)?(?![\d.])")
UNITS = (
    *("degrees", "metres per second squared", "second", "minute", "hour", "microtesla", "readings"),
    *("q v", "a gain of", "a threshold of", "of the field", "frame ", "axis "),
)


# ── by keyboard ────────────────────────────────────────────────────────────────────────────────

BUTTONS = ("link", "python")


@each_demo
def test_everyone_can_use_it(
    visit: Visit, page_of: PageOf, demo: type[Demo], pytestconfig: pytest.Config
) -> None:
    """One page for all that can be tried on one page."""
    page = visit(page_of(demo()))
    opening = positions_of(page, demo)
    the_reader_is_told_first_what_to_try(page)
    everything_has_a_name(page)
    unfold(page)
    tab_reaches_each_control_and_shows_where_it_is(page, demo, "light")
    if demo in KINDS or pytestconfig.getoption("full"):
        page.evaluate("document.documentElement.dataset.theme = 'dark'")
        tab_reaches_each_control_and_shows_where_it_is(page, demo, "dark")
        the_picture_follows_the_theme(page)
        only_keys_for_the_page_reach_the_page(page, demo)
        a_number_can_be_typed(page, demo, opening)
    the_keyboard_moves_each_slider_and_the_picture(page, demo, opening)
    keys_move_what_can_be_held(page, demo, opening)
    the_demo_fits_the_page(page, demo)
    picture_and_each_slider_are_seen_together_on_a_phone(page, demo)


def tab_reaches_each_control_and_shows_where_it_is(
    page: Page, demo: type[Demo], theme: str
) -> None:
    page.evaluate("document.activeElement.blur()")
    page.mouse.click(2, 2)  # where Tab begins
    picture_first = [None] * page.locator("canvas.chr-turns").count()
    reached = []
    beside = {name: [] if demo.class_traits()[name].whole else [""] for name in demo.controls}
    words = {names[0]: [None] for names in [FOLDED.get(demo, ())] if names}  # of what is folded
    stops = [each for name in demo.controls for each in (*words.get(name, []), name, *beside[name])]
    stops = ["play", "reset", *stops]
    buttons = [*BUTTONS, *(["phone"] if demo is TiltDemo else [])]
    for _ in range(len([*picture_first, *stops, *buttons])):
        page.keyboard.press("Tab")
        name, style, width, colour = page.evaluate(
            "() => { const each = document.activeElement, style = getComputedStyle(each);"
            " const { outlineStyle, outlineWidth, outlineColor } = style;"
            " return [each.name ?? null, outlineStyle, outlineWidth, outlineColor]; }"
        )
        reached.append(name)
        assert (style, width) == ("solid", "3px")
        assert contrast(channels(colour), of_palette("raised", theme)) >= 3
    assert reached == [*picture_first, *stops, *buttons]


# The state, the words of the picture, and the picture once it is drawn.
SEEN = f"""async (canvas) => {{
  const drawn = await ({PICTURE})(canvas);
  return [JSON.parse(canvas.closest(".chr-demo").dataset.state), canvas.ariaLabel, drawn];
}}"""


def the_keyboard_moves_each_slider_and_the_picture(
    page: Page, demo: type[Demo], opening: dict[str, str]
) -> None:
    for name in demo.controls:
        limits = demo.class_traits()[name]
        state, words, before = page.locator("canvas").evaluate(SEEN)
        up = state[name] < limits.max
        slider(page, name).press("ArrowRight" if up else "ArrowLeft")
        moved, told, drawn = page.locator("canvas").evaluate(SEEN)
        assert (moved[name] > state[name]) == up
        assert moved[name] != state[name]
        assert drawn != before, name
        assert told != words, name
        page.keyboard.press("Home")
        assert state_of(page)[name] == limits.min
        slider(page, name).evaluate(PUT_BACK, opening[name])


def a_number_can_be_typed(page: Page, demo: type[Demo], opening: dict[str, str]) -> None:
    names = [name for name in demo.controls if not demo.class_traits()[name].whole]
    for name in names:
        limits = demo.class_traits()[name]
        words = page.locator(".chr-control", has=slider(page, name)).locator(".chr-value")
        inside = round(0.5 * (limits.min + limits.max) + 0.001, 3)
        field(page, name).fill(str(inside))
        assert state_of(page)[name] == inside
        # All fields are read and judged by the same lines: of the others by one end.
        if name == names[0]:
            field(page, name).fill("")
            field(page, name).press_sequentially(str(inside).replace(".", ","))
            assert state_of(page)[name] == inside, "with a comma"
        wrong = (
            ("", "a number from ", inside),
            (str(limits.min - 1), "at least ", limits.min),
            (str(2 * limits.max + 1), "at most ", limits.max),
        )
        for typed, said, taken in wrong if name == names[0] else wrong[2:]:
            field(page, name).fill(typed)
            page.keyboard.press("Enter")
            assert state_of(page)[name] == taken
            expect(words).to_contain_text(said)
            expect(page.locator("[aria-live=polite]")).to_contain_text(said)
            assert float(field(page, name).input_value()) == taken
        page.keyboard.press("ArrowDown")
        assert limits.min < state_of(page)[name] < limits.max
        slider(page, name).evaluate(PUT_BACK, opening[name])


def keys_move_what_can_be_held(page: Page, demo: type[Demo], opening: dict[str, str]) -> None:
    names = HELD_BY_KEYS.get(demo)
    canvas = page.locator("canvas")
    assert ("With Shift" in str(canvas.get_attribute("aria-description"))) == bool(names)
    if names is None:
        return
    for name in reversed(demo.controls):  # one that brings another value with it comes before that
        slider(page, name).evaluate(PUT_BACK, opening[name])
    canvas.focus()
    page.keyboard.press("ArrowLeft")
    assert changed(page, demo()) == set(), "the camera is no part of the state"
    page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("Shift+ArrowUp")
    assert changed(page, demo())
    assert changed(page, demo()) <= names


PUT_BACK = """(input, position) => {
  input.value = position;
  input.dispatchEvent(new Event("input"));
}"""


def positions_of(page: Page, demo: type[Demo]) -> dict[str, str]:
    """Where the sliders are."""
    return {name: slider(page, name).input_value() for name in demo.controls}


def only_keys_for_the_page_reach_the_page(page: Page, demo: type[Demo]) -> None:
    page.evaluate(
        "() => { window.heard = [];"
        " document.addEventListener('keydown', (event) => window.heard.push(event.key)); }"
    )
    slider(page, demo.controls[0]).focus()
    for key in ("ArrowRight", "PageDown", "Home", "b", "Escape", "Control+k"):
        page.keyboard.press(key)
    # The Control key by itself comes with its own flag set.
    assert page.evaluate("window.heard") == ["Control", "k"]
    assert page.locator(".chr-demo[data-lm-suppress-shortcuts]").count() == 1


def test_wheel_over_a_slider_scrolls_the_page(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo(), TiltDemo(), TiltDemo()))
    before = state_of(page)
    slider(page, "roll").first.focus()
    slider(page, "roll").first.hover()
    page.mouse.wheel(0, 300)
    page.wait_for_function("scrollY > 100")
    assert state_of(page) == before


# ── by ear ─────────────────────────────────────────────────────────────────────────────────────


def everything_has_a_name(page: Page) -> None:
    names = page.locator("input, button, canvas, output, [role=group]").evaluate_all(
        "(all) => all.map((each) => each.ariaLabel ?? each.labels?.[0]?.textContent"
        " ?? each.textContent)"
    )
    assert all(str(name).strip() != "" for name in names)
    values = page.locator("[type=range]").evaluate_all(
        "(all) => all.map((each) => each.ariaValueText)"
    )
    for value in values:
        assert any(unit in value for unit in UNITS), value
    for name in ("Play", "Reset"):
        expect(page.get_by_role("button", name=name)).to_have_count(1)
    # A number with a unit beside it has the unit in its name.
    labels = page.locator(".chr-readout:has(.chr-unit:not(:empty)) output").evaluate_all(
        "(all) => all.map((each) => each.ariaLabel)"
    )
    endings = (", degrees", ", metres", ", metres per second", " squared", ", per cent")
    assert all(label.endswith(endings) for label in labels), labels


# ── by eye ─────────────────────────────────────────────────────────────────────────────────────


def the_picture_follows_the_theme(page: Page) -> None:
    dark = picture(page)
    page.evaluate("document.documentElement.dataset.theme = 'light'")
    assert picture(page) != dark


CUT_OFF = """() => [...document.querySelectorAll(".chr-readout *, .chr-caption *, .chr-table *")]
  .filter((part) => part.getBoundingClientRect().right > innerWidth)
  .map((part) => part.textContent)"""


def the_demo_fits_the_page(page: Page, demo: type[Demo]) -> None:
    for name in demo.controls:
        slider(page, name).press("End")
        assert state_of(page)[name] == demo.class_traits()[name].max
    for width in (320, 390, 1280):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.evaluate(CUT_OFF) == [], width


# Top and bottom of the picture and of a slider that comes into view.
TOGETHER = """(slider) => {
  slider.scrollIntoView({ block: "nearest" });
  const parts = [slider.closest(".chr-demo").querySelector("canvas"), slider];
  return parts.flatMap((each) => {
    const { top, bottom } = each.getBoundingClientRect();
    return [top, bottom];
  });
}"""


def picture_and_each_slider_are_seen_together_on_a_phone(page: Page, demo: type[Demo]) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    for name in demo.controls:
        top, bottom, slider_top, slider_bottom = slider(page, name).evaluate(TOGETHER)
        assert -1 <= top < bottom <= slider_top < slider_bottom <= 845, name


def the_reader_is_told_first_what_to_try(page: Page) -> None:
    root = page.locator(".chr-demo")
    assert str(root.text_content()).startswith("Try first. ")
    assert root.locator(".chr-hint ~ .chr-body canvas").count() == 1
