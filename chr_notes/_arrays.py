"""What the numeric functions share: checks of shape, and generated functions run in blocks."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Numbers = NDArray[Any]
"""Real or complex ones."""
Reports = tuple[Floats | None, NDArray[np.bool_] | None] | None

BLOCK = 8192
"""Rows that are worked on at a time: few enough that what is computed on the way stays in cache."""
_WORK, _PAIRS = 16, 8
# A squared length within these bounds lost nothing, and neither did its square.
_LEAST, _MOST = 2.0**-400, 2.0**400


@dataclass(frozen=True)
class Locked:
    """Elements at gimbal lock.

    Parameters
    ----------
    count
        How many there are.
    places
        Their indices in C order: the first one, or all of them if they were asked for.
    """

    count: int
    places: NDArray[np.intp]


def reals(name: str, value: ArrayLike, *last: int) -> Floats:
    """Take an argument as an array of real numbers with the given last axes.

    A type other than float64 stays as it is, so that no copy is needed: blocks are converted.

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
        If the numbers are not real.
    """
    array = np.asarray(value)
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        # The numbers under a mask are not to be used.
        array = np.where(np.ma.getmaskarray(value), np.nan, array)
    if array.dtype.kind in "cmM":
        # Times of NumPy would be taken for numbers in whatever unit they are kept.
        msg = f"{name}: expected real numbers, got {array.dtype}"
        raise TypeError(msg)
    if array.dtype.kind not in "biuf":
        # Numbers of other types may still be real, such as fractions.
        array = np.asarray(value, dtype=np.float64)
    if array.ndim < len(last) or array.shape[array.ndim - len(last) :] != last:
        sizes = ", ".join(str(size) for size in last)
        msg = f"{name}: expected shape (..., {sizes}), got {array.shape}"
        raise ValueError(msg)
    return array


def floats(name: str, value: ArrayLike, *last: int) -> Floats:
    """Take an argument as `reals` does, converted to float64."""
    return reals(name, value, *last).astype(np.float64, copy=False)


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
    if leading.count(leading[0]) == len(leading):
        return leading[0]
    try:
        return np.broadcast_shapes(*leading)
    except ValueError:
        names = " and ".join(name for name, _, _ in arguments)
        shapes = " and ".join(str(array.shape) for _, array, _ in arguments)
        msg = f"expected {names} with leading axes that broadcast, got shapes {shapes}"
        raise ValueError(msg) from None


def components(array: Floats, axes: int = 1) -> list[Floats]:
    """Take views of the elements along the last axes, row by row."""
    shape = array.shape[array.ndim - axes :]
    # The dots make a view of one element an array, not a number, so that it can be written to.
    places: Iterator[tuple[Any, ...]] = product([...], *map(range, shape))
    return [array[place] for place in places]


def in_pairs(*arrays: Floats) -> bool:
    """Whether neighbours along the last axis lie in memory as the parts of a complex number do."""
    return all(
        array.dtype == np.float64 and array.strides[-1] == array.itemsize and array.flags.aligned
        for array in arrays
    )


def pairs(array: Floats) -> list[Numbers]:
    """Take views of the elements along the last axis, of an even size, as complex numbers."""
    return components(array.view(np.complex128))


def blocks(
    given: Sequence[Numbers], out: Sequence[Numbers]
) -> Iterator[tuple[int, tuple[Numbers, ...], tuple[Numbers, ...], list[list[Numbers]]]]:
    """Go through arrays that broadcast in blocks of at most `BLOCK` elements.

    Parameters
    ----------
    given
        Arrays to read, of any real type or complex128.
    out
        Arrays to write, whose shape is what the others broadcast to.

    Yields
    ------
    tuple
        Index of the block's first element in C order, the blocks to read and to write, and
        storage for the real numbers that are computed on the way, and for complex ones if some of
        the arrays are complex.
    """
    arrays = [*given, *out]
    types = [np.complex128 if array.dtype.kind == "c" else np.float64 for array in arrays]
    size = min(BLOCK, max(1, arrays[-1].size))
    storage: list[Numbers] = [np.empty((_WORK, size))]
    if np.complex128 in types:
        storage.append(np.empty((_PAIRS, size), dtype=np.complex128))
    whole = [list(rows) for rows in storage]
    read: list[Literal["readonly", "writeonly"]] = ["readonly"]
    write: list[Literal["readonly", "writeonly"]] = ["writeonly"]
    start = 0
    with np.nditer(
        arrays,
        flags=["external_loop", "buffered", "zerosize_ok"],
        op_flags=[read] * len(given) + [write] * len(out),
        op_dtypes=types,
        order="C",
        casting="same_kind",
        buffersize=size,
    ) as iterator:
        for parts in iterator:
            count = len(parts[0])
            if count:
                work = whole if count == size else [list(rows[:, :count]) for rows in storage]
                yield start, parts[: len(given)], parts[len(given) :], work
            start += count


def evaluate(  # noqa: PLR0913 # the last two are for one function or two each
    function: Callable[..., Reports],
    given: Sequence[Numbers],
    out: Sequence[Numbers],
    scaled: tuple[str, Floats] | None = None,
    degree: int = 0,
    *,
    every_place: bool = False,
) -> Locked:
    """Run a generated function over arrays.

    Parameters
    ----------
    function
        From `chr_notes.generated.arrays`.
    given
        Its arguments, broadcasting; those of `scaled` come first.
    out
        Its results.
    scaled
        Name and value of the argument that must not be zero, for a function with a guard. Where its
        square would overflow or vanish it is scaled first.
    degree
        Power of the length of `scaled` to which the results are proportional.
    every_place
        Keep the index of every element at gimbal lock, for which memory grows with their number,
        instead of the first one's.

    Returns
    -------
    Locked
        The elements at gimbal lock, if the function tells.

    Raises
    ------
    ValueError
        If a row of `scaled` is zero; it names the first one.
    """
    count, found = 0, [np.empty(0, dtype=np.intp)]
    # Entered once: each time costs as much as an operation on a whole block.
    with np.errstate(all="ignore"):
        for start, parts, results, work in blocks(given, out):
            lock = _block(function, parts, results, work, scaled, degree)
            if lock is not None and lock.any():
                if every_place or not count:
                    found.append(start + np.flatnonzero(lock)[: None if every_place else 1])
                count += int(np.count_nonzero(lock))
    return Locked(count, np.concatenate(found))


def _block(  # noqa: PLR0913, PLR0917 # a block, and what `evaluate` was asked for
    function: Callable[..., Reports],
    parts: Sequence[Numbers],
    results: Sequence[Numbers],
    work: Sequence[Sequence[Numbers]],
    scaled: tuple[str, Floats] | None,
    degree: int,
) -> NDArray[np.bool_] | None:
    """Run a generated function over a block; tell which elements are at gimbal lock."""
    guard, lock = function(*parts, results, *work) or (None, None)
    # A comparison with NaN fails, so a block with NaN goes the slow way.
    if scaled is None or guard is None or (guard.min() > _LEAST and guard.max() < _MOST):
        return lock
    several = scaled[1].shape[-1] // len(_real(parts[0]))
    scaled_parts, exponent = _scale(parts[:several], *scaled)
    _, lock = function(*scaled_parts, *parts[several:], results, *work) or (None, None)
    for result in results if degree else ():
        np.ldexp(result, degree * exponent, out=result)
    return lock


def _scale(
    parts: Sequence[Numbers], name: str, argument: Floats
) -> tuple[list[Numbers], NDArray[np.intc]]:
    """Bring each row's largest element to between 1/2 and 1, exactly; refuse a row of zeros.

    Returns
    -------
    parts
        The scaled parts.
    exponent
        Power of two by which each row was divided.
    """
    copies = [part.copy() for part in parts]
    numbers = [number for part in copies for number in _real(part)]
    largest = np.max(np.abs(numbers), axis=0)
    if (largest == 0).any():
        where = np.argwhere(~np.any(argument, axis=-1))[0]
        msg = f"{name}: expected no row of zeros, got one at index {tuple(map(int, where))}"
        raise ValueError(msg)
    exponent = np.where(np.isfinite(largest), np.frexp(largest)[1], 0)
    for number in numbers:
        np.ldexp(number, -exponent, out=number)
    return copies, exponent


def _real(part: Numbers) -> list[Floats]:
    """Take the real numbers that a block consists of."""
    return [part.real, part.imag] if part.dtype.kind == "c" else [part]
