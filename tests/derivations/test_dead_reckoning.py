"""Integrals against sums and derivatives, and what an error of attitude leaves of gravity."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Function, lambdify, zeros

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.euler import rotation
from chr_notes.symbols import ACCELEROMETER, EULER, T, g

from .late import computing

angles = st.floats(-3, 3)
READING = computing((*EULER, g, *derived.ACCELERATION), derived.accelerometer_reading)
BACK = computing((*EULER, g, *ACCELEROMETER), derived.inertial_acceleration)
MAGNITUDE = computing((derived.tilt_error, g), derived.residual_magnitude)
RESIDUE = computing(
    (derived.tilt_error, derived.azimuth, derived.yaw_error, g),
    derived.residual_acceleration,
)
ERROR = computing(
    (derived.tilt_error, derived.azimuth, derived.yaw_error, g, *derived.ACCELERATION),
    derived.error_of_acceleration,
)


@given(angles, angles, angles, st.tuples(angles, angles, angles))
def test_acceleration_comes_back_from_the_reading(
    roll: float, pitch: float, yaw: float, acceleration: tuple[float, float, float]
) -> None:
    values = (roll, pitch, yaw, 9.8)
    measured = READING(*values, *acceleration).ravel()
    np.testing.assert_allclose(BACK(*values, *measured).ravel(), acceleration, atol=1e-12)


def test_integrals_are_undone_by_derivatives() -> None:
    acceleration = [Function(name)(derived.t) for name in ("a_N", "a_E", "a_D")]
    velocity = derived.velocity_after(derived.velocity_gained())
    position = derived.position_after(derived.position_gained())
    assert list(velocity.diff(derived.t)) == acceleration
    assert velocity.subs(derived.t, 0).doit() == derived.VELOCITY
    assert (position.diff(derived.t) - velocity).doit().expand() == zeros(3, 1)
    assert position.subs(derived.t, 0).doit() == derived.POSITION


def test_a_step_is_exact_for_an_acceleration_that_changes_evenly() -> None:
    velocity, position = derived.velocity_after_step(), derived.position_after_step()
    assert position.diff(T) == velocity
    assert velocity.diff(T) == derived.ACCELERATION + derived.JERK * T
    assert velocity.subs(T, 0) == derived.VELOCITY
    assert position.subs(T, 0) == derived.POSITION


def test_sums_are_what_the_steps_give() -> None:
    velocity = position = 0.0
    for _ in range(37):
        velocity, position = velocity + 0.1 * 2, position + 0.1 * velocity
    values = {derived.n: 37, T: 0.1, derived.a: 2}
    assert float(derived.velocity_by_steps().subs(values)) == pytest.approx(velocity)
    assert float(derived.position_by_steps().subs(values)) == pytest.approx(position)


@given(st.floats(0, 3), angles, angles)
def test_the_residue_has_its_magnitude_whatever_the_direction(
    tilt: float, azimuth: float, yaw: float
) -> None:
    residue = RESIDUE(tilt, azimuth, yaw, 9.8).ravel()
    assert MAGNITUDE(tilt, 9.8) == pytest.approx(np.linalg.norm(residue), abs=1e-12)
    assert np.hypot(*residue[:2]) == pytest.approx(abs(9.8 * np.sin(tilt)), abs=1e-12)
    assert residue[2] == pytest.approx(9.8 * (1 - np.cos(tilt)), abs=1e-12)


def test_the_residue_is_what_a_wrong_attitude_makes_of_a_reading_at_rest() -> None:
    true = lambdify(EULER, rotation("I", "B"))
    wrong = (0.3, -0.2, 1.1)
    reading = true(0.28, -0.25, 1.0) @ np.array([0, 0, -9.8])
    residue = true(*wrong).T @ reading + np.array([0, 0, 9.8])
    verticals = true(*wrong).T @ true(0.28, -0.25, 1.0)
    tilt = float(np.arccos(verticals[2, 2]))
    assert MAGNITUDE(tilt, 9.8) == pytest.approx(np.linalg.norm(residue))


def test_yaw_alone_leaves_nothing() -> None:
    np.testing.assert_allclose(RESIDUE(0, 0.4, 0.7, 9.8), np.zeros((3, 1)), atol=1e-15)


def test_drift_is_the_level_residue_integrated() -> None:
    acceleration, velocity, position = derived.drift()
    assert position.diff(derived.t) == velocity
    assert velocity.diff(derived.t) == acceleration
    assert (velocity.subs(derived.t, 0), position.subs(derived.t, 0)) == (0, 0)
    assert acceleration == derived.residual_acceleration().subs(derived.azimuth, 0)[0]


@given(st.floats(0, 3), angles, angles, st.tuples(angles, angles, angles))
def test_an_error_of_attitude_turns_what_is_measured(
    tilt: float, azimuth: float, yaw: float, acceleration: tuple[float, float, float]
) -> None:
    found = ERROR(tilt, azimuth, yaw, 9.8, *acceleration).ravel()
    measured = np.array(acceleration) - (0, 0, 9.8)
    assert np.linalg.norm(measured + found) == pytest.approx(np.linalg.norm(measured))
    still = ERROR(tilt, azimuth, yaw, 9.8, 0, 0, 0)
    np.testing.assert_allclose(still, RESIDUE(tilt, azimuth, yaw, 9.8), atol=1e-12)
    # An error of yaw alone turns the level part about the vertical, and leaves the rest.
    (north, east, down), turn = acceleration, np.array([np.cos(yaw), np.sin(yaw)])
    expected = np.array([turn @ (north, -east), turn @ (east, north), down]) - acceleration
    only_yaw = ERROR(0, 0, yaw, 9.8, *acceleration).ravel()
    np.testing.assert_allclose(only_yaw, expected, atol=1e-12)
