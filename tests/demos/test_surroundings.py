"""Demos beside each other, under a strict policy, and under a finger."""

import re
from collections.abc import Callable
from pathlib import Path

from playwright.sync_api import Page, expect

from chr_notes.demos import DriftDemo, GimbalLockDemo, TiltDemo

from .colours import channels, of_palette
from .parts import (
    ALL,
    PageOf,
    Visit,
    output,
    picture,
    slider,
    unfold,
)

MINUS_ZERO = re.compile(r"[−-]0(?:\.0+)?(?![\d.])")
UNITS = (
    *("degrees", "metres per second squared", "second", "minute", "hour", "microtesla", "readings"),
    *("q v", "a gain of", "a threshold of", "of the field", "frame ", "axis "),
)


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


def test_all_fit_a_finger_paper_and_chosen_colours(visit: Visit, page_of: PageOf) -> None:
    everything = page_of(*(demo() for demo in ALL))
    page = visit(everything, width=390, own=True, has_touch=True, is_mobile=True)
    unfold(page)
    what_a_finger_hits_is_large_enough(page)
    page.emulate_media(media="print")
    for kind, name, value in (
        ("input", "printColorAdjust", "exact"),  # else thumbs and fills stay white
        (".chr-stage", "position", "static"),  # else pictures cover what follows
        ("", "breakInside", "avoid"),  # else a question parts from its picture
    ):
        assert styles_of(page, kind, name) == {value}
    for forced, slider_looks in (("none", "none"), ("active", "auto")):
        page.emulate_media(media="screen", forced_colors=forced)
        assert styles_of(page, "[type=range]", "appearance") == {slider_looks}
        # What is drawn keeps its colours, and the ground that they are made for.
        ground = styles_of(page, ".chr-stage", "backgroundColor")
        assert [channels(each) for each in ground] == [of_palette("page", "light")]
        assert page.evaluate("document.documentElement.scrollWidth") <= 390


def styles_of(page: Page, selector: str, name: str) -> set[str]:
    """The values that a property has in all demos."""
    values = page.locator(f".chr-demo {selector}").evaluate_all(
        "(all, name) => all.map((each) => getComputedStyle(each)[name])", name
    )
    assert len(values) >= 8
    return set(values)


def what_a_finger_hits_is_large_enough(page: Page) -> None:
    sizes = page.evaluate(
        "() => [...document.querySelectorAll("
        "'.chr-demo :is(input, button, select, textarea, summary)')].filter((each) => !each.hidden)"
        ".map((each) => each.getBoundingClientRect()).map(({ width, height }) => [width, height])"
    )
    assert len(sizes) > 60
    assert min(min(size) for size in sizes) >= 44
