"""How errors of tilt, bias and noise grow into errors of position."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

import chr_notes
from chr_notes import (
    coasting_time,
    dead_reckon,
    drift_budget,
    drift_from_tilt_error,
)
from chr_notes.conventions import NOTES_GRAVITY
from chr_notes.ledger.table_1 import PRINTED_G
from chr_notes.sensors.simulated import SensorErrors, add_errors

from .sampling import few

G = chr_notes.STANDARD_GRAVITY


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
