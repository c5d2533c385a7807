"""Functions that take each row of their arrays by itself: by a kernel, and by NumPy."""

from collections.abc import Callable, Sequence
from contextvars import Context
from dataclasses import dataclass, field
from math import prod
from typing import Any, Literal

import numpy as np
from numpy import ndarray
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import DOUBLE, Bools, Floats, check_out, common_shape, floats, sum_of_squares
from chr_notes._kernels import completed, kernel
from chr_notes._odd_rows import WrongRow, check_rotations, rows_with_nan, scaled
from chr_notes.generated.arrays.shapes import SHAPES

Places = NDArray[np.intp]

BLOCK = 8192
"""Rows that NumPy works on at a time: few enough to stay in cache."""
# A C library that has seen an array as large as this come and go keeps the memory of smaller ones
# for the next of them. From the system it would come anew, page by page, which takes longer than
# the computing.
np.empty(2**18)
# A squared length between these lost nothing, and neither does its square.
_MOST, _LEAST = 2.0**380, 2.0**-380
_CLOSE = 1e-9  # hence R Rᵀ is within 3e-5
_NOWHERE = np.empty(0, dtype=np.intp)


@dataclass
class Locked:
    """Attitudes at gimbal lock.

    Parameters
    ----------
    every_place
        Whether to keep the index of each, for which memory grows with their number, or of the
        first one alone.
    count
        How many there are.
    places
        Their indices in C order.
    """

    every_place: bool = False
    count: int = 0
    places: Places = field(default_factory=lambda: _NOWHERE)

    def add(self, lock: Bools, rows: slice | Places) -> None:
        """Take note of those among some rows."""
        count = int(np.count_nonzero(lock))
        if count and (self.every_place or not self.count):
            found = np.r_[rows][np.flatnonzero(lock)[: None if self.every_place else 1]]
            self.places = np.concatenate([self.places, found])
        self.count += count


Told = tuple[Bools | None, Floats | None]
_NONE_LOCKED = Locked()
_FIRST = slice(0, 4 * BLOCK)  # as many numbers at most, of so few rows or fewer, at once
# What is run in a copy of it is run under np.errstate(all="ignore"), which takes ten times as long.
_SILENT = Context()
_SILENT.run(np.seterr, all="ignore")


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
    names
        Of the first arrays in errors, where they are not those of the general function.
    checked
        How many of the first arrays are parameters of float64 that were checked before.
    spreads
        Whether NaN in any other array makes all numbers of its row NaN by itself, so that none of
        them is looked at before.
    """

    compute: Callable[..., Floats]
    """Takes the arguments, in the order of the general function's, and an array or None."""

    def __init__(  # noqa: PLR0913 (what the function needs)
        self,
        general: Callable[..., Told],
        *,
        rotation: bool = False,
        scaled: Literal["refused", "nothing"] | None = None,
        degree: int = 0,
        names: tuple[str, ...] = (),
        checked: int = 0,
        spreads: bool = False,
    ) -> None:
        self.name, self._general = general.__name__, general
        arrays, self._result = SHAPES[self.name]
        self._lasts = tuple(arrays.values())
        self._names = (*names, *tuple(arrays)[len(names) :])
        self._layout = tuple(
            (name, last, slice(-len(last) or None), slice(-len(last) or 0, None if last else 0))
            for name, last in zip(self._names, self._lasts, strict=True)
        )
        self._rotation, self._scaled, self._degree = rotation, scaled, degree
        first, decisive = (0, 1) if rotation or scaled else (checked, checked)
        self._looked_at = slice(first, decisive if spreads else None)
        self.use(kernel(self.name))

    def use(self, compiled: Callable[..., Any] | None) -> None:
        """Compute by a kernel, or by NumPy alone."""
        self._kernel = compiled
        self.compute = completed(compiled, self._finished)

    def __call__(self, *given: ArrayLike, out: Floats | None = None) -> Floats:
        """Compute; the arguments come in the order of the general function's."""
        return self.compute(*given, out)

    def located(
        self, given: tuple[ArrayLike, ...], out: Floats | None, *, every_place: bool
    ) -> tuple[Floats, Locked]:
        """Compute, and tell where attitudes are at gimbal lock.

        Parameters
        ----------
        given
            The arguments.
        out
            For the result, if it is to go there.
        every_place
            Keep the index of each attitude at gimbal lock.

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
            return done, _NONE_LOCKED
        locked = Locked(every_place)
        return self._finished(done, (*given, out), locked), locked

    def _finished(
        self,
        done: Floats | tuple[Floats, bytes] | None,
        given: tuple[Any, ...],
        locked: Locked | None = None,
    ) -> Floats:
        """Check and compute what the kernel has left: some rows, or all."""
        arrays, leading = self._arrays(given)
        shape = leading + self._result
        out: Floats | None = given[-1]
        if out is not None:
            check_out(out, shape)
        if done is None and self._kernel is not None:
            done = self._kernel(*self._as_rows(arrays, leading), None)
        if isinstance(done, np.ndarray):
            result = done.reshape(shape)
        else:
            silently = _SILENT.copy().run
            result = np.empty(shape) if done is None else done[0].reshape(shape)
            few = done is None and result.size <= _FIRST.stop
            if not (few and silently(self._at_once, arrays, result, _FIRST, locked)):
                left, rows = done and done[1], self._as_rows(arrays, leading)
                silently(self._complete, result, left, rows, leading, locked)
        if out is None or out is result:
            return result
        np.copyto(out, result)
        return out

    def _arrays(self, given: tuple[Any, ...]) -> tuple[list[Floats], tuple[int, ...]]:
        """Take the arguments as arrays, and tell the leading axes of the result."""
        arrays: list[Floats] = []
        leading: tuple[int, ...] = ()
        alike = True
        for value, (name, last, before, behind) in zip(given, self._layout):  # noqa: B905 (slow)
            array = value
            if type(value) is not ndarray or value.dtype is not DOUBLE:
                array = floats(name, value, *last)
            shape = array.shape
            if shape != last:
                if shape[behind] != last:
                    floats(name, value, *last)  # raises
                own = shape[before]
                if own != leading:
                    alike = alike and not leading
                    leading = own
            arrays.append(array)
        if not alike:
            leading = common_shape(self._names, tuple(arrays), tuple(map(len, self._lasts)))
        return arrays, leading

    def _as_rows(self, arrays: list[Floats], leading: tuple[int, ...]) -> list[Floats]:
        return [_rows(a, leading, last) for a, last in zip(arrays, self._lasts, strict=True)]

    def _at_once(
        self,
        parts: Sequence[Floats],
        values: Floats,
        rows: slice | Places,
        locked: Locked | None,
    ) -> bool:
        """Compute rows of which none is odd.

        False if a row may have NaN, be zero, no rotation, or of a length whose square is beyond the
        largest or smallest number.
        """
        whole = 0.0
        for part in parts[self._looked_at]:
            whole += sum_of_squares(part.ravel())
        most, least = _MOST, _LEAST
        if self._rotation:
            # The determinant is at most the root of the cube of a third of the sum of squares, and
            # is so for rotations times a number alone. So if each is 1 or more, no sum is less than
            # 3, and if all sums add up to that, all are rotations, by more than is asked.
            count = parts[0].size // 9
            most, least = 3 * count + _CLOSE, 1 - _CLOSE / (count or 1)
        if not whole < most:  # nor is NaN
            return False
        lock, guard = self._general(*parts, values)
        if guard is not None and guard.size and not guard.item(guard.argmin()) > least:
            return False
        if lock is not None and locked is not None:
            locked.add(lock, rows)
        return True

    def _complete(
        self,
        result: Floats,
        left: bytes | None,
        rows: list[Floats],
        leading: tuple[int, ...],
        locked: Locked | None,
    ) -> None:
        """Compute what the kernel has left, block by block."""
        count = prod(leading)
        flat = result.reshape(count, *self._result)
        odd = None if left is None else np.frombuffer(left, dtype=np.bool_)
        for start in range(0, count, BLOCK):
            block: slice | Places = slice(start, min(start + BLOCK, count))
            if odd is not None:
                block = start + np.flatnonzero(odd[block])
                if not block.size:
                    continue
            parts = [array if len(array) == 1 else array[block] for array in rows]
            values = flat[block]  # a view, but where rows were picked
            try:
                if not self._at_once(parts, values, block, locked):
                    self._block(parts, values, block, locked)
            except WrongRow as wrong:
                several = len(rows[0]) > 1
                index = np.unravel_index(np.r_[block][wrong.row], leading) if several else ()
                msg = wrong.message.format(f"{self._names[0]}: ", tuple(map(int, index)))
                raise ValueError(msg) from None
            if odd is not None:
                flat[block] = values

    def _block(
        self, parts: list[Floats], values: Floats, rows: slice | Places, locked: Locked | None
    ) -> None:
        """Compute rows any of which may be odd."""
        missing = rows_with_nan(parts)
        if self._rotation:
            check_rotations(parts[0], missing)
        exponent = None
        if self._scaled is not None:
            parts[0], exponent, nothing = scaled(parts[0], refused=self._scaled == "refused")
            missing = missing | nothing
        lock, _ = self._general(*parts, values)
        if exponent is not None and self._degree:
            exponent = self._degree * exponent
            np.ldexp(values, exponent.reshape(-1, *[1] * len(self._result)), out=values)
        values[np.broadcast_to(missing, len(values))] = np.nan
        if lock is not None and locked is not None:
            locked.add(lock, rows)


def _rows(array: Floats, leading: tuple[int, ...], last: tuple[int, ...]) -> Floats:
    """Write an array as rows: as many as there are results, or one for all."""
    if array.size != prod(last) and array.shape != (*leading, *last):
        array = np.broadcast_to(array, (*leading, *last))
    return np.require(array, requirements=("C", "A")).reshape(-1, *last)
