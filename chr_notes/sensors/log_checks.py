"""What is wrong with readings: ends of ranges, readings that stick, readings that are missing."""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Floats
from chr_notes.sensors.column_names import SENSORS
from chr_notes.sensors.recording import Stretch, counted

_LISTED = 1000
_STUCK = 1.0  # seconds
_FEWEST_STUCK = 20
_FLAT = 3  # samples at the end of a range
_WIDTH = 50  # samples of a block that may be at rest
_RANGES = {
    "gyro": np.radians([125.0, 245, 250, 500, 1000, 2000, 4000]),
    "accel": 9.80665 * np.array([2.0, 3, 4, 6, 8, 16, 24, 32, 64, 100, 200]),
}
_NEAR_RANGE = 0.05


LOOKED_AT = 50_000
"""Rows of a longer log from which a median is taken."""

_WILD = {"gyro": 200.0, "accel": 4000.0}  # rad/s and m/s²: no sensor reads so much


def missing(values: Floats) -> float:
    """Give the share of rows without a whole reading."""
    return float(np.isnan(values[:, 0] + values[:, 1] + values[:, 2]).mean())


def median_norm(values: Floats) -> float:
    """Take the median norm of some of the readings, those that are whole; NaN without any."""
    some = values[:: max(1, len(values) // LOOKED_AT)]
    norms = np.sqrt((some**2).sum(axis=1))
    norms = norms[np.isfinite(norms)]
    return float(np.median(norms)) if len(norms) else float("nan")


def still_blocks(accel: Floats) -> tuple[Floats, NDArray[np.int64], int]:
    """Find where an accelerometer, in any unit, hardly varies.

    Returns
    -------
    means, places, width : ndarray, ndarray, int
        Mean reading in each still block, shape (K, 3), which blocks they are, and their samples.
    """
    width = min(_WIDTH, max(len(accel), 1))
    count = len(accel) // width
    means, variances = np.empty((count, 3)), np.empty((count, 3))
    for start in range(0, count, 1024):
        part = accel[start * width : min(start + 1024, count) * width].reshape(-1, width, 3)
        means[start : start + len(part)] = part.mean(axis=1)
        variances[start : start + len(part)] = part.var(axis=1)
    norms = np.sqrt((means**2).sum(axis=1))
    still = np.flatnonzero(np.sqrt(variances.sum(axis=1)) < 0.02 * norms)
    return means[still], still, width


def runs(same: NDArray[np.bool_], shortest: int) -> Iterator[tuple[int, int]]:
    """Give where a condition holds for so many samples in a row."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], same, [False]])))
    starts, stops = edges[::2], edges[1::2]
    long = np.flatnonzero(stops - starts >= shortest)[:_LISTED]
    yield from zip(starts[long].tolist(), stops[long].tolist(), strict=True)


def stuck(what: str, values: Floats, usual: float, place: Callable[[int], str]) -> list[Stretch]:
    """Find where a sensor repeats one reading."""
    shortest = max(_FEWEST_STUCK, round(_STUCK / usual)) if usual > 0 else 5 * _FEWEST_STUCK
    same = np.logical_and.reduce([column[1:] == column[:-1] for column in values.T])
    return [
        Stretch(what, start, stop + 1, (stop + 1 - start) * usual, place(start))
        for start, stop in runs(same, shortest - 1)
    ]


def saturated(
    what: str,
    values: Floats,
    full_range: float | None,
    usual: float,
    place: Callable[[int], str],
) -> list[Stretch]:
    """Find where an axis stands at the end of its range.

    A range that is not given is the one of a chip near which the largest readings lie, if they
    repeat there exactly.
    """
    found = []
    for axis, column in zip("xyz", values.T, strict=True):
        if full_range is not None:
            ends, shortest = [np.abs(column) >= full_range * (1 - 1e-6)], 1
        else:
            extremes = {float(np.nanmin(column)), float(np.nanmax(column))}
            ends = [column == end for end in extremes if _is_end(what, abs(end))]
            shortest = _FLAT
        found += [
            Stretch(f"{what} {axis}", start, stop, (stop - start) * usual, place(start))
            for end in ends
            for start, stop in runs(end, shortest)
        ]
    return found


def _is_end(what: str, size: float) -> bool:
    """Say whether a chip's range may end here."""
    ranges = _RANGES.get(what)
    return ranges is not None and bool((np.abs(size / ranges - 1) < _NEAR_RANGE).any())


def stretches(
    what: str, blocks: list[int], width: int, usual: float, place: Callable[[int], str]
) -> tuple[Stretch, ...]:
    """Join blocks that follow each other."""
    inside = np.zeros(max(blocks, default=-1) + 1, dtype=np.bool_)
    inside[blocks] = True
    return tuple(
        Stretch(what, a * width, b * width, (b - a) * width * usual, place(a * width))
        for a, b in runs(inside, 1)
    )


def faults(
    values: dict[str, Floats],
    full_range: dict[str, float],
    usual: float,
    place: Callable[[int], str],
) -> tuple[tuple[Stretch, ...], tuple[Stretch, ...], list[str]]:
    """Look for ends of ranges, readings that stick, are missing, or cannot be.

    Returns
    -------
    saturated, stuck, warnings
        Stretches, and a sentence for each kind of fault.
    """
    ends: list[Stretch] = []
    sticking: list[Stretch] = []
    warnings = []
    for name in (name for name in SENSORS if name in values):
        readings = values[name]
        share = missing(readings)
        if share:
            warnings.append(f"{name}: {share:.2%} of the rows lack a number of x, y or z")
        if share == 1:
            continue
        at_end = saturated(name, readings, full_range.get(name), usual, place)
        same = stuck(name, readings, usual, place)
        for found, what in ((at_end, "at the end of its range"), (same, "of one reading")):
            if found:
                many = counted(len(found), "stretch", "stretches")
                warnings.append(f"{name}: {many} {what}, from {found[0].place} on")
        ends += at_end
        sticking += same
        limit = _WILD.get(name, np.inf)
        wild = np.logical_or.reduce([np.abs(column) > limit for column in readings.T])
        if wild.any():
            first = place(int(np.argmax(wild)))
            warnings.append(
                f"{name}: {counted(int(wild.sum()), 'reading')} of no sensor, from {first} on"
            )
    return tuple(ends), tuple(sticking), warnings
