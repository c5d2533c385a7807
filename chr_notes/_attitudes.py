"""Checks that the routes to and from attitudes share: rotations, and the contract at the pole."""

import warnings
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, Locked, blocks, components, reals
from chr_notes.errors import GimbalLockError, GimbalLockWarning

OnGimbalLock = Literal["warn", "ignore", "raise"]
ROTATION_TOLERANCE = 1e-4
"""How far `R Rᵀ` may be off the identity, as the root mean square over its elements.

Matrices that are printed with four digits still pass.
"""


def rotations(name: str, value: ArrayLike) -> Floats:
    """Take an argument as rotation matrices.

    Parameters
    ----------
    name
        Of the argument, for the error.
    value
        Array-like of shape (..., 3, 3).

    Raises
    ------
    ValueError
        If the shape is another one, or a matrix is not a rotation; it names the first one.
    """
    matrix = reals(name, value, 3, 3)
    leading = matrix.shape[:-2]
    for start, parts, _, _ in blocks(components(matrix, 2), []):
        block = np.reshape(parts, (3, 3, -1))
        with np.errstate(all="ignore"):
            off = np.einsum("ikn,jkn->nij", block, block) - np.eye(3)
            off_by = np.sqrt(np.square(off, out=off).mean(axis=(1, 2)))
            volume = np.sum(np.cross(block[0], block[1], axis=0) * block[2], axis=0)
            # NaN compares as neither, so it passes and comes out in its own row.
            wrong = np.flatnonzero((off_by > ROTATION_TOLERANCE) | (volume < 0))
        if wrong.size:
            first = wrong[0]
            index = tuple(map(int, np.unravel_index(start + first, leading)))
            msg = (
                f"{name}: expected rotations (R Rᵀ = I within {ROTATION_TOLERANCE:g}, "
                f"determinant 1), got one at index {index} with R Rᵀ off by {off_by[first]:.2g} "
                f"and determinant {volume[first]:.4g}"
            )
            raise ValueError(msg)
    return matrix


def check_choice(on_gimbal_lock: str) -> None:
    """Refuse a way to deal with gimbal lock that does not exist.

    Raises
    ------
    ValueError
        If it is not one of the three.
    """
    if on_gimbal_lock not in get_args(OnGimbalLock):
        msg = f"on_gimbal_lock: expected one of {get_args(OnGimbalLock)}, got {on_gimbal_lock!r}"
        raise ValueError(msg)


def tell(locked: Locked, leading: tuple[int, ...], on_gimbal_lock: OnGimbalLock) -> None:
    """Warn of attitudes at gimbal lock, or raise, or keep silent.

    Parameters
    ----------
    locked
        The attitudes, all their places if the choice is "raise".
    leading
        Shape of the leading axes.
    on_gimbal_lock
        "warn", "ignore" or "raise".

    Raises
    ------
    GimbalLockError
        If there are any and the choice is "raise".
    """
    if not locked.count or on_gimbal_lock == "ignore":
        return
    # NumPy knows no places in a shape without axes.
    axes = np.array(np.unravel_index(locked.places, leading or (1,)))[: len(leading)]
    indices = tuple(map(tuple, axes.T.tolist()))
    if on_gimbal_lock == "raise":
        raise GimbalLockError(indices)
    message = (
        f"{locked.count} attitude(s) at gimbal lock, the first at index {indices[0]}: roll is set "
        f"to 0 and yaw carries the rest"
    )
    # The caller of the public function that calls this one.
    warnings.warn(message, GimbalLockWarning, stacklevel=3)
