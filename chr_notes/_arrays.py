"""What the numeric functions share: checks of type and shape."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
_DOUBLE = np.dtype(np.float64)


def floats(name: str, value: ArrayLike, *last: int) -> Floats:
    """Take an argument as an array of float64 in C order with the given last axes.

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
    if type(value) is np.ndarray and value.dtype is _DOUBLE and value.flags.c_contiguous:
        axes = value.ndim - len(last)
        if axes >= 0 and value.shape[axes:] == last:  # as is the rule, and quick to see
            return value
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
    return np.asarray(array, dtype=np.float64, order="C")


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
    return numbers


def common_shape(*arguments: tuple[str, Floats, int]) -> tuple[int, ...]:
    """Broadcast the leading axes of arguments.

    Parameters
    ----------
    *arguments
        Name and value of each, and how many of its last axes do not broadcast.

    Raises
    ------
    ValueError
        If the leading axes do not fit each other.
    """
    leading = [array.shape[: array.ndim - axes] for _, array, axes in arguments]
    first = leading[0]
    if all(shape == first for shape in leading):
        return first
    try:
        return np.broadcast_shapes(*leading)
    except ValueError:
        # Those that have leading axes, one of a name.
        told = {name: array.shape for name, array, axes in arguments if array.ndim > axes}
        names = " and ".join(told)
        shapes = " and ".join(map(str, told.values()))
        msg = f"expected {names} with leading axes that broadcast, got shapes {shapes}"
        raise ValueError(msg) from None
