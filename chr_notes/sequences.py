"""Attitudes as any three turns about axes: matrices, quaternions, rates, and the way back.

A sequence is written as SciPy writes it. "ZYX" stands for turns about z, then y, then x, each
about an axis of the frame as it has turned so far (rotating axes); "zyx" for turns about axes that
stay where they are (fixed axes). No axis comes twice in a row. Angles come in the order of the
letters, in radians. What is about fixed axes in one order is about rotating axes in the reversed
one: "xyz" with (roll, pitch, yaw) is "ZYX" with (yaw, pitch, roll).

Matrices take components to the turned frame, as everywhere in this package; SciPy's are their
transposes. Quaternions are those of `chr_notes.quaternions`.
"""

from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes._attitudes import OnGimbalLock, with_lock
from chr_notes._rows import Rows
from chr_notes.generated.arrays import sequences as generated

_matrix_from_angles = Rows(generated.matrix_from_angles)
_angles_from_matrix = Rows(generated.angles_from_matrix, rotation=True)
_quaternion_from_angles = Rows(generated.quaternion_from_angles)
_angles_from_quaternion = Rows(generated.angles_from_quaternion, scaled="refused")
_angle_rates_matrix = Rows(generated.angle_rates_matrix)

_ROTATING = tuple(
    "".join(axes) for axes in product("XYZ", repeat=3) if axes[0] != axes[1] != axes[2]
)
SEQUENCES = (*_ROTATING, *(name.lower() for name in _ROTATING))
"""The twelve sequences about rotating axes, and the twelve about fixed ones."""
# The axes of each in the order of turns about rotating axes, 1, 2, 3 for x, y, z.
_AXES = {
    name: np.array([1.0 + "XYZ".index(x) for x in name.upper()][:: 1 if name.isupper() else -1])
    for name in SEQUENCES
}


def matrix_from_angles(angles: ArrayLike, sequence: str, *, out: Floats | None = None) -> Floats:
    """Turn the angles of any sequence of turns into the matrix to the turned frame.

    Parameters
    ----------
    angles
        Of the three turns, in the order of the letters, radians, any real number, shape (..., 3).
    sequence
        Axes of the turns, such as "ZYX" (rotating) or "zyx" (fixed).
    out
        An array for the result.

    Returns
    -------
    ndarray
        R with `v_turned = R v`, shape (..., 3, 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 3, or the sequence is none.

    See Also
    --------
    chr_notes.euler.matrix_from_euler : Yaw, pitch and roll, as (roll, pitch, yaw).

    Examples
    --------
    >>> import numpy as np
    >>> import chr_notes
    >>> yaw, pitch, roll = 0.3, 0.2, 0.1
    >>> matrix = chr_notes.matrix_from_angles((yaw, pitch, roll), "ZYX")
    >>> bool(np.allclose(matrix, chr_notes.matrix_from_euler((roll, pitch, yaw))))
    True
    """
    axes = _axes(sequence)
    return _matrix_from_angles.compute(_turns(angles, sequence), axes, out)


def angles_from_matrix(
    matrix: ArrayLike,
    sequence: str,
    *,
    on_gimbal_lock: OnGimbalLock = "warn",
    out: Floats | None = None,
) -> Floats:
    """Find the angles of a sequence of turns that lead to the turned frame.

    Parameters
    ----------
    matrix
        R with `v_turned = R v`, shape (..., 3, 3).
    sequence
        Axes of the turns, such as "ZYX" (rotating) or "zyx" (fixed).
    on_gimbal_lock
        What to do where the second turn brings the first axis onto the line of the third, so that
        the last turn about rotating axes (the first one about fixed axes) is set to 0 and the other
        carries the rest: "warn", "ignore" or "raise".
    out
        An array for the result.

    Returns
    -------
    ndarray
        Angles in the order of the letters, radians, shape (..., 3): the first and the third in
        [-pi, pi], the second in [-pi/2, pi/2], or in [0, pi] if the last axis is the first again.
        They rebuild the matrix, at gimbal lock too.

    Raises
    ------
    ValueError
        If the last axes are not 3 by 3, a matrix is not a rotation (see
        `chr_notes.euler.euler_from_matrix`), or the sequence is none.
    GimbalLockError
        If an attitude is at gimbal lock and `on_gimbal_lock` is "raise".

    Warns
    -----
    GimbalLockWarning
        If an attitude is at gimbal lock and `on_gimbal_lock` is "warn".

    See Also
    --------
    chr_notes.euler.euler_from_matrix : Roll, pitch and yaw.

    Examples
    --------
    >>> import numpy as np
    >>> import chr_notes
    >>> matrix = chr_notes.matrix_from_euler((0.1, 0.2, 0.3))
    >>> print(chr_notes.angles_from_matrix(matrix, "ZXZ").round(4))
    [ 1.4031  0.2233 -1.1132]
    >>> print(chr_notes.angles_from_matrix(matrix, "xyz").round(4))
    [0.1 0.2 0.3]
    """
    # Direct, so that a warning tells of the caller's line.
    angles = with_lock(_angles_from_matrix, matrix, on_gimbal_lock, out, _axes(sequence))
    return _in_order(angles, sequence)


def quaternion_from_angles(
    angles: ArrayLike, sequence: str, *, out: Floats | None = None
) -> Floats:
    """Turn the angles of any sequence of turns into quaternions.

    Parameters
    ----------
    angles
        Of the three turns, in the order of the letters, radians, any real number, shape (..., 3).
    sequence
        Axes of the turns, such as "ZYX" (rotating) or "zyx" (fixed).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Unit quaternions with a >= 0 and `v = q v_turned q*`, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 3, or the sequence is none.

    See Also
    --------
    chr_notes.quaternions.conversions.quaternion_from_euler : Of roll, pitch and yaw.

    Examples
    --------
    >>> import chr_notes
    >>> print(chr_notes.quaternion_from_angles((0.3, 0.2, 0.1), "ZYX").round(4))
    [0.9833 0.0343 0.106  0.1436]
    """
    axes = _axes(sequence)
    return _quaternion_from_angles.compute(_turns(angles, sequence), axes, out)


def angles_from_quaternion(
    q: ArrayLike,
    sequence: str,
    *,
    on_gimbal_lock: OnGimbalLock = "warn",
    out: Floats | None = None,
) -> Floats:
    """Find the angles of a sequence of turns that a quaternion stands for.

    Parameters
    ----------
    q
        Quaternions with `v = q v_turned q*`, of any norm but zero, shape (..., 4).
    sequence
        Axes of the turns, such as "ZYX" (rotating) or "zyx" (fixed).
    on_gimbal_lock
        As in `chr_notes.sequences.angles_from_matrix`.
    out
        An array for the result.

    Returns
    -------
    ndarray
        Angles as `chr_notes.sequences.angles_from_matrix` gives them, shape (..., 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 4, a quaternion is zero, or the sequence is none.
    GimbalLockError
        If an attitude is at gimbal lock and `on_gimbal_lock` is "raise".

    Warns
    -----
    GimbalLockWarning
        If an attitude is at gimbal lock and `on_gimbal_lock` is "warn".

    See Also
    --------
    chr_notes.quaternions.conversions.euler_from_quaternion : Roll, pitch and yaw.

    Examples
    --------
    A quarter turn about x, as turns about z, x and z:

    >>> import chr_notes
    >>> print(chr_notes.angles_from_quaternion((1.0, 1.0, 0.0, 0.0), "ZXZ").round(4))
    [0.     1.5708 0.    ]
    """
    angles = with_lock(_angles_from_quaternion, q, on_gimbal_lock, out, _axes(sequence))
    return _in_order(angles, sequence)


def angle_rates_matrix(angles: ArrayLike, sequence: str, *, out: Floats | None = None) -> Floats:
    """Matrix D that takes rates about the turned frame's axes to the rates of the angles.

    Towards gimbal lock elements of the rows of the first and of the third angle grow without
    bound; exactly at it these rows are NaN.

    Parameters
    ----------
    angles
        Of the three turns, in the order of the letters, radians, shape (..., 3).
    sequence
        Axes of the turns, such as "ZYX" (rotating) or "zyx" (fixed).
    out
        An array for the result.

    Returns
    -------
    ndarray
        D, its rows in the order of the letters, shape (..., 3, 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 3, or the sequence is none.

    See Also
    --------
    chr_notes.euler.euler_rates_matrix : For yaw, pitch and roll, in the order roll, pitch, yaw.

    Examples
    --------
    Level, a gyro's x-axis turns roll, y pitch and z yaw:

    >>> import chr_notes
    >>> print(chr_notes.angle_rates_matrix((0.0, 0.0, 0.0), "xyz") + 0.0)
    [[1. 0. 0.]
     [0. 1. 0.]
     [0. 0. 1.]]
    """
    axes = _axes(sequence)
    rates = _angle_rates_matrix.compute(_turns(angles, sequence), axes, out)
    if sequence.islower():
        rates[...] = rates[..., ::-1, :]
    return rates


def _axes(sequence: str) -> Floats:
    if sequence not in _AXES:
        msg = (
            "sequence: expected three of X, Y, Z (rotating axes) or of x, y, z (fixed axes), none "
            f"twice in a row, got {sequence!r}"
        )
        raise ValueError(msg)
    return _AXES[sequence]


def _turns(angles: ArrayLike, sequence: str) -> ArrayLike:
    """Angles in the order of turns about rotating axes."""
    if sequence.isupper():
        return angles
    return np.ascontiguousarray(floats("angles", angles, 3)[..., ::-1])


def _in_order(angles: Floats, sequence: str) -> Floats:
    """Put angles of turns about rotating axes in the order of the letters, in their place."""
    if sequence.islower():
        angles[...] = angles[..., ::-1]
    return angles
