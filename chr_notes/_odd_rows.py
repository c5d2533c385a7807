"""Rows that are out of the ordinary: with NaN, zero, very long or short, or no rotations."""

from functools import reduce

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Bools, Floats
from chr_notes.generated.arrays.euler import rotation_defect

ROTATION_TOLERANCE = 1e-4
"""How far `R Rᵀ` may be off the identity, as the root mean square over its elements.

Matrices that are printed with four digits still pass.
"""


class WrongRow(Exception):  # noqa: N818 (it becomes an error once its place is known)
    """A row that is refused: its number in the block, and what to say."""

    def __init__(self, row: int, message: str) -> None:
        super().__init__(message)
        self.row, self.message = row, message


def rows_with_nan(parts: list[Floats]) -> Bools:
    """Say which rows have NaN: what comes of them is NaN as a whole."""
    each = [np.isnan(part).reshape(len(part), -1).any(axis=1) for part in parts]
    return np.asarray(reduce(np.logical_or, each))


def scaled(rows: Floats, *, refused: bool) -> tuple[Floats, NDArray[np.intc], Bools]:
    """Bring each row's largest element to between 1/2 and 1, exactly.

    Returns
    -------
    rows
        The scaled rows.
    exponent
        Power of two by which each was divided.
    nothing
        Which rows have no direction, unless those are refused.
    """
    largest = reduce(np.maximum, np.abs(rows).T)
    zero, finite = largest == 0, np.isfinite(largest)
    if refused and zero.any():
        row = int(np.argmax(zero))
        raise WrongRow(row, "{}expected no row of zeros, got one at index {}")
    exponent = np.where(finite, np.frexp(largest)[1], 0)
    nothing = np.zeros_like(zero) if refused else zero | ~finite
    return np.ldexp(rows, -exponent[:, np.newaxis]), exponent, nothing


def check_rotations(matrix: Floats, missing: Bools) -> None:
    """Refuse matrices that are not rotations; those with NaN are passed over."""
    defects = np.empty((len(matrix), 2))
    rotation_defect(matrix, defects)
    off_by, determinant = defects.T
    right = (off_by <= ROTATION_TOLERANCE) & (determinant >= 0)
    wrong = np.flatnonzero(~(right | missing))
    if wrong.size:
        first = int(wrong[0])
        raise WrongRow(
            first,
            f"{{}}expected rotations (R Rᵀ = I within {ROTATION_TOLERANCE:g}, determinant 1), got "
            f"one at index {{}} with R Rᵀ off by {off_by[first]:.2g} and determinant "
            f"{determinant[first]:.4g}",
        )
