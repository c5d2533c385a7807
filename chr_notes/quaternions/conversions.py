"""Quaternions from matrices, Euler angles, axis and angle, and back.

Each function takes array-likes, broadcasts over the leading axes, and returns new float64 arrays,
or a float64 where the result is one number. What comes out is a unit quaternion with a >= 0.
"""

from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, handed_out
from chr_notes._attitudes import OnGimbalLock, with_lock
from chr_notes._rows import Rows
from chr_notes.generated.arrays import quaternions as generated

_matrix_from_quaternion = Rows(generated.matrix_from_quaternion, scaled="refused")
_quaternion_from_matrix = Rows(generated.quaternion_from_matrix, rotation=True)
_quaternion_from_euler = Rows(generated.quaternion_from_euler, spreads=True)
_euler_from_quaternion = Rows(generated.euler_from_quaternion, scaled="refused")
_quaternion_from_axis_angle = Rows(generated.quaternion_from_axis_angle, scaled="refused")
_axis_angle_from_quaternion = Rows(generated.axis_angle_from_quaternion, scaled="refused")


def matrix_from_quaternion(q: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Turn quaternions into matrices from the inertial to the body frame.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    out
        An array for the result.

    Returns
    -------
    ndarray
        `R_I^B` with `v_B = R v_I`, shape (..., 3, 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a quaternion is zero; it names the first one.

    See Also
    --------
    quaternion_from_matrix

    Notes
    -----
    Ledger: quaternions.3.3.

    Examples
    --------
    >>> matrix_from_quaternion([1, 0, 0, 1]).round(6)  # heading east
    array([[ 0.,  1.,  0.],
           [-1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    return _matrix_from_quaternion.compute(q, out)


def quaternion_from_matrix(matrix: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Turn matrices from the inertial to the body frame into quaternions.

    Parameters
    ----------
    matrix
        `R_I^B` with `v_B = R v_I`, shape (..., 3, 3).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Unit quaternions with a >= 0, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axes are not 3 by 3, or a matrix is not a rotation: `R Rᵀ` is off the identity
        by more than 1e-4 (root mean square of the elements), or the determinant is negative. The
        error names the first such matrix.

    See Also
    --------
    matrix_from_quaternion

    Notes
    -----
    Ledger: quaternions.3.3, whose matrix is solved for the elements.

    Examples
    --------
    >>> quaternion_from_matrix([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]).round(6)  # heading east
    array([0.707107, 0.      , 0.      , 0.707107])
    """
    return _quaternion_from_matrix.compute(matrix, out)


def quaternion_from_euler(euler: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Turn Euler angles into quaternions.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, any real number, shape (..., 3).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Unit quaternions with a >= 0, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 3.

    See Also
    --------
    euler_from_quaternion
    chr_notes.euler.matrix_from_euler

    Notes
    -----
    Ledger: quaternions.2.2, for each of the three turns.

    Examples
    --------
    >>> import numpy as np
    >>> quaternion_from_euler(np.radians([0, 0, 90])).round(6)  # half the angle
    array([0.707107, 0.      , 0.      , 0.707107])
    """
    return _quaternion_from_euler.compute(euler, out)


def euler_from_quaternion(
    q: ArrayLike, *, on_gimbal_lock: OnGimbalLock = "warn", out: Floats | None = None
) -> Floats:
    """Turn quaternions into Euler angles, to full precision up to the pole.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    on_gimbal_lock
        What to do where pitch is ±90°, so that roll is set to 0 and yaw carries the rest: "warn",
        "ignore" or "raise".
    out
        An array for the result.

    Returns
    -------
    ndarray
        Roll in [-pi, pi], pitch in [-pi/2, pi/2], yaw in [-pi, pi], radians, shape (..., 3). They
        rebuild the attitude, at gimbal lock too.

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a quaternion is zero; it names the first one.
    GimbalLockError
        If an attitude is at gimbal lock and `on_gimbal_lock` is "raise".

    Warns
    -----
    GimbalLockWarning
        If an attitude is at gimbal lock and `on_gimbal_lock` is "warn".

    See Also
    --------
    quaternion_from_euler

    Notes
    -----
    Ledger: quaternions.4.1, quaternions.4.2, quaternions.4.3.

    Examples
    --------
    >>> import numpy as np
    >>> np.degrees(euler_from_quaternion([1, 0, 0, 1])).round(6)  # of any length
    array([ 0.,  0., 90.])
    """
    return with_lock(_euler_from_quaternion, q, on_gimbal_lock, out)


def quaternion_from_axis_angle(
    axis: ArrayLike, angle: ArrayLike, *, out: Floats | None = None
) -> Floats:
    """Quaternion of a turn about an axis.

    Parameters
    ----------
    axis
        Direction of the axis, of any length but zero, shape (..., 3).
    angle
        Angle of the turn by the right-hand rule, radians, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Unit quaternions with a >= 0, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis of `axis` is not of size 3, the shapes do not broadcast, or an axis is
        zero; it names the first one.

    See Also
    --------
    axis_angle_from_quaternion

    Notes
    -----
    Ledger: quaternions.2.2.

    Examples
    --------
    >>> import numpy as np
    >>> quaternion_from_axis_angle([0, 0, 2], np.radians(60)).round(6)  # an axis of any length
    array([0.866025, 0.      , 0.      , 0.5     ])
    """
    return _quaternion_from_axis_angle.compute(axis, angle, out)


def axis_angle_from_quaternion(
    q: ArrayLike, *, out: tuple[Floats, Floats] | None = None
) -> tuple[Floats, Floats]:
    """Axis and angle of the turn that a quaternion stands for.

    Parameters
    ----------
    q
        Quaternions of any norm but zero, shape (..., 4).
    out
        Arrays for axis and angle.

    Returns
    -------
    axis
        Unit vectors, shape (..., 3); (1, 0, 0) where there is no turn.
    angle
        Angle in [0, pi], radians, shape (...).

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a quaternion is zero; it names the first one.

    See Also
    --------
    quaternion_from_axis_angle

    Notes
    -----
    Ledger: quaternions.2.2.

    Examples
    --------
    >>> import numpy as np
    >>> axis, angle = axis_angle_from_quaternion([np.sqrt(3), 0, 0, 1])
    >>> axis
    array([0., 0., 1.])
    >>> float(np.degrees(angle).round(6))
    60.0
    """
    both = _axis_angle_from_quaternion(q)
    axis, angle = handed_out((both[..., :3], both[..., 3]), out)
    return axis, angle
