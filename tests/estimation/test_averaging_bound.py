"""How far off the vertical the averaging filter says that it may be, and is."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from chr_notes import (
    averaged_attitude,
    averaging_bound,
    fixed_gain_observer,
    matrix_from_euler,
    observe_averaging,
)
from chr_notes.simulation import at_rest, ideal_readings, swing, trajectory
from tests.estimation.test_averaging import GRAVITY, PERIOD, still, tilt_off, tumbling


@pytest.mark.parametrize("seed", range(5))
def test_the_bound_holds_for_a_body_that_moves(seed: int) -> None:
    random = np.random.default_rng(seed)
    rates, _, truth = tumbling(4000)
    velocity = np.array(
        [
            np.interp(np.arange(4000), np.arange(0, 4001, 40), v)
            for v in random.uniform(-1, 1, (3, 101))
        ]
    ).T / np.sqrt(3)
    acceleration = np.diff(velocity, axis=0, prepend=velocity[:1]) / PERIOD
    forces = np.einsum("nij,nj->ni", matrix_from_euler(truth), acceleration - [0, 0, GRAVITY])
    found = averaged_attitude(rates + 0.0025, forces, PERIOD, bias=0)
    off = tilt_off(found.euler, truth)
    assert (off[1:] <= found.tilt_bound[1:]).all()
    assert (
        off[1000:].max()
        < 0.1
        * np.abs(
            fixed_gain_observer(rates, forces, PERIOD, 0.5)[1000:, :2] - truth[1000:, :2]
        ).max()
    )


@pytest.mark.parametrize(
    ("frequency", "said"), [(0.1, "is taken for the bias"), (0.3, "no bias is taken off")]
)
def test_the_bound_holds_where_no_rest_shows_the_bias(frequency: float, said: str) -> None:
    """A stand that swings without a pause: the stillest two seconds are a turn."""
    time = PERIOD * np.arange(6000)
    euler = swing(time, np.radians([20, 15, 0]), [frequency, 0.7 * frequency, 0])
    truth = trajectory(time, euler, at_rest(time))
    ideal, bias = ideal_readings(truth), np.array([0.04, -0.02, 0.01])
    with pytest.warns(UserWarning, match=said):
        found = averaged_attitude(ideal.body_rates + bias, ideal.accel, PERIOD)
    off = tilt_off(found.euler, truth.euler)
    assert off.max() > 2 * averaging_bound(found.averaged[-1])  # that of a bias that is known
    assert (off[1:] < found.tilt_bound[1:]).all()


@pytest.mark.parametrize("reads", [0.0, 1e-6, 0.01, 0.3])
@pytest.mark.parametrize("seconds", [1, 8, 13])
def test_the_bound_holds_in_free_fall_and_after(reads: float, seconds: int) -> None:
    rates, forces, truth = tumbling(5000)
    noise = np.random.default_rng(5).normal(0, reads, (5000, 3))
    fall = slice(1000, 1000 + 100 * seconds)
    forces[fall] = noise[fall]
    # A steady drift about the vertical's own normal, at the bound of gyros.
    north = np.array([0.0049, 0.0, 0.0])
    rates = rates + np.einsum("nij,j->ni", matrix_from_euler(truth), north)
    found = averaged_attitude(rates, forces, PERIOD, bias=0)
    off = tilt_off(found.euler, truth)
    assert (off[1:] < found.tilt_bound[1:]).all()
    assert off[fall][-1] == pytest.approx(0.0049 * (3.0 + seconds), rel=0.1)
    assert found.tilt_bound[fall][-1] > found.tilt_bound[999] + 0.005 * seconds
    assert found.averaged[-1] == 3.0
    *_, last = observe_averaging(zip(rates, forces, [PERIOD] * fall.stop, strict=False), bias=0)
    assert last.tilt_bound == pytest.approx(found.tilt_bound[fall][-1])


def test_a_weaker_force_that_stays_is_heard_again() -> None:
    rates, forces = still(9000)
    forces[1000:] *= 0.1  # another unit
    forces[3000:, 1] += 0.2
    found = averaged_attitude(rates, forces, PERIOD, bias=0)
    assert found.averaged[-1] == 3.0
    assert found.euler[-1, 0] == pytest.approx(-0.2 / (0.1 * GRAVITY), abs=0.02)


def test_the_bound_of_other_bodies() -> None:
    both = averaging_bound([0.0, 1.0, 3.0], speed=2.0, bias=0.01)
    late = 2 * np.sqrt(2) * np.exp(-np.pi / 4) / (1 - np.exp(-np.pi)) * 2 / (GRAVITY * 3)
    assert_allclose(both, [np.pi, 4 / GRAVITY + 0.03, late + 0.03])
