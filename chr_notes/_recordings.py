"""Steps of filters, run over a recording: by a kernel, or sample by sample in Python."""

from collections.abc import Callable, Iterable
from functools import partial
from itertools import repeat

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._kernels import kernel

_TOGETHER = 4096
"""Samples at a time, few enough that what is between them and the result stays in cache."""


def run(
    step: Callable[..., tuple[float, ...]],
    state: Iterable[float],
    *inputs: Floats,
    finish: Callable[[Floats], Floats] = np.asarray,
    before: Floats | None = None,
) -> Floats:
    """Run a generated step over a recording.

    Parameters
    ----------
    step
        From `chr_notes.generated.scalar`: takes the state, then a sample.
    state
        Before the first sample.
    *inputs
        Of each sample, shape (N,) or (N, size); what is the same for all has no axis of samples.
    finish
        From states to what is wanted of them, row by row.
    before
        Rows that stand before all others in the result.

    Returns
    -------
    ndarray
        Those, and what is wanted of the state after each sample, shape (N, size).
    """
    compiled = kernel(step.__name__)
    advance = partial(_by_python, step) if compiled is None else partial(_by_kernel, compiled)
    given = [np.ascontiguousarray(array) if array.ndim else array for array in inputs]
    count = max(len(array) for array in given if array.ndim)
    now = np.array([*state])
    ahead = 0 if before is None else len(before)
    whole = np.empty((ahead + count, finish(now[np.newaxis].copy()).shape[1]))
    whole[:ahead] = 0.0 if before is None else before
    kept = whole[ahead:]
    for start in range(0, count, _TOGETHER):
        part = slice(start, start + _TOGETHER)
        states = advance(now, [array[part] if array.ndim else array for array in given])
        now = states[-1].copy()  # what finishes may write on the states
        kept[part] = finish(states)
    return whole


def _by_kernel(compiled: Callable[..., Floats], state: Floats, inputs: list[Floats]) -> Floats:
    return compiled(state, *inputs, None)


def _by_python(
    step: Callable[..., tuple[float, ...]], before: Floats, inputs: list[Floats]
) -> Floats:
    state, rows = tuple(before.tolist()), []
    for sample in zip(*(column for array in inputs for column in _columns(array)), strict=False):
        state = step(*state, *sample)
        rows.append(state)
    return np.array(rows)


def _columns(array: Floats) -> list[Iterable[float]]:
    """Give Python's own numbers, a column each; without end where one is for all."""
    if not array.ndim:
        return [repeat(float(array))]
    return [array.tolist()] if array.ndim == 1 else [column.tolist() for column in array.T]
