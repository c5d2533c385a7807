"""Functions that take each row of their arrays by itself: by a kernel, and by NumPy."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from math import isfinite, prod
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats, common_shape, floats
from chr_notes._kernels import completed, kernel
from chr_notes.generated.arrays.euler import rotation_defect
from chr_notes.generated.arrays.shapes import SHAPES

Bools = NDArray[np.bool_]
Places = NDArray[np.intp]

ROTATION_TOLERANCE = 1e-4
"""How far `R Rᵀ` may be off the identity, as the root mean square over its elements.

Matrices that are printed with four digits still pass.
"""
BLOCK = 8192
"""Rows that NumPy works on at a time: few enough to stay in cache."""
# A squared length below this, and above its inverse, lost nothing, and neither does its square.
_MOST = 2.0**380


@dataclass(frozen=True)
class Locked:
    """Attitudes at gimbal lock.

    Parameters
    ----------
    count
        How many there are.
    places
        Their indices in C order: the first one, or all of them if they were asked for.
    """

    count: int
    places: Places


NONE_LOCKED = Locked(0, np.empty(0, dtype=np.intp))


class Rows:
    """A function that takes each row of its arrays by itself, and broadcasts.

    A kernel computes where there is one. What it leaves, such as NaN, very large angles or
    quaternions, and attitudes at gimbal lock, and everything where there is none, NumPy does.

    Parameters
    ----------
    general
        The function from `chr_notes.generated.arrays`.
    rotation
        Whether the first array has to be a rotation.
    scaled
        What a row of zeros means in the first array, if its length does not matter: it is
        "refused", or "nothing" comes out, NaN.
    degree
        Power of that length to which the result is proportional nevertheless.
    """

    compute: Callable[..., Floats]
    """Takes the arguments, in the order of the general function's, and an array or None."""

    def __init__(
        self,
        general: Callable[..., Bools | None],
        *,
        rotation: bool = False,
        scaled: Literal["refused", "nothing"] | None = None,
        degree: int = 0,
    ) -> None:
        self.name, self._general = general.__name__, general
        arrays, self._result = SHAPES[self.name]
        self._names, self._lasts = tuple(arrays), tuple(arrays.values())
        self._axes = tuple(map(len, self._lasts))
        self._rotation, self._scaled, self._degree = rotation, scaled, degree
        self.use(kernel(self.name))

    def use(self, compiled: Callable[..., Any] | None) -> None:
        """Compute by a kernel, or by NumPy alone."""
        self._kernel = compiled
        self.compute = completed(compiled, self._rest)

    def __call__(self, *given: ArrayLike, out: Floats | None = None) -> Floats:
        """Compute; the arguments come in the order of the general function's."""
        return self.compute(*given, out)

    def _rest(self, done: tuple[Floats, bytes] | None, *given: Any) -> Floats:  # noqa: ANN401 (arrays, and one for the result)
        return self._finished(done, given[:-1], given[-1], self._names)[0]

    def located(
        self,
        *given: ArrayLike,
        out: Floats | None = None,
        names: tuple[str, ...] | None = None,
        every_place: bool = False,
    ) -> tuple[Floats, Locked]:
        """Compute, and tell where attitudes are at gimbal lock.

        Parameters
        ----------
        *given
            The arguments.
        out
            For the result, if it is to go there.
        names
            Of the arguments for errors, where they are not those of the general function.
        every_place
            Keep the index of each attitude at gimbal lock, for which memory grows with their
            number, instead of the first one's.

        Returns
        -------
        result
            Of shape (..., *last axes).
        locked
            The attitudes at gimbal lock.

        Raises
        ------
        ValueError
            If a shape is wrong, a row of zeros is refused, or a matrix is no rotation.
        TypeError
            If an argument holds no real numbers.
        """
        done = self._kernel(*given, out) if self._kernel is not None else None
        if done.__class__ is np.ndarray:
            return done, NONE_LOCKED
        return self._finished(done, given, out, names or self._names, every_place=every_place)

    def _finished(
        self,
        done: tuple[Floats, bytes] | None,
        given: tuple[ArrayLike, ...],
        out: Floats | None,
        names: tuple[str, ...],
        *,
        every_place: bool = False,
    ) -> tuple[Floats, Locked]:
        """Check and compute what the kernel has left: some rows, or all."""
        arrays = [floats(n, g, *last) for n, g, last in zip(names, given, self._lasts, strict=True)]
        leading = common_shape(*zip(names, arrays, self._axes, strict=True))
        shape = (*leading, *self._result)
        if out is not None:
            check_out(out, shape)
        rows = [_rows(a, leading, last) for a, last in zip(arrays, self._lasts, strict=True)]
        now = self._kernel(*rows, None) if done is None and self._kernel is not None else done
        locked = NONE_LOCKED
        if isinstance(now, np.ndarray):
            result = now.reshape(shape)
        else:
            result, left = now or (np.empty(shape), None)
            result = result.reshape(shape)
            locked = self._complete(result, left, rows, leading, names[0], every_place=every_place)
        if out is None or out is result:
            return result, locked
        np.copyto(out, result)
        return out, locked

    def _complete(  # noqa: PLR0913 (what there is, and what to say of it)
        self,
        result: Floats,
        left: bytes | None,
        rows: list[Floats],
        leading: tuple[int, ...],
        name: str,
        *,
        every_place: bool,
    ) -> Locked:
        """Compute what the kernel has left, block by block."""
        count = prod(leading)
        flat = result.reshape(count, *self._result)
        odd = None if left is None else np.frombuffer(left, dtype=np.bool_)
        locked = 0
        places: list[Places] = []
        whole = odd is None and count <= BLOCK
        with np.errstate(all="ignore"):
            for start in range(0, count, BLOCK):
                block: slice | Places = slice(start, min(start + BLOCK, count))
                if odd is not None:
                    block = start + np.flatnonzero(odd[block])
                    if not block.size:
                        continue
                parts = [array if whole or len(array) == 1 else array[block] for array in rows]
                values = flat if whole else flat[block]  # a view, but where rows were picked
                try:
                    lock = self._block(parts, values)
                except _WrongRow as wrong:
                    several = len(rows[0]) > 1
                    index = np.unravel_index(np.r_[block][wrong.row], leading) if several else ()
                    msg = wrong.message.format(f"{name}: ", tuple(map(int, index)))
                    raise ValueError(msg) from None
                if odd is not None:
                    flat[block] = values
                if lock is not None and lock.any():
                    if every_place or not places:
                        places.append(np.r_[block][lock][: None if every_place else 1])
                    locked += int(np.count_nonzero(lock))
        return Locked(locked, np.concatenate(places)) if places else NONE_LOCKED

    def _block(self, parts: list[Floats], values: Floats) -> Bools | None:
        ordinary = self._scaled is not None and _is_ordinary(parts[0])
        missing = _missing(parts[1:] if ordinary else parts)
        if self._rotation:
            _check_rotations(parts[0], missing)
        exponent = None
        if self._scaled is not None and not ordinary:
            parts[0], exponent = _scaled(parts[0], refused=self._scaled == "refused")
        lock = self._general(*parts, values)
        if exponent is not None and self._degree:
            exponent = self._degree * exponent
            np.ldexp(values, exponent.reshape(-1, *[1] * len(self._result)), out=values)
        if missing is not None:
            values[np.broadcast_to(missing, len(values))] = np.nan
        return lock


class _WrongRow(Exception):  # noqa: N818 (it becomes an error once its place is known)
    """A row that is refused: its number in the block, and what to say."""

    def __init__(self, row: int, message: str) -> None:
        super().__init__(message)
        self.row, self.message = row, message


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


def _rows(array: Floats, leading: tuple[int, ...], last: tuple[int, ...]) -> Floats:
    """Write an array as rows: as many as there are results, or one for all."""
    if array.shape == (len(array) if array.ndim else 1, *last) and len(leading) == 1:
        return array
    if array.size == prod(last):
        return array.reshape(1, *last)
    if array.shape != (*leading, *last):
        array = np.ascontiguousarray(np.broadcast_to(array, (*leading, *last)))
    return array.reshape(-1, *last)


def _missing(parts: list[Floats]) -> Bools | None:
    """Say which rows have NaN: what comes of them is NaN as a whole. None where no row has."""
    # A sum is NaN where a number is; nothing is lost if infinities make one too. (The product of
    # a row with itself is faster for few, but BLAS calls other threads for many.)
    if isfinite(sum([np.add.reduce(part, axis=None) for part in parts])):
        return None
    each = [np.isnan(part).reshape(len(part), -1).any(axis=1) for part in parts]
    return np.asarray(reduce(np.logical_or, each))


def _is_ordinary(rows: Floats) -> bool:
    """Say whether no row has NaN, or a length whose square or its square loses anything."""
    squares = np.einsum("ij,ij->i", rows, rows)
    return bool(np.add.reduce(squares + 1 / squares) < _MOST)


def _scaled(rows: Floats, *, refused: bool) -> tuple[Floats, NDArray[np.intc]]:
    """Bring each row's largest element to between 1/2 and 1, exactly.

    Returns
    -------
    rows
        The scaled rows.
    exponent
        Power of two by which each was divided.
    """
    largest = reduce(np.maximum, np.abs(rows).T)
    if refused and (largest == 0).any():
        row = int(np.argmax(largest == 0))
        raise _WrongRow(row, "{}expected no row of zeros, got one at index {}")
    exponent = np.where(np.isfinite(largest), np.frexp(largest)[1], 0)
    return np.ldexp(rows, -exponent[:, np.newaxis]), exponent


def _check_rotations(matrix: Floats, missing: Bools | None) -> None:
    """Refuse matrices that are not rotations; those with NaN are passed over."""
    defects = np.empty((len(matrix), 2))
    rotation_defect(matrix, defects)
    off_by, determinant = defects.T
    right = (off_by <= ROTATION_TOLERANCE) & (determinant >= 0)
    wrong = np.flatnonzero(~(right if missing is None else right | missing))
    if wrong.size:
        first = int(wrong[0])
        raise _WrongRow(
            first,
            f"{{}}expected rotations (R Rᵀ = I within {ROTATION_TOLERANCE:g}, determinant 1), got "
            f"one at index {{}} with R Rᵀ off by {off_by[first]:.2g} and determinant "
            f"{determinant[first]:.4g}",
        )
