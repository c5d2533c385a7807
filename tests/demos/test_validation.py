"""The demo of the factor E: its numbers are Python's, and it is blind where E is."""

import numpy as np
import pytest
from playwright.sync_api import expect

import chr_notes
from chr_notes.demos import ValidationDemo
from chr_notes.demos.base import rounded

from .parts import FOLDED, SET_AND_READ, PageOf, Visit, output, random_states, slider

STEPS = dict.fromkeys(ValidationDemo.controls, 1.0) | {
    "error": 0.5,
    "threshold": 0.005,
    "iron": 0.01,
}


def expected(state: dict[str, float]) -> dict[str, float]:
    """E and the angle of the verticals from matrices: believed = true, turned by the error."""
    truth = chr_notes.matrix_from_euler(np.radians([0, 0, state["heading"]]))
    axis_in_body = chr_notes.matrix_from_euler(
        np.radians([0, state["axis_pitch"], state["axis_yaw"]])
    )[0]
    turn = chr_notes.quaternion_from_axis_angle(axis_in_body, np.radians(state["error"]))
    believed = chr_notes.matrix_from_quaternion(turn) @ truth
    dip = np.radians(state["inclination"])
    mag = truth @ [np.cos(dip), 0, np.sin(dip)] + [0, 0, state["iron"]]
    euler = chr_notes.euler_from_matrix(believed, on_gimbal_lock="ignore")
    apart = np.arctan2(
        np.linalg.norm(np.cross(believed[:, 2], truth[:, 2])), believed[:, 2] @ truth[:, 2]
    )
    return {
        "factor": abs(float(chr_notes.validation_factor(mag, euler[:2], np.sin(dip)))),
        "tilt_error": float(np.degrees(apart)),
    }


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    states = random_states(ValidationDemo, STEPS, seed=12)
    names = ValidationDemo.controls
    extremes = [
        [0, 0, 0, 0, 0, 0, 66],
        [180, -180, 90, 30, 0.3, 0.5, 90],
        [0, 0, -90, 30, 0, -0.5, 0],
    ]
    states += [dict(zip(names, row, strict=True)) for row in extremes]
    page = visit(page_of(ValidationDemo()))
    for state, (now, texts) in zip(states, page.evaluate(SET_AND_READ, states), strict=True):
        assert now == state
        numbers, found = expected(state), ValidationDemo(**state).readouts()
        assert {name: found[name] for name in numbers} == pytest.approx(numbers, abs=1e-9)
        assert float(texts["factor"]) == round(numbers["factor"], 3), state
        assert texts["tilt_error"] == rounded(numbers["tilt_error"]), state
        assert {name: texts[name] for name in ("missed", "false_alarms")} == {
            name: rounded(found[name]) for name in ("missed", "false_alarms")
        }, state


def test_missed_directions_are_a_share_of_the_sphere() -> None:
    """For a small error dE is proportional to the axis along one direction: a belt is missed."""
    state = {"error": 1.0, "inclination": 60.0, "iron": 0.0, "threshold": 0.004}
    # dE/d(angle) = cos(inclination) times the axis's part to the east, from derivations.sensitivity
    belt = state["threshold"] / (np.cos(np.radians(60)) * np.radians(1.0))
    assert ValidationDemo(**state).readouts()["missed"] == pytest.approx(100 * belt, abs=1.5)


def test_roll_is_seen_to_the_east_and_not_to_the_north(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ValidationDemo(heading=0), ValidationDemo(heading=90)))
    expect(output(page, "meaning").nth(0)).to_contain_text("to this direction it is blind")
    expect(output(page, "meaning").nth(1)).to_contain_text("it sees this error")


def test_iron_raises_an_alarm_although_the_angles_are_right(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ValidationDemo(error=0, iron=-0.37)))
    expect(output(page, "meaning")).to_contain_text("the magnetometer lies")
    expect(output(page, "false_alarms")).to_have_text("100")


def test_what_is_rarely_moved_is_folded_away_while_it_is_as_usual(
    visit: Visit, page_of: PageOf
) -> None:
    address = page_of(ValidationDemo())
    page = visit(address)
    (first, *_) = FOLDED[ValidationDemo]
    expect(slider(page, first)).not_to_be_visible()
    for state, seen in (("iron=0.1", True), ("heading=90", False), ("inclination=-20", True)):
        page.goto(f"{address}#validation?{state}")
        expect(slider(page, first)).to_be_visible(visible=seen)


def test_text_has_the_state_and_the_numbers() -> None:
    text = ValidationDemo(heading=90).fallback()
    factor = expected(ValidationDemo(heading=90).state())["factor"]
    assert "off by 10° about the axis 0° from the nose" in text
    assert f"E is {round(factor, 3)}, the vertical is off by 10°" in text
