"""A foot that stands on the ground: found in the readings, and used against the drift."""

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import chr_notes
from chr_notes import (
    accelerometer_from_acceleration,
    dead_reckon,
    fit_gyro_bias,
    fixed_gain_observer,
    static_interval,
    zero_velocity,
)
from chr_notes.derivations import dead_reckoning as derived
from chr_notes.simulation import ideal_readings, minimum_jerk, swing, trajectory

Floats = NDArray[np.float64]
G = chr_notes.STANDARD_GRAVITY


def walked(recordings: Path) -> tuple[Floats, Floats, float]:
    """Rates without bias, forces, and the step of a walk that ended where it began."""
    walk = np.loadtxt(recordings / "xio_gait_short_walk.csv", delimiter=",", skiprows=1)
    # The times are those of arrival, in bursts; the samples were taken evenly.
    step = (walk[-1, 0] - walk[0, 0]) / (len(walk) - 1)
    to_body = np.array([1.0, -1.0, -1.0])  # from z up to forward, right, down
    rates, forces = np.radians(walk[:, 1:4]) * to_body, G * walk[:, 4:7] * to_body
    return rates + fit_gyro_bias(rates[static_interval(rates, 800)]), forces, step


@pytest.mark.parametrize(("limit", "largest"), [(0.3, 0.4), (0.6, 0.5), (1.0, 0.7), (1.5, 1.0)])
def test_a_recorded_walk_with_rests_ends_near_its_start(
    recordings: Path, limit: float, largest: float
) -> None:
    rates, forces, step = walked(recordings)
    still = zero_velocity(rates, forces, step, rate_limit=limit)
    heard = np.where(still[:, np.newaxis], forces, np.nan)
    euler = fixed_gain_observer(rates, heard, step, 0.02)
    _, without = dead_reckon(forces, euler, step)
    velocity, position = dead_reckon(forces, euler, step, still=still)
    assert np.linalg.norm(without[-1]) > 5
    assert np.linalg.norm(position[-1]) < largest
    assert 6 < np.linalg.norm(position, axis=1).max() < 8
    assert_allclose(velocity[still], 0, atol=1e-9)


def test_a_constant_error_between_rests_is_taken_off() -> None:
    time = np.linspace(0, 6, 1201)
    stops = [[0, 0, 0], [0, 0, 0], [3, -1, 0.5], [3, -1, 0.5]]
    motion = minimum_jerk(time, [0, 1, 5, 6], stops)
    truth = trajectory(time, swing(time, 0.0, 1.0), motion)
    forces = ideal_readings(truth).accel + np.array([0.2, -0.1, 0.3])
    still = (time < 1) | (time > 5)
    _, position = dead_reckon(forces, truth.euler, time[1], still=still)
    assert np.linalg.norm(position - truth.position, axis=1).max() < 0.01
    error = derived.acceleration_error_between_rests().subs(
        {derived.VELOCITY[0]: 0.8, derived.t: 4}
    )
    assert float(error) == 0.2


def test_rests_do_nothing_to_what_has_no_error_and_nothing_after_the_last_one() -> None:
    forces = np.tile(accelerometer_from_acceleration([1.0, 0, 0], [0, 0, 0]), (6, 1))
    euler, none = np.zeros((6, 3)), np.zeros(6)
    assert_array_equal(dead_reckon(forces, euler, 1.0, still=none), dead_reckon(forces, euler, 1.0))
    velocity, _ = dead_reckon(forces, euler, 1.0, still=[0, 0, 0, 1, 0, 0], velocity=[9, 0, 0])
    assert_allclose(velocity[:, 0], [6, 3, 0, 0, 1, 2])
    velocity, _ = dead_reckon(forces, euler, 1.0, still=[1, 0, 0, 0, 0, 0], velocity=[9, 0, 0])
    assert_allclose(velocity[:, 0], [0, 1, 2, 3, 4, 5])
    forces[1] = np.nan
    velocity, _ = dead_reckon(forces, euler, 1.0, still=[0, 0, 0, 1, 0, 0], velocity=[2, 0, 0])
    assert_allclose(velocity[:, 0], [1, np.nan, 0, 0, 1, 2])


def test_a_body_that_stands_is_told_from_one_that_moves() -> None:
    rates, forces = np.zeros((300, 3)), np.tile([0.0, 0.0, -G], (300, 1))
    rates[100:200, 1], forces[250:] = 3.0, [0.0, 4.0, -G]
    rates[20, 0] = np.nan
    still = zero_velocity(rates, forces, 0.01, force_limit=0.05)
    assert still[:95].sum() == 94
    assert not still[100:200].any()
    assert still[206:244].all()
    assert not still[250:].any()
    assert zero_velocity(rates[:0], forces[:0], 0.01).shape == (0,)
    with pytest.raises(ValueError, match="rate_limit: expected a positive number, got -1"):
        zero_velocity(rates, forces, 0.01, rate_limit=-1.0)
    with pytest.raises(ValueError, match=r"true or false for each sample, shape \(300,\)"):
        dead_reckon(forces, np.zeros((300, 3)), 0.01, still=still[1:])


def test_a_recorded_walk_ends_metres_off(recordings: Path) -> None:
    rates, forces, step = walked(recordings)
    # The accelerometer on a foot shows its tilt only while the foot stands.
    stands = np.abs(np.linalg.norm(forces, axis=1) - G) < 0.05 * G
    stands &= np.linalg.norm(rates, axis=1) < np.radians(20)
    heard = np.where(stands[:, np.newaxis], forces, np.nan)
    euler = fixed_gain_observer(rates, heard, step, 0.02)
    velocity, position = dead_reckon(forces, euler, step)
    # It ended where it began.
    assert 10 < np.linalg.norm(position[-1]) < 20
    # Why: a foot that stands does not move, but each step leaves a velocity that stays.
    assert np.linalg.norm(velocity[stands], axis=1).mean() > 0.2
