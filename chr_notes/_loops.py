"""Generated loops over samples: compiled by numba where it is installed, plain Python elsewhere.

Both run the same source and give the same numbers.
"""

from collections.abc import Callable, Iterable, Sequence
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from itertools import repeat
from struct import pack
from types import FunctionType
from typing import Any

import numpy as np

from chr_notes._arrays import Floats

LONG = 100_000
"""Samples from which on it pays to load numba and compile, which takes seconds the first time."""
# Samples at a time, few enough that they stay in cache: lists of Python's numbers take more room.
_LISTED, _COMPILED = 1024, 8192


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
    kept = np.empty((count, len(state)))
    fast = count >= LONG and find_spec("numba") is not None
    function, size = (compiled(loop), _COMPILED) if fast else (loop, _LISTED)
    # Arrays that are always alike, so that numba compiles once
    take: Callable[[Floats], Iterable[float]] = np.array if fast else _listed
    for start in range(0, count, size):
        part = kept[start : start + size]
        given = [take(each[start : start + size]) for each in inputs]
        rows = np.empty(part.shape[::-1]) if fast else [[0.0] * len(part) for _ in state]
        state = function(*state, *constants, *given, *rows)
        for column, row in zip(part.T, rows, strict=True):
            # Packed first, a list is read in a third of the time.
            column[:] = row if fast else np.frombuffer(pack(f"{len(row)}d", *row))
    return kept


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
