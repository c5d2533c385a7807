"""Euler angles: matrices and rates as numeric functions.

Each takes array-likes, broadcasts over the leading axes, and returns new float64 arrays, or a
float64 where the result is one number. Angles are in radians, in the order (roll, pitch, yaw);
matrices are `R_I^B`, body from inertial.
"""

from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._attitudes import OnGimbalLock, with_lock
from chr_notes._rows import Rows
from chr_notes.generated.arrays import euler as generated

_matrix_from_euler = Rows(generated.matrix_from_euler)
_euler_from_matrix = Rows(generated.euler_from_matrix, rotation=True)
_wrap_angle = Rows(generated.wrap_angle)
_euler_rates_matrix = Rows(generated.euler_rates_matrix)
_euler_rates_from_body_rates = Rows(generated.euler_rates_from_body_rates)
_body_rates_from_euler_rates = Rows(generated.body_rates_from_euler_rates)


def matrix_from_euler(euler: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Turn Euler angles into the matrix from the inertial to the body frame.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, any real number, shape (..., 3).
    out
        An array for the result.

    Returns
    -------
    ndarray
        `R_I^B` with `v_B = R v_I`, shape (..., 3, 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 3.

    Notes
    -----
    Ledger: euler.5.2, euler.5.3.
    """
    return _matrix_from_euler.compute(euler, out)


def euler_from_matrix(
    matrix: ArrayLike, *, on_gimbal_lock: OnGimbalLock = "warn", out: Floats | None = None
) -> Floats:
    """Turn matrices from the inertial to the body frame into Euler angles.

    Parameters
    ----------
    matrix
        `R_I^B` with `v_B = R v_I`, shape (..., 3, 3).
    on_gimbal_lock
        What to do where pitch is ±90°, so that roll is set to 0 and yaw carries the rest: "warn",
        "ignore" or "raise".
    out
        An array for the result.

    Returns
    -------
    ndarray
        Roll in [-pi, pi], pitch in [-pi/2, pi/2], yaw in [-pi, pi], radians, shape (..., 3). They
        rebuild the matrix, at gimbal lock too.

    Raises
    ------
    ValueError
        If the last axes are not 3 by 3, or a matrix is not a rotation: `R Rᵀ` is off the identity
        by more than 1e-4 (root mean square of the elements), or the determinant is negative. The
        error names the first such matrix.
    GimbalLockError
        If an attitude is at gimbal lock and `on_gimbal_lock` is "raise".

    Warns
    -----
    GimbalLockWarning
        If an attitude is at gimbal lock and `on_gimbal_lock` is "warn".
    """
    return with_lock(_euler_from_matrix, matrix, on_gimbal_lock, out)


def wrap_angle(angle: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Take whole turns off an angle until it lies in [-pi, pi).

    An angle that lies there already is returned as it is.

    Parameters
    ----------
    angle
        Radians, any shape.
    out
        An array for the result.

    Returns
    -------
    ndarray
        The angle in [-pi, pi), same shape.
    """
    wrapped = _wrap_angle.compute(angle, out)
    return wrapped[()] if out is None else wrapped


def euler_rates_matrix(euler: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Matrix D that takes body rates to Euler rates.

    Towards a pitch of ±90° the second and third elements of its first and last row grow without
    bound, each but where roll makes it zero.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.
    out
        An array for the result.

    Returns
    -------
    ndarray
        D, shape (..., 3, 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 3.

    Notes
    -----
    Ledger: euler.7.2, euler.7.d.
    """
    return _euler_rates_matrix.compute(euler, out)


def euler_rates_from_body_rates(
    euler: ArrayLike, body_rates: ArrayLike, *, out: Floats | None = None
) -> Floats:
    """Turn what the gyros read into the derivatives of roll, pitch and yaw.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.
    body_rates
        Rates p, q, r about the body axes, rad/s, shape (..., 3).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Derivatives of roll, pitch and yaw, rad/s, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis is not of size 3 or the leading axes do not broadcast.

    Notes
    -----
    Ledger: euler.7.3.
    """
    return _euler_rates_from_body_rates.compute(euler, body_rates, out)


def body_rates_from_euler_rates(
    euler: ArrayLike, euler_rates: ArrayLike, *, out: Floats | None = None
) -> Floats:
    """Turn derivatives of roll, pitch and yaw into the rates that the gyros read.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.
    euler_rates
        Derivatives of roll, pitch and yaw, rad/s, shape (..., 3).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Rates p, q, r about the body axes, rad/s, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis is not of size 3 or the leading axes do not broadcast.

    Notes
    -----
    Ledger: euler.7.a.
    """
    return _body_rates_from_euler_rates.compute(euler, euler_rates, out)
