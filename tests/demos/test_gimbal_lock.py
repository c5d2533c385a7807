"""The gimbal-lock demo: its readouts are Python's numbers, at the lock as well."""

import math
import re

import numpy as np
import pytest
from playwright.sync_api import expect

import chr_notes
from chr_notes.demos import GimbalLockDemo
from chr_notes.demos.base import formatted

from .parts import SET_AND_READ, PageOf, Visit, drawn, output, picture, slider

# ── in Python ──────────────────────────────────────────────────────────────────────────────────


def test_text_has_the_state_and_the_numbers() -> None:
    text = GimbalLockDemo(yaw=-30.5, pitch=60, roll=20).fallback()
    assert "yaw −30.5°, pitch 60°, roll 20°" in text
    assert "Determinant of D: 2." in text
    assert "Condition number of D: 3.732." in text


def test_at_the_lock_the_numbers_have_no_bound() -> None:
    for pitch in (-90, 90):
        assert GimbalLockDemo(pitch=pitch).fallback().count("∞") == 2


def test_aircraft_stands_still_where_the_readout_says_so() -> None:
    for pitch, roll in ((90, 40), (-90, -40)):
        before = chr_notes.matrix_from_euler(np.radians([0, pitch, 0]))
        after = chr_notes.matrix_from_euler(np.radians([roll, pitch, 40]))
        np.testing.assert_allclose(after, before, atol=1e-15)


# ── in the browser ─────────────────────────────────────────────────────────────────────────────


def test_determinant_at_60_degrees_is_2(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    slider(page, "pitch").fill("60")
    expect(output(page, "determinant")).to_have_text("2")
    expect(output(page, "condition")).to_have_text("3.732")


def entries(text: str) -> list[float]:
    return [float(entry) for entry in text.replace("−", "-").split()]


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    random = np.random.default_rng(2)
    low, high = [-180, -89, -180], [180, 89, 180]
    attitudes = random.integers(low, high, size=(50, 3), endpoint=True)
    attitudes = np.vstack([attitudes, [[-71, 90, 33], [10, -90, 20], [0, 0, 0], [180, 89, -180]]])
    states = [dict(zip(("roll", "pitch", "yaw"), row, strict=True)) for row in attitudes.tolist()]
    shown = page.evaluate(SET_AND_READ, states)
    for attitude, (_, texts) in zip(attitudes, shown, strict=True):
        euler = np.radians(attitude)
        roll_axis = chr_notes.matrix_from_euler(euler)[0]
        apart = math.degrees(math.atan2(math.hypot(*roll_axis[:2]), abs(roll_axis[2])))
        fastest = np.linalg.norm(chr_notes.euler_rates_matrix(euler)[2])
        rates = chr_notes.euler_rates_matrix(euler)
        assert texts["determinant"] == formatted(np.linalg.det(rates))
        assert texts["condition"] == formatted(np.linalg.cond(rates, 2))
        numbers = re.findall(r"\d+(?:\.\d+)?", texts["rings"])
        locked = abs(attitude[1]) == 90
        assert numbers == ([] if locked else [formatted(apart), formatted(fastest)])
        matrix = chr_notes.matrix_from_euler(euler).round(3)
        assert entries(texts["matrix"]) == matrix.ravel().tolist()
        assert texts["matrix"].count("\n") == 2
        quaternion = chr_notes.quaternion_from_euler(euler).round(3)
        assert entries(texts["quaternion"]) == quaternion.tolist()


@pytest.mark.parametrize(("pitch", "sense"), [(90, "opposite senses"), (-90, "same sense")])
def test_lock_is_named_at_exactly_90_degrees(
    visit: Visit, page_of: PageOf, pitch: int, sense: str
) -> None:
    page = visit(page_of(GimbalLockDemo(yaw=33, pitch=pitch, roll=-71)))
    expect(output(page, "determinant")).to_have_text("∞")
    expect(output(page, "condition")).to_have_text("∞")
    expect(output(page, "rings")).to_contain_text(
        "Gimbal lock. Yaw and roll turn the aircraft about the same axis"
    )
    expect(output(page, "rings")).to_contain_text(sense)
    attitude = np.radians([-71, pitch, 33])
    matrix = entries(str(output(page, "matrix").text_content()))
    np.testing.assert_allclose(
        np.reshape(matrix, (3, 3)), chr_notes.matrix_from_euler(attitude), atol=5.1e-4
    )
    quaternion = entries(str(output(page, "quaternion").text_content()))
    np.testing.assert_allclose(quaternion, chr_notes.quaternion_from_euler(attitude), atol=5.1e-4)
    assert "−0.000" not in str(output(page, "matrix").text_content())


def test_letters_of_the_compass_stand_in_front(visit: Visit, page_of: PageOf) -> None:
    painted = [text for text, _ in drawn(visit(page_of(GimbalLockDemo(yaw=30, pitch=60))))]
    words = ["N", "E", "S", "W", "z yaw", "y pitch", "x roll"]
    last_area = max(i for i, text in enumerate(painted) if text == "")
    assert [text for text in painted[last_area:] if text != ""] == words


def test_in_the_story_the_aircraft_stands_still_at_the_lock(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()), reduced_motion="reduce")
    attitudes = {}
    page.get_by_role("button", name="Show me, step by step").click()
    while page.get_by_role("button", name="Next step").count() > 0:
        page.get_by_role("button", name="Next step").click()
        if slider(page, "pitch").input_value() == "90":
            attitudes[picture(page)] = output(page, "matrix").text_content()
    assert len(attitudes) == 2
    assert len(set(attitudes.values())) == 1


@pytest.mark.parametrize("width", [320, 390, 640, 774])
def test_matrix_and_quaternion_keep_apart(visit: Visit, page_of: PageOf, width: int) -> None:
    page = visit(page_of(GimbalLockDemo(yaw=30, pitch=75, roll=20)), width=width)
    matrix = output(page, "matrix").bounding_box()
    quaternion = output(page, "quaternion").bounding_box()
    assert matrix is not None
    assert quaternion is not None
    assert matrix["x"] + matrix["width"] + 8 <= quaternion["x"]
