"""Warnings of rates and time steps that are hardly in the unit in which they are expected."""

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import chr_notes
from chr_notes import UnitWarning
from chr_notes._units import ENOUGH, FAST

Floats = NDArray[np.float64]
Filter = Callable[[Floats, Any], object]
MONITOR = chr_notes.Monitor(0.1, 5)


def force(rates: Floats) -> Floats:
    return np.tile([0.0, 0.0, -9.8], (len(rates), 1))


def monitored(rates: Floats, dt: Any) -> object:  # noqa: ANN401 (a number or an array)
    forces = force(rates)
    mag = np.add(forces, [0.4, 0.0, 0.0])
    return chr_notes.monitored_observer(rates, forces, mag, dt, reference_down=0.7, monitor=MONITOR)


def stream(rates: Floats, dt: Any) -> Any:  # noqa: ANN401 (as above)
    return zip(rates, force(rates), np.broadcast_to(dt, len(rates)).tolist(), strict=True)


RECORDINGS: dict[str, Filter] = {
    "integrate_gyro": chr_notes.integrate_gyro,
    "fixed_gain_observer": lambda w, dt: chr_notes.fixed_gain_observer(w, force(w), dt, 0.02),
    "monitored_observer": monitored,
    "averaging_observer": lambda w, dt: chr_notes.averaging_observer(w, force(w), dt, bias=0.0),
    "averaged_attitude": lambda w, dt: chr_notes.averaged_attitude(w, force(w), dt, bias=0.0),
}
STREAMS: dict[str, Filter] = {
    "observe": lambda w, dt: [*chr_notes.observe(stream(w, dt), 0.02)],
    "observe_averaging": lambda w, dt: [*chr_notes.observe_averaging(stream(w, dt))],
    "observe_sample": lambda w, dt: [
        chr_notes.observe_sample([0, 0, 0], *sample, 0.02) for sample in stream(w, dt)
    ],
}
EVERY = RECORDINGS | STREAMS


def turning(rate: float, count: int = ENOUGH) -> Floats:
    return np.tile([0.0, 0.6 * rate, 0.8 * rate], (count, 1))


@pytest.mark.parametrize("method", ["quaternion", "euler"])
def test_a_turn_that_ends_in_the_range_of_angles_is_noticed_too(method: Any) -> None:  # noqa: ANN401
    start, rates, force = [0, 0, -3.0], [0, 0, 3.3], [0, 0, -9.8]
    with pytest.warns(UnitWarning, match=r"got 3\.3 rad"):
        chr_notes.observe_sample(start, rates, force, 1.0, 0.02, method=method)


@pytest.mark.parametrize("name", EVERY)
def test_a_turn_that_nobody_can_tell_from_a_smaller_one_is_noticed(name: str) -> None:
    rates = turning(31.0, 4)
    rates[1] = np.nan
    rates[3] *= 1.02  # 3.162 rad in 0.1 s
    EVERY[name](rates[:3], 0.1)
    with pytest.warns(UnitWarning, match=r"half a revolution .*, got 3\.162 rad") as told:
        EVERY[name](rates, 0.1)
    assert [warning.filename for warning in told] == [__file__]


@pytest.mark.parametrize("name", RECORDINGS)
def test_rates_in_degrees_are_noticed(name: str) -> None:
    spins = turning(5.0, 1000)
    spins[::50] = turning(90.0, 20)
    with pytest.warns(UnitWarning, match=r"expected rad/s, got 90 .* in °/s\?") as told:
        RECORDINGS[name](spins, 0.01)
    assert [warning.filename for warning in told] == [__file__]


@pytest.mark.parametrize("name", EVERY)
def test_what_gyros_read_damage_and_gaps_are_no_other_unit(name: str) -> None:
    EVERY[name](turning(0.99 * FAST), 0.01)
    damaged = turning(5.0)
    damaged[50], damaged[60], damaged[70] = 2 * FAST, np.nan, 1e15
    EVERY[name](damaged, 0.01)
    steps = np.full(ENOUGH, 0.01)
    steps[40] = 0.6
    EVERY[name](turning(5.0), steps)


def test_a_gap_of_the_averaging_filter_is_no_turn() -> None:
    steps = np.full(ENOUGH, 0.01)
    steps[40] = 1.9e8  # a clock was set
    for name in ("averaging_observer", "averaged_attitude", "observe_averaging"):
        EVERY[name](turning(1e-3), steps)
    for name in ("integrate_gyro", "fixed_gain_observer", "monitored_observer", "observe"):
        with pytest.warns(UnitWarning, match=r"got 1\.9e\+05 rad"):
            EVERY[name](turning(1e-3), steps)


def test_milliseconds_are_noticed() -> None:
    rates = turning(0.01)
    level = chr_notes.matrix_from_euler(np.zeros((ENOUGH, 3))) @ [0.0, 0.0, -9.80665]
    calls: list[Callable[[], object]] = [
        lambda: chr_notes.integrate_gyro(rates, 10),
        lambda: chr_notes.fixed_gain_observer(rates, level, np.full(ENOUGH, 10.0), 0.02),
        lambda: chr_notes.dead_reckon(level, 0 * rates, 10.0),
    ]
    for call in calls:
        with pytest.warns(UnitWarning, match=r"dt: expected seconds, got mostly 10: ") as told:
            call()
        assert [warning.filename for warning in told] == [__file__]
    chr_notes.integrate_gyro(rates, 1.0)
    chr_notes.integrate_gyro(rates[1:], 10)  # too few to tell


def turned_slowly(most: float, count: int = 6000) -> tuple[Floats, Floats, Floats]:
    """A sensor turned by hand, in °/s at most, beside a bias and some noise; rates are rad/s."""
    random, time = np.random.default_rng(3), 0.01 * np.arange(count)[:, np.newaxis]
    rates = np.radians(most) * np.sin(time * [0.5, 0.3, 0.7] + [0.0, 1.6, 0.0])
    euler = chr_notes.integrate_gyro(rates, 0.01, [0.1, 0.2, 0.0])
    forces = chr_notes.accelerometer_at_rest(euler) + random.normal(0, 0.05, (count, 3))
    field = chr_notes.matrix_from_euler(euler) @ [20.0, 0.0, 43.0]
    return rates + random.normal(0, 0.002, (count, 3)) + 0.01, forces, field


@pytest.mark.parametrize("most", [2.0, 60.0])
def test_slow_turns_in_degrees_are_noticed_by_how_the_others_turn(most: float) -> None:
    rates, forces, field = turned_slowly(most)
    calls: list[Callable[[Floats], object]] = [
        lambda w: chr_notes.fixed_gain_observer(w, forces, 0.01, 0.02),
        lambda w: chr_notes.averaging_observer(w, forces, np.full(6000, 0.01), bias=0.0),
        lambda w: chr_notes.averaging_observer(w, forces, 0.01, bias=0.0, mag=field),
        lambda w: chr_notes.monitored_observer(
            w, forces, field, 0.01, reference_down=0.9, monitor=MONITOR
        ),
    ]
    for call in calls:
        call(rates)
        for factor, message in ((180 / np.pi, "are they in °/s"), (np.pi / 180, "rad/s before")):
            with pytest.warns(UnitWarning, match=message) as told:
                call(factor * rates)
            assert [warning.filename for warning in told] == [__file__]


def test_where_physics_cannot_tell_degrees_nothing_is_said() -> None:
    rates, forces, _ = turned_slowly(0.0)  # a bias of 0.01 and noise are no turn
    for count in (50, 6000):
        for factor in (np.pi / 180, 1.0, 180 / np.pi):
            part = factor * rates[:count], forces[:count]
            chr_notes.fixed_gain_observer(*part, 0.01, 0.02)
    # Noise in the rates of a slow turn makes the factor small, and a shaken body any.
    random = np.random.default_rng(4)
    rates, forces, _ = turned_slowly(0.5)
    noise = random.normal(0, 0.1, (2, 6000, 3))
    chr_notes.fixed_gain_observer(rates + noise[0], forces, 0.01, 0.02)
    swing = 3 * np.sin(0.05 * np.arange(6000))[:, np.newaxis] * [1.0, 0.5, 0.2]
    chr_notes.fixed_gain_observer(np.degrees(rates), forces + swing + noise[1], 0.01, 0.02)


def test_angles_in_degrees_are_noticed_by_the_gravity_that_they_leave() -> None:
    angles = np.radians([[2.0, -1.5, 40.0]] * ENOUGH)
    forces = np.add(chr_notes.accelerometer_at_rest(angles), [0.1, 0.0, 0.2])
    chr_notes.dead_reckon(forces, angles, 0.01)
    with pytest.warns(UnitWarning, match=r"euler: expected radians.* are they in °\?") as told:
        chr_notes.dead_reckon(forces, np.degrees(angles), 0.01)
    assert [warning.filename for warning in told] == [__file__]


def test_a_force_in_g_is_noticed_by_all_that_compare_it_with_gravity() -> None:
    force = np.tile([0.0, 0.0, -1.0], (ENOUGH, 1))
    still, mag = 0 * force, np.tile([20.0, 0.0, 43.0], (ENOUGH, 1))
    calls: list[Callable[[], object]] = [
        lambda: chr_notes.zero_velocity(still, force, 0.01),
        lambda: chr_notes.accelerated(force, 0.01),
        lambda: chr_notes.doubtful_sensors(
            force, mag, still, 0.01, strength=47.4, reference_down=0.9
        ),
    ]
    for call in calls:
        with pytest.warns(UnitWarning, match="are they in g") as told:
            call()
        assert [warning.filename for warning in told] == [__file__]


def test_a_recording_is_told_from_itself_in_degrees(recordings: Path) -> None:
    log = chr_notes.read_log(recordings / "broad_06_fast_rotation_A_95hz_ned.csv")
    steps = np.diff(log.time, prepend=log.time[0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        chr_notes.integrate_gyro(log.body_rates, steps)
    with pytest.warns(UnitWarning, match="in °/s"):
        chr_notes.integrate_gyro(np.degrees(log.body_rates), steps)
