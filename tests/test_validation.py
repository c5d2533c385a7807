"""Heading and the factor E."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

import chr_notes
from chr_notes import heading_from_magnetometer, validation_factor

seeds = st.integers(0, 2**32 - 1)
angles = st.floats(-np.pi, np.pi)
pitches = st.floats(-1.5, 1.5)
FIELD = np.array([20.0, 3.0, 45.0])
DOWN = FIELD[2] / np.linalg.norm(FIELD)


@given(angles, pitches, angles, st.floats(1e-200, 1e200))
def test_heading_undoes_the_field_in_the_body(
    roll: float, pitch: float, yaw: float, scale: float
) -> None:
    mag = scale * (chr_notes.matrix_from_euler([roll, pitch, yaw]) @ FIELD)
    found = heading_from_magnetometer(mag, [roll, pitch], FIELD[:2])
    assert_allclose(np.exp(1j * found), np.exp(1j * yaw), atol=1e-12)


@given(angles, pitches, angles, st.floats(-3, 3))
def test_turning_the_world_about_the_vertical_turns_the_heading(
    roll: float, pitch: float, yaw: float, turn: float
) -> None:
    one, other = (
        heading_from_magnetometer(
            chr_notes.matrix_from_euler([roll, pitch, angle]) @ FIELD, [roll, pitch]
        )
        for angle in (yaw, yaw + turn)
    )
    assert_allclose(np.exp(1j * (other - one)), np.exp(1j * turn), atol=1e-12)


@pytest.mark.parametrize(
    ("mag", "heading_deg"),
    [([1, 0, 2], 0), ([0, -1, 2], 90), ([-1, 0.0, 2], 180), ([0, 1, 2], -90), ([1, -1, 2], 45)],
)
def test_heading_level_in_all_quadrants(mag: list[float], heading_deg: float) -> None:
    found = np.degrees(heading_from_magnetometer(mag, [0.0, 0.0]))
    assert_allclose((found - heading_deg + 180) % 360, 180, atol=1e-12)


def test_heading_upside_down() -> None:
    assert_allclose(heading_from_magnetometer([1.0, 0.0, -2.0], [np.pi, 0.0]), 0, atol=1e-12)
    assert_allclose(heading_from_magnetometer([0.0, 1.0, -2.0], [np.pi, 0.0]), np.pi / 2)


def test_declination_is_an_angle_of_the_reference() -> None:
    reference = [np.cos(0.1), np.sin(0.1)]
    assert_allclose(heading_from_magnetometer([1.0, 0, 2], [0.0, 0.0], reference), 0.1)


@given(angles, pitches, angles, st.floats(1e-200, 1e200))
def test_the_factor_is_zero_for_exact_angles(
    roll: float, pitch: float, yaw: float, scale: float
) -> None:
    mag = scale * (chr_notes.matrix_from_euler([roll, pitch, yaw]) @ FIELD)
    assert_allclose(validation_factor(mag, [roll, pitch], DOWN), 0, atol=1e-12)


@given(seeds)
def test_the_factor_is_what_is_left_of_the_part_down(seed: int) -> None:
    generator = np.random.default_rng(seed)
    mag, tilt = generator.normal(size=3), generator.uniform(-1.5, 1.5, 2)
    upright = chr_notes.matrix_from_euler([*tilt, 0.0]).T @ mag
    expected = abs(0.3 - upright[2] / np.linalg.norm(mag))
    assert_allclose(validation_factor(mag, tilt, 0.3), expected, atol=1e-12)


@pytest.mark.parametrize("down", [1.0, -1.0])
def test_above_a_magnetic_pole_the_field_is_upright(down: float) -> None:
    assert validation_factor([0.0, 0.0, 50 * down], [0.0, 0.0], down) == 0
    assert_allclose(validation_factor([0.0, 0.0, -50 * down], [0.0, 0.0], down), 2)


def test_a_field_of_zero_tells_nothing_and_nan_stays_in_its_row() -> None:
    mag = np.array([[1.0, 0, 1], [0, 0, 0], [np.nan, 0, 1], [1, 0, 1]])
    tilt = np.zeros((4, 2))
    assert np.isnan(heading_from_magnetometer(mag, tilt)).tolist() == [False, True, True, False]
    assert np.isnan(validation_factor(mag, tilt, 0.5)).tolist() == [False, True, True, False]


@pytest.mark.parametrize("exponent", [-1030, -600, 600, 1020])
def test_the_factor_of_the_weakest_and_strongest_field_is_that_of_any(exponent: int) -> None:
    mag, tilt = np.array([1.0, 0.5, 2.0]), [0.3, -0.2]
    expected = validation_factor(mag, tilt, 0.5)
    mags = np.stack([np.ldexp(mag, exponent), np.full(3, np.nan)])
    assert_allclose(validation_factor(mags[0], tilt, 0.5), expected, rtol=1e-15)
    assert_allclose(validation_factor(mags, tilt, 0.5), np.array([expected, np.nan]), rtol=1e-15)


def test_arguments_broadcast() -> None:
    assert heading_from_magnetometer(np.ones((4, 1, 3)), np.zeros((5, 2))).shape == (4, 5)
    assert validation_factor(np.ones((4, 1, 3)), np.zeros((5, 2)), np.zeros(5)).shape == (4, 5)


REFUSED = {
    "shape of the field": (
        lambda: heading_from_magnetometer([1.0, 2.0], [0, 0]),
        r"mag: expected shape \(\.\.\., 3\), got \(2,\)",
    ),
    "yaw in the tilt": (
        lambda: validation_factor([1.0, 0, 0], [0, 0, 0], 0.5),
        r"tilt: expected shape \(\.\.\., 2\), got \(3,\)",
    ),
    "a whole field for a reference": (
        lambda: heading_from_magnetometer([1.0, 0, 0], [0, 0], FIELD),
        r"reference: expected shape \(\.\.\., 2\), got \(3,\)",
    ),
    "no horizontal field": (
        lambda: heading_from_magnetometer([1.0, 0, 0], [0, 0], (0.0, 0.0)),
        "reference: expected a horizontal field, got none",
    ),
    "no horizontal field in one of many": (
        lambda: heading_from_magnetometer([1.0, 0, 0], [0, 0], [[1.0, 0.0], [0.0, 0.0]]),
        r"reference: expected a horizontal field, got none at index \(1,\)",
    ),
    "a part down in microtesla": (
        lambda: validation_factor([1.0, 0, 0], [0, 0], 45.0),
        r"reference_down: expected the part down of a field of magnitude 1, .* got 45\.0",
    ),
    "shapes that do not fit": (
        lambda: validation_factor(np.ones((2, 3)), np.ones((3, 2)), 0.5),
        "expected mag and tilt with leading axes that broadcast",
    ),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()
