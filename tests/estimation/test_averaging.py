"""The averaging filter over recordings: closed forms, other people's numbers, and what may come."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes import (
    EarthField,
    accelerometer_at_rest,
    averaged_attitude,
    averaging_bound,
    averaging_observer,
    fit_gyro_bias,
    fixed_gain_observer,
    integrate_gyro,
    matrix_from_euler,
    quaternion_from_euler,
)

Floats = NDArray[np.float64]
PERIOD, GRAVITY = 0.01, 9.80665
FIELD = np.array([18.0, 0.0, 45.0])


def still(count: int, roll: float = 0.0, pitch: float = 0.0) -> tuple[Floats, Floats]:
    """What a body at rest reads."""
    return np.zeros((count, 3)), np.tile(accelerometer_at_rest([roll, pitch, 0.0]), (count, 1))


def tumbling(count: int, period: float = PERIOD) -> tuple[Floats, Floats, Floats]:
    """Rates of up to 300 °/s about an axis that wanders, through the pole too, and the truth."""
    time = period * np.arange(count)[:, np.newaxis]
    rates = 3 * np.cos(time * [0.7, 0.5, 0.3] + [0.0, 1.0, 2.0])
    truth = integrate_gyro(rates, period, [0.1, -0.2, 0.7])
    return rates, accelerometer_at_rest(truth), truth


def tilt_off(euler: Floats, truth: Floats) -> Floats:
    """Angle between two verticals, radians, row by row."""
    one, other = matrix_from_euler(euler)[..., 2], matrix_from_euler(truth)[..., 2]
    return np.asarray(2 * np.arcsin(np.clip(np.linalg.norm(one - other, axis=-1) / 2, 0, 1)))


def apart(euler: Floats, truth: Floats) -> Floats:
    """Angle between attitudes, radians, row by row."""
    one, other = quaternion_from_euler(euler), quaternion_from_euler(truth)
    nearest = np.minimum(*(np.linalg.norm(one - s * other, axis=-1) for s in (1, -1)))
    return np.asarray(4 * np.arcsin(np.clip(nearest / 2, 0, 1)))


def test_perfect_sensors_are_followed_through_the_pole() -> None:
    rates, forces, truth = tumbling(6000)
    start = averaging_observer(rates, forces, PERIOD, bias=0)
    assert tilt_off(start, truth).max() < 1e-9
    field = np.einsum("nij,j->ni", matrix_from_euler(truth), FIELD)
    euler = averaging_observer(rates, forces, PERIOD, bias=0, mag=field)
    assert apart(euler, truth).max() < 1e-9
    assert np.abs(truth[:, 1]).max() > 1.5
    assert (np.abs(euler[:, [0, 2]]) <= np.pi).all()
    assert (np.abs(euler[:, 1]) <= np.pi / 2).all()


def test_vibration_comes_through_as_scipys_low_pass_has_it() -> None:
    rates, forces = still(6000)
    shake = 0.5 * np.random.default_rng(1).normal(size=6000)
    forces[:, 1] += shake
    roll = averaging_observer(rates, forces, PERIOD, bias=0)[:, 0]
    # Once it has run in; a small force across tilts by itself over gravity, to the third order.
    above, below = scipy.signal.butter(2, np.sqrt(2) / 3.0, analog=True)
    held = scipy.signal.cont2discrete((above, below), PERIOD)
    expected = scipy.signal.lfilter(held[0].ravel(), held[1], np.r_[-shake / GRAVITY, 0.0])[1:]
    assert_allclose(roll[3000:], expected[3000:], atol=2e-4)
    digital = scipy.signal.lfilter(
        *scipy.signal.butter(2, np.sqrt(2) / 3 / np.pi * PERIOD), -shake / GRAVITY
    )
    assert_allclose(roll[3000:], digital[3000:], atol=5e-4)
    assert np.std(roll[3000:]) == pytest.approx(0.5 / GRAVITY * np.sqrt(PERIOD / 6), rel=0.3)


def test_until_it_has_run_in_it_is_a_mean() -> None:
    rates, forces = still(250)
    forces[:, 1] += np.random.default_rng(2).normal(size=250)
    found = averaged_attitude(rates, forces, PERIOD, bias=0)
    # The first sample has no time step of its own.
    means = np.cumsum(forces[1:], axis=0) / np.arange(1, 250)[:, np.newaxis]
    assert_allclose(found.euler[1:, 0], np.arctan2(-means[:, 1], -means[:, 2]), atol=1e-12)
    assert_allclose(found.averaged, PERIOD * np.arange(250))


def test_a_bias_costs_itself_times_the_time_constant() -> None:
    rates, forces = still(9000)
    rates[:, 0] = 0.004
    for constant in (1.0, 3.0, 6.0):
        euler = averaging_observer(rates, forces, PERIOD, bias=0, time_constant=constant)
        assert euler[-1, 0] == pytest.approx(0.004 * constant, rel=0.01)
        settled = averaged_attitude(rates, forces, PERIOD, bias=0, time_constant=constant)
        assert settled.tilt_bound[-1] > euler[-1, 0]
    for bias in ("stillest", "running", [-0.004, 0, 0], fit_gyro_bias(rates)):
        euler = averaging_observer(rates, forces, PERIOD, bias=bias)  # type: ignore[arg-type]
        assert abs(euler[-1, 0]) < 1e-5


def test_steps_may_change_and_so_may_the_rate() -> None:
    rates, forces, truth = tumbling(6000, 0.005)
    keep = np.sort(np.random.default_rng(3).choice(6000, 4000, replace=False))
    steps = 0.005 * np.diff(keep, prepend=keep[0])
    # A mean rate over each step that is left.
    angle = np.cumsum(0.005 * rates, axis=0)
    mean = np.diff(angle[keep], axis=0, prepend=angle[keep[:1]]) / np.maximum(steps, 1e-9)[:, None]
    euler = averaging_observer(mean, forces[keep], steps, bias=0)
    assert tilt_off(euler, truth[keep]).max() < np.radians(0.2)


def test_after_a_gap_it_soon_believes_the_force_again() -> None:
    rates, forces = still(2000)
    forces[1000:] = accelerometer_at_rest([0.8, 0.0, 0.0])
    steps = np.full(2000, PERIOD)
    steps[1000] = 5.0
    found = averaged_attitude(rates, forces, steps, bias=0)
    assert found.averaged[999] == 3.0
    assert found.averaged[1000] < 0.2
    assert found.tilt_bound[1000] > 10 * found.tilt_bound[999]
    assert abs(found.euler[1000, 0] - 0.8) < 0.2
    assert abs(found.euler[1100, 0] - 0.8) < 0.03
    assert found.averaged[-1] == 3.0
    # Without the gap it is the gyros that are believed, for a while.
    assert averaging_observer(rates, forces, PERIOD, bias=0)[1010, 0] < 0.1


@pytest.mark.parametrize("missing", [np.nan, np.inf, 1e300])
def test_what_is_missing_changes_nothing_at_once(missing: float) -> None:
    rates, forces, truth = tumbling(3000)
    holes = forces.copy()
    holes[1000:1100, 1] = missing
    holes[1500] = 0.0
    found = averaged_attitude(rates, holes, PERIOD, bias=0)
    assert tilt_off(found.euler, truth).max() < 1e-6
    assert found.averaged[1099] < 3.0
    assert found.averaged[1500] > 2.9
    gone = rates.copy()
    gone[1000, 2] = missing
    euler = averaging_observer(gone, forces, PERIOD, bias=0)
    assert np.isnan(euler[1000]).all()
    assert np.isfinite(euler[1001:]).all()
    assert tilt_off(euler[1001:], truth[1001:])[0] < 0.04
    assert tilt_off(euler[-1], truth[-1]) < 0.001


@pytest.mark.parametrize("glitch", [1e3, 1e7, -1e11])
def test_a_glitch_of_the_force_is_no_more_than_a_knock(glitch: float) -> None:
    rates, forces = still(4000)
    forces[2000, 0] = glitch
    euler = averaging_observer(rates, forces, PERIOD)
    assert np.abs(euler[2001:, 1]).max() < np.radians(8)
    assert np.abs(euler[-1]).max() < np.radians(0.1)


def test_upside_down_after_a_gap() -> None:
    rates, forces = still(600)
    forces[300:] *= -1
    steps = np.where(np.arange(600) == 300, 100.0, PERIOD)
    last = averaging_observer(rates, forces, steps, bias=0)[-1]
    assert tilt_off(last, np.array([np.pi, 0, 0])) < 1e-6


def turning(count: int) -> tuple[Floats, Floats, Floats, Floats]:
    """A body that turns level, and the field along it."""
    rates, forces = still(count)
    rates[:, 2] = 0.3
    truth = integrate_gyro(rates, PERIOD, [0.0, 0.0, 1.0])
    return rates, forces, np.einsum("nij,j->ni", matrix_from_euler(truth), FIELD), truth


def test_heading_from_the_first_sample_and_against_a_bias() -> None:
    rates, forces, field, truth = turning(9000)
    rates[:, 2] += 0.002
    euler = averaging_observer(rates, forces, PERIOD, mag=field, bias=0)
    assert apart(euler[:1], truth[:1])[0] < 1e-9
    assert apart(euler, truth)[-1] == pytest.approx(0.002 * 9.0, rel=0.01)
    alone = averaging_observer(rates, forces, PERIOD, bias=0)
    assert alone[0, 2] == 0
    declined = EarthField(reference=(np.cos(0.1), np.sin(0.1)))
    east = averaging_observer(rates, forces, PERIOD, mag=field, bias=0, field=declined)
    assert_allclose(apart(east, euler), 0.1, atol=1e-9)


@pytest.mark.parametrize("known", [{}, {"length": 48.47, "down": 0.928}])
def test_a_disturbed_field_is_held_out(known: dict[str, float]) -> None:
    rates, forces, field, truth = turning(6000)
    field[2000:4000] += np.array([25.0, 5.0, -10.0])
    earth = EarthField(**known)  # type: ignore[arg-type]
    found = averaged_attitude(rates, forces, PERIOD, mag=field, bias=0, field=earth)
    assert apart(found.euler, truth).max() < 1e-3
    assert found.heading_averaged[1999] == 9.0
    assert found.heading_averaged[3999] < 3.0
    assert found.heading_averaged[-1] == 9.0
    heard = EarthField(tolerance=10.0)
    astray = averaging_observer(rates, forces, PERIOD, mag=field, bias=0, field=heard)
    assert apart(astray, truth).max() > 0.3


def test_a_field_that_stays_is_the_field() -> None:
    rates, forces, field, truth = turning(12000)
    # Read beside iron for five seconds, then elsewhere.
    near = field.copy()
    near[:500] += [0.0, 30.0, 0.0]
    euler = averaging_observer(rates, forces, PERIOD, mag=near, bias=0)
    off = apart(euler, truth)
    assert off[499] > 0.5
    assert off[1100] < off[990]
    assert off[-1] < 0.01


def test_a_field_without_direction_is_not_heard() -> None:
    rates, forces, field, truth = turning(2000)
    field[500:600, 1] = np.nan
    field[700] = 0.0
    field[800] = 1e300
    found = averaged_attitude(rates, forces, PERIOD, mag=field, bias=0)
    assert apart(found.euler, truth).max() < 1e-9
    none = averaged_attitude(rates, forces, PERIOD, mag=np.full((2000, 3), np.nan), bias=0)
    assert_array_equal(none.euler, averaging_observer(rates, forces, PERIOD, bias=0))
    assert not none.heading_averaged.any()


def test_shapes_and_what_comes_before_the_first_force() -> None:
    rates, forces = still(50, 0.3)
    assert averaging_observer(rates[:0], forces[:0], PERIOD, bias=0).shape == (0, 3)
    assert averaging_observer(rates[:1], forces[:1], PERIOD, bias=0).shape == (1, 3)
    forces[:10] = np.nan
    for mag in (None, np.tile(FIELD, (50, 1))):
        found = averaged_attitude(rates, forces, PERIOD, bias=0, mag=mag)
        assert np.isnan(found.euler[:10]).all()
        assert_allclose(found.euler[10:], np.tile([0.3, 0, found.euler[10, 2]], (40, 1)), atol=1e-9)
        assert found.averaged[:11].tolist() == [0.0] * 11
        assert_allclose(found.tilt_bound[:11], np.pi)


def test_what_has_no_meaning_is_refused() -> None:
    rates, forces = still(50)
    with pytest.raises(ValueError, match=r"longest_step = 0.15 s.*got 0.5 s"):
        averaging_observer(rates, forces, 0.5)
    for name in ("time_constant", "heading_time_constant", "longest_step"):
        with pytest.raises(ValueError, match=f"{name}: expected a positive number, got 0"):
            averaging_observer(rates, forces, PERIOD, **{name: 0})  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="expected as many rows in each of body_rates, accel, mag"):
        averaging_observer(rates, forces, PERIOD, mag=forces[:3])
    with pytest.raises(ValueError, match="accel: expected a sample that shows a tilt"):
        averaging_observer(rates, 0 * forces, PERIOD)
    for wrong, message in (
        ({"reference": (0.0, 0.0)}, "horizontal field"),
        ({"length": 50.0}, "length and down together"),
        ({"length": -1.0, "down": 0.5}, "length: expected a positive number"),
        ({"length": 50.0, "down": 1.5}, "from -1 to 1"),
        ({"tolerance": 0.0}, "tolerance: expected a positive number"),
        ({"patience": np.nan}, "patience: expected a positive number"),
    ):
        with pytest.raises(ValueError, match=message):
            EarthField(**wrong)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="speed: expected a number, not negative"):
        averaging_bound(1.0, speed=-1.0)


# VQF 2.1.1 in its defaults, `VQF(dt).updateBatch`, degrees RMS over the moving rows.
BY_VQF = {"01_slow_rotation": (0.6888, 2.0456), "06_fast_rotation": (0.5130, 4.1153),
          "15_fast_translation": (0.4162, 2.1660)}  # fmt: skip


@pytest.mark.parametrize("trial", BY_VQF)
def test_broad(trial: str, recordings: Path) -> None:
    log = np.genfromtxt(recordings / f"broad_{trial}_A_95hz_ned.csv", delimiter=",", names=True)
    columns: Callable[..., Floats] = lambda *names: np.stack([log[n] for n in names], axis=1)  # noqa: E731
    rates = columns("gx_rad_s", "gy_rad_s", "gz_rad_s")
    forces = columns("ax_m_s2", "ay_m_s2", "az_m_s2")
    field, dt = columns("mx_uT", "my_uT", "mz_uT"), 1 / 95.238
    truth = np.radians(columns("roll_deg", "pitch_deg", "yaw_deg"))
    rows = (log["moving"] == 1) & np.isfinite(truth).all(axis=1)
    inclination, total = BY_VQF[trial]

    def error(angle: Callable[..., Floats], euler: Floats) -> float:
        return float(np.degrees(np.sqrt(np.mean(angle(euler, truth)[rows] ** 2))))

    euler = averaging_observer(rates, forces, dt, mag=field)
    assert error(tilt_off, averaging_observer(rates, forces, dt)) < 1.05 * inclination
    assert (
        error(tilt_off, averaging_observer(rates, forces, dt, bias="running")) < 1.25 * inclination
    )
    assert error(apart, euler) < 1.25 * total
    best = {"01_slow_rotation": (0.01, 0.75), "06_fast_rotation": (0.003, 0.95)}
    if trial in best:
        gain, most = best[trial]
        assert error(tilt_off, fixed_gain_observer(rates, forces, dt, gain)) < most
