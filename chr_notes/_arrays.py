"""What the numeric functions share: checks of type and shape, of arguments and of results."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]
DOUBLE = np.dtype(np.float64)
# Of more numbers BLAS adds up with several threads, for which others have to wait.
_ALONE = 10_000
_LEFT_OUT = {
    "body_rates": "a log without a gyro has none",
    "accel": "a log without an accelerometer has none",
    "mag": "a log without a magnetometer has none",
    "temperature": "a log without a thermometer has none; leave the argument out",
    "dt": "a log without times has none; pass rate= to read_log, in Hz, or here one over the rate",
}


def floats(name: str, value: ArrayLike | float, *last: int) -> Floats:
    """Take an argument as an array of float64 in C order, aligned, with the given last axes.

    Parameters
    ----------
    name
        Of the argument, for the error.
    value
        Array-like of real numbers; elements that are masked out are taken for NaN.
    *last
        Expected sizes of the last axes.

    Raises
    ------
    ValueError
        If the last axes differ; it states the expected and the received shape.
    TypeError
        If what is given are not real numbers.
    """
    if type(value) is np.ndarray and value.dtype is DOUBLE and value.flags.carray:
        axes = value.ndim - len(last)
        if axes >= 0 and value.shape[axes:] == last:  # as is the rule, and quick to see
            return value
    if isinstance(value, float) and not last:
        return np.array(value, dtype=np.float64)
    if value is None:
        advice = f"; {_LEFT_OUT[name]}" if name in _LEFT_OUT else ""  # type: ignore[unreachable]
        msg = f"{name}: expected real numbers, got None{advice}"
        raise TypeError(msg)
    try:
        array = np.asarray(value)
    except ValueError:
        msg = f"{name}: expected rows of equal length, got {value!r:.80}"
        raise ValueError(msg) from None
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        # The numbers under a mask are not to be used.
        array = np.where(np.ma.getmaskarray(value), np.nan, array)
    if array.dtype.kind not in "biuf":
        array = _numbers(name, array)
    if array.ndim < len(last) or array.shape[array.ndim - len(last) :] != last:
        sizes = ", ".join(str(size) for size in last)
        msg = f"{name}: expected shape (..., {sizes}), got {array.shape}"
        raise ValueError(msg)
    if array.dtype.itemsize > DOUBLE.itemsize:
        with np.errstate(all="ignore"):  # of wider numbers some become infinite, or zero
            array = array.astype(np.float64)
    array = np.asarray(array, dtype=np.float64, order="C")
    return array if array.flags.aligned else array.copy()


def _numbers(name: str, array: NDArray[Any]) -> Floats:
    """Take numbers of other types that are real, such as fractions; refuse all else.

    Times of NumPy would be taken for numbers in whatever unit they are kept, text for what it
    says, and nothing for NaN.
    """
    if array.dtype.kind != "O":
        msg = f"{name}: expected real numbers, got {array.dtype}"
        raise TypeError(msg)
    numbers = np.empty(array.shape)
    for place, value in np.ndenumerate(array):
        try:
            numbers[place] = float(value) if not isinstance(value, str | bytes) else None
        except (TypeError, ValueError):
            msg = f"{name}: expected real numbers, got {value!r:.40} at index {place}"
            raise TypeError(msg) from None
        except OverflowError:
            msg = f"{name}: expected numbers below 1.8e308, got a larger one at index {place}"
            raise ValueError(msg) from None
    return numbers


def common_shape(
    names: tuple[str, ...], arrays: tuple[Floats, ...], axes: tuple[int, ...]
) -> tuple[int, ...]:
    """Broadcast the leading axes of arguments.

    Parameters
    ----------
    names, arrays
        Of the arguments.
    axes
        How many of the last axes of each do not broadcast.

    Raises
    ------
    ValueError
        If the leading axes do not fit each other.
    """
    leading = [a.shape[: a.ndim - last] for a, last in zip(arrays, axes, strict=True)]
    try:
        return np.broadcast_shapes(*leading)
    except ValueError:
        # Those that have leading axes, one of a name.
        whole = zip(names, arrays, leading, strict=True)
        told = {name: str(array.shape) for name, array, axes_of_it in whole if axes_of_it}
        msg = (
            f"expected {' and '.join(told)} with leading axes that broadcast, got shapes "
            f"{' and '.join(told.values())}"
        )
        raise ValueError(msg) from None


def check_out(out: Floats, shape: tuple[int, ...]) -> None:
    """Refuse what a result of that shape cannot go to.

    Raises
    ------
    ValueError
        If the shape differs, or the array may not be written to.
    TypeError
        If it is no array of float64.
    """
    if not isinstance(out, np.ndarray) or out.dtype != np.float64:
        got = str(out.dtype) if isinstance(out, np.ndarray) else type(out).__name__
        msg = f"out: expected an array of float64, got {got}"
        raise TypeError(msg)
    if out.shape != shape or not out.flags.writeable:
        got = "one that may not be written to" if out.shape == shape else f"shape {out.shape}"
        msg = f"out: expected an array of shape {shape}, got {got}"
        raise ValueError(msg)


def at_first(where: Bools) -> str:
    """Say, at the end of an error, where something holds first; nothing of one number."""
    return f" at index {tuple(map(int, np.argwhere(where)[0]))}" if where.ndim else ""


def sum_of_squares(flat: Floats) -> float:
    """Add up squares, by BLAS in one thread."""
    if len(flat) <= _ALONE:
        return float(flat.dot(flat))
    half = len(flat) // 2
    return sum_of_squares(flat[:half]) + sum_of_squares(flat[half:])


def handed_out(parts: tuple[Floats, ...], out: tuple[Floats, ...] | None) -> tuple[Floats, ...]:
    """Give each part of a result as an array of its own, or write it to one of `out`.

    Raises
    ------
    TypeError
        If `out` is no tuple of as many arrays of float64.
    ValueError
        As `check_out`.
    """
    if out is None:
        return tuple(part.copy()[()] for part in parts)
    if not isinstance(out, tuple) or len(out) != len(parts):
        got = len(out) if isinstance(out, tuple) else type(out).__name__
        msg = f"out: expected a tuple of {len(parts)} arrays, got {got}"
        raise TypeError(msg)
    for part, to in zip(parts, out, strict=True):
        check_out(to, part.shape)
    for part, to in zip(parts, out, strict=True):
        np.copyto(to, part)
    return out
