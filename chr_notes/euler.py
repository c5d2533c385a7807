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
_wrap_angle = Rows(generated.wrap_angle, spreads=True)
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

    See Also
    --------
    euler_from_matrix
    chr_notes.quaternions.conversions.quaternion_from_euler

    Notes
    -----
    Ledger: euler.5.2, euler.5.3.

    Examples
    --------
    >>> import numpy as np
    >>> matrix = matrix_from_euler([0, 0, np.pi / 2])  # heading east
    >>> (matrix @ [0, 1, 0]).round(3)  # what lies east, lies ahead
    array([1., 0., 0.])
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

    See Also
    --------
    matrix_from_euler

    Examples
    --------
    >>> import numpy as np
    >>> from chr_notes import matrix_from_euler
    >>> matrix = matrix_from_euler(np.radians([20, 30, 40]))
    >>> np.degrees(euler_from_matrix(matrix)).round(6)
    array([20., 30., 40.])
    >>> locked = matrix_from_euler(np.radians([20, 90, 40]))
    >>> np.degrees(euler_from_matrix(locked, on_gimbal_lock="ignore")).round(6)
    array([ 0., 90., 20.])
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

    See Also
    --------
    chr_notes.differences.angle_between_attitudes

    Examples
    --------
    >>> import numpy as np
    >>> np.degrees(wrap_angle(np.radians([190.0, -190.0, 370.0]))).round(6)
    array([-170.,  170.,   10.])
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

    See Also
    --------
    euler_rates_from_body_rates

    Notes
    -----
    Ledger: euler.7.2, euler.7.d.

    Examples
    --------
    >>> import numpy as np
    >>> euler_rates_matrix(np.radians([30, 60, 0])).round(3)
    array([[ 1.   ,  0.866,  1.5  ],
           [ 0.   ,  0.866, -0.5  ],
           [ 0.   ,  1.   ,  1.732]])
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

    See Also
    --------
    body_rates_from_euler_rates
    euler_rates_matrix

    Notes
    -----
    Ledger: euler.7.3.

    Examples
    --------
    >>> import numpy as np
    >>> level, steep = np.radians([[0, 0, 0], [0, 60, 0]])
    >>> euler_rates_from_body_rates(level, [0.1, 0.2, 0.3]).round(3)
    array([0.1, 0.2, 0.3])
    >>> euler_rates_from_body_rates(steep, [0.1, 0.2, 0.3]).round(3)
    array([0.62, 0.2 , 0.6 ])
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

    See Also
    --------
    euler_rates_from_body_rates

    Notes
    -----
    Ledger: euler.7.a.

    Examples
    --------
    >>> import numpy as np
    >>> attitude = np.radians([90, 0, 0])  # on the right wing
    >>> body_rates_from_euler_rates(attitude, [0, 0, 1.0]).round(3)  # yaw is felt by q
    array([0., 1., 0.])
    """
    return _body_rates_from_euler_rates.compute(euler, euler_rates, out)
