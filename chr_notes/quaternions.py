"""Quaternions as numeric functions: conversions, algebra, rotation of vectors.

Each takes array-likes, broadcasts over the leading axes, and returns new float64 arrays.
Quaternions are Hamilton's, scalar first, and an attitude satisfies `v_I = q v_B q*`. A quaternion
that stands for an attitude may have any norm but zero; results that do are unit quaternions with
a >= 0. Products, conjugates and inverses are those of the algebra, sign and norm included.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import (
    Floats,
    Numbers,
    Reports,
    common_shape,
    components,
    evaluate,
    in_pairs,
    pairs,
    reals,
)
from chr_notes._attitudes import OnGimbalLock, check_choice, rotations, tell
from chr_notes.generated.arrays import quaternions as generated


def matrix_from_quaternion(q: ArrayLike) -> Floats:
    """Turn quaternions into matrices from the inertial to the body frame.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).

    Returns
    -------
    ndarray
        `R_I^B` with `v_B = R v_I`, shape (..., 3, 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a quaternion is zero; it names the first one.

    Notes
    -----
    Ledger: quaternions.3.3.
    """
    quaternion = reals("q", q, 4)
    out = np.empty((*quaternion.shape[:-1], 3, 3))
    given = components(quaternion)
    evaluate(generated.matrix_from_quaternion, given, components(out, 2), ("q", quaternion))
    return out


def quaternion_from_matrix(matrix: ArrayLike) -> Floats:
    """Turn matrices from the inertial to the body frame into quaternions.

    Parameters
    ----------
    matrix
        `R_I^B` with `v_B = R v_I`, shape (..., 3, 3).

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

    Notes
    -----
    Ledger: quaternions.3.3, whose matrix is solved for the elements.
    """
    rotation = rotations("matrix", matrix)
    out = np.empty((*rotation.shape[:-2], 4))
    evaluate(generated.quaternion_from_matrix, components(rotation, 2), components(out))
    return out


def quaternion_from_euler(euler: ArrayLike) -> Floats:
    """Turn Euler angles into quaternions.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, any real number, shape (..., 3).

    Returns
    -------
    ndarray
        Unit quaternions with a >= 0, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 3.

    Notes
    -----
    Ledger: quaternions.2.2, for each of the three turns.
    """
    angles = reals("euler", euler, 3)
    out = np.empty((*angles.shape[:-1], 4))
    evaluate(generated.quaternion_from_euler, components(angles), components(out))
    return out


def euler_from_quaternion(q: ArrayLike, *, on_gimbal_lock: OnGimbalLock = "warn") -> Floats:
    """Turn quaternions into Euler angles, to full precision up to the pole.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    on_gimbal_lock
        What to do where pitch is ±90°, so that roll is set to 0 and yaw carries the rest: "warn",
        "ignore" or "raise".

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

    Notes
    -----
    Ledger: quaternions.4.1, quaternions.4.2, quaternions.4.3, quaternions.4.b.
    """
    check_choice(on_gimbal_lock)
    quaternion = reals("q", q, 4)
    out = np.empty((*quaternion.shape[:-1], 3))
    given = components(quaternion)
    locked = evaluate(
        generated.euler_from_quaternion,
        given,
        components(out),
        ("q", quaternion),
        every_place=on_gimbal_lock == "raise",
    )
    tell(locked, out.shape[:-1], on_gimbal_lock)
    return out


def quaternion_from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Floats:
    """Quaternion of a turn about an axis.

    Parameters
    ----------
    axis
        Direction of the axis, of any length but zero, shape (..., 3).
    angle
        Angle of the turn by the right-hand rule, radians, shape (...).

    Returns
    -------
    ndarray
        Unit quaternions with a >= 0, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis of `axis` is not of size 3, the shapes do not broadcast, or an axis is
        zero; it names the first one.

    Notes
    -----
    Ledger: quaternions.2.2.
    """
    axes, angles = reals("axis", axis, 3), reals("angle", angle)
    shape = common_shape(("axis", axes, 1), ("angle", angles, 0))
    out = np.empty((*shape, 4))
    given = [*components(axes), angles]
    evaluate(generated.quaternion_from_axis_angle, given, components(out), ("axis", axes))
    return out


def axis_angle_from_quaternion(q: ArrayLike) -> tuple[Floats, Floats]:
    """Axis and angle of the turn that a quaternion stands for.

    Parameters
    ----------
    q
        Quaternions of any norm but zero, shape (..., 4).

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

    Notes
    -----
    Ledger: quaternions.2.2.
    """
    quaternion = reals("q", q, 4)
    axis = np.empty((*quaternion.shape[:-1], 3))
    angle = np.empty(quaternion.shape[:-1])
    given, out = components(quaternion), [*components(axis), angle]
    evaluate(generated.axis_angle_from_quaternion, given, out, ("q", quaternion))
    return axis, angle[()]


def quaternion_multiply(p: ArrayLike, q: ArrayLike) -> Floats:
    """Hamilton's product `p q`: the turn p after the turn q, both about fixed axes.

    Parameters
    ----------
    p, q
        Quaternions, shape (..., 4).

    Returns
    -------
    ndarray
        The product as it is, with its own sign and norm, shape (..., 4).

    Raises
    ------
    ValueError
        If a last axis is not of size 4 or the leading axes do not broadcast.

    Notes
    -----
    Ledger: quaternions.3.2.
    """
    first, second = reals("p", p, 4), reals("q", q, 4)
    out = np.empty((*common_shape(("p", first, 1), ("q", second, 1)), 4))
    if in_pairs(first, second):
        given = [*pairs(first), *pairs(second)]
        evaluate(generated.quaternion_multiply_pairs, given, pairs(out))
    else:
        given = [*components(first), *components(second)]
        evaluate(generated.quaternion_multiply, given, components(out))
    return out


def quaternion_conjugate(q: ArrayLike) -> Floats:
    """Negate the vector part: for a unit quaternion, the turn back.

    Parameters
    ----------
    q
        Quaternions, shape (..., 4).

    Returns
    -------
    ndarray
        `q*`, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 4.

    Notes
    -----
    Ledger: quaternions.3.a, quaternions.3.c.
    """
    quaternion = reals("q", q, 4)
    out = np.empty(quaternion.shape)
    evaluate(generated.quaternion_conjugate, components(quaternion), components(out))
    return out


def quaternion_inverse(q: ArrayLike) -> Floats:
    """Inverse of a quaternion: `q` times it is 1.

    Parameters
    ----------
    q
        Quaternions of any norm but zero, shape (..., 4).

    Returns
    -------
    ndarray
        `q* / (q q*)`, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a quaternion is zero; it names the first one.

    Notes
    -----
    Ledger: quaternions.3.a.
    """
    quaternion = reals("q", q, 4)
    out = np.empty(quaternion.shape)
    given = components(quaternion)
    evaluate(generated.quaternion_inverse, given, components(out), ("q", quaternion), degree=-1)
    return out


def rotate_to_inertial(q: ArrayLike, v_body: ArrayLike) -> Floats:
    """Components in the inertial frame of vectors given in the body frame: `q v q*`.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    v_body
        Vectors in the body frame, any unit, shape (..., 3).

    Returns
    -------
    ndarray
        The vectors in the inertial frame, same unit, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis has another size, the leading axes do not broadcast, or a quaternion is
        zero; it names the first one.

    Notes
    -----
    Ledger: quaternions.3.1.
    """
    plain, paired = generated.rotate_to_inertial, generated.rotate_to_inertial_pairs
    return _rotated(plain, paired, ("q", q), ("v_body", v_body))


def rotate_to_body(q: ArrayLike, v_inertial: ArrayLike) -> Floats:
    """Components in the body frame of vectors given in the inertial frame: `q* v q`.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    v_inertial
        Vectors in the inertial frame, any unit, shape (..., 3).

    Returns
    -------
    ndarray
        The vectors in the body frame, same unit, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis has another size, the leading axes do not broadcast, or a quaternion is
        zero; it names the first one.

    Notes
    -----
    Ledger: quaternions.3.1, quaternions.3.4.
    """
    plain, paired = generated.rotate_to_body, generated.rotate_to_body_pairs
    return _rotated(plain, paired, ("q", q), ("v_inertial", v_inertial))


def _rotated(
    plain: Callable[..., Reports],
    paired: Callable[..., Reports],
    attitude: tuple[str, ArrayLike],
    turned: tuple[str, ArrayLike],
) -> Floats:
    """Rotate vectors, in pairs where their elements lie side by side."""
    quaternion, vector = reals(*attitude, 4), reals(*turned, 3)
    out = np.empty((*common_shape((attitude[0], quaternion, 1), (turned[0], vector, 1)), 3))
    scaled = attitude[0], quaternion
    if in_pairs(quaternion, vector):
        given: list[Numbers] = [*pairs(quaternion), *components(vector[..., :1])]
        given += pairs(vector[..., 1:])
        evaluate(paired, given, [*components(out[..., :1]), *pairs(out[..., 1:])], scaled)
    else:
        given = [*components(quaternion), *components(vector)]
        evaluate(plain, given, components(out), scaled)
    return out
