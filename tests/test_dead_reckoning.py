"""Velocity and position from an accelerometer."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

import chr_notes
from chr_notes import (
    UnitWarning,
    accelerometer_from_acceleration,
    dead_reckon,
    drift_from_tilt_error,
    inertial_acceleration,
)
from chr_notes.derivations import dead_reckoning as derived
from chr_notes.simulation import ideal_readings, minimum_jerk, swing, trajectory
from chr_notes.symbols import T

from .sampling import few

seeds = st.integers(0, 2**32 - 1)
G = chr_notes.STANDARD_GRAVITY


@given(seeds, st.floats(0.1, 20.0))
def test_reading_and_acceleration_undo_each_other(seed: int, gravity: float) -> None:
    generator = np.random.default_rng(seed)
    acceleration = generator.normal(size=(4, 3))
    euler = generator.uniform(-4, 4, (4, 3))
    reading = accelerometer_from_acceleration(acceleration, euler, gravity)
    assert_allclose(inertial_acceleration(reading, euler, gravity), acceleration, atol=1e-12)
    matrix = chr_notes.matrix_from_euler(euler)
    expected = np.einsum("nij,nj->ni", matrix, acceleration - np.array([0, 0, gravity]))
    assert_allclose(reading, expected, atol=1e-12)


def test_at_rest_there_is_no_acceleration_and_in_free_fall_one_g() -> None:
    euler = [0.3, -0.4, 2.0]
    at_rest = chr_notes.accelerometer_at_rest(euler)
    assert_allclose(inertial_acceleration(at_rest, euler), 0, atol=1e-14)
    assert_allclose(inertial_acceleration([0, 0, 0], euler), [0, 0, G])


@given(seeds)
@few(20)
def test_steps_are_those_of_the_notes(seed: int) -> None:
    generator = np.random.default_rng(seed)
    forces, euler = generator.normal(size=(2, 12, 3))
    steps = generator.uniform(0, 0.1, 12)
    velocity, position = generator.normal(size=(2, 3))
    found = dead_reckon(forces, euler, steps, velocity=velocity, position=position)
    for k, acceleration in enumerate(inertial_acceleration(forces, euler)):
        # The position goes on by the velocity before the step.
        velocity, position = velocity + steps[k] * acceleration, position + steps[k] * velocity
        assert_allclose(found[0][k], velocity, atol=1e-12)
        assert_allclose(found[1][k], position, atol=1e-12)


def test_a_known_motion_is_followed_to_the_step() -> None:
    errors = []
    for count in (500, 1000, 2000):
        time = np.linspace(0, 5, count + 1)
        motion = minimum_jerk(time, [0, 2, 5], [[0, 0, 0], [3, -1, 0.5], [4, 4, 0]])
        truth = trajectory(time, swing(time, [0.3, 0.2, 0.5], [0.5, 0.3, 0.2]), motion)
        ideal = ideal_readings(truth)
        _, position = dead_reckon(ideal.accel[:-1], truth.euler[:-1], 5 / count)
        off = np.linalg.norm(position - truth.position[1:], axis=1)
        errors.append(off.max())
    assert_allclose(np.array(errors[:-1]) / errors[1:], 2.0, rtol=0.1)
    assert errors[-1] < 0.01


def test_rows_with_nan_are_held_out() -> None:
    forces = np.tile(accelerometer_from_acceleration([1.0, 0, 0], [0, 0, 0]), (6, 1))
    euler = np.zeros((6, 3))
    forces[2, 1], euler[4, 0] = np.nan, np.nan
    velocity, position = dead_reckon(forces, euler, 1.0)
    assert_allclose(velocity[:, 0], [1, 2, np.nan, 3, np.nan, 4])
    assert_allclose(position[:, 0], [0, 1, np.nan, 5, np.nan, 11])


@pytest.mark.parametrize("wild", [np.inf, -np.inf, np.nan])
def test_a_reading_without_end_is_held_out(wild: float) -> None:
    euler = np.tile([0.3, -0.4, 2.0], (5, 1))
    forces = accelerometer_from_acceleration(np.tile([1.0, 0, 0], (5, 1)), euler)
    forces[2, 1] = wild
    velocity, position = dead_reckon(forces, euler, 1.0)
    assert np.isnan(velocity[2]).all()
    assert np.isnan(position[2]).all()
    assert_allclose(np.delete(velocity, 2, axis=0)[:, 0], [1, 2, 3, 4])


def test_steps_sum_up_as_derived() -> None:
    forces = np.tile(accelerometer_from_acceleration([0.5, 0, 0], [0, 0, 0]), (40, 1))
    velocity, position = dead_reckon(forces, np.zeros((40, 3)), 0.1)
    known = {derived.n: 40, derived.a: 0.5, T: 0.1}
    assert_allclose(velocity[-1, 0], float(derived.velocity_by_steps().subs(known)))
    assert_allclose(position[-1, 0], float(derived.position_by_steps().subs(known)))


@pytest.mark.parametrize("unit", [1 / G, 16384 / G])
def test_readings_in_another_unit_are_noticed(unit: float) -> None:
    still = np.tile([0.0, 0.0, -G], (3000, 1))
    with pytest.warns(UnitWarning, match=r"about 9\.807, .* got mostly .*: are they in g"):
        dead_reckon(unit * still, 0 * still, 0.01)
    dead_reckon(unit * still, 0 * still, 0.01, gravity=unit * G)


# What is refused

N3 = np.zeros((5, 3))
REFUSED = {
    "one reading": (
        lambda: dead_reckon(np.zeros(3), N3, 0.1),
        r"accel: expected shape \(N, 3\), got \(3,\)",
    ),
    "attitudes of another length": (
        lambda: dead_reckon(N3, N3[:4], 0.1),
        "expected as many rows in each of accel, euler, got 5, 4",
    ),
    "steps of another length": (
        lambda: dead_reckon(N3, N3, [0.1, 0.1]),
        r"dt: expected a number or shape \(5,\), got \(2,\)",
    ),
    "velocity of NaN": (
        lambda: dead_reckon(N3, N3, 0.1, velocity=(0, np.nan, 0)),
        r"velocity: expected three finite numbers, got \[0\.0, nan, 0\.0\]",
    ),
    "many gravities": (
        lambda: dead_reckon(N3, N3, 0.1, gravity=np.ones((2, 1))),  # type: ignore[arg-type]
        r"gravity: expected a number, got shape \(2, 1\)",
    ),
    "many positions": (
        lambda: dead_reckon(N3, N3, 0.1, position=N3),
        r"position: expected shape \(3,\), got \(5, 3\)",
    ),
    "shape of the reading": (
        lambda: inertial_acceleration([0.0, 1.0], [0, 0, 0]),
        r"accel: expected shape \(\.\.\., 3\), got \(2,\)",
    ),
    "shapes that do not fit": (
        lambda: accelerometer_from_acceleration(np.zeros((2, 3)), np.zeros((4, 3))),
        "expected acceleration and euler with leading axes that broadcast",
    ),
    "angles and times that do not fit": (
        lambda: drift_from_tilt_error([0.1, 0.2], [1.0, 2.0, 3.0]),
        "expected angle_error and time with leading axes that broadcast",
    ),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()


def test_no_samples_give_no_way() -> None:
    velocity, position = dead_reckon(np.zeros((0, 3)), np.zeros((0, 3)), 0.1)
    assert velocity.shape == position.shape == (0, 3)
    assert_array_equal(velocity, position)
