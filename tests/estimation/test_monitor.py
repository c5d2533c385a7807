"""The monitor of the factor E."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import chr_notes
from chr_notes import Monitor, Watch, fixed_gain_observer, monitored_observer, validation_factor
from chr_notes.sensors.simulated import SensorErrors, add_errors, passing_iron
from chr_notes.simulation import Readings, at_rest, ideal_readings, swing, trajectory

TIME = np.arange(0, 40, 0.01)
TRUTH = trajectory(TIME, swing(TIME, [0.4, 0.3, 0.5], [0.2, 0.15, 0.1]), at_rest(TIME))
FIELD = np.array([20.0, 0.0, 45.0])
DOWN = float(FIELD[2] / np.linalg.norm(FIELD))


def watched(monitor: Monitor, factors: list[float]) -> list[Watch]:
    found = [monitor.begin()]
    for factor in factors:
        found.append(monitor.watch(found[-1], factor))
    return found[1:]


def run(readings: Readings, monitor: Monitor) -> chr_notes.Monitored:
    return monitored_observer(
        readings.body_rates, readings.accel, readings.mag, 0.01,
        reference_down=DOWN, monitor=monitor,
    )  # fmt: skip


def test_the_gain_is_adapted_first_and_then_there_is_an_alarm() -> None:
    found = watched(Monitor(0.1, patience=2), [0.0, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.1, 0.2])
    assert [each.gain for each in found] == [0.02, 0.07, 0.07, 0.01, 0.01, 0.02, 0.02, 0.02, 0.07]
    assert [each.alarm for each in found] == [False] * 5 + [True] * 2 + [False] * 2


def test_gains_stay_in_the_range_of_the_paper() -> None:
    factors = np.random.default_rng(0).uniform(0, 0.2, 500).tolist()
    gains = [each.gain for each in watched(Monitor(0.1, patience=3), factors)]
    assert (min(gains), max(gains)) == (0.01, 0.07)


def test_nan_tells_nothing() -> None:
    monitor = Monitor(0.1, patience=1)
    with_gap = watched(monitor, [0.2, np.nan, np.nan, 0.2, 0.2])
    assert [each.alarm for each in with_gap] == [False, False, False, False, True]
    assert with_gap[1] == with_gap[0]


def test_without_faults_it_is_the_observer() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    found = run(ideal, Monitor(0.1, patience=50))
    expected = fixed_gain_observer(ideal.body_rates, ideal.accel, 0.01, 0.02)
    assert_allclose(found.euler, expected, atol=1e-12)
    assert_allclose(found.factor, validation_factor(ideal.mag, expected[:, :2], DOWN), atol=1e-12)
    assert_array_equal(found.gain, 0.02)
    assert not found.alarm.any()


def test_it_starts_at_the_first_tilt_as_the_observer_does() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    ideal.accel[:3] = np.nan
    found = run(ideal, Monitor(0.1, patience=50))
    expected = fixed_gain_observer(ideal.body_rates, ideal.accel, 0.01, 0.02)
    assert np.isnan(expected[:3]).all()
    assert_allclose(found.euler, expected, atol=1e-12)
    assert_array_equal(np.isnan(found.factor), np.arange(len(TIME)) < 3)
    assert_array_equal(found.gain, 0.02)
    assert not found.alarm.any()


def test_it_is_the_observer_step_by_step_with_the_gain_of_the_watch() -> None:
    iron = passing_iron(TIME, 10.0, 20.0, (0.0, 40.0, -60.0))
    readings = ideal_readings(TRUTH, FIELD + iron)
    rates = add_errors(readings.body_rates, TIME, SensorErrors(noise_density=1e-3), seed=1)
    accel = add_errors(readings.accel, TIME, SensorErrors(noise_density=0.02), seed=2)
    mag = readings.mag.copy()
    rates[100], accel[200:210], mag[1100:1105], mag[1200] = np.nan, 0.0, np.nan, 0.0
    monitor = Monitor(0.1, patience=40, gain=0.03)
    found = run(replace(readings, body_rates=rates, accel=accel, mag=mag), monitor)
    watch = monitor.begin()
    euler = np.array([*chr_notes.tilt_from_accelerometer(accel[0]), 0.0])
    for sample, (turning, force, flux) in enumerate(zip(rates, accel, mag, strict=True)):
        assert found.gain[sample] == watch.gain
        if sample:
            euler = chr_notes.observe_sample(euler, turning, force, 0.01, watch.gain)
        factor = validation_factor(flux, euler[:2], DOWN)
        watch = monitor.watch(watch, float(factor))
        assert found.alarm[sample] == watch.alarm
        assert_allclose(found.factor[sample], factor, atol=1e-10)
        if np.isfinite(turning).all():
            assert_allclose(found.euler[sample], euler, atol=1e-10)
    assert set(found.gain) == {0.01, 0.03, 0.07}


def test_a_disturbed_field_raises_an_alarm_that_ends() -> None:
    iron = passing_iron(TIME, 10.0, 20.0, (0.0, 40.0, -60.0))
    found = run(ideal_readings(TRUTH, FIELD + iron), Monitor(0.1, patience=50))
    assert found.alarm.any()
    assert TIME[found.alarm].min() > 11.0
    assert TIME[found.alarm].max() < 20.0
    # The angles do not come from the field, so they stay right.
    inclination = chr_notes.matrix_from_euler(found.euler)[..., 2]
    truth = chr_notes.matrix_from_euler(TRUTH.euler)[..., 2]
    assert np.degrees(np.linalg.norm(inclination - truth, axis=1)).max() < 0.5


def test_a_gyro_that_fails_is_heard_less_before_there_is_an_alarm() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    broken = add_errors(ideal.body_rates, TIME, SensorErrors(bias=(0.5, 0.5, 0.0)), seed=1)
    faulty = Readings(ideal.time, broken, ideal.accel, ideal.mag)
    found = run(faulty, Monitor(0.1, patience=20))
    constant = fixed_gain_observer(broken, ideal.accel, 0.01, 0.02)
    assert 0.07 in found.gain
    assert found.factor.mean() < validation_factor(ideal.mag, constant[:, :2], DOWN).mean()


def test_missing_samples_leave_the_watch_as_it_was() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    ideal.mag[100] = np.nan
    ideal.body_rates[200, 1] = np.nan
    found = run(ideal, Monitor(0.1, patience=50))
    assert np.flatnonzero(np.isnan(found.factor)).tolist() == [100]
    assert np.flatnonzero(np.isnan(found.euler).any(axis=1)).tolist() == [200]


REFUSED = {
    "threshold": (lambda: Monitor(0.0, 5), r"threshold: expected a positive number, got 0\.0"),
    "threshold of NaN": (lambda: Monitor(np.nan, 5), "threshold: expected a positive number"),
    "patience": (lambda: Monitor(0.1, 0), "patience: expected a whole number .* or more, got 0"),
    "half a sample": (lambda: Monitor(0.1, 1.5), "patience: expected a whole number .* got 1.5"),  # type: ignore[arg-type]
    "a gain above 1": (
        lambda: Monitor(0.1, 5, highest=1.5),
        r"highest: expected a number from 0 to 1, got 1\.5",
    ),
    "gains out of order": (
        lambda: Monitor(0.1, 5, gain=0.005),
        r"expected lowest <= gain <= highest, got 0\.01, 0\.005 and 0\.07",
    ),
    "a part down in microtesla": (
        lambda: monitored_observer(
            np.zeros((1, 3)), [[0, 0, -1.0]], [[1.0, 0, 1]], 0.1,
            reference_down=45.0, monitor=Monitor(0.1, 5),
        ),
        "reference_down: expected the part down of a field of magnitude 1",
    ),
    "many parts down": (
        lambda: monitored_observer(
            np.zeros((1, 3)), [[0, 0, -1.0]], [[1.0, 0, 1]], 0.1,
            reference_down=[0.5, 0.5], monitor=Monitor(0.1, 5),  # type: ignore[arg-type]
        ),
        r"reference_down: expected a number, got shape \(2,\)",
    ),
    "sensors of different lengths": (
        lambda: monitored_observer(
            np.zeros((2, 3)), np.zeros((2, 3)), np.zeros((1, 3)), 0.1,
            reference_down=0.5, monitor=Monitor(0.1, 5),
        ),
        "expected as many rows in each of body_rates, accel, mag, got 2, 2, 1",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_rules_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()
