"""Calibration from data, simulated and recorded."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from chr_notes import (
    RateGyroCalibration,
    ThreeAxisCalibration,
    fit_accelerometer,
    fit_gyro_bias,
    static_interval,
)

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
UPRIGHT = np.stack([np.eye(3), -np.eye(3)], axis=1).reshape(6, 3)  # x up, x down, y up, ...


def recorded(recordings: Path, file: str) -> Floats:
    return np.loadtxt(recordings / file, delimiter=",", skiprows=1)


@given(seeds, st.floats(1.0, 20.0))
def test_six_positions_give_the_model(seed: int, gravity: float) -> None:
    generator = np.random.default_rng(seed)
    misalignment = np.eye(3) + generator.uniform(-0.1, 0.1, (3, 3))
    np.fill_diagonal(misalignment, 1.0)
    sensitivity = generator.uniform(0.5, 2000.0) * generator.uniform(0.8, 1.2, 3)
    bias = generator.normal(size=3)
    sensor = ThreeAxisCalibration(misalignment, sensitivity, bias)
    found = fit_accelerometer(sensor.measure(gravity * UPRIGHT), gravity)
    assert_allclose(found.misalignment, misalignment, atol=1e-9)
    assert_allclose(found.sensitivity[0], sensitivity, rtol=1e-9)
    assert_allclose(found.bias[0], bias, atol=1e-8)


def test_a_recorded_session_of_six_positions(recordings: Path) -> None:
    session = recorded(recordings, "imucal_ferraris_session.csv")[:, 4:]
    listed = json.loads((recordings / "imucal_ferraris_session_list.json").read_text())
    stretches = [listed[name] for name in ("x_p", "x_a", "y_p", "y_a", "z_p", "z_a")]
    readings = np.array([session[s["start"] : s["end"]].mean(axis=0) for s in stretches])
    before = np.linalg.norm(readings, axis=1) / 9.81
    after = np.linalg.norm(fit_accelerometer(readings, 9.81).correct(readings), axis=1) / 9.81
    assert np.abs(before - 1).max() > 0.05
    assert np.abs(after - 1).max() < 0.001


POSITIONS = 9.81 * UPRIGHT
REFUSED_POSITIONS = {
    "five": (POSITIONS[:5], 9.81, r"readings: expected shape \(\.\.\., 6, 3\), got \(5, 3\)"),
    "sessions": (
        POSITIONS[np.newaxis],
        9.81,
        r"readings: expected shape \(6, 3\), got \(1, 6, 3\)",
    ),
    "NaN": (
        np.where(UPRIGHT == -1, np.nan, POSITIONS),
        9.81,
        r"readings: expected numbers, got NaN or infinity in position -x",
    ),
    "no gravity": (POSITIONS, 0.0, r"gravity: expected a positive number, got 0\.0"),
    "gravity without end": (POSITIONS, np.inf, "gravity: expected a positive number, got inf"),
    "gravity by axis": (POSITIONS, np.ones(3), r"gravity: expected a number, got shape \(3,\)"),
    "all the same": (np.ones((6, 3)), 9.81, "the x-axis to change most between x up and x down"),
    "another order": (
        POSITIONS[[0, 1, 4, 5, 2, 3]],
        9.81,
        r"y-axis to change most between y up and y down, got a change of 0 there and of 19\.62",
    ),
}


@pytest.mark.parametrize(
    ("readings", "gravity", "message"), REFUSED_POSITIONS.values(), ids=REFUSED_POSITIONS
)
def test_positions_that_tell_nothing_are_refused(
    readings: Floats, gravity: float, message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        fit_accelerometer(readings, gravity)


def test_bias_is_the_mean_of_what_is_there() -> None:
    rates = np.random.default_rng(0).normal([0.1, -0.2, 0.3], 0.001, (1000, 3))
    holed = np.insert(rates, [10, 500], np.nan, axis=0)
    assert_allclose(fit_gyro_bias(holed), -rates.mean(axis=0))


def test_the_bias_of_the_model_follows_from_the_reading_at_rest() -> None:
    generator = np.random.default_rng(3)
    misalignment, coupling = np.eye(3) + generator.normal(0, 0.1, (3, 3)), generator.normal(size=9)
    bias, force = generator.normal(0, 0.01, 3), np.array([1.0, -2.0, -9.0])
    gyro = RateGyroCalibration(misalignment, np.ones(3), bias, coupling.reshape(3, 3) / 1000)
    at_rest = gyro.measure(np.zeros(3), force)
    assert_allclose(gyro.g_sensitivity @ force - np.linalg.solve(misalignment, at_rest), bias)
    plain = RateGyroCalibration(np.eye(3), np.ones(3), bias, np.zeros((3, 3)))
    assert_allclose(fit_gyro_bias([plain.measure(np.zeros(3), force)] * 10), bias)


def test_bias_of_a_recording_at_rest(recordings: Path) -> None:
    rates = np.radians(recorded(recordings, "mpu6050_static_449s_raw.csv")[:, 4:] / 131)
    error = fit_gyro_bias(rates) + rates.mean(axis=0)
    assert np.abs(np.degrees(error)).max() < 0.002
    # Half of the samples tell the mean of the other half, and holes do no harm.
    half = np.where(np.arange(len(rates))[:, np.newaxis] % 2, rates, np.nan)
    error = fit_gyro_bias(half) + rates[::2].mean(axis=0)
    assert 0 < np.abs(np.degrees(error)).max() < 0.002
    # The bias drifts by more than that even at rest: two minutes know only their own.
    error = fit_gyro_bias(rates[static_interval(rates, 12_000)]) + rates.mean(axis=0)
    assert 0.002 < np.abs(np.degrees(error)).max() < 0.01


def test_glitches_leave_the_bias_as_it_is() -> None:
    rates = np.random.default_rng(4).normal([0.1, -0.2, 0.3], 0.001, (1000, 3))
    expected = fit_gyro_bias(rates)
    rates[[0, 300, 301, 999], [0, 1, 1, 2]] = [1e7, -5.0, -4.0, 1e11]
    assert_allclose(fit_gyro_bias(rates), expected, atol=1e-5)


def test_a_gyro_that_moves_or_is_silent_has_no_bias_to_find() -> None:
    time = np.linspace(0, 10, 500)[:, np.newaxis]
    with pytest.raises(
        ValueError,
        match=r"a standard deviation of at most 0\.02 rad/s, got 0\.666 rad/s about the y-axis",
    ):
        fit_gyro_bias(np.sin(time) * [0.0, 1.0, 0.5])
    with pytest.raises(ValueError, match="at least one row without NaN, got none"):
        fit_gyro_bias(np.full((5, 3), np.nan))
    with pytest.raises(ValueError, match=r"body_rates: expected shape \(N, 3\), got \(3,\)"):
        fit_gyro_bias(np.zeros(3))
