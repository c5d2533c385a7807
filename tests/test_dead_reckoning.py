"""Velocity and position from an accelerometer."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import chr_notes
from chr_notes import (
    UnitWarning,
    accelerometer_from_acceleration,
    coasting_time,
    dead_reckon,
    drift_budget,
    drift_from_tilt_error,
    fit_gyro_bias,
    fixed_gain_observer,
    inertial_acceleration,
    static_interval,
    zero_velocity,
)
from chr_notes.conventions import NOTES_GRAVITY
from chr_notes.derivations import dead_reckoning as derived
from chr_notes.ledger.table_1 import PRINTED_G
from chr_notes.sensors.simulated import SensorErrors, add_errors
from chr_notes.simulation import ideal_readings, minimum_jerk, swing, trajectory
from chr_notes.symbols import T

from .sampling import few

Floats = NDArray[np.float64]
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


# How errors grow


# Half of a subnormal number has not the digits that are compared here.
@given(st.floats(-0.1, 0.1, allow_subnormal=False), st.floats(0, 2 * np.pi))
@few(20)
def test_a_tilt_error_makes_the_drift_that_is_derived(error: float, yaw: float) -> None:
    count, period = 3000, 0.01
    reading = np.tile(chr_notes.accelerometer_at_rest([0, 0, 0], 9.8), (count, 1))
    wrong = np.tile([0.0, error, yaw], (count, 1))
    velocity, position = dead_reckon(reading, wrong, period, gravity=9.8)
    acceleration, fast, far = drift_from_tilt_error(abs(error), count * period)
    level = slice(0, 2)
    assert_allclose(np.linalg.norm(velocity[-1, level]), abs(fast), rtol=1e-9, atol=1e-12)
    # The notes' steps lag the integral by half a step of velocity.
    lag = abs(fast) * period / 2
    assert_allclose(np.linalg.norm(position[-1, level]), far - lag, rtol=1e-9, atol=1e-12)
    assert_allclose(acceleration, 9.8 * np.sin(abs(error)))


def test_steps_sum_up_as_derived() -> None:
    forces = np.tile(accelerometer_from_acceleration([0.5, 0, 0], [0, 0, 0]), (40, 1))
    velocity, position = dead_reckon(forces, np.zeros((40, 3)), 0.1)
    known = {derived.n: 40, derived.a: 0.5, T: 0.1}
    assert_allclose(velocity[-1, 0], float(derived.velocity_by_steps().subs(known)))
    assert_allclose(position[-1, 0], float(derived.position_by_steps().subs(known)))


def test_noise_makes_velocity_walk_with_the_root_of_time() -> None:
    time = 0.01 * np.arange(1000)
    still = np.tile([0.0, 0.0, -G], (1000, 1))
    ends = []
    for seed in range(200):
        forces = add_errors(still, time, SensorErrors(noise_density=0.02), seed=seed)
        velocity, position = dead_reckon(forces, np.zeros((1000, 3)), 0.01)
        ends.append([velocity[-1], position[-1]])
    # White noise of density d: after t seconds d √t of velocity, d √(t³/3) of position. 600 ends
    # know a standard deviation to 2.9 %.
    expected = 0.02 * np.sqrt([10.0, 10.0**3 / 3])
    assert_allclose(np.std(ends, axis=(0, 2)), expected, rtol=0.12)


def test_table_1_as_it_should_be() -> None:
    seconds = np.array([10.0, 60.0, 600.0, 3600.0])
    acceleration, velocity, position = drift_from_tilt_error(np.radians(1.0), seconds)
    assert_allclose(acceleration, 0.17103, rtol=1e-4)
    assert_allclose(velocity[0], 1.7103, rtol=1e-4)
    assert_allclose(position, [8.5517, 307.86, 30786, 1108295], rtol=1e-4)


def test_the_gravity_of_the_notes_is_the_one_that_their_table_is_judged_by() -> None:
    assert float(PRINTED_G) == NOTES_GRAVITY


def test_drift_broadcasts() -> None:
    parts = drift_from_tilt_error([[0.01], [0.02]], [1.0, 2.0, 3.0])
    assert [part.shape for part in parts] == [(2, 3)] * 3


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


@pytest.mark.parametrize("unit", [1 / G, 16384 / G])
def test_readings_in_another_unit_are_noticed(unit: float) -> None:
    still = np.tile([0.0, 0.0, -G], (3000, 1))
    with pytest.warns(UnitWarning, match=r"about 9\.807, .* got mostly .*: are they in g"):
        dead_reckon(unit * still, 0 * still, 0.01)
    dead_reckon(unit * still, 0 * still, 0.01, gravity=unit * G)


@pytest.mark.parametrize("seed", range(3))
def test_the_budget_is_what_the_integrals_give(seed: int) -> None:
    generator = np.random.default_rng(seed)
    tilt, bias, turning = generator.uniform(0.001, 0.01, 3) * [1, 1, 0.01]
    steps, time = 20_000, 20.0
    wrong = np.zeros((steps, 3))
    wrong[:, 1] = tilt + turning * np.linspace(0, time, steps)
    forces = np.tile([bias, 0.0, -G], (steps, 1))
    _, position = dead_reckon(forces, wrong, time / steps)
    found = drift_budget(time, tilt=tilt, accel_bias=bias, gyro_bias=turning)
    # A nose that is thought to be up makes a force that seems to point backwards: signs apart.
    assert_allclose(
        abs(position[-1, 0]), abs(found.accel_bias - found.tilt - found.gyro_bias), rtol=2e-3
    )
    assert_allclose(found.worst, found.tilt + found.accel_bias + found.gyro_bias)
    assert_allclose(found.tilt, drift_from_tilt_error(tilt, time, G)[2])


def test_the_budget_of_a_time_before_the_start_is_refused() -> None:
    with pytest.raises(ValueError, match="time: expected seconds, not negative, got -2"):
        drift_budget([1.0, -2.0], tilt=0.1)


def test_the_noise_of_the_budget_is_what_repetition_shows() -> None:
    generator = np.random.default_rng(1)
    period, count, density = 0.01, 1000, 0.02
    white = generator.normal(0, density / np.sqrt(period), (400, count))
    far = np.cumsum(np.cumsum(white, axis=1) * period, axis=1)[:, -1] * period
    assert_allclose(far.std(), drift_budget(10.0, accel_noise=density).noise, rtol=0.1)
    turned = G * np.cumsum(white, axis=1) * period
    far = np.cumsum(np.cumsum(turned, axis=1) * period, axis=1)[:, -1] * period
    assert_allclose(far.std(), drift_budget(10.0, gyro_noise=density).noise, rtol=0.1)


def test_how_long_one_may_coast() -> None:
    for errors in ({"tilt": 0.01}, {"gyro_bias": 1e-3, "accel_bias": 0.1}, {"accel_noise": 0.01}):
        time = coasting_time(1.0, **errors)
        assert_allclose(drift_budget(time, **errors).likely, 1.0)
    assert_allclose(coasting_time(2.0, accel_bias=0.04), 10.0)
    assert coasting_time() == np.inf
    with pytest.raises(ValueError, match="distance: expected a positive number, got 0"):
        coasting_time(0.0)
    with pytest.raises(ValueError, match="tilt: expected a number, got nan"):
        coasting_time(tilt=np.nan)
    with pytest.raises(ValueError, match=r"tilt: expected a number, got \[0.1, 0.2\]"):
        coasting_time(tilt=[0.1, 0.2])  # type: ignore[arg-type]


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
