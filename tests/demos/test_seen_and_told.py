"""What a demo shows: its picture in words, colours that stand out, numbers without a wrong sign."""

import json
import re

import pytest

from chr_notes.demos import DriftDemo, GimbalLockDemo, QuaternionDemo, TiltDemo
from chr_notes.demos.base import SOURCES

from .colours import channels, contrast, of_palette
from .parts import (
    ALL,
    PageOf,
    Visit,
)

MINUS_ZERO = re.compile(r"[−-]0(?:\.0+)?(?![\d.])")
UNITS = (
    *("degrees", "metres per second squared", "second", "minute", "hour", "microtesla", "readings"),
    *("q v", "a gain of", "a threshold of", "of the field", "frame ", "axis "),
)


TOLD = [
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
    (DriftDemo(time=600), "after 10 minutes it is 30.8\u00a0km away, out of the city"),
    (
        DriftDemo(view=1, time=600),
        "At 10 minutes velocity is off by 102.6 m/s, position by 30.8\u00a0km",
    ),
    (
        QuaternionDemo(angle=360, product=2),
        "turned by 360° about an axis at yaw 40°, pitch 35°. Its quaternion is −1.000",
    ),
    (DriftDemo(angle_error=0), "off by 0°, it stays where it is"),
    (DriftDemo(view=1, angle_error=0), "Without an error of angle it is empty."),
]


def test_picture_is_told_in_words(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(*(demo for demo, _ in TOLD)))
    told = page.get_by_role("img").evaluate_all("(all) => all.map((each) => each.ariaLabel)")
    for picture_in_words, (_, words) in zip(told, TOLD, strict=True):
        assert words in picture_in_words


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


NEAR_ZERO = [
    GimbalLockDemo(yaw=-0.001, pitch=-0.001, roll=-0.001),
    GimbalLockDemo(yaw=-180, pitch=90, roll=180),
    TiltDemo(roll=-0.001, pitch=-0.001, forward_acceleration=-0.001),
    TiltDemo(roll=180, pitch=-90, lateral_acceleration=-0.001),
    DriftDemo(angle_error=0, time=1),
    QuaternionDemo(axis_yaw=0, axis_pitch=0, angle=0),
    QuaternionDemo(axis_yaw=-180, axis_pitch=-90, angle=720, product=2),
]


def test_no_number_is_minus_zero(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(*NEAR_ZERO))
    shown = page.locator(".chr-demo").evaluate_all(
        "(all) => all.map((each) => [each.innerText + each.innerHTML, each.dataset.state])"
    )
    for (html, state), demo in zip(shown, NEAR_ZERO, strict=True):
        assert MINUS_ZERO.search(html) is None, demo
        assert MINUS_ZERO.search(demo.fallback()) is None, demo
        assert json.loads(state) == demo.state()
