"""Euler angles: matrices and rates as numeric functions.

Each takes array-likes, broadcasts over the leading axes, and returns new float64 arrays. Angles
are in radians, in the order (roll, pitch, yaw); matrices are `R_I^B`, body from inertial.
"""

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import (
    Floats,
    common_shape,
    components,
    evaluate,
    in_pairs,
    pairs,
    reals,
)
from chr_notes._attitudes import OnGimbalLock, check_choice, rotations, tell
from chr_notes.generated.arrays import euler as generated


def matrix_from_euler(euler: ArrayLike) -> Floats:
    """Turn Euler angles into the matrix from the inertial to the body frame.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, any real number, shape (..., 3).

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
    angles = reals("euler", euler, 3)
    out = np.empty((*angles.shape, 3))
    evaluate(generated.matrix_from_euler, components(angles), components(out, 2))
    return out


def euler_from_matrix(matrix: ArrayLike, *, on_gimbal_lock: OnGimbalLock = "warn") -> Floats:
    """Turn matrices from the inertial to the body frame into Euler angles.

    Parameters
    ----------
    matrix
        `R_I^B` with `v_B = R v_I`, shape (..., 3, 3).
    on_gimbal_lock
        What to do where pitch is ±90°, so that roll is set to 0 and yaw carries the rest: "warn",
        "ignore" or "raise".

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
    check_choice(on_gimbal_lock)
    rotation = rotations("matrix", matrix)
    out = np.empty(rotation.shape[:-1])
    locked = evaluate(
        generated.euler_from_matrix,
        components(rotation, 2),
        components(out),
        every_place=on_gimbal_lock == "raise",
    )
    tell(locked, out.shape[:-1], on_gimbal_lock)
    return out


def wrap_angle(angle: ArrayLike) -> Floats:
    """Take whole turns off an angle until it lies in [-pi, pi).

    An angle that lies there already is returned as it is.

    Parameters
    ----------
    angle
        Radians, any shape.

    Returns
    -------
    ndarray
        The angle in [-pi, pi), same shape.
    """
    angles = reals("angle", angle)
    out = np.empty(angles.shape)
    evaluate(generated.wrap_angle, [angles], [out])
    return out[()]


def euler_rates_matrix(euler: ArrayLike) -> Floats:
    """Matrix D that takes body rates to Euler rates.

    Towards a pitch of ±90° its elements grow without bound.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.

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
    angles = reals("euler", euler, 3)
    out = np.empty((*angles.shape, 3))
    evaluate(generated.euler_rates_matrix, components(angles)[:2], components(out, 2))
    return out


def euler_rates_from_body_rates(euler: ArrayLike, body_rates: ArrayLike) -> Floats:
    """Turn what the gyros read into the derivatives of roll, pitch and yaw.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.
    body_rates
        Rates p, q, r about the body axes, rad/s, shape (..., 3).

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
    angles, rates = reals("euler", euler, 3), reals("body_rates", body_rates, 3)
    shape = common_shape(("euler", angles, 1), ("body_rates", rates, 1))
    out = np.empty((*shape, 3))
    given = components(angles)[:2]
    if in_pairs(rates):
        given += [*components(rates[..., :1]), *pairs(rates[..., 1:])]
        evaluate(generated.euler_rates_from_body_rates_pairs, given, components(out))
    else:
        given += components(rates)
        evaluate(generated.euler_rates_from_body_rates, given, components(out))
    return out


def body_rates_from_euler_rates(euler: ArrayLike, euler_rates: ArrayLike) -> Floats:
    """Turn derivatives of roll, pitch and yaw into the rates that the gyros read.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.
    euler_rates
        Derivatives of roll, pitch and yaw, rad/s, shape (..., 3).

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
    angles, rates = reals("euler", euler, 3), reals("euler_rates", euler_rates, 3)
    shape = common_shape(("euler", angles, 1), ("euler_rates", rates, 1))
    out = np.empty((*shape, 3))
    given = [*components(angles)[:2], *components(rates)]
    evaluate(generated.body_rates_from_euler_rates, given, components(out))
    return out
