"""Errors of simulated sensors."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from chr_notes.sensors.simulated import SensorErrors, add_errors, passing_iron

PERIOD = 0.01
TIME = PERIOD * np.arange(200_000)
STILL = np.zeros((len(TIME), 3))


def test_no_errors_leave_the_readings_as_they_are() -> None:
    ideal = np.random.default_rng(0).normal(size=(50, 3))
    assert_array_equal(add_errors(ideal, TIME[:50], SensorErrors(), seed=1), ideal)


def test_bias_is_added_by_axis() -> None:
    read = add_errors(STILL, TIME, SensorErrors(bias=(1.0, 2.0, 3.0)), seed=1)
    assert_array_equal(read, np.tile([1.0, 2.0, 3.0], (len(TIME), 1)))


def test_noise_has_its_density() -> None:
    read = add_errors(STILL, TIME, SensorErrors(noise_density=0.02), seed=2)
    # 200 000 samples know a standard deviation to 0.16 %.
    assert_allclose(read.std(axis=0), 0.02 / np.sqrt(PERIOD), rtol=0.008)
    assert abs(np.corrcoef(read[1:, 0], read[:-1, 0])[0, 1]) < 0.01
    # Integrated over the stretches of 2 s that it falls into: density times the root of time
    integrals = read.reshape(-1, 200, 3).sum(axis=1) * PERIOD
    assert_allclose(integrals.std(axis=0), 0.02 * np.sqrt(2.0), rtol=0.12)


def test_noise_keeps_its_density_where_steps_vary() -> None:
    generator = np.random.default_rng(3)
    steps = generator.choice([0.001, 0.01], size=200_000)
    read = add_errors(STILL, np.cumsum(steps), SensorErrors(noise_density=0.02), seed=4)
    for step in (0.001, 0.01):
        assert_allclose(read[steps == step].std(), 0.02 / np.sqrt(step), rtol=0.01)


def test_the_bias_walks_with_the_root_of_time() -> None:
    ends = []
    for seed in range(200):
        read = add_errors(STILL[:400], TIME[:400], SensorErrors(bias_drift=0.5), seed=seed)
        assert_array_equal(read[0], 0)
        ends.append(read[-1])
    # 600 walks know a standard deviation to 3 %.
    assert_allclose(np.std(ends), 0.5 * np.sqrt(TIME[399]), rtol=0.12)


def test_vibration_is_a_sine() -> None:
    read = add_errors(STILL, TIME, SensorErrors(vibration=2.0, vibration_frequency=7.0), seed=5)
    spectrum = np.abs(np.fft.rfft(read, axis=0)) * 2 / len(TIME)
    peak = round(7.0 * len(TIME) * PERIOD)
    assert_array_equal(spectrum.argmax(axis=0), peak)
    assert_allclose(spectrum[peak], 2.0, rtol=1e-9)


def test_the_seed_decides() -> None:
    errors = SensorErrors(noise_density=1.0, bias_drift=1.0, vibration=1.0)
    first = add_errors(STILL[:20], TIME[:20], errors, seed=6)
    assert_array_equal(first, add_errors(STILL[:20], TIME[:20], errors, seed=6))
    assert (first != add_errors(STILL[:20], TIME[:20], errors, seed=7)).all()


def test_one_error_can_be_changed_alone() -> None:
    both = add_errors(
        STILL[:20], TIME[:20], SensorErrors(noise_density=1.0, bias_drift=1.0), seed=6
    )
    noise = add_errors(STILL[:20], TIME[:20], SensorErrors(noise_density=1.0), seed=6)
    drift = add_errors(STILL[:20], TIME[:20], SensorErrors(bias_drift=1.0), seed=6)
    assert_allclose(noise + drift, both)


def test_passing_iron_comes_and_goes() -> None:
    field = passing_iron([0.0, 1.0, 2.0, 3.0, 4.0], 1.0, 3.0, (10.0, -4.0, 0.0))
    expected = np.outer([0, 0, 1, 0, 0], [10.0, -4.0, 0.0])
    assert_allclose(field, expected, atol=1e-12)


def test_what_cannot_be_simulated_is_refused() -> None:
    errors = SensorErrors()
    with pytest.raises(ValueError, match=r"noise_density: expected numbers that are not negative"):
        SensorErrors(noise_density=(0.0, -1.0, 0.0))
    with pytest.raises(ValueError, match=r"bias: expected a number or shape \(3,\), got \(2,\)"):
        add_errors(STILL[:4], TIME[:4], SensorErrors(bias=(1.0, 2.0)), seed=0)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"ideal: expected shape \(N, 3\), got \(3,\)"):
        add_errors(np.zeros(3), TIME[:4], errors, seed=0)
    with pytest.raises(ValueError, match=r"as many times as readings, at least 2, got 4 times"):
        add_errors(STILL[:5], TIME[:4], errors, seed=0)
    with pytest.raises(ValueError, match=r"time: expected rising times, got \[1.0, 1.0\] at 1"):
        add_errors(STILL[:4], [0.0, 1.0, 1.0, 2.0], errors, seed=0)
    with pytest.raises(
        ValueError, match=r"vibration: expected finite numbers, got \[nan, nan, nan"
    ):
        SensorErrors(vibration=np.nan)
    with pytest.raises(ValueError, match=r"time: expected shape \(N,\), got \(2, 2\)"):
        passing_iron(np.zeros((2, 2)), 1.0, 2.0, (1.0, 0.0, 0.0))
    with pytest.raises(ValueError, match=r"expected start before stop, got 2\.0 and 2\.0"):
        passing_iron(TIME, 2.0, 2.0, (1.0, 0.0, 0.0))
