"""Demos on a page of the book: each by itself, with a state in the address, idle out of sight."""

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from chr_notes.demos import ConverterDemo, DriftDemo, GimbalLockDemo, TiltDemo
from chr_notes.demos.base import Demo

from .parts import (
    DEMOS,
    PageOf,
    Samples,
    Visit,
    each_kind,
    hold,
    let_pass,
    output,
    picture,
    slider,
    state_of,
)


def test_a_demo_that_fails_leaves_the_others_alone(visit: Visit, page_of: PageOf) -> None:
    address = page_of(GimbalLockDemo(), TiltDemo(), DriftDemo())
    path = Path(address.removeprefix("file://"))
    text = path.read_text(encoding="utf-8").replace('data-demo="gimbal-lock"', 'data-demo="none"')
    path.write_text(text.replace("&quot;vibration&quot;: 0.0", "nonsense"), encoding="utf-8")
    page = visit(address)
    expect(page.locator(".chr-demo")).to_have_count(1)
    # What stood there for readers without scripts still stands there.
    expect(page.locator("[data-failed]")).to_have_count(2)
    expect(page.get_by_text("An aircraft in three rings: yaw 0°")).to_have_count(1)


COUNT = """<script>
  window.mounted = [];
  new MutationObserver((changes) => {
    const added = changes.flatMap((change) => [...change.addedNodes]);
    window.mounted.push(added.filter((each) => each.className === "chr-demo").length);
  }).observe(document, { childList: true, subtree: true });
</script>"""


def test_each_demo_comes_in_a_task_of_its_own(visit: Visit, page_of: PageOf) -> None:
    address = page_of(GimbalLockDemo(), TiltDemo(), DriftDemo())
    path = Path(address.removeprefix("file://"))
    text = path.read_text(encoding="utf-8").replace("<body>", f"<body>{COUNT}", 1)
    path.write_text(text, encoding="utf-8")
    page = visit(address)
    # What changes in one task is told of at once.
    assert [count for count in page.evaluate("mounted") if count] == [1, 1, 1]


@each_kind
def test_a_state_can_be_kept_and_copied(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo(), demo()))
    assert "#" not in page.url
    # The second one of that name stays as the page has it.
    others = page.locator(".chr-demo").nth(1).get_attribute("data-state")
    name = demo.controls[0]
    at_the_end = demo().state()[name] == demo.class_traits()[name].max
    slider(page, name).first.press("ArrowLeft" if at_the_end else "ArrowRight")
    page.wait_for_function("location.hash !== ''")
    state = state_of(page)
    assert page.url.partition("#")[2].startswith(f"{demo.element}?{name}=")
    page.reload()
    assert state_of(page) == about(state)
    assert page.locator(".chr-demo").nth(1).get_attribute("data-state") == others
    link, python = copied(page)
    made = eval(python, {each.__name__: each for each in DEMOS})  # noqa: S307 (our own text)
    assert made.state() == state_of(page)
    page.get_by_role("button", name="Reset").first.click()
    page.wait_for_function(
        "(state) => document.querySelector('.chr-demo').dataset.state === state", arg=others
    )
    page.goto("about:blank")
    page.goto(link)
    assert state_of(page) == about(made.state())


def about(state: dict[str, Any]) -> dict[str, Any]:
    """A state with numbers as near as an address has them, and its texts."""
    return {
        name: value if isinstance(value, str) else pytest.approx(value, rel=1e-5)
        for name, value in state.items()
    }


def copied(page: Page) -> list[str]:
    """What the two buttons of the first demo copy."""
    page.evaluate(
        "() => { window.copied = []; Object.defineProperty(navigator, 'clipboard',"
        " { value: { writeText: async (text) => { window.copied.push(text); } } }); }"
    )
    for name in ("Copy link", "Copy as Python"):
        page.get_by_role("button", name=name).first.click()
        expect(page.get_by_role("button", name="Copied").first).to_be_visible()
    return [str(text) for text in page.evaluate("copied")]


# Too large, no number, nothing, no text at all; then others that read as numbers elsewhere.
MEANINGLESS = (
    *("roll=900", "roll=nonsense", "", "%"),
    *("roll=", "other=3", "roll=1e999", "roll=0x10", "roll=1e1", "roll=Infinity", "roll=%2010"),
)


def test_an_address_that_means_nothing_changes_nothing(
    visit: Visit, page_of: PageOf, samples: Samples
) -> None:
    address = page_of(TiltDemo(roll=10))
    page = visit(address)
    for query in MEANINGLESS[: samples(4, len(MEANINGLESS))]:
        page.goto("about:blank")
        page.goto(f"{address}#tilt?{query}")
        assert state_of(page) == TiltDemo(roll=10).state(), query


def test_nothing_is_drawn_or_played_out_of_sight(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()), width=700, own=True)
    hold(page)
    page.get_by_role("button", name="Play").click()
    let_pass(page, 600)
    page.evaluate("document.body.style.paddingBottom = '5000px'; scrollTo(0, 4500)")
    expect(page.get_by_role("button", name=re.compile("Go on|Play"))).to_have_count(1)
    state = state_of(page)
    let_pass(page, 20_000, frame=2_000)
    assert state_of(page) == state


CUT_OFF = """(width) => [...document.querySelectorAll(".chr-demo *")].filter((part) => {
  if (part.closest(".chr-live") || part.tagName === "OPTION") return false;
  const box = part.getBoundingClientRect();
  return box.width > 0 && (box.right > width + 0.5 || part.scrollWidth > part.clientWidth + 1
    && getComputedStyle(part).display !== "inline" && part.tagName !== "INPUT");
}).map((part) => `${part.className} ${part.textContent}`)"""


def test_nothing_is_cut_off_at_any_width(
    visit: Visit, page_of: PageOf, pytestconfig: pytest.Config
) -> None:
    extremes = [
        GimbalLockDemo(yaw=-180, pitch=89.9, roll=-180),
        TiltDemo(roll=-179, pitch=-89, forward_acceleration=-10, lateral_acceleration=-9.9),
        DriftDemo(angle_error=4.6, time=3599),
    ]
    highest = [
        each(**{name: each.class_traits()[name].max for name in each.controls}) for each in DEMOS
    ]
    page = visit(page_of(*extremes, *highest, ConverterDemo()))
    page.evaluate("window.requestAnimationFrame = () => 1")  # what is drawn changes no layout
    # Around the widths at which parts move, finer with `--full`.
    fine, finest = (2, 1) if pytestconfig.getoption("full") else (6, 5)
    widths = (*range(320, 400, 10), *range(640, 730, fine), *range(985, 1000, finest), 1200, 1920)
    for width in widths:
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate(CUT_OFF, width) == [], width


# ── turning the picture ────────────────────────────────────────────────────────────────────────


def test_the_picture_turns_by_hand_and_by_keys_and_back(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(yaw=30, pitch=60)))
    canvas = page.locator("canvas")
    first = picture(page)
    box = canvas.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 100, box["y"] + 100)
    page.mouse.down()
    page.mouse.move(box["x"] + 160, box["y"] + 120)
    page.mouse.up()
    dragged = picture(page)
    assert dragged != first
    page.mouse.move(box["x"] + 260, box["y"] + 220)
    assert picture(page) == dragged, "it turns without a button down"
    canvas.dblclick()
    assert picture(page) == first
    canvas.focus()
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("ArrowUp")
    assert picture(page) != first
    page.keyboard.press("Home")
    assert picture(page) == first
    assert state_of(page) == GimbalLockDemo(yaw=30, pitch=60).state()
    expect(output(page, "determinant")).to_have_text("2")
