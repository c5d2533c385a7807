"""The demo of the frames: the wind's components are Python's, in either order of the turns."""

import numpy as np
import pytest
from playwright.sync_api import expect
from traitlets import TraitError

import chr_notes
from chr_notes.demos import FramesDemo

from .parts import PageOf, Visit, check_readouts, output, random_states

STEPS = dict.fromkeys(FramesDemo.controls, 1.0) | {"frame": 0.25}


def expected(state: dict[str, float]) -> dict[str, float | list[float]]:
    wind = [np.cos(np.radians(state["wind"])), np.sin(np.radians(state["wind"])), 0]
    both = []
    for order in (("yaw", "pitch", "roll"), ("pitch", "yaw", "roll")):
        matrix = np.eye(3)
        for turn, name in enumerate(order):
            angle = np.clip(state["frame"] - turn, 0, 1) * np.radians(state[name])
            angles = [angle if each == name else 0 for each in ("roll", "pitch", "yaw")]
            matrix = chr_notes.matrix_from_euler(angles) @ matrix
        both.append(matrix)
    noses = [matrix[0] for matrix in both]
    apart = np.arctan2(np.linalg.norm(np.cross(*noses)), np.dot(*noses))
    return {
        "components": (both[0] @ wind).tolist(),
        "other_order": (both[1] @ wind).tolist(),
        "apart": float(np.degrees(apart)),
    }


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    states = random_states(FramesDemo, STEPS, seed=11)
    names = FramesDemo.controls
    extremes = [[0, 0, 0, 0, 0, 0], [3, 2, 180, 90, -180, 180], [3, 1, -180, -90, 33, -90]]
    states += [dict(zip(names, row, strict=True)) for row in extremes]
    check_readouts(visit(page_of(FramesDemo())), states, expected)
    for state in states:
        found = FramesDemo(**state).readouts()
        for name, value in expected(state).items():
            np.testing.assert_allclose(found[name], value, atol=1e-12)


def test_the_lit_row_is_the_one_that_makes_the_component(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(FramesDemo(yaw=40, pitch=0, roll=0, frame=1, axis=1)))
    lit = page.locator(".chr-lit").locator("th, td").all_text_contents()
    assert lit == ["▸ y", "−0.643", "0.766", "0.000", "−0.643"]
    expect(output(page, "meaning")).to_contain_text(
        "−0.643 · 1.000 + 0.766 · 0.000 + 0.000 · 0.000 = −0.643"
    )


def test_an_axis_between_two_is_refused() -> None:
    with pytest.raises(TraitError):
        FramesDemo(axis=0.5)


def test_text_has_the_state_and_the_numbers() -> None:
    text = FramesDemo(yaw=40, pitch=0, roll=0, frame=1).fallback()
    assert (
        "After 1 of the three turns, along the axes of the frame, "
        "the wind is (0.766, −0.643, 0.000)" in text
    )
    assert "with pitch before yaw it would be (1.000, 0.000, 0.000)" in text
