"""Distances between attitudes, for tests."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import chr_notes


def turns(euler: Any) -> Rotation:  # noqa: ANN401
    """Attitudes as rotations, from body to inertial."""
    return Rotation.from_matrix(np.swapaxes(chr_notes.matrix_from_euler(euler), -1, -2))


def apart(first: Any, second: Any) -> NDArray[np.float64]:  # noqa: ANN401
    """Angles between attitudes."""
    return np.asarray((turns(first).inv() * turns(second)).magnitude())


def inclinations_apart(first: Any, second: Any) -> NDArray[np.float64]:  # noqa: ANN401
    """Angles between the directions down of attitudes."""
    one, other = (chr_notes.matrix_from_euler(each)[..., 2] for each in (first, second))
    return np.arctan2(np.linalg.norm(np.cross(one, other), axis=-1), np.sum(one * other, axis=-1))


def of_quaternion(q: NDArray[np.float64]) -> Rotation:
    """Rotations by SciPy from quaternions with the scalar first, of any norm."""
    return Rotation.from_quat(q, scalar_first=True)
