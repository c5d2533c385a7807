"""Steps of filters, run over a recording: by a kernel, or sample by sample in Python."""

from collections.abc import Callable, Iterable
from itertools import repeat

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._kernels import kernel

_LISTED = 1024
"""Samples at a time, few enough that they stay in cache: Python's numbers take more room."""


def run(step: Callable[..., tuple[float, ...]], state: Iterable[float], *inputs: Floats) -> Floats:
    """Run a generated step over a recording.

    Parameters
    ----------
    step
        From `chr_notes.generated.scalar`: takes the state, then a sample.
    state
        Before the first sample.
    *inputs
        Of each sample, shape (N,) or (N, size); what is the same for all has no axis of samples.

    Returns
    -------
    ndarray
        The state after each sample, shape (N, size of the state).
    """
    state = tuple(state)
    count = max(len(array) for array in inputs if array.ndim)
    compiled = kernel(step.__name__)
    if compiled is not None and count:
        done: Floats | None = compiled(
            np.array(state), *(np.ascontiguousarray(array) for array in inputs), None
        )
        if done is not None:
            return done
    kept = np.empty((count, len(state)))
    for start in range(0, count, _LISTED):
        part = slice(start, start + _LISTED)
        rows = []
        for sample in zip(*(c for array in inputs for c in _columns(array, part)), strict=False):
            state = step(*state, *sample)
            rows.append(state)
        kept[part] = rows
    return kept


def _columns(array: Floats, part: slice) -> list[Iterable[float]]:
    """Give Python's own numbers, a column each; without end where one is for all."""
    if not array.ndim:
        return [repeat(float(array))]
    rows = array[part]
    return [rows.tolist()] if rows.ndim == 1 else [column.tolist() for column in rows.T]
