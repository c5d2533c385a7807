"""Tilt from an accelerometer at rest."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import chr_notes
from chr_notes import tilt_from_accelerometer

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
roll_angles = st.floats(-np.pi, np.pi)
off_the_pole = st.floats(-1.55, 1.55)
LEVEL = np.array([0.0, 0.0, -9.80665])
PERIOD = 0.01


@given(roll_angles, off_the_pole, st.floats(-10, 10), st.floats(1e-3, 1e3))
def test_tilt_undoes_the_reading_at_rest(
    roll: float, pitch: float, yaw: float, gravity: float
) -> None:
    reading = chr_notes.accelerometer_at_rest([roll, pitch, yaw], gravity)
    found = tilt_from_accelerometer(reading)
    assert_allclose(np.exp(1j * found), np.exp(1j * np.array([roll, pitch])), atol=1e-9)


@given(seeds, st.floats(1e-300, 1e300))
def test_the_scale_of_the_reading_does_not_matter(seed: int, scale: float) -> None:
    reading = np.random.default_rng(seed).normal(size=3)
    one, other = tilt_from_accelerometer(reading), tilt_from_accelerometer(scale * reading)
    assert_allclose(other, one, rtol=1e-13, atol=1e-13)


def test_the_scale_of_the_reading_costs_no_digit() -> None:
    reading = np.array([3.7, -2.1, 1.3])
    expected = tilt_from_accelerometer(reading)
    # A power of two scales exactly, as long as no number becomes a denormal one.
    for power in range(-1020, 1021, 7):
        found = tilt_from_accelerometer(np.ldexp(reading, power))
        assert_allclose(found, expected, rtol=1e-15)


@pytest.mark.parametrize(
    ("reading", "roll_deg", "pitch_deg"),
    [
        ([0.0, 0.0, -1.0], 0, 0),
        ([0.0, 0.0, 1.0], 180, 0),
        ([-0.0, -0.0, 1.0], 180, 0),
        ([0.0, 5e-324, 1.0], 180, 0),
        ([0.0, -1.0, 0.0], 90, 0),
        ([0.0, 1.0, 0.0], -90, 0),
        ([1.0, 0.0, 0.0], 0, 90),
        ([-1.0, -0.0, -0.0], 0, -90),
        ([1.0, 0.0, 1.0], 180, 45),
        ([2.0, -1.0, -1.0], 45, np.degrees(np.arctan(np.sqrt(2)))),
        ([2.0, 1.0, 1.0], -135, np.degrees(np.arctan(np.sqrt(2)))),
    ],
)
def test_tilt_in_all_quadrants_and_beyond_one_g(
    reading: list[float], roll_deg: float, pitch_deg: float
) -> None:
    found = tilt_from_accelerometer(reading)
    assert_allclose(np.degrees(found), [roll_deg, pitch_deg], atol=1e-12)


@given(st.lists(st.floats(-2, 2), min_size=3, max_size=3).filter(any))
def test_tilt_stays_in_its_range(reading: list[float]) -> None:
    roll, pitch = tilt_from_accelerometer(reading)
    assert -np.pi < roll <= np.pi
    assert -np.pi / 2 <= pitch <= np.pi / 2


def test_a_reading_of_zero_shows_no_tilt() -> None:
    readings = np.array(
        [LEVEL, [0.0, 0.0, 0.0], [np.nan, 1.0, 1.0], [np.nan, 0, 0], [np.inf, 0, 0], LEVEL]
    )
    shown = np.isfinite(tilt_from_accelerometer(readings))
    assert_array_equal(shown, np.outer([True, *[False] * 4, True], [True, True]))


REFUSED = {
    "tilt from a pair": (
        lambda: tilt_from_accelerometer([1.0, 2.0]),
        r"accel: expected shape \(\.\.\., 3\), got \(2,\)",
    ),
    "gravities that do not fit": (
        lambda: chr_notes.accelerometer_at_rest(np.zeros((2, 3)), np.ones(3)),
        r"expected euler and gravity with leading axes that broadcast",
    ),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()
