"""Checks of shape that the numeric functions share."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def floats(name: str, value: ArrayLike, *last: int) -> Floats:
    """Take an argument as float64 with the given last axes.

    Parameters
    ----------
    name
        Of the argument, for the error.
    value
        Array-like of real numbers.
    *last
        Expected sizes of the last axes.

    Raises
    ------
    ValueError
        If the last axes differ; it states the expected and the received shape.
    """
    array = np.asarray(value, dtype=np.float64)
    if array.shape[array.ndim - len(last) :] != last:
        sizes = ", ".join(str(size) for size in last)
        msg = f"{name}: expected shape (..., {sizes}), got {array.shape}"
        raise ValueError(msg)
    return array


def common_shape(first: tuple[str, Floats], second: tuple[str, Floats]) -> tuple[int, ...]:
    """Broadcast the leading axes of two arguments whose last axis is a vector.

    Raises
    ------
    ValueError
        If the leading axes do not fit each other.
    """
    try:
        return np.broadcast_shapes(first[1].shape[:-1], second[1].shape[:-1])
    except ValueError:
        msg = (
            f"expected {first[0]} and {second[0]} with leading axes that broadcast, "
            f"got shapes {first[1].shape} and {second[1].shape}"
        )
        raise ValueError(msg) from None
