"""Calibration of accelerometers and gyros from logs, simulated and recorded."""

import copy
import json
import warnings
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from chr_notes import (
    CalibrationWarning,
    RateGyroCalibration,
    ThreeAxisCalibration,
    accelerometer_at_rest,
    fit_accelerometer,
    fit_accelerometer_from_log,
    fit_gyro_at_rest,
    fit_gyro_bias,
    fit_gyro_scale,
    integrate_gyro,
)
from chr_notes.derivations import calibration
from chr_notes.simulation import Readings, at_rest, ideal_readings, minimum_jerk, trajectory

Floats = NDArray[np.float64]
G = 9.80665
LAID = np.radians(
    [[0, 0, 0], [90, 0, 0], [180, 0, 0], [270, 0, 0], [270, 80, 30], [270, -80, 90], [180, -80, 90]]
)
MORE = np.random.default_rng(20).uniform(-1.3, 1.3, (12, 3)) * [2, 1, 1]


def session(seed: int, poses: Floats = LAID) -> Readings:
    """Three seconds in each pose and two of turning to the next, at 50 Hz, with noise."""
    starts = 5.0 * np.arange(len(poses))
    stops = np.sort(np.r_[starts, starts + 3.0])
    time = np.arange(0, stops[-1], 0.02)
    attitude = minimum_jerk(time, stops, np.repeat(poses, 2, axis=0))
    ideal = ideal_readings(trajectory(time, attitude, at_rest(time)))
    generator = np.random.default_rng(seed)
    return Readings(
        time,
        ideal.body_rates + generator.normal(0.01, 0.001, ideal.body_rates.shape),
        ideal.accel + generator.normal(0, 0.01, ideal.accel.shape),
        ideal.mag,
    )


SENSOR = ThreeAxisCalibration(np.eye(3), np.array([1.05, 0.97, 1.02]), np.array([0.3, -0.2, 0.5]))


@pytest.mark.parametrize("seed", range(3))
def test_six_poses_give_sensitivity_and_bias(seed: int) -> None:
    log = session(seed)
    found = fit_accelerometer_from_log(log.body_rates, SENSOR.measure(log.accel), 0.02)
    assert_allclose(found.sensitivity, SENSOR.sensitivity, atol=0.001)
    assert_allclose(found.bias, SENSOR.bias, atol=0.01)
    assert_allclose(found.misalignment, np.eye(3), atol=1e-12)


def test_the_unit_of_the_accelerometer_does_not_matter() -> None:
    log = session(3)
    found = fit_accelerometer_from_log(log.body_rates, SENSOR.measure(log.accel) / G, 0.02)
    assert_allclose(found.sensitivity * G, SENSOR.sensitivity, atol=0.001)


def test_many_poses_give_the_angles_between_the_axes_too() -> None:
    log = session(4, np.concatenate([LAID, MORE]))
    aslant = np.array([[1, 0.02, 0.01], [0.02, 1, -0.03], [0.01, -0.03, 1]])
    sensor = ThreeAxisCalibration(aslant, np.ones(3), np.array([0.3, -0.2, 0.5]))
    found = fit_accelerometer_from_log(log.body_rates, sensor.measure(log.accel), 0.02)
    lengths = np.linalg.norm(found.correct(sensor.measure(log.accel)), axis=1)
    assert_allclose(lengths, G, atol=0.08)
    assert_allclose(found.misalignment, aslant, atol=0.003)


def test_glitches_do_no_harm() -> None:
    log = session(5)
    readings = SENSOR.measure(log.accel)
    readings[::97, 1] += 1e5
    log.body_rates[::151, 0] = 1e7
    found = fit_accelerometer_from_log(log.body_rates, readings, 0.02)
    assert_allclose(found.sensitivity, SENSOR.sensitivity, atol=0.001)


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("whole", [1, -1])
def test_a_backward_axis_is_named(axis: int, whole: int) -> None:
    log = session(6)
    signs = np.full(3, whole)
    signs[axis] = -whole
    with pytest.warns(CalibrationWarning, match=f"the {'xyz'[axis]}-axis of the accelerometer"):
        fit_accelerometer_from_log(log.body_rates, signs * log.accel, 0.02)


def test_poses_that_are_missing_are_named() -> None:
    log = session(7)
    few = slice(0, 1000)
    with pytest.raises(ValueError, match="expected at least 6 still poses, got 4: lay the sensor"):
        fit_accelerometer_from_log(log.body_rates[few], log.accel[few], 0.02)
    flat = session(8, np.radians([[15 * k, 0, 0] for k in range(8)]))
    with pytest.raises(ValueError, match=r"6 different poses all around, got \d in 8 still .* up:"):
        fit_accelerometer_from_log(flat.body_rates, flat.accel, 0.02)
    with pytest.raises(ValueError, match=r"got 0: .*; rates in °/s, too, leave"):
        fit_accelerometer_from_log(np.degrees(log.body_rates), log.accel, 0.02)
    with pytest.raises(ValueError, match="gravity: expected a positive number, got 0"):
        fit_accelerometer_from_log(log.body_rates, log.accel, 0.02, 0.0)


def test_swapped_positions_are_warned_of() -> None:
    six = G * np.stack([np.eye(3), -np.eye(3)], axis=1).reshape(6, 3)
    with pytest.warns(CalibrationWarning, match="backwards along z, so .* left-handed"):
        fit_accelerometer(six[[0, 1, 2, 3, 5, 4]])
    with pytest.warns(CalibrationWarning, match="backwards along x, y, z, so .* left-handed"):
        fit_accelerometer(-six)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fit_accelerometer(six[[1, 0, 3, 2, 4, 5]])  # a sensor that was mounted the other way round


def recorded_session(recordings: Path) -> tuple[Floats, Floats, dict[str, slice]]:
    session = np.loadtxt(recordings / "imucal_ferraris_session.csv", delimiter=",", skiprows=1)
    listed = json.loads((recordings / "imucal_ferraris_session_list.json").read_text())
    parts = {name: slice(part["start"], part["end"]) for name, part in listed.items()}
    return np.radians(session[:, 1:4]), session[:, 4:], parts


def test_a_recorded_session_is_cut_by_itself(recordings: Path) -> None:
    rates, forces, parts = recorded_session(recordings)
    found = fit_accelerometer_from_log(rates, forces, 1 / 102.4, 9.81)
    names = ("x_p", "x_a", "y_p", "y_a", "z_p", "z_a")
    marked = np.array([forces[parts[name]].mean(axis=0) for name in names])
    assert np.abs(np.linalg.norm(marked, axis=1) / 9.81 - 1).max() > 0.05
    assert np.abs(np.linalg.norm(found.correct(marked), axis=1) / 9.81 - 1).max() < 0.0005
    by_hand = fit_accelerometer(marked, 9.81)
    assert_allclose(found.sensitivity, by_hand.sensitivity, atol=0.0005)
    assert_allclose(found.bias, by_hand.bias, atol=0.01)
    with pytest.warns(CalibrationWarning, match="the z-axis of the accelerometer"):
        fit_accelerometer_from_log(rates, forces * [1, 1, -1], 1 / 102.4, 9.81)


# Gyros


def test_a_bias_is_what_correct_takes() -> None:
    rates = np.random.default_rng(9).normal([0.1, -0.2, 0.3], 0.001, (1000, 3))
    found = fit_gyro_at_rest(rates)
    assert_allclose(found.bias, [fit_gyro_bias(rates)], atol=1e-15)
    assert_allclose(found.correct(rates, np.zeros(3)), rates + fit_gyro_bias(rates), atol=1e-15)
    assert_allclose(found.correct(rates, np.zeros(3)).mean(axis=0), np.zeros(3), atol=1e-15)


@pytest.mark.parametrize("seed", range(3))
def test_the_bias_over_temperature_is_found(seed: int) -> None:
    generator = np.random.default_rng(seed)
    warmth = np.linspace(15, 55, 4000) + generator.normal(0, 0.1, 4000)
    coefficients = generator.normal(0, [[0.02], [1e-3], [1e-5]], (3, 3))
    actual = np.polynomial.polynomial.polyval(warmth, coefficients).T
    rates = actual + generator.normal(0, 0.001, actual.shape)
    rates[::100], rates[50::500] = np.nan, 1e7
    found = fit_gyro_at_rest(rates, warmth)
    assert_allclose(found.correct(actual, np.zeros(3), warmth), 0, atol=3e-4)
    assert_allclose(-found.bias, coefficients, atol=0.002)


def test_temperatures_that_tell_nothing_are_refused() -> None:
    rates = np.random.default_rng(10).normal(0, 0.001, (100, 3))
    with pytest.raises(ValueError, match="a change of at least 2 °C, got"):
        fit_gyro_at_rest(rates, np.linspace(20, 20.5, 100))
    with pytest.raises(TypeError, match="integer"):
        fit_gyro_at_rest(rates, np.linspace(20, 30, 100), degree=1.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"temperature: expected shape \(100,\), got \(3,\)"):
        fit_gyro_at_rest(rates, [20.0, 21.0, 22.0])
    with pytest.raises(ValueError, match="degree: expected 0 or more, got -1"):
        fit_gyro_at_rest(rates, np.linspace(20, 30, 100), degree=-1)
    with pytest.raises(ValueError, match="expected more than 2 temperatures, got 2"):
        fit_gyro_at_rest(rates, np.repeat([20.0, 30.0], 50))
    with pytest.raises(ValueError, match=r"a sensor at rest, .* about a polynomial in temperature"):
        fit_gyro_at_rest(rates * 100, np.linspace(20, 30, 100))


def test_temperatures_beyond_those_of_the_fit_are_noticed() -> None:
    warmth = np.linspace(20, 40, 500)
    found = fit_gyro_at_rest(0.001 * warmth[:, np.newaxis] * np.ones(3), warmth, degree=1)
    assert found.temperatures == (20, 40)
    for copied in (found, copy.deepcopy(found)):
        copied.correct(np.zeros((2, 3)), np.zeros(3), [18.1, 41.9])
        with pytest.warns(UserWarning, match=r"from 20 to 40, .*, got 43: its poly") as told:
            copied.correct(np.zeros(3), np.zeros(3), 43.0)
        assert [warning.filename for warning in told] == [__file__]


def test_an_accelerometer_tells_a_slow_turn_from_a_bias() -> None:
    rates = np.tile([0.02, 0.0, 0.0], (300, 1))
    forces = accelerometer_at_rest(integrate_gyro(rates, 0.01))
    forces[100, 2] = 1e7
    with pytest.raises(ValueError, match=r"accelerometer turned by 3\.3°"):
        fit_gyro_at_rest(rates, accel=forces)
    still = np.tile([0.1, 0.2, -1.0], (300, 1))
    assert fit_gyro_at_rest(rates, accel=still).bias[0] == pytest.approx([-0.02, 0, 0])
    with pytest.raises(ValueError, match="accel: expected readings of gravity, got 0 whole ones"):
        fit_gyro_at_rest(rates, accel=np.nan * still)


AXES = np.array([[2, 0, 0.1], [0, -3, 0], [0.2, 0, 4], [1, 1, -1]]) * np.pi / 2


def turns(gyro: RateGyroCalibration, warmth: Floats | None = None) -> Floats:
    """Two seconds of rest and one of turning, by turns, at 100 Hz."""
    actual = np.zeros((300 * len(AXES) + 200, 3))
    bell = np.sin(np.pi * np.arange(100) / 100) ** 2
    for number, axis in enumerate(AXES):
        actual[300 * number + 200 : 300 * number + 300] = bell[:, np.newaxis] * axis / 0.5
    noise = np.random.default_rng(11).normal(0, 0.0005, actual.shape)
    return gyro.measure(actual, np.zeros(3), warmth) + noise


def test_turns_of_known_angle_give_the_model() -> None:
    misalignment = np.array([[1, 0.02, -0.01], [0.01, 1, 0.03], [-0.02, 0.01, 1]])
    bias = np.array([0.01, -0.02, 0.03])
    gyro = RateGyroCalibration(misalignment, np.array([1.03, 0.98, 1.01]), bias, np.zeros((3, 3)))
    known = [(slice(300 * k + 190, 300 * k + 310), axis) for k, axis in enumerate(AXES)]
    found = fit_gyro_scale(turns(gyro), 0.01, known)
    assert_allclose(found.misalignment, misalignment, atol=5e-4)
    assert_allclose(found.sensitivity, gyro.sensitivity, atol=5e-4)
    assert_allclose(found.bias, gyro.bias, atol=3e-4)
    symbols = dict(zip(calibration.MISALIGNMENT, misalignment.flat, strict=True))
    symbols |= dict(zip(calibration.SENSITIVITY, gyro.sensitivity[0], strict=True))
    symbols |= dict(zip(calibration.INPUT, AXES[3], strict=True))
    derived = np.array(calibration.turned_reading().subs(symbols), dtype=float)[:, 0]
    summed = (turns(gyro)[known[3][0]] - gyro.measure(np.zeros(3), np.zeros(3))).sum(axis=0) / 100
    assert_allclose(summed, derived, atol=3e-3)


def test_the_sensitivity_over_temperature_is_found() -> None:
    warmth = np.linspace(20, 40, 300 * len(AXES) + 200)
    sensitivity = np.array([[1.0, 1.0, 0.98], [0.0, 0.0, 0.001]])
    gyro = RateGyroCalibration(np.eye(3), sensitivity, np.full(3, 0.01), np.zeros((3, 3)))
    known = [(slice(300 * k + 190, 300 * k + 310), [0, 0, 0]) for k in range(len(AXES))]
    known = [(part, axis * [0, 0, 1]) for (part, _), axis in zip(known, AXES, strict=True)]
    readings = turns(gyro, warmth) * [0, 0, 1]
    found = fit_gyro_scale(readings, 0.01, known[2:], temperature=warmth)
    assert_allclose(found.sensitivity[:, 2], sensitivity[:, 2], rtol=0.1)
    at_33 = found.correct([0, 0, 1.0], np.zeros(3), 33.0)
    assert_allclose(at_33[2], (1.0 + 0.01) / (0.98 + 0.033), atol=1e-3)
    assert_allclose(found.sensitivity[:, :2], [[1, 1], [0, 0]])


def test_turns_the_other_way_round_are_refused() -> None:
    plain = RateGyroCalibration(np.eye(3), np.ones(3), np.zeros(3), np.zeros((3, 3)))
    readings = turns(plain)
    with pytest.raises(ValueError, match=r"turn 0 to be 180° about its axis, .* got -180° from"):
        fit_gyro_scale(readings, 0.01, [(slice(190, 310), [-np.pi, 0, 0])])
    with pytest.raises(ValueError, match="expected at least one turn, got none"):
        fit_gyro_scale(readings, 0.01, [])
    with pytest.raises(ValueError, match=r"an axis times an angle, got .* for turn 0"):
        fit_gyro_scale(readings, 0.01, [(slice(190, 310), [0, 0, 0])])


def test_recorded_turns_give_the_sensitivity(recordings: Path) -> None:
    rates, _, parts = recorded_session(recordings)
    known = [
        (parts[f"{name}_rot"], -2 * np.pi * axis)
        for name, axis in zip("xyz", np.eye(3), strict=True)
    ]
    found = fit_gyro_scale(rates, 1 / 102.4, known)
    corrected = found.correct(rates, np.zeros(3))
    for part, vector in known:
        assert_allclose(corrected[part].sum(axis=0) / 102.4, vector, atol=1e-6)
    assert np.abs(found.sensitivity - 1).max() < 0.03
    at_rest = np.degrees(corrected[parts["x_p"]].mean(axis=0))
    assert np.abs(at_rest).max() < 0.05
