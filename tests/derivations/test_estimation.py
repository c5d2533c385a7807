"""The observer's closed forms against its steps, run with numbers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Symbol, lambdify, pi, symbols

from chr_notes.derivations import estimation as derived
from chr_notes.derivations.euler import rotation
from chr_notes.symbols import ACCELEROMETER, T, g, phi, psi, theta

from .late import computing

GAINS = [0.02, 0.5, 0.9, 1.0]
PERIOD = 0.01
SIGMAS = {derived.gyro_noise: 0.05, derived.accel_noise: 0.02, T: PERIOD}

TILT = computing(ACCELEROMETER, derived.tilt)
AT_REST = computing((phi, theta, g), derived.accelerometer_at_rest)
LEVEL_MATRIX = computing((phi, theta), lambda: rotation("I", "B").subs(psi, 0))
_TURN = Symbol("turn")
SHORTEST = computing(_TURN, lambda: derived.shortest_turn(_TURN))


def step(gain: float, error: float, gyro: float, accel: float) -> float:
    """One step of prediction and update on numbers, written out."""
    predicted = error + gyro * PERIOD
    return predicted + gain * (accel - predicted)


@given(
    st.floats(-np.pi, np.pi), st.floats(-np.pi / 2, np.pi / 2), st.sampled_from([1e-3, 1, 9.8, 50])
)
def test_tilt_rebuilds_the_attitude_at_any_scale(roll: float, pitch: float, scale: float) -> None:
    reading = AT_REST(roll, pitch, scale).ravel()
    estimated = TILT(*reading).ravel()
    at_pole = abs(abs(pitch) - np.pi / 2) < 1e-6  # there roll is not determined
    if not at_pole:
        np.testing.assert_allclose(LEVEL_MATRIX(*estimated), LEVEL_MATRIX(roll, pitch), atol=1e-9)
    np.testing.assert_allclose(AT_REST(*estimated, scale).ravel(), reading, atol=1e-9 * scale)


def test_level_and_at_rest_reads_minus_g() -> None:
    np.testing.assert_allclose(AT_REST(0, 0, 9.8).ravel(), [0, 0, -9.8])


def test_update_ends_at_either_source() -> None:
    assert derived.update().subs(derived.L, 0) == derived.predicted
    assert derived.update().subs(derived.L, 1) == derived.measured


@given(st.floats(-30, 30))
def test_the_shortest_turn_differs_by_whole_turns(turn: float) -> None:
    short = SHORTEST(turn)
    assert -np.pi - 1e-12 <= short <= np.pi + 1e-12
    assert np.exp(1j * short) == pytest.approx(np.exp(1j * turn))


def test_the_shortest_turn_leaves_half_a_turn_at_its_lower_end() -> None:
    assert derived.shortest_turn(pi) == -pi
    assert derived.shortest_turn(-pi) == -pi


@pytest.mark.parametrize("gain", GAINS)
@pytest.mark.parametrize("steps", [1, 2, 50])
def test_error_after_is_what_the_steps_give(gain: float, steps: int) -> None:
    start, bias = 0.3, 0.02
    error = start
    for _ in range(steps):
        error = step(gain, error, bias, 0)
    values = {derived.L: gain, derived.n: steps, T: PERIOD}
    values |= {derived.start_error: start, derived.bias: bias}
    assert float(derived.error_after().subs(values)) == pytest.approx(error)
    following = step(gain, error, bias, 0)
    assert float(derived.error_growth().subs(values)) == pytest.approx(following - error)


def test_the_gyro_alone_drifts() -> None:
    error = variance = 0.0
    for _ in range(40):
        error, variance = error + 0.02 * PERIOD, variance + (0.05 * PERIOD) ** 2
    values = {derived.n: 40, derived.bias: 0.02, derived.start_error: 0, **SIGMAS}
    assert float(derived.gyro_error_after().subs(values)) == pytest.approx(error)
    assert float(derived.gyro_variance_after().subs(values)) == pytest.approx(variance)


@pytest.mark.parametrize("gain", GAINS)
def test_steady_errors_are_where_the_steps_settle(gain: float) -> None:
    error, variance = 0.3, 0.3
    for _ in range(3000):
        error = step(gain, error, 0.02, 0)
        variance = (1 - gain) ** 2 * (variance + (0.05 * PERIOD) ** 2) + gain**2 * 0.02**2
    values = {derived.bias: 0.02, **SIGMAS}
    assert float(derived.steady_bias_error(gain).subs(values)) == pytest.approx(error, abs=1e-15)
    assert float(derived.steady_variance(gain).subs(values)) == pytest.approx(variance)
    shares = 0.05**2 * derived.gyro_share(gain) + 0.02**2 * derived.accel_share(gain)
    assert float(shares.subs(values)) == pytest.approx(variance)


@pytest.mark.parametrize("gain", GAINS)
@pytest.mark.parametrize("omega", [0.0, 30.0, 200.0])
def test_vibration_comes_through_as_the_steps_let_it(gain: float, omega: float) -> None:
    wave = np.exp(1j * omega * PERIOD * np.arange(4000))
    error = 0j
    for value in wave:
        error = (1 - gain) * error + gain * value
    share = derived.vibration_share(gain).subs({derived.omega: omega, T: PERIOD})
    assert float(share) == pytest.approx(abs(error) ** 2, rel=1e-9)


def test_the_kalman_gain_is_where_its_variances_settle() -> None:
    before = 1.0
    for _ in range(20000):
        predicted = before + (0.05 * PERIOD) ** 2
        gain = predicted / (predicted + 0.02**2)
        before = (1 - gain) * predicted
    assert float(derived.kalman_gain().subs(SIGMAS)) == pytest.approx(gain)


def test_no_gain_beats_the_best() -> None:
    best = float(derived.best_gain().subs(SIGMAS))
    variance = lambdify(derived.L, derived.steady_variance().subs(SIGMAS))
    assert 0 < best < 1
    assert all(variance(best) < variance(best * factor) for factor in (0.5, 0.9, 1.1, 2))


def test_a_level_turn_presses_through_the_floor() -> None:
    bank, time = symbols("bank t", real=True)
    shown = derived.roll_in_level_turn(bank, time)
    for degrees in (-60, 10, 45):
        assert shown.subs({bank: pi * degrees / 180, g: 10}) == 0, degrees
