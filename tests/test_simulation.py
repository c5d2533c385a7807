"""Motions and ideal readings."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes.simulation import (
    Curve,
    at_rest,
    ideal_readings,
    minimum_jerk,
    swing,
    trajectory,
)

from .sampling import few

seeds = st.integers(0, 2**32 - 1)
TIME = np.linspace(0, 4, 4001)
STOPS = [0.5, 1.5, 2.0, 3.5]
VALUES = [[0, 0, 0], [1, -2, 3], [1, -2, 3], [0, 5, -1]]
CURVES = {
    "swing": swing(TIME, [1, 2, 3], [0.5, 0.3, 0.7], [0.1, 0.2, 0.3], offset=1.0, slope=[0, 1, 2]),
    "minimum jerk": minimum_jerk(TIME, STOPS, VALUES),
    "at rest": at_rest(TIME, [1.0, 2.0, 3.0]),
}


@pytest.mark.parametrize("curve", CURVES.values(), ids=CURVES)
def test_derivatives_are_those_of_the_curve(curve: Curve) -> None:
    spline = CubicSpline(TIME, curve.value)
    # The third derivative of a minimum-jerk leg jumps at its ends.
    assert_allclose(spline(TIME, 1), curve.first, atol=2e-4)
    assert_allclose(spline(TIME, 2)[5:-5], curve.second[5:-5], atol=0.5)
    assert_allclose(np.diff(curve.first, axis=0) / 0.001, curve.second[:-1], atol=0.5)


def test_a_swing_is_a_sine_on_a_line() -> None:
    curve = swing([0.0, 1.0], 2.0, 0.25, offset=1.0, slope=3.0)
    assert_allclose(curve.value, [[1, 1, 1], [6, 6, 6]])
    assert_allclose(curve.first[0], 3 + np.pi)


def test_stops_are_reached_at_rest() -> None:
    curve = minimum_jerk(STOPS, STOPS, VALUES)
    assert_allclose(curve.value, VALUES, atol=1e-12)
    assert_allclose(curve.first, 0, atol=1e-12)
    assert_allclose(curve.second, 0, atol=1e-12)
    outside = minimum_jerk([-1.0, 9.0], STOPS, VALUES)
    assert_allclose(outside.value, [VALUES[0], VALUES[-1]])
    assert_array_equal(outside.first, 0)
    assert_array_equal(outside.second, 0)


def test_half_way_is_half_the_way() -> None:
    assert_allclose(minimum_jerk([1.0], STOPS, VALUES).value, [[0.5, -1, 1.5]])


@given(seeds)
@few(10)
def test_gyros_read_how_the_attitude_turns(seed: int) -> None:
    generator = np.random.default_rng(seed)
    step = 1e-5
    time = np.sort(generator.uniform(0, 10, 20))
    amplitude, frequency = generator.uniform(-2, 2, 3), generator.uniform(0, 1, 3)
    before, after = (
        Rotation.from_matrix(
            np.swapaxes(
                chr_notes.matrix_from_euler(swing(time + shift, amplitude, frequency).value), 1, 2
            )
        )
        for shift in (-step, step)
    )
    turned = (before.inv() * after).as_rotvec() / (2 * step)
    motion = trajectory(time, swing(time, amplitude, frequency), at_rest(time))
    assert_allclose(motion.body_rates, turned, atol=1e-6)


def test_ideal_sensors_read_what_the_library_says() -> None:
    attitude = swing(TIME, [0.5, 0.4, 1.0], [0.5, 0.3, 0.7])
    truth = trajectory(TIME, attitude, minimum_jerk(TIME, STOPS, VALUES))
    ideal = ideal_readings(truth, (20.0, 5.0, 45.0), gravity=9.8)
    assert_array_equal(ideal.body_rates, truth.body_rates)
    found = chr_notes.inertial_acceleration(ideal.accel, truth.euler, 9.8)
    assert_allclose(found, truth.acceleration, atol=1e-12)
    heading = chr_notes.heading_from_magnetometer(ideal.mag, truth.euler[:, :2], (20.0, 5.0))
    assert_allclose(heading, truth.euler[:, 2], atol=1e-12)


def test_the_field_may_change_with_time() -> None:
    field = np.random.default_rng(0).normal(size=(len(TIME), 3))
    truth = trajectory(TIME, at_rest(TIME), at_rest(TIME))
    assert_allclose(ideal_readings(truth, field).mag, field)


STILL = at_rest(TIME)
REFUSED = {
    "values that move at rest": (
        lambda: at_rest([0.0, 1.0], [[0, 0, 0], [1, 1, 1]]),
        r"value: expected shape \(3,\), got \(2, 3\)",
    ),
    "a curve of other times": (
        lambda: trajectory(TIME, STILL, at_rest(TIME[1:])),
        "expected as many rows in each of time, attitude, motion, got 4001, 4001, 4000",
    ),
    "a field of other times": (
        lambda: ideal_readings(trajectory(TIME, STILL, STILL), np.ones((5, 3))),
        r"field: expected shape \(3,\) or \(4001, 3\), got \(5, 3\)",
    ),
    "times of two axes": (
        lambda: at_rest(np.zeros((2, 2))),
        r"time: expected shape \(N,\), got \(2, 2\)",
    ),
    "times that fall": (
        lambda: swing([0.0, 1.0, 0.5], 1.0, 1.0),
        r"time: expected rising times, got \[1\.0, 0\.5\] at 1",
    ),
    "two amplitudes": (
        lambda: swing(TIME, [1.0, 2.0], 1.0),
        r"amplitude: expected a number or shape \(3,\), got \(2,\)",
    ),
    "one stop": (
        lambda: minimum_jerk(TIME, [1.0], [[0, 0, 0]]),
        r"expected stops of shape \(K,\), K at least 2, .* got \(1,\) and \(1, 3\)",
    ),
    "more stops than values": (
        lambda: minimum_jerk(TIME, STOPS, VALUES[:3]),
        r"values of shape \(K, 3\), got \(4,\) and \(3, 3\)",
    ),
    "stops that fall": (
        lambda: minimum_jerk(TIME, [1.0, 0.0], VALUES[:2]),
        r"stops: expected rising times, got \[1\.0, 0\.0\]",
    ),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()
