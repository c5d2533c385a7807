"""The low-pass of the averaging filter and its closed forms, against SciPy's and by numbers."""

from functools import cache

import numpy as np
import pytest
import scipy
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from sympy import exp, lambdify, simplify, symbols

from chr_notes import rotate_to_inertial
from chr_notes.derivations import averaging as derived
from chr_notes.derivations import estimation, further
from chr_notes.symbols import T, g

from .late import computing

TAU, PERIOD = 3.0, 0.05
NUMBERS = {derived.tau: TAU, T: PERIOD}
CORNER = float(derived.corner().subs(NUMBERS))
RESPONSE = computing(derived.t, lambda: derived.impulse_response().subs(NUMBERS))
STEP = computing(
    (derived.mean, derived.slope, derived.force, T),
    lambda: list(derived.low_pass_step().subs(derived.tau, TAU)),
)


@cache
def analog() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """SciPy's Butterworth filter of the same corner."""
    above, below = scipy.signal.butter(2, CORNER, analog=True)
    return above, below


def run(inputs: list[float], periods: list[float]) -> list[float]:
    """Put samples through the step, from rest at zero."""
    mean, slope, found = 0.0, 0.0, []
    for force, period in zip(inputs, periods, strict=True):
        mean, slope = STEP(mean, slope, force, period)
        found.append(mean)
    return found


def test_the_mean_of_an_acceleration_is_the_velocity_gained_over_the_time() -> None:
    time = np.linspace(0, 7, 100_001)
    acceleration = np.cos(time) - 0.3 * np.sin(3 * time)
    velocity = np.sin(time) + 0.1 * np.cos(3 * time)
    mean = scipy.integrate.trapezoid(acceleration, time) / 7
    v = next(iter(derived.mean_acceleration().atoms(derived.Function))).func
    values = {v(0): velocity[0], v(derived.t): velocity[-1], derived.t: 7}
    assert mean == pytest.approx(float(derived.mean_acceleration().subs(values)), abs=1e-8)


def test_the_low_pass_is_butterworths() -> None:
    frequencies = np.geomspace(0.01, 100, 50)
    _, expected = scipy.signal.freqs(*analog(), frequencies)
    power = lambdify(estimation.omega, derived.power_left().subs(NUMBERS))
    assert_allclose(power(frequencies), np.abs(expected) ** 2)
    assert float(derived.power_left(derived.corner())) == 0.5


def test_its_weights_add_up_to_one_and_are_as_old_as_the_time_constant() -> None:
    assert scipy.integrate.quad(RESPONSE, 0, 60)[0] == pytest.approx(1)
    assert scipy.integrate.quad(lambda t: t * RESPONSE(t), 0, 90)[0] == pytest.approx(TAU)
    assert derived.lag(derived.impulse_response()) == derived.tau
    assert derived.lag(exp(-derived.t / derived.tau) / derived.tau) == derived.tau
    times, expected = scipy.signal.impulse(analog())
    assert_allclose(RESPONSE(times), expected, atol=1e-9)


def test_the_step_is_scipys_for_an_input_that_is_held() -> None:
    inputs = np.random.default_rng(0).normal(size=500).tolist()
    above, below, _ = scipy.signal.cont2discrete(analog(), PERIOD)
    # There a sample holds from then on, here up to then.
    expected = scipy.signal.lfilter(above.ravel(), below, [*inputs, 0.0])[1:]
    assert_allclose(run(inputs, [PERIOD] * 500), expected, atol=1e-13)


@given(st.lists(st.floats(0, 5), min_size=2, max_size=6), st.floats(-10, 10))
def test_steps_of_any_lengths_add_up(periods: list[float], force: float) -> None:
    many = run([1.0, *[force] * len(periods)], [0.7, *periods])[-1]
    one = run([1.0, force], [0.7, sum(periods)])[-1]
    assert many == pytest.approx(one, abs=1e-12)


def test_a_gyro_bias_costs_the_bias_times_the_time_constant() -> None:
    bias, count = 0.002, 4000
    turning = (bias * PERIOD * np.arange(1, count + 1)).tolist()
    error = turning[-1] - run(turning, [PERIOD] * count)[-1]
    stated = float(derived.bias_error().subs({estimation.bias: bias, **NUMBERS}))
    assert stated == bias * TAU
    assert error == pytest.approx(stated, abs=bias * PERIOD)


def test_the_variance_of_noise() -> None:
    weights = np.array(run([1.0, *[0.0] * 3000], [PERIOD] * 3001))
    stated = float(derived.noise_share().subs(NUMBERS))
    assert (weights**2).sum() == pytest.approx(stated, rel=1e-3)


@given(st.integers(0, 2**32 - 1), st.floats(0.05, 20))
def test_the_bound_for_a_body_of_bounded_speed(seed: int, smooth: float) -> None:
    time = np.arange(0, 40, 0.01)
    noise = np.random.default_rng(seed).choice([-1.0, 1.0], int(40 / smooth) + 2)
    velocity = noise[(time / smooth).astype(int)]
    output = run(np.diff(velocity, prepend=velocity[0]) / 0.01, [0.01] * len(time))
    unit = {derived.speed: 1, g: 1, derived.tau: TAU}
    assert np.abs(output).max() <= float(derived.motion_error().subs(unit))


def test_the_bound_is_reached() -> None:
    # The worst velocity has the sign of the slope of the weights, looked at from the end.
    age = np.arange(0, 30, 0.001)[::-1]
    slope = np.gradient(RESPONSE(age), -0.001)
    velocity = np.sign(slope)
    output = run(np.diff(velocity, prepend=0) / 0.001, [0.001] * len(age))[-1]
    unit = {derived.speed: 1, g: 1, derived.tau: TAU}
    assert abs(output) == pytest.approx(float(derived.motion_error().subs(unit)), rel=0.01)


def test_a_body_that_turns_back_reaches_the_bound_of_a_plain_mean() -> None:
    time = np.linspace(0, 4, 4001)
    velocity = -1.5 * np.cos(np.pi * time / 4)  # from one way at full speed to the other
    leaning = np.gradient(velocity, time).mean() / 9.8
    unit = {derived.speed: 1.5, derived.t: 4, g: 9.8}
    assert leaning == pytest.approx(float(derived.mean_motion_error().subs(unit)), rel=1e-3)


def test_what_a_turn_unseen_leaves_of_a_mean() -> None:
    turn = symbols("turn", positive=True)
    left = derived.averaged_after(turn)
    bound = derived.mean_motion_error()
    assert simplify(bound.subs(derived.t, left) - bound - turn) == 0


def test_the_best_time_constant_has_the_least_error() -> None:
    numbers = {estimation.bias: 0.001, estimation.accel_noise: 0.05, T: PERIOD}
    best = float(derived.best_time_constant().subs(numbers))
    error = derived.bias_error() ** 2 + estimation.accel_noise**2 * derived.noise_share()
    values = [float(error.subs(numbers).subs(derived.tau, best * k)) for k in (0.95, 1, 1.05)]
    assert values[1] == min(values)


def test_gain_and_time_constant() -> None:
    again = derived.gain_from_time_constant().subs(derived.tau, derived.time_constant_from_gain())
    assert simplify(again) == estimation.L
    left = 1 - derived.gain_from_time_constant()
    assert left == derived.relaxation()


TURN = computing(further.UPWARD, further.level_turn)


@given(st.tuples(*[st.floats(-10, 10)] * 3))
def test_the_level_turn_brings_a_vector_up(vector: tuple[float, ...]) -> None:
    length = np.linalg.norm(vector)
    turn = np.ravel(TURN(*vector))
    if np.linalg.norm(turn) <= 1e-6 * length:
        return  # straight down, from where every way is as short
    assert turn[3] == 0  # about a level axis
    if length > 1e-100:
        assert_allclose(rotate_to_inertial(turn, vector), [0, 0, -length], atol=1e-8 * length)
