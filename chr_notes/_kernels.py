"""The kernels: functions of arrays in compiled C, where they were built.

The environment variable `CHR_NOTES_KERNELS` says `off` to compute with NumPy alone, and `require`
to fail where the kernels cannot be used.
"""

import os
import sys
import warnings
from collections.abc import Callable
from functools import partial
from importlib import import_module
from itertools import chain
from types import ModuleType
from typing import Any

import numpy as np

from chr_notes._signals import IS_COMMAND
from chr_notes.generated import STAMP

VARIABLE = "CHR_NOTES_KERNELS"


def _load() -> ModuleType | None:
    choice = os.environ.get(VARIABLE, "")
    if choice not in ("", "off", "require"):
        msg = f"{VARIABLE}: expected off or require, got {choice!r}"
        raise ValueError(msg)
    if choice == "off":
        return None
    try:
        module = import_module("chr_notes._compiled")
    except ImportError as error:
        if choice == "require":
            msg = (
                "expected the kernels, but they were not built: is there a C compiler, with "
                "Python's headers? `pip install -v` shows what it says"
            )
            raise ImportError(msg) from error
        return None
    if getattr(module, "stamp", None) != STAMP:
        msg = "the kernels were built from other sources than these: install chr_notes again"
        if choice == "require":
            raise ImportError(msg)
        warnings.warn(f"{msg}; until then NumPy computes", RuntimeWarning, stacklevel=2)
        return None
    return module


try:
    _MODULE = _load()
except (ImportError, ValueError) as error:
    if not IS_COMMAND:
        raise
    sys.exit(f"chr-notes: {error}")


def kernel(name: str) -> Callable[..., Any] | None:
    """Find a kernel by the name of its function, None where NumPy has to do.

    It takes arrays, and None or an array for the result. It returns the result; or the result and
    a byte for each row that is left to the general way, of a filter's step for each sample that is
    not a usual one; or None where the arrays are not of float64 in C order, nor rows of one, or
    would have to be broadcast.
    """
    return getattr(_MODULE, name, None)


def completed(compiled: Callable[..., Any] | None, rest: Callable[..., Any]) -> Callable[..., Any]:
    """Make a function that asks a kernel, and then another function, if something is left.

    Parameters
    ----------
    compiled
        The kernel, if there is one.
    rest
        Takes what the kernel returned, or None, and a tuple of its arguments.
    """
    if compiled is None or _MODULE is None:
        return lambda *given: rest(None, given)
    return _MODULE.completed(compiled, rest)  # type: ignore[no-any-return] # a module of C


def of_arrays(step: Callable[..., Any]) -> Callable[..., Any]:
    """Find the kernel of a filter's step, or make a function of the same arguments of the step.

    Parameters
    ----------
    step
        From `chr_notes.generated.scalar`, over samples.

    Returns
    -------
    callable
        Takes state and sample, arrays and numbers, and None or an array for the next state, which
        it returns; None where a kernel is given anything else.
    """
    compiled = kernel(step.__name__)
    return partial(_by_numbers, step) if compiled is None else completed(compiled, all_of_it)


def all_of_it(done: tuple[Any, bytes] | None, _: object) -> Any:  # noqa: ANN401 (arrays)
    """Take what a kernel of samples has done, whatever samples they were."""
    return done and done[0]


def _by_numbers(step: Callable[..., Any], *given: Any) -> Any:  # noqa: ANN401 (arrays)
    *taken, out = given
    arrays = (each.tolist() if isinstance(each, np.ndarray) else (each,) for each in taken)
    state = step(*chain.from_iterable(arrays))
    if out is None:
        return np.array(state)
    out[:] = state
    return out


def sampled(step: Callable[..., Any], finish: Callable[..., Any]) -> Callable[..., Any] | None:
    """Find the kernels that move a state on by a sample, and tell something of it.

    Parameters
    ----------
    step, finish
        From `chr_notes.generated.scalar`.

    Returns
    -------
    callable or None
        Takes the state, an array that is changed, and a sample. Returns the result of `finish`
        of the state; False where the sample is not a usual one, or `finish` has no kernel for the
        state; or None, and nothing is done, where a sample is no arrays of float64.
    """
    first, second = kernel(step.__name__), kernel(finish.__name__)
    if _MODULE is None or first is None or second is None:
        return None
    return _MODULE.sampled(first, second)  # type: ignore[no-any-return] # a module of C


def kernels_in_use() -> bool:
    """Say whether compiled kernels do the work, or NumPy.

    They are built when chr_notes is installed, where there is a C compiler. When it is imported,
    the environment variable `CHR_NOTES_KERNELS` says `off` to do without them, and `require` to
    fail without them; to what is installed it makes no difference.

    Returns
    -------
    bool
        Whether they are at work.

    Examples
    --------
    >>> isinstance(kernels_in_use(), bool)
    True
    """
    return _MODULE is not None
