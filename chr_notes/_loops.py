"""Generated loops over samples: compiled by numba where it is installed, plain Python elsewhere.

Both run the same source and give the same numbers.
"""

from collections.abc import Callable, Iterable, Sequence
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from itertools import repeat
from types import FunctionType
from typing import Any

import numpy as np

from chr_notes._arrays import Floats

LONG = 100_000
"""Samples from which on it pays to load numba and compile, which takes seconds the first time."""
_CHUNK = 8192  # samples at a time in plain Python, whose lists take much memory


def run(
    loop: Callable[..., Any],
    state: Sequence[float],
    constants: Sequence[float],
    inputs: Sequence[Floats],
) -> Floats:
    """Run a generated loop over a recording.

    Parameters
    ----------
    loop
        From `chr_notes.generated.loops`.
    state
        Before the first sample.
    constants
        Its constants.
    inputs
        Its inputs, each of shape (N,).

    Returns
    -------
    ndarray
        The state after each sample, shape (N, number of states).
    """
    count = len(inputs[0])
    kept = np.empty((len(state), count))
    if count >= LONG and find_spec("numba") is not None:
        samples = [np.ascontiguousarray(each) for each in inputs]
        compiled(loop)(*state, *constants, *samples, *kept)
        return kept.T
    for start in range(0, count, _CHUNK):
        part = slice(start, start + _CHUNK)
        lists = [_listed(each[part]) for each in inputs]
        rows = [[0.0] * len(inputs[0][part]) for _ in state]
        state = loop(*state, *constants, *lists, *rows)
        kept[:, part] = rows
    return kept.T


def _listed(values: Floats) -> Iterable[float]:
    """Give the values as Python's own numbers, once for all where they are broadcast."""
    return values.tolist() if values.strides[0] else repeat(float(values[0]), len(values))


@cache
def compiled(loop: FunctionType) -> Callable[..., Any]:
    """Compile a loop, and the functions of its module that it calls."""
    jit = import_module("numba").njit(cache=True)
    called = {
        name: jit(loop.__globals__[name])
        for name in loop.__code__.co_names
        if isinstance(loop.__globals__.get(name), FunctionType)
    }
    bound = FunctionType(loop.__code__, {**loop.__globals__, **called}, loop.__name__)
    bound.__qualname__, bound.__module__ = loop.__qualname__, loop.__module__
    result: Callable[..., Any] = jit(bound)
    return result
