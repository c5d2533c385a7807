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


def test_a_recording_is_told_from_itself_in_degrees(recordings: Path) -> None:
    log = chr_notes.read_log(recordings / "broad_06_fast_rotation_A_95hz_ned.csv")
    steps = np.diff(log.time, prepend=log.time[0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        chr_notes.integrate_gyro(log.body_rates, steps)
    with pytest.warns(UnitWarning, match="in °/s"):
        chr_notes.integrate_gyro(np.degrees(log.body_rates), steps)
