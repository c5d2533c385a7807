"""What a gyro reads at rest, taken off before an attitude is estimated."""

import warnings
from collections.abc import Iterator
from itertools import repeat
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._recordings import states
from chr_notes._samples import per_axis
from chr_notes.estimation.averaging_bound import BIAS
from chr_notes.generated.scalar.estimation import bias_at_rest
from chr_notes.sensors.still import STILL_LIMIT, static_interval, without_glitches

Bias = Literal["stillest", "running"] | ArrayLike
REST = 2.0
"""Seconds of rest from which a bias is taken."""
_BLOCKS = 24  # to look about
_ENOUGH = 25  # rows of a block, to tell whether it varies
_ROWS = 8192  # at a time, few enough to stay in cache
_LARGEST = 0.05  # rad/s, as gyros have it when nobody has taken it off; more may be a turn


def check_bias(bias: Bias) -> str | Floats:
    """Take "stillest", "running", or a bias: one number for all axes or one for each.

    Returns
    -------
    str or ndarray
        The word, or what a gyro of this bias reads at rest: its negative.
    """
    if isinstance(bias, str):
        if bias not in ("stillest", "running"):
            msg = f'bias: expected "stillest", "running" or numbers, got {bias!r}'
            raise ValueError(msg)
        return bias
    given = per_axis("bias", bias)
    if not np.isfinite(given).all():
        msg = f"bias: expected finite numbers, got {given.tolist()}"
        raise ValueError(msg)
    return -given


def bias_of(  # noqa: PLR0913, PLR0917 (a recording, and from where)
    bias: Bias, rates: Floats, forces: Floats, dt: Floats, longest_step: float, begin: int = 0
) -> tuple[Iterator[Floats], float]:
    """Find what the gyros read at rest, from sample `begin` on: for each part of the recording.

    Returns
    -------
    iterator of ndarray
        Of shape (3,) without end, or where it is learnt on the way of shape (rows of the part, 3).
    float
        How much of their bias may be left without it, rad/s.
    """
    checked = check_bias(bias)
    if not isinstance(checked, str):
        return repeat(checked), BIAS
    if checked == "stillest":
        found, left = _stillest(rates, dt)
        return repeat(found), left
    return _learnt(rates, forces, dt, longest_step, begin), BIAS


def _learnt(
    rates: Floats, forces: Floats, dt: Floats, longest_step: float, begin: int
) -> Iterator[Floats]:
    limits = [np.array(limit) for limit in (REST, longest_step)]
    state: Floats = np.zeros(10)
    for part in (slice(begin), slice(begin, None)):
        given = (rates[part], forces[part], dt[part] if dt.ndim else dt, *limits)
        for found in states(bias_at_rest, state, *given):
            state = found[-1]
            if part.start is not None:
                yield found[:, 7:]


def _stillest(rates: Floats, dt: Floats) -> tuple[Floats, float]:
    """Mean over the stillest two seconds, or over all if there is less, and how far off it may be.

    What is taken for a rest may be none, and then all of the mean is a turn.
    """
    usual = float(np.median(dt)) if dt.size else 0.0
    length = round(min(REST / usual, len(rates))) if usual > 0 else len(rates)
    found = _steady(_still_parts(rates, length), length)
    if found is None:
        return _none("no stretch as long without a gap in the rates")
    variance, mean = found
    spread = float(np.sqrt(variance.max()))
    if spread > STILL_LIMIT:
        return _none(f"the stillest has a standard deviation of {spread:.2g} rad/s: no rest")
    largest = float(np.abs(mean).max())
    if largest > _LARGEST:
        _warn(
            f"the stillest reads {largest:.2g} rad/s, which is taken for the bias: if it is a "
            "steady turn, pass a bias"
        )
        return mean, BIAS + float(np.linalg.norm(mean))
    return mean, BIAS


def _steady(part: Floats, length: int) -> tuple[Floats, Floats] | None:
    """Find variance and mean in the stillest stretch, apart from glitches."""
    try:
        still = static_interval(part, length)
    except ValueError:  # none without NaN
        return None
    steady, glitches = without_glitches(part[still])
    kept = steady[~glitches]
    return np.asarray(kept.var(axis=0)), np.asarray(kept.mean(axis=0))


def _still_parts(rates: Floats, length: int) -> Floats:
    """Cut out where to look, with NaN between: about the blocks of half the length that vary least.

    To look everywhere takes longer than the filter.
    """
    half = length // 2
    count = len(rates) // half if half else 0
    if not count:
        return rates
    blocks = rates[: count * half].reshape(count, half, 3)
    together, every = max(1, _ROWS // half), max(1, half // _ENOUGH)
    with np.errstate(over="ignore", invalid="ignore"):
        variance = np.concatenate(
            [
                _variances(blocks[start : start + together, ::every])
                for start in range(0, count, together)
            ]
        )
    variance[~(variance < np.inf)] = np.inf  # NaN too
    chosen = np.argpartition(variance, min(_BLOCKS, count) - 1)[:_BLOCKS]
    near = np.zeros(count + 2, dtype=np.bool_)
    for shift in range(3):
        near[chosen + shift] = True
    edges = np.flatnonzero(np.diff(near[1:-1], prepend=False, append=False)) * half
    ends = [len(rates) if stop >= count * half else stop for stop in edges[1::2]]
    gap = np.full((1, 3), np.nan)
    found = [(rates[start:end], gap) for start, end in zip(edges[::2], ends, strict=True)]
    return np.concatenate([part for each in found for part in each])


def _variances(blocks: Floats) -> Floats:
    """Sum the squares about the mean of each block."""
    off = blocks - blocks[:, :1]
    mean = np.einsum("bij->bj", off)
    return np.asarray(np.einsum("bij,bij->b", off, off) - (mean * mean).sum(axis=1) / off.shape[1])


def _none(why: str) -> tuple[Floats, float]:
    _warn(f"{why}, and no bias is taken off: pass one")
    return np.zeros(3), _LARGEST


def _warn(what: str) -> None:
    warnings.warn(f"bias: of stretches of {REST} s, {what}", stacklevel=5)
