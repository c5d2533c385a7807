"""Euler angles: matrices and rates as numeric functions.

Each takes array-likes, broadcasts over the leading axes, and returns new float64 arrays. Angles
are in radians, in the order (roll, pitch, yaw); matrices are `R_I^B`, body from inertial.
"""

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, common_shape, floats
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
    angles = floats("euler", euler, 3)
    out = np.empty((*angles.shape, 3))
    generated.matrix_from_euler(angles[..., 0], angles[..., 1], angles[..., 2], out)
    return out


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
    angles = floats("euler", euler, 3)
    out = np.empty((*angles.shape, 3))
    generated.euler_rates_matrix(angles[..., 0], angles[..., 1], out)
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
    angles, rates = floats("euler", euler, 3), floats("body_rates", body_rates, 3)
    out = np.empty((*common_shape(("euler", angles), ("body_rates", rates)), 3))
    first, second, third = np.moveaxis(rates, -1, 0)
    roll, pitch = angles[..., 0], angles[..., 1]
    generated.euler_rates_from_body_rates(roll, pitch, first, second, third, out)
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
    angles, rates = floats("euler", euler, 3), floats("euler_rates", euler_rates, 3)
    out = np.empty((*common_shape(("euler", angles), ("euler_rates", rates)), 3))
    first, second, third = np.moveaxis(rates, -1, 0)
    roll, pitch = angles[..., 0], angles[..., 1]
    generated.body_rates_from_euler_rates(roll, pitch, first, second, third, out)
    return out
