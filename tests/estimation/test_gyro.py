"""Attitude from gyros alone."""

from typing import Any, Literal

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes import integrate_gyro
from chr_notes.derivations import estimation as derived
from chr_notes.sensors.simulated import SensorErrors, add_errors
from chr_notes.simulation import at_rest, swing, trajectory
from chr_notes.symbols import T
from tests.attitudes import apart, turns
from tests.sampling import few

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
roll_angles = st.floats(-np.pi, np.pi)
off_the_pole = st.floats(-1.55, 1.55)
LEVEL = np.array([0.0, 0.0, -9.80665])
PERIOD = 0.01


@given(seeds, st.floats(0.1, 3.0))
@few(20)
def test_a_constant_turn_is_integrated_exactly(seed: int, total: float) -> None:
    generator = np.random.default_rng(seed)
    axis = generator.normal(size=3)
    initial = generator.uniform(-1, 1, 3)
    rates = np.tile(total * axis / np.linalg.norm(axis), (50, 1))
    steps = generator.uniform(0, 2, 50)
    steps *= 1 / steps.sum()
    found = integrate_gyro(rates, steps, initial, method="quaternion")
    expected = turns(initial) * Rotation.from_rotvec(rates[0])
    assert (turns(found[-1]).inv() * expected).magnitude() < 1e-12


def test_the_notes_step_converges_with_the_step() -> None:
    errors = []
    for count in (200, 400, 800):
        time = np.arange(count + 1) * (4.0 / count)
        truth = trajectory(time, swing(time, [0.8, 0.5, 1.0], [0.3, 0.4, 0.2]), at_rest(time))
        given = (truth.body_rates[:-1], 4.0 / count, truth.euler[0])
        found = integrate_gyro(*given, method="euler")
        errors.append(apart(found[-1], truth.euler[-1]))
    assert_allclose(np.array(errors[:-1]) / errors[1:], 2.0, rtol=0.1)


def test_both_methods_agree_to_the_step() -> None:
    time = np.arange(4000) * 0.001
    truth = trajectory(time, swing(time, [0.8, 0.5, 1.0], [0.3, 0.4, 0.2]), at_rest(time))
    by_angles, by_turns = (
        integrate_gyro(truth.body_rates, 0.001, truth.euler[0], method=method)
        for method in ("euler", "quaternion")
    )
    assert apart(by_angles, by_turns).max() < 0.005


@pytest.mark.parametrize("method", ["quaternion", "euler"])
def test_half_a_turn_is_written_with_a_minus(method: Literal["quaternion", "euler"]) -> None:
    half_a_turn = integrate_gyro([[np.pi, 0.0, 0.0], [0.0, 0.0, np.pi]], 1.0, method=method)
    assert_array_equal(half_a_turn[:, 0], -np.pi)
    assert_allclose(np.abs(half_a_turn[1, 2]), np.pi)
    found = integrate_gyro([[0.0, 0.0, np.pi]], 1.0, method=method)
    assert_array_equal(found, [[0.0, 0.0, -np.pi]])


@pytest.mark.parametrize("beyond", [1e-9, 1e-4, 0.3])
def test_a_pitch_beyond_the_pole_is_written_from_the_other_side(beyond: float) -> None:
    start = (0.2, np.pi / 2 + beyond, 0.3)
    found = integrate_gyro(np.zeros((1, 3)), 0.01, start, method="euler")
    assert np.abs(found[0, 1]) <= np.pi / 2
    assert apart(found[0], start) < 1e-7


def test_only_turns_survive_the_pole() -> None:
    # A loop: pitch goes round once, in 4 s.
    rates = np.tile([0.01, 2 * np.pi / 4, 0.02], (400, 1))
    exact = integrate_gyro(rates, 0.01, method="quaternion")
    expected = [Rotation.from_rotvec(0.01 * (k + 1) * rates[0]).as_matrix() for k in range(400)]
    assert apart(exact, chr_notes.euler_from_matrix(np.swapaxes(expected, 1, 2))).max() < 1e-12
    assert np.abs(exact[:, 1]).max() <= np.pi / 2
    by_angles = integrate_gyro(rates, 0.01, method="euler")
    assert np.isfinite(by_angles).all()
    assert np.abs(by_angles[:, 1]).max() <= np.pi / 2
    assert apart(by_angles, exact).max() > 0.05


def test_gyro_samples_with_nan_are_held_out() -> None:
    rates = np.random.default_rng(0).normal(size=(20, 3))
    holed = rates.copy()
    holed[[4, 11], [0, 2]] = np.nan
    for method in ("euler", "quaternion"):
        kept = np.delete(rates, [4, 11], axis=0)
        expected = integrate_gyro(kept, 0.01, method=method)
        found = integrate_gyro(holed, 0.01, method=method)
        assert np.flatnonzero(np.isnan(found).any(axis=1)).tolist() == [4, 11]
        assert_array_equal(np.delete(found, [4, 11], axis=0), expected)


def test_gyro_noise_alone_makes_a_walk_as_derived() -> None:
    count, density = 400, 0.05
    ends = []
    for seed in range(300):
        rates = add_errors(
            np.zeros((count, 3)), PERIOD * np.arange(count),
            SensorErrors(noise_density=density), seed=seed,
        )  # fmt: skip
        ends.append(integrate_gyro(rates, PERIOD)[-1])
    variance = derived.gyro_variance_after().subs(derived.n, count)
    known = {derived.gyro_noise: density / np.sqrt(PERIOD), T: PERIOD}
    expected = float(variance.subs(known))
    # 900 ends know a variance to 4.7 %; the walks bend a little, being of 6 degrees.
    assert_allclose(np.var(ends), expected, rtol=0.2)


N3 = np.zeros((5, 3))
REFUSED = {
    "one sample": (
        lambda: integrate_gyro(np.zeros(3), 0.01),
        r"body_rates: expected shape \(N, 3\), got \(3,\)",
    ),
    "quaternions for rates": (
        lambda: integrate_gyro(np.zeros((5, 4)), 0.01),
        r"body_rates: expected shape \(\.\.\., 3\), got \(5, 4\)",
    ),
    "steps of another length": (
        lambda: integrate_gyro(N3, np.ones(4)),
        r"dt: expected a number or shape \(5,\), got \(4,\)",
    ),
    "a step of NaN": (
        lambda: integrate_gyro(N3, np.nan),
        r"dt: expected seconds, not negative, got nan at 0",
    ),
    "a method of another name": (
        lambda: integrate_gyro(N3, 0.01, method="rk4"),  # type: ignore[arg-type]
        'method: expected "quaternion" or "euler", got \'rk4\'',
    ),
    "an initial attitude of NaN": (
        lambda: integrate_gyro(N3, 0.01, (0.0, np.nan, 0.0)),
        r"initial: expected three finite numbers, got \[0\.0, nan, 0\.0\]",
    ),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()


def test_a_time_in_a_unit_of_its_own_is_refused() -> None:
    with pytest.raises(TypeError, match=r"dt: expected real numbers, got timedelta64\[ms\]"):
        integrate_gyro(N3, np.timedelta64(10, "ms"))


def test_no_samples_give_no_estimates() -> None:
    empty = np.zeros((0, 3))
    assert integrate_gyro(empty, 0.01).shape == (0, 3)
    assert integrate_gyro(empty, 0.01, method="quaternion").shape == (0, 3)
