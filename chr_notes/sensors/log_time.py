"""The times of a log: their unit, and what is wrong with them."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Floats
from chr_notes.sensors.recording import Stretch, counted

SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}

_USUAL_RATES = (3.0, 3000.0)  # Hz, less than a factor of 1000 apart: at most one unit fits
RATES = (0.5, 30_000.0)
"""From and to which a sensor is sampled, Hz."""

_GAP = 2.5  # usual steps
_JUMP = 3600.0  # seconds: no gap of a log, but a clock that was set
_MOST_BACKWARD = 0.01  # share of the rows
_MOST_REPEATED = 0.5
_LISTED = 1000


@dataclass
class Times:
    """What the times of a log are."""

    time: Floats | None = None
    dt: Floats | None = None
    kept: NDArray[np.bool_] | None = None
    unit: str | None = None
    rate: float | None = None
    jitter: float | None = None
    repeated: int = 0
    backward: int = 0
    gaps: list[Stretch] = field(default_factory=list)
    clock_jumps: list[Stretch] = field(default_factory=list)
    assumed: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)


def even(count: int, rate: float, *, had_times: bool) -> Times:
    """Make times of a rate that the caller gives."""
    if not (np.isfinite(rate) and rate > 0):
        msg = f"rate: expected a positive number, Hz, got {rate}"
        raise ValueError(msg)
    time = np.arange(count) / rate
    times = Times(time, np.full(count, 1 / rate), rate=rate, jitter=0.0)
    told = ", and not the times of the log" if had_times else ""
    times.assumed.append(f"one sample every {1 / rate:.6g} s, by the rate given{told}")
    return times


def is_possible(rate: float) -> bool:
    """Say whether a sensor may be sampled so often."""
    return RATES[0] <= rate <= RATES[1]


def timed(
    values: Floats,
    unit: str | None,
    place: Callable[[int], str],
    contradiction: Callable[[str], None],
) -> Times:
    """Take the times of a log.

    Parameters
    ----------
    values
        As they stand there, shape (N,).
    unit
        Given or told by the name, or None.
    place
        Says where a row stands.
    contradiction
        Is called if the unit cannot be; returns if it is to be taken all the same.

    Raises
    ------
    ValueError
        If the unit cannot be told or contradicts the size of the steps, or the times go back.
    """
    times = Times()
    values = _unwrapped(values, times, place)
    known = ~np.isnan(values)
    if not known.all():
        timeless = counted(int((~known).sum()), "row has", "rows have")
        first = place(int(np.argmin(known)))
        times.warnings.append(f"{timeless} no time, the first at {first}: left out")
    steps = np.diff(values[known])
    forward = steps[steps > 0]
    if len(forward) == 0:
        msg = f"time: expected rising times, got {_few(values)}; pass rate=, in Hz"
        raise ValueError(msg)
    usual = float(np.median(forward))
    if unit is not None and (why := _doubt(unit, usual)):
        contradiction(why)
    times.unit = unit or _unit(usual, forward, times)
    seconds = values * SECONDS[times.unit]
    usual *= SECONDS[times.unit]
    rows = np.flatnonzero(known)
    seconds = _without_jumps(seconds[rows], usual, rows, times, place)
    later = _later(seconds, rows, times, place)
    rows, seconds = rows[later], seconds[later]
    if len(rows) < len(values):
        times.kept = np.zeros(len(values), dtype=np.bool_)
        times.kept[rows] = True
    steps = np.diff(seconds)
    usual = float(np.median(steps))
    gaps = steps > _GAP * usual
    times.time = seconds - seconds[0]
    times.dt = np.concatenate([[usual], steps])
    times.rate, times.jitter = 1 / usual, float(steps[~gaps].std() / usual)
    if not _USUAL_RATES[0] <= times.rate <= _USUAL_RATES[1]:
        times.warnings.append(
            f"a rate of {times.rate:.4g} Hz is unusual; is the time in {times.unit}?"
        )
    for each in np.flatnonzero(gaps)[:_LISTED].tolist():
        length = float(steps[each])
        times.gaps.append(Stretch("time", each, each + 2, length, place(int(rows[each + 1]))))
    if times.gaps:
        longest = max(times.gaps, key=lambda gap: gap.seconds)
        times.warnings.append(
            f"{counted(int(gaps.sum()), 'gap')} in time, the longest of {longest.seconds:.3g} s at "
            f"{longest.place}"
        )
    return times


def _few(values: Floats) -> str:
    return ", ".join(f"{value:.10g}" for value in values[:3]) + ", ..."


def _unwrapped(values: Floats, times: Times, place: Callable[[int], str]) -> Floats:
    """Let a counter of 32 bits go on where it began again at zero."""
    wraps = np.flatnonzero(np.diff(values) < -0.9 * 2**32)
    if len(wraps) == 0 or not 0 <= np.nanmin(values) <= np.nanmax(values) < 2**32:
        return values
    turns = np.zeros(len(values))
    turns[wraps + 1] = 2.0**32
    first = place(int(wraps[0]) + 1)
    times.assumed.append(f"time is a counter of 32 bits that began again at {first}")
    return np.asarray(values + np.cumsum(turns))


def _fitting(usual: float) -> list[str]:
    """Give the units, at most one, in which steps are of a usual rate."""
    low, high = _USUAL_RATES
    return [name for name, second in SECONDS.items() if low <= 1 / (usual * second) <= high]


def _unit(usual: float, forward: Floats, times: Times) -> str:
    """Find the unit by the size of the steps."""
    fitting = _fitting(usual)
    if not fitting or (usual == 1 and np.ptp(forward) == 0):
        msg = (
            f"time: cannot tell its unit from steps of {usual:g}; "
            "pass units={'time': 's'}, 'ms', 'us' or 'ns', or rate=, in Hz"
        )
        raise ValueError(msg)
    rate = 1 / (usual * SECONDS[fitting[0]])
    times.assumed.append(f"time is in {fitting[0]}, by its steps of {usual:g}: {rate:.4g} Hz")
    return fitting[0]


def _doubt(unit: str, usual: float) -> str | None:
    """Say what speaks against a unit."""
    rate = 1 / (usual * SECONDS[unit])
    if is_possible(rate):
        return None
    advice = "".join(f"units={{'time': {name!r}}}, or " for name in _fitting(usual))
    return (
        f"time: expected a sensor's rate, from {RATES[0]:g} to {RATES[1]:g} Hz, got steps of "
        f"{usual:g} {unit}, {rate:.4g} Hz; pass {advice}on_contradiction='warn' if it is so"
    )


def _without_jumps(
    seconds: Floats,
    usual: float,
    rows: NDArray[np.int64],
    times: Times,
    place: Callable[[int], str],
) -> Floats:
    """Count a step by which the clock was set as a usual one."""
    steps = np.diff(seconds)
    jumps = np.flatnonzero(np.abs(steps) > _JUMP)
    if len(jumps) == 0:
        return seconds
    for each in jumps[:_LISTED].tolist():
        length, where = float(steps[each]), place(int(rows[each + 1]))
        times.clock_jumps.append(Stretch("time", each, each + 2, length, where))
    first = times.clock_jumps[0]
    times.warnings.append(
        f"the clock was set {counted(len(jumps), 'time')}, first by {first.seconds:.4g} s at "
        f"{first.place}: counted as a usual step"
    )
    steps[jumps] = usual
    return np.concatenate([[0.0], np.cumsum(steps)])


def _later(
    seconds: Floats, rows: NDArray[np.int64], times: Times, place: Callable[[int], str]
) -> NDArray[np.bool_]:
    """Say which rows come later than all before."""
    latest = np.concatenate([[-np.inf], np.maximum.accumulate(seconds)[:-1]])
    same, before = seconds == latest, seconds < latest
    times.repeated, times.backward = int(same.sum()), int(before.sum())
    if times.backward > max(_MOST_BACKWARD * len(seconds), 1):
        row = int(np.argmax(before))
        msg = (
            f"{place(int(rows[row]))}: time: expected rising times, got {seconds[row]:.10g} s "
            f"after {latest[row]:.10g} s, and {times.backward} rows before the latest; "
            "pass rate=, or cut the log there"
        )
        raise ValueError(msg)
    if times.repeated > _MOST_REPEATED * len(seconds):
        row = int(np.argmax(same))
        msg = (
            f"{place(int(rows[row]))}: time: expected rising times, got {times.repeated} of "
            f"{len(seconds)} rows at the time of the row before; pass rate=, in Hz"
        )
        raise ValueError(msg)
    for count, what in ((times.repeated, same), (times.backward, before)):
        if count:
            come = "row comes" if count == 1 else "rows come"
            how = "at the same time as" if what is same else "at a time before"
            times.warnings.append(
                f"{count} {come} {how} an earlier one, the first at "
                f"{place(int(rows[int(np.argmax(what))]))}: left out"
            )
    return np.asarray(seconds > latest)
