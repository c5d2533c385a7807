"""The errors of the fixed-gain observer are those that the derivations say."""

from typing import Any

import numpy as np
from numpy.testing import assert_allclose

import chr_notes
from chr_notes import fixed_gain_observer
from chr_notes.derivations import estimation as derived
from chr_notes.sensors.simulated import SensorErrors, add_errors
from chr_notes.symbols import T

LEVEL = np.array([0.0, 0.0, -9.80665])
PERIOD, GAIN = 0.01, 0.05


def at(formula: Any, **values: float) -> float:  # noqa: ANN401
    """Evaluate a derived formula at the period and gain of these tests."""
    known = {derived.bias: "bias", derived.gyro_noise: "gyro", derived.accel_noise: "accel"}
    named = {symbol: values[name] for symbol, name in known.items() if name in values}
    return float(formula.subs({derived.L: GAIN, T: PERIOD, **named}))


def test_a_gyro_bias_leaves_the_error_that_is_derived() -> None:
    bias = 0.02
    rates = np.tile([bias, 0.0, 0.0], (500, 1))
    found = fixed_gain_observer(rates, np.tile(LEVEL, (500, 1)), PERIOD, GAIN, (0, 0, 0))
    assert_allclose(found[-1, 0], at(derived.steady_bias_error(), bias=bias), rtol=1e-9)
    on_the_way = derived.error_after().subs({derived.n: 7, derived.start_error: 0})
    assert_allclose(found[6, 0], at(on_the_way, bias=bias), rtol=1e-12)


def test_noise_leaves_the_variance_that_is_derived() -> None:
    time = PERIOD * np.arange(400_000)
    still = np.zeros((len(time), 3))
    density, force_density = 0.002, 0.01
    rates = add_errors(still, time, SensorErrors(noise_density=density), seed=1)
    forces = add_errors(still + LEVEL, time, SensorErrors(noise_density=force_density), seed=2)
    found = fixed_gain_observer(rates, forces, PERIOD, GAIN, (0, 0, 0))[1000:]
    expected = at(
        derived.steady_variance(),
        gyro=density / np.sqrt(PERIOD),
        accel=force_density / np.sqrt(PERIOD) / 9.80665,
    )
    # The error remembers (1 - L)^k of itself, which leaves this relative error of a variance.
    kept = (1 - GAIN) ** 2
    uncertainty = np.sqrt(2 * (1 + kept) / (1 - kept) / len(found))
    assert_allclose(found[:, :2].var(axis=0), expected, rtol=4 * uncertainty)


def test_vibration_comes_through_as_derived() -> None:
    frequency, amplitude = 7.0, 0.01
    angle = 2 * np.pi * frequency * PERIOD * np.arange(20_000)
    tilt = amplitude * np.sin(angle)
    forces = chr_notes.accelerometer_at_rest(np.stack([tilt, 0 * tilt, 0 * tilt], axis=1))
    found = fixed_gain_observer(np.zeros_like(forces), forces, PERIOD, GAIN)[1000:, 0]
    share = derived.vibration_share().subs(derived.omega, 2 * np.pi * frequency)
    assert_allclose(found.var(), at(share) * amplitude**2 / 2, rtol=1e-3)
