"""Checks that functions of recordings share: samples along the first axis, one after another."""

from collections.abc import Sequence
from math import isfinite
from typing import Any, cast

import numpy as np
from numpy import ndarray
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import DOUBLE, Floats, floats

WILD_RATE = 1e12
"""No gyro reads as much, rad/s: such rates come from damaged logs, and leave angles no digits."""
_THREE = (3,)


def samples(name: str, value: ArrayLike) -> Floats:
    """Take a recording of vectors, shape (N, 3).

    Raises
    ------
    ValueError
        If the shape differs; it states the expected and the received shape.
    """
    array = floats(name, value, 3)
    if array.ndim != 2:  # noqa: PLR2004 (samples by axes)
        msg = f"{name}: expected shape (N, 3), got {array.shape}"
        raise ValueError(msg)
    return array


@np.errstate(all="ignore")  # without end is not below
def complete(array: Floats, below: float = np.inf) -> NDArray[np.bool_]:
    """Say which rows of a two-dimensional array hold numbers alone, of a length below a limit."""
    flat = array.ravel()
    if np.einsum("i,i", flat, flat) < below**2:  # as is the rule, and then nothing is NaN
        return np.ones(len(array), dtype=np.bool_)
    return np.asarray(np.hypot.reduce(array.T) < below)


@np.errstate(all="ignore")  # without end is a length too
def lengths(vectors: Floats) -> Floats:
    """Lengths of vectors, shape (N, 3)."""
    return np.asarray(np.linalg.norm(vectors, axis=1))


def one_sample(name: str, value: ArrayLike) -> Sequence[float]:
    """Take one vector, as three of Python's numbers.

    Raises
    ------
    ValueError
        If the shape is not (3,); it states the received shape.
    """
    # Of what is the rule it is quick to see.
    kind: type = type(value)
    numbers: Any = value.tolist() if kind is ndarray else value  # type: ignore[union-attr]
    try:
        if kind is list or kind is ndarray or isinstance(value, (list, tuple)):
            x, y, z = numbers
            if type(x) is type(y) is type(z) is float:
                return numbers  # type: ignore[no-any-return]
    except (TypeError, ValueError):  # of which is told below
        pass
    array = floats(name, value, 3)
    if array.ndim != 1:
        msg = f"{name}: expected shape (3,), got {array.shape}"
        raise ValueError(msg)
    return list(array.tolist())


def one_vector(name: str, value: ArrayLike) -> Floats:
    """Take one vector, as an array that a kernel takes; refuse it as `one_sample` does."""
    if type(value) is ndarray and value.dtype is DOUBLE and value.shape == _THREE:
        return value if value.flags.carray else value.copy()
    return np.array(one_sample(name, value))


def period(value: object) -> float:
    """Take one time step.

    Raises
    ------
    ValueError
        If it is negative or no number.
    """
    if isinstance(value, float) and 0 <= value < np.inf:
        return value
    return float(periods(number("dt", cast("ArrayLike", value)), 1))


def start(name: str, value: ArrayLike) -> Sequence[float]:
    """Take three numbers to start from.

    Raises
    ------
    ValueError
        If the shape is not (3,), or a number is not finite.
    """
    x, y, z = numbers = one_sample(name, value)
    if not isfinite(x + y + z) and not all(map(isfinite, numbers)):
        msg = f"{name}: expected three finite numbers, got {[*numbers]}"
        raise ValueError(msg)
    return numbers


def number(name: str, value: ArrayLike | float) -> float:
    """Take one number.

    Raises
    ------
    ValueError
        If it is an array; it states the received shape.
    """
    if isinstance(value, float):
        return float(value)
    array = floats(name, value)
    if array.ndim:
        msg = f"{name}: expected a number, got shape {array.shape}"
        raise ValueError(msg)
    return float(array)


def positive(name: str, value: ArrayLike | float) -> float:
    """Take a positive number.

    Raises
    ------
    ValueError
        If it is not positive, or infinite.
    """
    found = number(name, value)
    if not 0 < found < np.inf:
        msg = f"{name}: expected a positive number, got {found}"
        raise ValueError(msg)
    return found


def horizontal(name: str, value: ArrayLike) -> tuple[float, float]:
    """Take a horizontal field, north and east, as two of Python's numbers.

    Raises
    ------
    ValueError
        If the shape is not (2,), or the field is zero or not finite.
    """
    north, east = floats(name, value, 2).T.tolist() if np.ndim(value) == 1 else (np.nan, np.nan)
    if not (isfinite(north) and isfinite(east) and (north or east)):
        msg = f"{name}: expected a horizontal field, north and east, got {value!r}"
        raise ValueError(msg)
    return north, east


def same_length(*recordings: tuple[str, Floats]) -> int:
    """Count the samples of recordings that belong together.

    Raises
    ------
    ValueError
        If one has more or fewer rows than another.
    """
    lengths = [len(array) for _, array in recordings]
    if len(set(lengths)) > 1:
        names = ", ".join(name for name, _ in recordings)
        msg = f"expected as many rows in each of {names}, got {', '.join(map(str, lengths))}"
        raise ValueError(msg)
    return lengths[0]


def times(value: ArrayLike) -> Floats:
    """Take times in seconds, rising, shape (N,).

    Raises
    ------
    ValueError
        If the shape differs, or the times do not rise.
    """
    array = floats("time", value)
    if array.ndim != 1:
        msg = f"time: expected shape (N,), got {array.shape}"
        raise ValueError(msg)
    steps = np.diff(array)
    if not (steps > 0).all():
        place = int(np.argmax(~(steps > 0)))
        msg = f"time: expected rising times, got {array[place : place + 2].tolist()} at {place}"
        raise ValueError(msg)
    return array


def periods(value: ArrayLike, count: int) -> Floats:
    """Take the time steps of a recording: a number, or one for each sample.

    Raises
    ------
    ValueError
        If the shape is neither, or a step is negative or no number.
    """
    array = floats("dt", value)
    if array.shape not in ((), (count,)):
        msg = f"dt: expected a number or shape ({count},), got {array.shape}"
        raise ValueError(msg)
    wrong = np.flatnonzero(~(np.isfinite(array) & (array >= 0)))
    if wrong.size:
        found = array.reshape(-1)[wrong[0]]
        msg = f"dt: expected seconds, not negative, got {found} at {wrong[0]}"
        raise ValueError(msg)
    return array


def per_axis(name: str, value: ArrayLike) -> Floats:
    """Take one number for all axes or one for each, as shape (3,).

    Raises
    ------
    ValueError
        If it is neither; it states the expected and the received shape.
    """
    array = floats(name, value)
    if array.shape not in ((), (3,)):
        msg = f"{name}: expected a number or shape (3,), got {array.shape}"
        raise ValueError(msg)
    return np.broadcast_to(array, (3,))
