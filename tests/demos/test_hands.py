"""What of a picture can be taken hold of: by a pointer, by a finger, and by keys."""

import json

import numpy as np
import pytest
from playwright.sync_api import Locator, expect

import chr_notes
from chr_notes.demos import (
    DriftDemo,
    FilterDemo,
    MagnetometerDemo,
    QuaternionDemo,
    TiltDemo,
    ValidationDemo,
)
from chr_notes.demos.base import rounded

from .parts import HELD_BY_KEYS, PageOf, Visit, changed, output, picture, slider, state_of

Place = tuple[float, float]


def drag(canvas: Locator, *places: Place) -> None:
    """Drag from the first to the others, each as parts of the width and of the height."""
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()
    assert box is not None
    mouse = canvas.page.mouse
    for i, (right, down) in enumerate(places):
        place = (box["x"] + right * box["width"], box["y"] + down * box["height"])
        mouse.move(*place, steps=1 if i == 0 else 12)
        if i == 0:
            mouse.down()
    mouse.up()


def axis_on_screen(state: dict[str, float], canvas: Locator) -> Place:
    """Where the axis of the quaternion demo ends, as parts of the width and of the height."""
    box = canvas.bounding_box()
    assert box is not None
    camera = chr_notes.matrix_from_euler(np.radians([0, -25, 20]))
    angles = np.radians([0, state["axis_pitch"], state["axis_yaw"]])
    depth, right, down = camera @ (1.2 * chr_notes.matrix_from_euler(angles)[0])
    high = 0.64 * box["height"]
    scale = 7 * min(box["width"], high) / 2.95 / (7 + depth)
    return 0.5 + scale * right / box["width"], (high / 2 + scale * down) / box["height"]


def test_an_axis_follows_the_pointer_and_elsewhere_the_camera_turns(
    visit: Visit, page_of: PageOf
) -> None:
    demo = QuaternionDemo()
    page = visit(page_of(demo))
    canvas = page.locator("canvas")
    first = picture(page)
    drag(canvas, (0.2, 0.4), (0.3, 0.45))
    assert changed(page, demo) == set()
    assert picture(page) != first
    canvas.dblclick(position={"x": 60, "y": 150})
    assert picture(page) == first
    for place in ((0.6, 0.15), (0.45, 0.3)):  # the axis keeps to whole degrees
        drag(canvas, axis_on_screen(state_of(page), canvas), place)
        assert changed(page, demo) == {"axis_yaw", "axis_pitch"}
        assert axis_on_screen(state_of(page), canvas) == pytest.approx(place, abs=0.01)


def test_a_line_in_a_chart_is_moved(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(FilterDemo(gain=0.1), DriftDemo(view=1, time=60)))
    for demo, left, right, shares, name, value in (
        ("filter", 44, 64, (0.75, 0.5), "gain", 0.01),
        ("drift", 46, 80, (0.5, 0.7), "time", 3600**0.7),
    ):
        part = page.locator(f'[data-demo="{demo}"]')
        before, canvas = state_of(part), part.locator("canvas")
        box = canvas.bounding_box()
        assert box is not None
        ends = [(left + share * (box["width"] - right - left)) / box["width"] for share in shares]
        drag(canvas, *((end, 0.7) for end in ends))
        assert state_of(part) == before | {name: pytest.approx(value, rel=0.05)}


def test_a_sensor_is_taken_along_on_its_rings(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(DriftDemo(time=60)))
    canvas = page.locator("canvas")
    box = canvas.bounding_box()
    assert box is not None
    middle = 0.5 + 7 / box["height"]

    def place(time: float) -> Place:
        metres = DriftDemo(time=time).readouts()["total_error"]
        share = np.log1p(metres / 0.05) / np.log1p(4e7 / 0.05)
        return (0.42 * box["width"] + share * (0.58 * box["width"] - 16)) / box["width"], middle

    drag(canvas, place(60), place(600))
    assert state_of(page) == DriftDemo(time=600).state()
    drag(canvas, place(600), (0.999, middle))
    assert state_of(page)["time"] == 3600


def test_a_threshold_is_moved(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ValidationDemo(threshold=0.05)))
    canvas = page.locator("canvas")
    box = canvas.bounding_box()
    assert box is not None
    ends = [(50 + share * (box["width"] - 72)) / box["width"] for share in (0.5, 0.8, 0.2)]
    drag(canvas, (ends[0], 0.85), (ends[1], 0.85))
    assert state_of(page) == ValidationDemo(threshold=0.08).state()
    drag(canvas, (ends[1], 0.85), (ends[2], 0.85))
    assert state_of(page) == ValidationDemo(threshold=0.02).state()


def test_a_sensor_turned_by_hand_grows_its_cloud(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(MagnetometerDemo()), width=1280)
    canvas = page.locator("canvas")
    drag(canvas, (0.15, 0.15), (0.2, 0.15))
    few = state_of(page)
    assert 0 < len(str(few["turned"])) // 4 < 10
    expect(output(page, "meaning")).to_contain_text("a fit needs 10 at least")
    expect(output(page, "error_after")).to_have_text("–")
    drag(canvas, (0.15, 0.15), (0.5, 0.2), (0.2, 0.6), (0.7, 0.5))
    more = state_of(page)
    assert str(more["turned"]).startswith(str(few["turned"])[:-4])
    numbers = MagnetometerDemo(**more).readouts()
    for name, value in numbers.items():
        expect(output(page, name)).to_have_text(rounded(value))
    # It is in the address, and a slider of the walk brings the walk back.
    page.wait_for_function("(turned) => location.hash.endsWith(turned)", arg=more["turned"])
    page.reload()
    assert state_of(page) == more
    slider(page, "tilt").press("ArrowLeft")
    assert state_of(page)["turned"] == ""


HELD = """(part) => {
  const canvas = part.querySelector("canvas");
  part.scrollIntoView();
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const places = { held: [], free: [] };
  for (let x = left + 6; x < left + width - 6; x += 12)
    for (let y = top + 6; y < top + height - 6; y += 12) {
      canvas.dispatchEvent(new PointerEvent("pointermove", { clientX: x, clientY: y }));
      places[canvas.classList.contains("chr-holds") ? "held" : "free"].push([x, y]);
    }
  const middle = (all) => all.length && all[Math.floor(all.length / 2)];
  return [middle(places.held), places.free.findLast(([, y]) => y > top + 0.7 * height)];
}"""
"""A place where a picture can be taken hold of, and one low down where it cannot."""


AT_REST = """async () => {
  for (let [last, still] = [NaN, 0]; still < 5; last = scrollY) {
    await new Promise((done) => requestAnimationFrame(done));
    still = scrollY === last ? still + 1 : 0;
  }
  return scrollY;
}"""
"""Where the page stands once it no longer scrolls: it goes on when a finger has left it."""


def test_a_finger_holds_and_elsewhere_the_page_scrolls(visit: Visit, page_of: PageOf) -> None:
    demos = (*HELD_BY_KEYS, FilterDemo, DriftDemo)
    page = visit(
        page_of(*(demo(**{"view": 1} if demo is DriftDemo else {}) for demo in demos)),
        width=390, has_touch=True, is_mobile=True,
    )  # fmt: skip
    page.evaluate("document.body.style.paddingBottom = '2000px'")
    fingers = page.context.new_cdp_session(page)

    def swipe(place: Place, by: Place) -> float:
        """Move a finger, and return how far the page has scrolled."""
        before = page.evaluate("scrollY")
        for i in range(9):
            at = {"x": place[0] + i * by[0] / 8, "y": place[1] + i * by[1] / 8}
            kind = "touchMove" if i else "touchStart"
            fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [at]})
        fingers.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        return float(page.evaluate(AT_REST)) - before

    for demo in demos:
        part = page.locator(f'[data-demo="{demo.element}"]')
        before = state_of(part)
        held, free = part.evaluate(HELD)
        assert swipe(held, (24, -40)) == 0, demo
        assert state_of(part) != before, demo
        moved = state_of(part)
        held, free = part.evaluate(HELD)
        assert swipe(free, (0, -60)) > 20, demo
        assert state_of(part) == moved, demo


def test_attitudes_that_are_none_are_refused(visit: Visit, page_of: PageOf) -> None:
    address = page_of(MagnetometerDemo())
    page = visit(f"{address}#magnetometer?turned=gIC&tilt=30")
    assert state_of(page) == MagnetometerDemo(tilt=30).state()
    demo = MagnetometerDemo(turned="gICAhoCA")
    assert json.loads(json.dumps(demo.state()))["turned"] == "gICAhoCA"
    assert eval(repr(demo)).state() == demo.state()  # noqa: S307 (our own text)
    for wrong in ("gIC", "gIC!", "gICA" * 201):
        with pytest.raises(Exception, match="turned: attitudes of four letters"):
            MagnetometerDemo(turned=wrong)


def test_a_plumb_line_is_pushed_and_an_aircraft_tilted(visit: Visit, page_of: PageOf) -> None:
    demo = TiltDemo(roll=20, pitch=10)
    page = visit(page_of(demo))
    canvas = page.locator("canvas")
    box = canvas.bounding_box()
    assert box is not None
    size, high = box["width"] / 2, 0.66 * box["height"]
    scale = min(size / 2.2, high / 2.85)

    def place(view: int, right: float, down: float) -> Place:
        """From the centre of a view, in units of the picture, as parts of the canvas."""
        x, y = size * (view + 0.5) + scale * right, high / 2 + scale * (down + 0.12)
        return x / box["width"], y / box["height"]

    # From the right, the bob goes where the pointer is: the reading is held up along the line.
    drag(canvas, place(1, 0, 1), place(1, -0.4, 0.8))
    state = state_of(page)
    assert changed(page, demo) == {"forward_acceleration"}
    force = chr_notes.accelerometer_at_rest(np.radians([20, 10, 0]))
    force += np.array([state["forward_acceleration"], 0, 0])
    north, _, down = chr_notes.matrix_from_euler(np.radians([20, 10, 0])).T @ force
    assert north / down == pytest.approx(-0.4 / 0.8, abs=0.02)
    # From behind, the wings.
    wing = 1.25 * chr_notes.matrix_from_euler(np.radians([20, 10, 0])).T @ [-0.04, 0.53, -0.01]
    angle = np.radians(-50)
    to = 0.6 * np.array([np.cos(angle), np.sin(angle) * np.cos(np.radians(10))])
    drag(canvas, place(0, wing[1], wing[2]), place(0, *to))
    assert state_of(page)["roll"] == pytest.approx(-50, abs=2)
