"""Everyone can use each demo: by keyboard, by ear, in both themes, at any width."""

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from chr_notes.demos import DriftDemo, GimbalLockDemo, QuaternionDemo, TiltDemo
from chr_notes.demos.base import SOURCES, Demo
from chr_notes.palette import PALETTE

from .parts import (
    ALL,
    PageOf,
    Visit,
    each_demo,
    field,
    output,
    picture,
    slider,
    state_of,
)

MINUS_ZERO = re.compile(r"[−-]0(?:\.0+)?(?![\d.])")
UNITS = (
    *("degrees", "metres per second squared", "second", "minute", "hour", "microtesla", "readings"),
    *("q v", "a gain of", "a threshold of", "of the field", "frame ", "axis "),
)


# ── by keyboard ────────────────────────────────────────────────────────────────────────────────

BUTTONS = ("play", "reset", "link", "python")


@each_demo
def test_everyone_can_use_it(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    """One page for all that can be tried on one page."""
    page = visit(page_of(demo()))
    the_reader_is_told_first_what_to_try(page)
    everything_has_a_name(page)
    for theme in ("light", "dark"):
        page.evaluate("(theme) => { document.documentElement.dataset.theme = theme; }", theme)
        tab_reaches_each_control_and_shows_where_it_is(page, demo, theme)
    the_picture_follows_the_theme(page)
    only_keys_for_the_page_reach_the_page(page, demo)
    the_keyboard_moves_each_slider_and_the_picture(page, demo)
    a_number_can_be_typed(page, demo)
    the_demo_fits_the_page(page, demo)


def tab_reaches_each_control_and_shows_where_it_is(
    page: Page, demo: type[Demo], theme: str
) -> None:
    page.evaluate("document.activeElement.blur()")
    page.mouse.click(2, 2)  # where Tab begins
    picture_first = [None] * page.locator("canvas.chr-turns").count()
    reached = []
    beside = {name: [] if demo.class_traits()[name].whole else [""] for name in demo.controls}
    stops = [each for name in demo.controls for each in (name, *beside[name])]
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


def the_keyboard_moves_each_slider_and_the_picture(page: Page, demo: type[Demo]) -> None:
    for name in demo.controls:
        limits = demo.class_traits()[name]
        before, state = picture(page), state_of(page)[name]
        words = page.locator("canvas").get_attribute("aria-label")
        slider(page, name).focus()
        up = state < limits.max
        for _ in range(2):
            page.keyboard.press("ArrowRight" if up else "ArrowLeft")
        assert (state_of(page)[name] > state) == up
        assert picture(page) != before, name
        assert page.locator("canvas").get_attribute("aria-label") != words, name
        page.keyboard.press("Home")
        assert state_of(page)[name] == limits.min
        page.keyboard.press("End")
        assert state_of(page)[name] == limits.max
        slider(page, name).evaluate(SET, demo().state()[name])


def a_number_can_be_typed(page: Page, demo: type[Demo]) -> None:
    for name in demo.controls:
        limits = demo.class_traits()[name]
        if limits.whole:
            continue
        words = page.locator(".chr-control", has=slider(page, name)).locator(".chr-value")
        inside = round(0.5 * (limits.min + limits.max) + 0.001, 3)
        field(page, name).fill(str(inside))
        assert state_of(page)[name] == inside
        for typed, said, taken in (
            (str(2 * limits.max + 1), "at most ", limits.max),
            (str(limits.min - 1), "at least ", limits.min),
            ("", "a number from ", limits.min),
        ):
            field(page, name).fill(typed)
            page.keyboard.press("Enter")
            assert state_of(page)[name] == taken
            expect(words).to_contain_text(said)
            expect(page.locator("[aria-live=polite]")).to_contain_text(said)
            assert float(field(page, name).input_value()) == taken
        page.keyboard.press("ArrowUp")
        assert state_of(page)[name] > limits.min
        slider(page, name).evaluate(SET, demo().state()[name])


SET = """(input, value) => {
  const put = (position) => {
    input.value = position;
    input.dispatchEvent(new Event("input"));
    return JSON.parse(document.querySelector(".chr-demo").dataset.state)[input.name];
  };
  if (put(value) === value) return;
  for (let at = Number(input.min); put(at) < value; at += Number(input.step));
}"""
"""Move a slider to a value, or to the first position with at least so much."""


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


@pytest.mark.parametrize(
    ("demo", "words"),
    [
        (GimbalLockDemo(yaw=-30, pitch=60), "yaw −30°, pitch 60°, roll 0°, nose up. The roll axis"),
        (GimbalLockDemo(pitch=-90), "nose down. The yaw axis and the roll axis are one line"),
        (
            TiltDemo(roll=5, forward_acceleration=2),
            "Roll 5°, pitch 0°. It accelerates by 2 m/s² forward and 0 m/s² to the right.",
        ),
        (
            TiltDemo(forward_acceleration=2),
            "The vertical that it believes in leans 11.53° from the real one.",
        ),
        (TiltDemo(vibration=2), "single readings scatter round it"),
        (DriftDemo(time=600), "after 10 minutes it is 30.8 km away, out of the city"),
        (
            DriftDemo(view=1, time=600),
            "At 10 minutes velocity is off by 102.6 m/s, position by 30.8 km",
        ),
        (
            QuaternionDemo(angle=360, product=2),
            "turned by 360° about an axis at yaw 40°, pitch 35°. Its quaternion is −1.000",
        ),
        (DriftDemo(angle_error=0), "off by 0°, it stays where it is"),
        (DriftDemo(view=1, angle_error=0), "Without an error of angle it is empty."),
    ],
)
def test_picture_is_told_in_words(visit: Visit, page_of: PageOf, demo: Demo, words: str) -> None:
    picture_in_words = visit(page_of(demo)).get_by_role("img").get_attribute("aria-label")
    assert words in str(picture_in_words)


# ── by eye ─────────────────────────────────────────────────────────────────────────────────────


def channels(colour: str) -> list[float]:
    """The three numbers of `rgb(…)`, or of `#rrggbb`, from 0 to 1."""
    if colour.startswith("#"):
        return [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return [float(part) / 255 for part in colour.strip("rgba()").split(",")[:3]]


def of_palette(name: str, theme: str) -> list[float]:
    return channels(str(getattr(PALETTE[name], theme)))


def contrast(one: list[float], other: list[float]) -> float:
    """As the Web Content Accessibility Guidelines define it."""
    linear = [
        [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour]
        for colour in (one, other)
    ]
    low, high = sorted(0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in linear)
    return (high + 0.05) / (low + 0.05)


WRITTEN = """() => [...document.querySelectorAll(".chr-demo *")].filter((each) =>
  [...each.childNodes].some((child) => child.nodeType === 3 && child.data.trim() !== "")
).map((each) => {
  const opaque = (colour) => !colour.endsWith(", 0)");
  let behind = each;
  while (!opaque(getComputedStyle(behind).backgroundColor)) behind = behind.parentElement;
  return [each.textContent, getComputedStyle(each).color, getComputedStyle(behind).backgroundColor];
})"""


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_words_and_edges_stand_out(visit: Visit, page_of: PageOf, theme: str) -> None:
    page = visit(page_of(*(demo() for demo in ALL), TiltDemo(pitch=90), theme=theme))
    written = page.evaluate(WRITTEN)
    assert len(written) > 60
    for text, colour, background in written:
        assert contrast(channels(colour), channels(background)) >= 4.5, text
    edges = page.locator("button").evaluate_all(
        "(all) => all.map((each) => getComputedStyle(each).borderTopColor)"
    )
    assert min(contrast(channels(edge), of_palette("raised", theme)) for edge in edges) >= 3


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_colours_of_pictures_stand_out(theme: str) -> None:
    """What is written on a canvas, on its background, and what a slider is made of."""
    for name in ("ink", "muted", "x", "y", "z", "alert", "accent", "proved", "corrected"):
        assert contrast(of_palette(name, theme), of_palette("page", theme)) >= 4.5, name
        assert contrast(of_palette(name, theme), of_palette("raised", theme)) >= 3, name
    css = (SOURCES / "demos.css").read_text(encoding="utf-8")
    assert ".chr-stage { background: var(--chr-page)" in css
    for part in ("webkit-slider-runnable", "moz-range"):
        rule = css.partition(f"::-{part}-track {{")[2].partition("}")[0]
        assert "border: 1px solid var(--chr-muted)" in rule


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
    for width in (320, 390, 1280):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.evaluate(CUT_OFF) == [], width


def the_reader_is_told_first_what_to_try(page: Page) -> None:
    root = page.locator(".chr-demo")
    assert str(root.text_content()).startswith("Try first. ")
    assert root.locator(".chr-hint ~ .chr-body canvas").count() == 1


# ── beside each other, and as a page from anywhere ─────────────────────────────────────────────


def test_several_demos_on_a_page_keep_apart(visit: Visit, page_of: PageOf) -> None:
    others = (DriftDemo(time=60), GimbalLockDemo(pitch=60), TiltDemo(roll=10))
    page = visit(page_of(TiltDemo(), *others, DriftDemo()))
    for name in TiltDemo.controls:
        slider(page, name).first.press("End")
    _, drift, gimbal_lock, tilt, last = page.locator("[data-demo]").all()
    slider(last, "time").press("End")
    expect(output(drift, "velocity_error")).to_have_text("10.26")
    expect(output(gimbal_lock, "determinant")).to_have_text("2")
    expect(output(tilt, "roll_estimate")).to_have_text("10")
    assert page.locator(".chr-demo [id]").count() == 0, "an id would stand twice"


STRICT = "default-src 'self'; img-src 'self' data:; style-src 'self' 'unsafe-inline'"


def test_demos_work_from_a_server_with_a_strict_policy(
    visit: Visit, page_of: PageOf, serve: Callable[[Path], str], tmp_path: Path
) -> None:
    page_of(*(demo() for demo in ALL))
    written = (tmp_path / "page.html").read_text(encoding="utf-8")
    before, script, after = re.split(r"<script>(.*)</script>", written, flags=re.DOTALL)
    (tmp_path / "pages.js").write_text(script, encoding="utf-8")
    policy = f'<meta http-equiv="Content-Security-Policy" content="{STRICT}">'
    strict = before.replace('<meta charset="utf-8">', f'<meta charset="utf-8">{policy}')
    (tmp_path / "page.html").write_text(
        f'{strict}<script src="pages.js"></script>{after}', encoding="utf-8"
    )
    page = visit(serve(tmp_path) + "page.html")
    expect(page.locator(".chr-demo")).to_have_count(len(ALL))
    assert picture(page.locator(".chr-demo").first) != ""


def test_what_a_finger_hits_is_large_enough(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(*(demo() for demo in ALL)), width=390, has_touch=True, is_mobile=True)
    sizes = page.evaluate(
        "() => [...document.querySelectorAll('.chr-demo :is(input, button, select, textarea)')]"
        ".filter((each) => !each.hidden)"
        ".map((each) => each.getBoundingClientRect()).map(({ width, height }) => [width, height])"
    )
    assert len(sizes) > 60
    assert min(min(size) for size in sizes) >= 44


@pytest.mark.parametrize(
    "demo",
    [
        GimbalLockDemo(yaw=-0.001, pitch=-0.001, roll=-0.001),
        GimbalLockDemo(yaw=-180, pitch=90, roll=180),
        TiltDemo(roll=-0.001, pitch=-0.001, forward_acceleration=-0.001),
        TiltDemo(roll=180, pitch=-90, lateral_acceleration=-0.001),
        DriftDemo(angle_error=0, time=1),
        QuaternionDemo(axis_yaw=0, axis_pitch=0, angle=0),
        QuaternionDemo(axis_yaw=-180, axis_pitch=-90, angle=720, product=2),
    ],
)
def test_no_number_is_minus_zero(visit: Visit, page_of: PageOf, demo: Demo) -> None:
    page = visit(page_of(demo))
    html = page.locator(".chr-demo").evaluate("(each) => each.innerText + each.innerHTML")
    assert MINUS_ZERO.search(str(html)) is None
    assert MINUS_ZERO.search(demo.fallback()) is None
    assert json.loads(str(page.locator(".chr-demo").get_attribute("data-state"))) == demo.state()
