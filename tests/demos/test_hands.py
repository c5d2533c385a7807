"""What of a picture can be taken hold of: by a pointer, by a finger, and by keys."""

import json

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

import chr_notes
from chr_notes.demos import (
    DriftDemo,
    FilterDemo,
    FramesDemo,
    MagnetometerDemo,
    QuaternionDemo,
    ValidationDemo,
)
from chr_notes.demos.base import Demo, rounded

from .parts import PageOf, Visit, output, picture, slider, state_of

Place = tuple[float, float]


def drag(canvas: Locator, *places: Place) -> None:
    """Drag from the first to the others, each as parts of the width and of the height."""
    box = canvas.bounding_box()
    assert box is not None
    mouse = canvas.page.mouse
    for i, (right, down) in enumerate(places):
        place = (box["x"] + right * box["width"], box["y"] + down * box["height"])
        mouse.move(*place, steps=1 if i == 0 else 12)
        if i == 0:
            mouse.down()
    mouse.up()


def changed(page: Page, demo: Demo) -> set[str]:
    now = state_of(page)
    return {name for name, value in demo.state().items() if now[name] != value}


@pytest.mark.parametrize(
    ("demo", "names"),
    [
        (QuaternionDemo(), {"axis_yaw", "axis_pitch"}),
        (ValidationDemo(axis_yaw=60), {"axis_yaw", "axis_pitch"}),
        (FramesDemo(), {"wind"}),
        (MagnetometerDemo(), {"turned"}),
    ],
    ids=lambda each: each.element if isinstance(each, Demo) else "",
)
def test_keys_move_what_can_be_held(
    visit: Visit, page_of: PageOf, demo: Demo, names: set[str]
) -> None:
    page = visit(page_of(demo))
    canvas = page.locator("canvas")
    assert "With Shift" in str(canvas.get_attribute("aria-description"))
    canvas.focus()
    page.keyboard.press("ArrowLeft")
    assert changed(page, demo) == set(), "the camera is no part of the state"
    page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("Shift+ArrowUp")
    assert changed(page, demo)
    assert changed(page, demo) <= names


def axis_on_screen(state: dict[str, float], canvas: Locator) -> Place:
    """Where the axis of the quaternion demo ends, as parts of the width and of the height."""
    box = canvas.bounding_box()
    assert box is not None
    camera = chr_notes.matrix_from_euler(np.radians([0, -20, -35]))
    angles = np.radians([0, state["axis_pitch"], state["axis_yaw"]])
    depth, right, down = camera @ (1.2 * chr_notes.matrix_from_euler(angles)[0])
    high = 0.64 * box["height"]
    scale = 7 * min(box["width"], high) / 2.75 / (7 + depth)
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


@pytest.mark.parametrize(
    ("demo", "shares", "value"),
    [
        (FilterDemo(gain=0.1), (0.75, 0.5), {"gain": 0.01}),
        (DriftDemo(view=1, time=60), (0.5, 0.7), {"time": 3600**0.7}),
    ],
    ids=["filter", "drift"],
)
def test_a_line_in_a_chart_is_moved(
    visit: Visit, page_of: PageOf, demo: Demo, shares: Place, value: dict[str, float]
) -> None:
    page = visit(page_of(demo))
    canvas = page.locator("canvas")
    box = canvas.bounding_box()
    assert box is not None
    left = {"filter": 44, "drift": 46}[demo.element]
    ends = [(left + share * (box["width"] - 14 - left)) / box["width"] for share in shares]
    drag(canvas, *((end, 0.7) for end in ends))
    assert changed(page, demo) == {*value}
    assert {name: state_of(page)[name] for name in value} == pytest.approx(value, rel=0.05)


def test_a_sensor_turned_by_hand_grows_its_cloud(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(MagnetometerDemo()))
    canvas = page.locator("canvas")
    drag(canvas, (0.15, 0.15), (0.2, 0.15))
    few = state_of(page)
    assert 0 < len(str(few["turned"])) // 4 < 10
    expect(output(page, "meaning")).to_contain_text("A fit needs 10 at least")
    expect(output(page, "error_after")).to_have_text("–")
    drag(canvas, (0.15, 0.15), (0.5, 0.2), (0.2, 0.6), (0.7, 0.5), (0.1, 0.1), (0.9, 0.9))
    more = state_of(page)
    assert str(more["turned"]).startswith(str(few["turned"])[:-4])
    numbers = MagnetometerDemo(**more).readouts()
    for name, value in numbers.items():
        expect(output(page, name)).to_have_text(rounded(value))
    # It is in the address, and a slider of the walk brings the walk back.
    page.wait_for_function("location.hash.includes('turned=')")
    page.reload()
    assert state_of(page) == more
    slider(page, "tilt").press("ArrowLeft")
    assert state_of(page)["turned"] == ""


def test_a_finger_holds_and_the_page_stays(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(MagnetometerDemo()), width=390, has_touch=True, is_mobile=True)
    prevented = page.evaluate(
        """() => {
          const canvas = document.querySelector("canvas");
          const { left, top, width } = canvas.getBoundingClientRect();
          return [0.15, 0.5].map((part) => {
            const at = { clientX: left + part * width, clientY: top + part * width, pointerId: 1 };
            canvas.setPointerCapture = () => {};
            canvas.dispatchEvent(new PointerEvent("pointerdown", at));
            const touch = new TouchEvent("touchstart", { cancelable: true });
            canvas.dispatchEvent(touch);
            canvas.dispatchEvent(new PointerEvent("pointerup", at));
            return touch.defaultPrevented;
          });
        }"""
    )
    assert prevented == [True, False]


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
