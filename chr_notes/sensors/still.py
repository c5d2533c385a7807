"""Where a sensor lay still: the stillest stretch of a log, and all still ones."""

from itertools import pairwise
from operator import index

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats
from chr_notes._samples import WILD_RATE, complete, periods, positive, same_length, samples

STILL_LIMIT = 0.02
"""Standard deviation of a gyro at rest, rad/s, at most: ten times the noise of a cheap one."""
_LARGEST_BIAS_CHANGE = 0.05  # rad/s; a bias moves by less within a log, a turn by more
_ABOVE_NOISE = 3.0  # a spread that passes for still, over that of the stillest window
_FAR = 10.0  # from the median, over what is usual
_BLOCK = 25  # rows that tell what is usual
_FEWEST = 8  # rows of a window
_LONGEST_STEP = 5.0  # over the usual one; a longer one is a gap
_MISSING = 0.2  # share of the rows of a window that may be missing
_ROWS = 8192  # at a time, few enough to stay in cache


def static_interval(body_rates: ArrayLike, length: int) -> slice:
    """Find where a gyro's readings vary least.

    A glitch moves nothing but the stretches that hold it, however large it is. If each still
    stretch of that length holds one, the stillest apart from glitches is found.

    Parameters
    ----------
    body_rates
        Readings, rad/s, shape (N, 3). A stretch holds no row with NaN or beyond 1e12 rad/s.
    length
        Number of samples in the stretch, at least 2.

    Returns
    -------
    slice
        Of `length` samples, the first such where several vary as little.

    Raises
    ------
    ValueError
        If there are fewer samples, or no stretch of that length is free of NaN.
    TypeError
        If the length is no whole number.

    See Also
    --------
    static_intervals : All still stretches of a log.

    Examples
    --------
    >>> import numpy as np
    >>> rates = np.sin(np.arange(600.0))[:, np.newaxis] * [0.1, 0.2, 0.3]
    >>> rates[200:300] = [0.01, 0.0, -0.02]
    >>> rates[50] = 1e7
    >>> static_interval(rates, 100)
    slice(200, 300, None)
    """
    rates = samples("body_rates", body_rates)
    length = index(length)
    if not 2 <= length <= len(rates):  # noqa: PLR2004 (one sample does not vary)
        msg = f"length: expected from 2 to the {len(rates)} samples there are, got {length}"
        raise ValueError(msg)
    known = complete(rates, WILD_RATE)
    usable = np.True_ if known.all() else window_sums(~known, length) == 0
    if not usable.any():
        msg = f"body_rates: expected {length} samples in a row without NaN, got none"
        raise ValueError(msg)
    rates = rates if known.all() else np.where(known[:, np.newaxis], rates, 0.0)
    steady, glitches = without_glitches(rates)
    spread = _variances(steady, length)
    if glitches.any():
        # What holds glitches comes after what is as still without; the second term counts where
        # all readings are equal.
        held = window_sums(glitches, length)
        spread = spread * (1 + held) + held * np.finfo(np.float64).tiny
    start = int(np.argmin(np.where(usable, spread, np.inf)))
    return slice(start, start + length)


def static_intervals(
    body_rates: ArrayLike, accel: ArrayLike, dt: ArrayLike, *, shortest: float = 1.0
) -> list[slice]:
    """Find all stretches in which a sensor lay still.

    What passes for still is found from the log itself: gyro and accelerometer may both vary up to
    three times as much as in the stillest window that there is, and the gyro's mean must be near
    the least of theirs, because a steady turn does not vary either. A glitch, or a missing row,
    neither hides a stretch nor ends it; a gap in time does.

    Parameters
    ----------
    body_rates
        Readings, rad/s, shape (N, 3).
    accel
        Specific force in any unit, shape (N, 3).
    dt
        Time step before each sample, seconds: a number, or shape (N,).
    shortest
        Seconds that a stretch lasts at least.

    Returns
    -------
    list of slice
        In order; empty where the gyro never varies by less than 0.02 rad/s, as in a log in deg/s.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative or no number, or `shortest` is not positive.

    See Also
    --------
    static_interval : The stillest stretch of a given length.

    Notes
    -----
    The variance in a window against a threshold found from the log is the detector of Tedaldi,
    Pretto and Menegatti, A robust and easy to implement method for IMU calibration, 2014.

    Examples
    --------
    >>> import numpy as np
    >>> noise = np.random.default_rng(0).normal(0, 0.001, (1000, 3))
    >>> rates, accel = noise.copy(), 10 * noise - [0, 0, 9.8]
    >>> rates[400:600, 0] += np.sin(np.arange(200) / 10)
    >>> static_intervals(rates, accel, 0.01)
    [slice(0, 401, None), slice(600, 1000, None)]
    """
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    count = same_length(("body_rates", rates), ("accel", forces))
    steps = np.broadcast_to(periods(dt, count), (count,))
    seconds = positive("shortest", shortest)
    usual = float(np.median(steps)) if count else 0.0
    width = max(_FEWEST, round(min(seconds / 2 / usual, count + 1))) if usual > 0 else _FEWEST
    if count < width:
        return []
    known = complete(rates, WILD_RATE) & complete(forces, WILD_RATE)
    gap = np.r_[False, steps[1:] > _LONGEST_STEP * usual]
    # A window must not hold a step over a gap, which lies before its own first row.
    whole = window_sums(gap, width) - gap[: count - width + 1] == 0
    whole &= window_sums(~known, width) <= _MISSING * width
    last = np.maximum.accumulate(np.where(known, np.arange(count), 0))
    quiet = whole
    for readings, limit in ((rates, STILL_LIMIT), (forces, np.inf)):
        steady, _ = without_glitches(np.where(known[last, np.newaxis], readings[last], 0.0))
        if readings is rates:
            means = np.stack([window_sums(column, width) for column in steady.T], axis=1) / width
        spread = np.where(whole, np.sqrt(_variances(steady, width)), np.inf)
        noise = max(float(spread.min()), _resolution(steady))
        if not noise <= limit:
            return []
        quiet = quiet & (spread <= _ABOVE_NOISE * noise)
    # Of a rest and a steady turn, in which nothing varies either, the rest has the lower rate.
    size = np.where(quiet, np.linalg.norm(means, axis=1), np.inf)
    bias = means[int(np.argmin(size))]
    quiet &= np.abs(means - bias).max(axis=1) <= _LARGEST_BIAS_CHANGE
    return _stretches(quiet, gap, width, seconds / usual if usual > 0 else width)


def _stretches(
    quiet: NDArray[np.bool_], gap: NDArray[np.bool_], width: int, shortest: float
) -> list[slice]:
    """Join quiet windows that overlap, given by their first rows; leave out short stretches."""
    begins = np.zeros(len(gap) + 1, dtype=np.int64)
    starts = np.flatnonzero(quiet)
    np.add.at(begins, starts, 1)
    np.add.at(begins, starts + width, -1)
    still = np.cumsum(begins[:-1]) > 0
    edges = np.flatnonzero(np.diff(np.r_[False, still, False].astype(np.int8)) | np.r_[gap, False])
    return [
        slice(int(start), int(stop))
        for start, stop in pairwise(edges)
        if still[start] and stop - start >= shortest
    ]


def steady_mean(readings: Floats) -> Floats:
    """Average what a sensor read at rest, apart from its glitches, shape (3,)."""
    steady, glitches = without_glitches(readings)
    return np.asarray(steady[~glitches].mean(axis=0))


@np.errstate(all="ignore")  # far beyond all is a glitch
def without_glitches(readings: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """Replace glitches of one or two rows by the median around them, and say which rows.

    A glitch is further from the median of five rows than noise or motion take it: 10 times as far
    as is usual near it, some 8 standard deviations, and 4 times as far as the other side reaches.
    """
    steady, glitches = readings.copy(), np.zeros(len(readings), dtype=np.bool_)
    if len(readings) < 3:  # noqa: PLR2004 (of five, two on each side)
        return steady, glitches
    padded = np.concatenate([readings[2:0:-1], readings, readings[-2:-4:-1]])
    for start in range(0, len(readings), _ROWS):
        own = readings[start : start + _ROWS]
        around = padded[start : start + len(own) + 4]
        median = _median(*(around[shift : shift + len(own)] for shift in range(5)))
        away = np.abs(own - median)
        # A glitch does not get into a median of five, so the greatest of five such is noise.
        blocks = np.pad(away, ((0, -len(own) % _BLOCK), (0, 0)), mode="reflect")
        usual = _median(*(blocks[shift::5] for shift in range(5))).reshape(-1, 5, 3).max(axis=1)
        rows, axes = np.nonzero(away > _FAR * usual.repeat(_BLOCK, axis=0)[: len(own)])
        five = np.stack([around[rows + shift, axes] for shift in range(5)])
        middle, found = median[rows, axes], own[rows, axes]
        below, above = middle - five.min(axis=0), five.max(axis=0) - middle
        out = away[rows, axes] > 4 * np.where(found > middle, below, above)
        steady[start + rows[out], axes[out]] = middle[out]
        glitches[start + rows[out]] = True
    return steady, glitches


def _median(a: Floats, b: Floats, c: Floats, d: Floats, e: Floats) -> Floats:
    low, high = np.minimum, np.maximum
    # Neither the least of two of the least nor the greatest of two of the greatest is the median.
    left, right = high(low(a, b), low(c, d)), low(high(a, b), high(c, d))
    return np.asarray(high(low(left, right), low(high(left, right), e)))


def _variances(readings: Floats, length: int) -> Floats:
    """Sum of the variances along the three axes, in each window."""
    # Of smaller numbers the difference below loses less; any middle will do.
    middle = np.median(readings[:: 1 + len(readings) // 1000], axis=0)
    columns = [column - part for column, part in zip(readings.T, middle, strict=True)]
    spread = window_sums(sum(column**2 for column in columns), length) / length
    for column in columns:
        spread -= (window_sums(column, length) / length) ** 2
    return np.maximum(spread, 0.0)


def window_sums(values: ArrayLike, length: int) -> Floats:
    """Sum a column over each window.

    A window is the end of one block of its length and the beginning of the next. So nothing
    outside it enters, as it does in the difference of two sums from the start.
    """
    array = np.asarray(values, dtype=np.float64)
    count = len(array) - length + 1
    blocks = np.pad(array, (0, -len(array) % length)).reshape(-1, length)
    begins = np.cumsum(blocks, axis=1)
    begins[:, -1] = 0.0  # a window that is one whole block is its end
    ends = np.cumsum(blocks[:, ::-1], axis=1)[:, ::-1]
    return np.asarray(ends.reshape(-1)[:count] + begins.reshape(-1)[length - 1 :][:count])


def _resolution(readings: Floats) -> float:
    """Half of the smallest step between readings, below which no spread says anything."""
    steps = np.abs(np.diff(readings, axis=0))
    return float(steps[steps > 0].min(initial=np.inf)) / 2 if (steps > 0).any() else 0.0
