"""Angles and matrices against the same formulas in many digits, by the kernels and by NumPy."""

from collections.abc import Callable, Iterator

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from chr_notes import (
    euler_from_quaternion,
    matrix_from_euler,
    matrix_from_quaternion,
    wrap_angle,
)

Floats = NDArray[np.float64]
MP = mpmath.mp.clone()
MP.prec = 150
ANGLES, ELEMENTS = 1e-15, 4e-16
FROM_THE_POLE = (1e-3, 1e-6, 1e-9)

pytestmark = pytest.mark.usefixtures("each_way")


@pytest.fixture(scope="module")
def count(samples: Callable[[int, int], int]) -> int:
    return samples(300, 100_000)


def unit(q: Floats) -> Floats:
    return np.asarray(q / np.linalg.norm(q, axis=1, keepdims=True))


def near_the_pole(distance: float, count: int) -> Floats:
    """Unit quaternions so far from a pitch of ±90°."""
    generator = np.random.default_rng(1)
    roll, yaw = generator.uniform(-np.pi, np.pi, (2, count)) / 2
    pitch = generator.choice([-0.5, 0.5], count) * (np.pi / 2 - distance)
    parts = [
        np.cos(roll) * np.cos(pitch) * np.cos(yaw) + np.sin(roll) * np.sin(pitch) * np.sin(yaw),
        np.sin(roll) * np.cos(pitch) * np.cos(yaw) - np.cos(roll) * np.sin(pitch) * np.sin(yaw),
        np.cos(roll) * np.sin(pitch) * np.cos(yaw) + np.sin(roll) * np.cos(pitch) * np.sin(yaw),
        np.cos(roll) * np.cos(pitch) * np.sin(yaw) - np.sin(roll) * np.sin(pitch) * np.cos(yaw),
    ]
    return np.stack(parts, axis=1)


def exact_matrices(quaternions: Floats) -> Iterator[list[mpmath.mpf]]:
    """R_I^B row by row, of the very numbers, whose length is 1 but for rounding."""
    for row in quaternions.tolist():
        a, b, c, d = map(MP.mpf, row)
        n = a * a + b * b + c * c + d * d
        yield [
            element / n
            for element in (
                *(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)),
                *(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)),
                *(2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d),
            )
        ]


def exact_angles(quaternions: Floats) -> Iterator[list[mpmath.mpf]]:
    for matrix in exact_matrices(quaternions):
        roll, yaw = MP.atan2(matrix[5], matrix[8]), MP.atan2(matrix[1], matrix[0])
        yield [roll, -MP.asin(matrix[2]), yaw]


def exact_matrices_of_angles(euler: Floats) -> Iterator[list[mpmath.mpf]]:
    """The turns about x, y and z in a row, as definitions have them."""
    for row in euler.tolist():
        (sr, cr), (sp, cp), (sy, cy) = ((MP.sin(MP.mpf(x)), MP.cos(MP.mpf(x))) for x in row)
        roll = MP.matrix([[1, 0, 0], [0, cr, sr], [0, -sr, cr]])
        pitch = MP.matrix([[cp, 0, -sp], [0, 1, 0], [sp, 0, cp]])
        yaw = MP.matrix([[cy, sy, 0], [-sy, cy, 0], [0, 0, 1]])
        yield list(roll * pitch * yaw)


def worst(found: Floats, exact: Iterator[list[mpmath.mpf]], *, turns: bool = False) -> float:
    """The largest difference; that of angles by less than a whole turn."""
    most = 0.0
    for row, right in zip(found.reshape(len(found), -1).tolist(), exact, strict=True):
        for number, wanted in zip(row, right, strict=True):
            off = abs(MP.mpf(number) - wanted)
            most = max(most, float(min(off, abs(off - 2 * MP.pi)) if turns else off))
    return most


def test_angles_of_random_attitudes(count: int) -> None:
    q = unit(np.random.default_rng(0).normal(size=(count, 4)))
    assert worst(euler_from_quaternion(q), exact_angles(q), turns=True) < ANGLES


@pytest.mark.parametrize("distance", FROM_THE_POLE)
def test_angles_near_the_pole(count: int, distance: float) -> None:
    q = near_the_pole(distance, count)
    assert worst(euler_from_quaternion(q), exact_angles(q), turns=True) < ANGLES


def test_matrices_of_random_attitudes(count: int) -> None:
    q = unit(np.random.default_rng(2).normal(size=(count, 4)))
    assert worst(matrix_from_quaternion(q), exact_matrices(q)) < ELEMENTS


def test_matrices_of_random_angles(count: int) -> None:
    euler = np.random.default_rng(3).uniform(-np.pi, np.pi, (count, 3))
    assert worst(matrix_from_euler(euler), exact_matrices_of_angles(euler)) < ELEMENTS


def test_whole_turns_taken_off_angles(count: int) -> None:
    generator = np.random.default_rng(5)
    halves = np.pi * generator.integers(-300_000, 300_000, count)
    angles = np.concatenate(
        [
            *(generator.uniform(-most, most, count) for most in (10, 1e6, 1e12)),
            *(halves, np.nextafter(halves, np.inf), np.nextafter(halves, -np.inf)),
        ]
    )
    wrapped = wrap_angle(angles)
    assert ((-np.pi <= wrapped) & (wrapped < np.pi)).all()
    turn = 2 * MP.pi
    exact = ([MP.mpf(x) - turn * MP.nint(MP.mpf(x) / turn)] for x in angles.tolist())
    assert worst(wrapped[:, np.newaxis], exact, turns=True) < ANGLES
