"""Which sensor to hold out, and what the paper's monitor and this make of recordings."""

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from numpy.typing import NDArray

from chr_notes import (
    Monitor,
    accelerated,
    doubtful_sensors,
    fit_gyro_bias,
    fixed_gain_observer,
    matrix_from_euler,
    matrix_from_quaternion,
    monitored_observer,
    static_interval,
    validation_factor,
)
from chr_notes.simulation import at_rest, ideal_readings, swing, trajectory

Floats = NDArray[np.float64]
G = 9.80665
TIME = np.arange(0, 20, 0.01)
TRUTH = trajectory(TIME, swing(TIME, [0.4, 0.3, 0.5], [0.2, 0.15, 0.1]), at_rest(TIME))
FIELD = np.array([20.0, 0.0, 45.0])
STRENGTH = float(np.linalg.norm(FIELD))
DOWN = float(FIELD[2] / STRENGTH)


def doubts(accel: Floats, mag: Floats, euler: Floats) -> list[NDArray[np.bool_]]:
    return list(doubtful_sensors(accel, mag, euler, 0.01, strength=STRENGTH, reference_down=DOWN))


def test_without_faults_there_is_no_doubt() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    for each in doubts(ideal.accel, ideal.mag, TRUTH.euler):
        assert not each.any()


def test_a_push_puts_the_accelerometer_in_doubt_for_a_while() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    ideal.accel[500:510] *= 1.6
    accel, mag, attitude = doubts(ideal.accel, ideal.mag, TRUTH.euler)
    assert_array_equal(np.flatnonzero(accel), np.arange(500, 610))
    assert not mag.any()
    assert not attitude.any()
    assert_array_equal(accelerated(ideal.accel, 0.01), accel)
    assert accelerated(ideal.accel / G, np.full(2000, 0.01), gravity=1.0).sum() == 110


def test_iron_puts_the_magnetometer_in_doubt() -> None:
    stronger, turned = ideal_readings(TRUTH, FIELD), ideal_readings(TRUTH, FIELD)
    stronger.mag[700:800] *= 1.3
    accel, mag, attitude = doubts(stronger.accel, stronger.mag, TRUTH.euler)
    assert_array_equal(np.flatnonzero(mag), np.arange(700, 900))
    # As strong, but from elsewhere.
    elsewhere = ideal_readings(TRUTH, np.array([45.0, 0.0, 20.0])).mag
    turned.mag[700:800] = elsewhere[700:800]
    accel, mag, attitude = doubts(turned.accel, turned.mag, TRUTH.euler)
    assert_array_equal(np.flatnonzero(mag), np.arange(700, 900))
    assert not accel.any()
    assert not attitude.any()


def test_an_attitude_that_the_gyros_led_astray_is_told_from_iron() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    ideal.accel[400:600] *= 1.6
    wrong = TRUTH.euler.copy()
    wrong[450:650, 1] += 0.6
    _, mag, attitude = doubts(ideal.accel, ideal.mag, wrong)
    assert attitude[450:650].mean() > 0.9
    assert not mag.any()


def planted(onset: Floats, *, force: bool = True) -> tuple[Floats, Floats]:
    """Readings with noise, and a fault in the room's axes on top from 10 s on."""
    generator = np.random.default_rng(7)
    ideal = ideal_readings(TRUTH, FIELD)
    fault = np.einsum("nij,nj->ni", matrix_from_euler(TRUTH.euler), onset)
    accel = ideal.accel + generator.normal(0, 0.05, fault.shape) + (fault if force else 0)
    return accel, ideal.mag + generator.normal(0, 0.3, fault.shape) + (0 if force else fault)


SINCE = np.maximum(TIME - 10, 0)


@pytest.mark.parametrize(
    ("frequency", "axis", "delay"), [(1, 0, 0.14), (2, 0, 0.07), (5, 0, 0.03), (1, 2, 0.06)]
)
def test_shaking_is_noticed_after_a_moment(frequency: float, axis: int, delay: float) -> None:
    push = 1.5 * G * np.sin(2 * np.pi * frequency * SINCE)
    found = accelerated(planted(np.outer(push, np.eye(3)[axis]))[0], 0.01)
    assert np.argmax(found) == pytest.approx(1000 + 100 * delay, abs=1.5)
    assert found[1000 + round(100 * delay) + 2 :].all()


@pytest.mark.parametrize(("push", "noticed"), [(1.05, False), (1.2, True)])
def test_a_steady_push_is_noticed_at_once_or_never(push: float, noticed: bool) -> None:  # noqa: FBT001
    found = accelerated(planted(np.outer(push * G * (SINCE > 0), [1, 0, 0]))[0], 0.01)
    assert not found[:1001].any()
    assert found[1010:].all() == found.any() == noticed


@pytest.mark.parametrize(
    ("axis", "least", "heading"), [(0, 11.7, 0.0), (2, 10.4, 0.0), (1, 24.7, 51.0)]
)
def test_iron_that_comes_near_is_noticed_at_a_limit(
    axis: int, least: float, heading: float
) -> None:
    iron = np.outer(np.minimum(5 * SINCE, 40), np.eye(3)[axis])
    accel, mag = planted(iron, force=False)
    found = doubts(accel, mag, TRUTH.euler)[1]
    first = int(np.argmax(found))
    assert iron[first, axis] == pytest.approx(least, abs=0.8)
    assert found[first:].all()
    north, east, _ = FIELD + iron[first]
    assert np.degrees(np.arctan2(east, north)) == pytest.approx(heading, abs=1.5)


def test_a_missing_row_says_nothing() -> None:
    ideal = ideal_readings(TRUTH, FIELD)
    ideal.accel[300], ideal.mag[400], TRUTH.euler[0] = np.nan, np.nan, TRUTH.euler[0]
    for each in doubts(ideal.accel, ideal.mag, TRUTH.euler):
        assert not each.any()
    assert accelerated(np.zeros((0, 3)), 0.01).shape == (0,)


@pytest.mark.parametrize("name", ["limit", "patience", "gravity"])
def test_limits_have_to_be_positive(name: str) -> None:
    with pytest.raises(ValueError, match=f"{name}: expected a positive number, got 0"):
        accelerated(np.ones((5, 3)), 0.01, **{name: 0.0})


Trial = tuple[Floats, Floats, Floats, Floats, NDArray[np.bool_]]
STEP = 1 / 95.24


def trial(recordings: Path, name: str) -> Trial:
    file = recordings / f"broad_{name}_A_95hz_ned.csv"
    log = np.genfromtxt(file, delimiter=",", names=True)
    rates, forces, field = (
        np.stack([log[f"{letter}{axis}_{unit}"] for axis in "xyz"], axis=1)
        for letter, unit in (("g", "rad_s"), ("a", "m_s2"), ("m", "uT"))
    )
    truth = np.stack([log[f"q{part}"] for part in "wxyz"], axis=1)
    rates += fit_gyro_bias(rates[static_interval(rates, 190)])
    return rates, forces, field, truth, log["moving"] == 1


def off(euler: Floats, truth: Floats, moving: NDArray[np.bool_]) -> float:
    """Root mean square of the angle between verticals, degrees."""
    scored = moving & ~np.isnan(truth).any(axis=1)
    one, other = (
        matrix[:, :, 2]
        for matrix in (matrix_from_euler(euler[scored]), matrix_from_quaternion(truth[scored]))
    )
    sine, cosine = np.linalg.norm(np.cross(one, other), axis=1), (one * other).sum(axis=1)
    return float(np.degrees(np.sqrt(np.mean(np.arctan2(sine, cosine) ** 2))))


# Trial; degrees without a rule, by the paper's, and with the accelerometer held out.
MEASURED = {
    "01_slow_rotation": (0.75, 0.75, 0.76),
    "06_fast_rotation": (2.05, 2.40, 1.99),
    "15_fast_translation": (24.0, 32.0, 9.2),
}


@pytest.mark.parametrize("name", MEASURED)
def test_holding_out_helps_where_the_rule_of_the_paper_hurts(recordings: Path, name: str) -> None:
    rates, forces, field, truth, moving = trial(recordings, name)
    plain = fixed_gain_observer(rates, forces, STEP, 0.02)
    rest = field[~moving] / np.linalg.norm(field[~moving], axis=1, keepdims=True)
    level = np.einsum("nji,nj->ni", matrix_from_euler(plain[~moving]), rest)
    papers = monitored_observer(
        rates, forces, field, STEP,
        reference_down=float(np.median(level[:, 2])), monitor=Monitor(0.1, 10),
    )  # fmt: skip
    doubt = accelerated(forces, STEP)
    heard = np.where(doubt[:, np.newaxis], np.nan, forces)
    held = fixed_gain_observer(rates, heard, STEP, 0.02)
    found = [off(euler, truth, moving) for euler in (plain, papers.euler, held)]
    assert found == pytest.approx(MEASURED[name], rel=0.03)
    assert not doubt[:1000].any()
    if name == "01_slow_rotation":
        assert doubt[moving].mean() < 0.025


@pytest.mark.parametrize("name", MEASURED)
def test_false_alarms_are_rare_by_the_true_attitude(recordings: Path, name: str) -> None:
    _, _, field, truth, moving = trial(recordings, name)
    scored = moving & ~np.isnan(truth).any(axis=1)
    to_body = matrix_from_quaternion(truth[scored])
    level = np.einsum("nji,nj->ni", to_body, field[scored])
    sizes = np.linalg.norm(field[scored], axis=1)
    down = float(np.median(level[:, 2] / sizes))
    tilt = np.stack(
        [np.arctan2(to_body[:, 1, 2], to_body[:, 2, 2]), -np.arcsin(to_body[:, 0, 2])], 1
    )
    factor = validation_factor(field[scored], tilt, down)
    assert np.mean(factor > 0.1) < 0.01
    strength = np.median(np.linalg.norm(field[~moving], axis=1))
    assert np.mean(np.abs(sizes / strength - 1) > 0.2) < 0.001
