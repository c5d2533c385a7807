"""Steps of filters, run over a recording: by a kernel, or sample by sample in Python."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import repeat

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._kernels import all_of_it, completed, kernel

_TOGETHER = 8192
"""Samples at a time, few enough that what is between them and the result stays in cache."""


def run(
    step: Callable[..., tuple[float, ...]],
    state: Iterable[float],
    *inputs: Floats | Iterator[Floats],
    finish: Callable[[Floats], Floats] = np.asarray,
    before: Floats | None = None,
) -> Floats:
    """Run a generated step over a recording.

    Parameters
    ----------
    step, state, *inputs
        As for `states`.
    finish
        From states to what is wanted of them, row by row.
    before
        Rows that stand before all others in the result.

    Returns
    -------
    ndarray
        Those, and what is wanted of the state after each sample, shape (N, size).
    """
    begin = np.array([*state])
    ahead = 0 if before is None else len(before)
    whole = np.empty((ahead + _count(inputs), finish(begin[np.newaxis].copy()).shape[1]))
    whole[:ahead] = 0.0 if before is None else before
    kept = whole[ahead:]
    for part, found in zip(parts(len(kept)), states(step, begin, *inputs), strict=True):
        kept[part] = finish(found)
    return whole


def states(
    step: Callable[..., tuple[float, ...]],
    state: Iterable[float],
    *inputs: Floats | Iterator[Floats],
) -> Iterator[Floats]:
    """Run a generated step over a recording, part by part.

    Parameters
    ----------
    step
        From `chr_notes.generated.scalar`: takes the state, then a sample.
    state
        Before the first sample.
    *inputs
        Of each sample, shape (N,) or (N, size), as a whole or, where another has a length to tell,
        part by part; what is the same for all has no axis of samples.

    Yields
    ------
    ndarray
        The state after each sample of a part, which may be written on.
    """
    compiled = kernel(step.__name__)
    by_python = partial(_by_python, step)
    advance = by_python if compiled is None else completed(compiled, all_of_it)
    now = np.array([*state])
    for part in parts(_count(inputs)):
        found = advance(now, *(_part(each, part) for each in inputs), None)
        now = found[-1].copy()
        yield found


def parts(count: int) -> Iterator[slice]:
    """Divide samples into the parts that are run through together."""
    return (slice(start, start + _TOGETHER) for start in range(0, count, _TOGETHER))


def _count(inputs: Iterable[Floats | Iterator[Floats]]) -> int:
    return max(len(each) for each in inputs if isinstance(each, np.ndarray) and each.ndim)


def _part(each: Floats | Iterator[Floats], part: slice) -> Floats:
    if isinstance(each, np.ndarray):
        return each[part] if each.ndim else each
    return next(each)


def _by_python(
    step: Callable[..., tuple[float, ...]], before: Floats, *inputs: Floats | None
) -> Floats:
    given = [column for array in inputs if array is not None for column in _columns(array)]
    state, rows = tuple(before.tolist()), []
    for sample in zip(*given, strict=False):
        state = step(*state, *sample)
        rows.append(state)
    return np.array(rows)


def _columns(array: Floats) -> list[Iterable[float]]:
    """Give Python's own numbers, a column each; without end where one is for all."""
    if not array.ndim:
        return [repeat(float(array))]
    return [array.tolist()] if array.ndim == 1 else [column.tolist() for column in array.T]
