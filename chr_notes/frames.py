"""Vectors and attitudes in the axes of other systems: z up, east-north-up, phones.

- `notes`: north-east-down and forward-right-down; roll, pitch, yaw of this package.
- `ros`: east-north-up and forward-left-up; roll, pitch, yaw of REP 103.
- `android`: east-north-up and right-forward-up; azimuth, pitch, roll of `getOrientation`.
- `browser`: east-north-up and right-forward-up; alpha, beta, gamma of `deviceorientation`.

Angles stand in an array in this order.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes.euler import wrap_angle
from chr_notes.quaternions.algebra import quaternion_conjugate, quaternion_multiply
from chr_notes.quaternions.conversions import (
    euler_from_quaternion,
    quaternion_from_euler,
    quaternion_from_matrix,
)

Axes = Literal["frd", "flu", "rfu", "ned", "enu"]
System = Literal["notes", "ros", "android", "browser"]

_SWAPPED = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
# From each to forward-right-down, and to north-east-down.
_BODY = {"frd": np.eye(3), "flu": np.diag([1.0, -1.0, -1.0]), "rfu": _SWAPPED}
_NAVIGATION = {"ned": np.eye(3), "enu": _SWAPPED}


@dataclass(frozen=True)
class _System:
    """Axes of a system, and its angles by those of this package in the same attitude.

    Parameters
    ----------
    navigation, body
        Names of its axes.
    angles
        From roll, pitch, yaw, radians, to its own angles, or none if it has the same in its axes.
    euler
        The other way.
    """

    navigation: str
    body: str
    angles: Callable[[Floats], Floats] | None = None
    euler: Callable[[Floats], Floats] | None = None


def _android(euler: Floats) -> Floats:
    """Azimuth, pitch and roll of Android; its pitch grows when the top of the device sinks."""
    roll, pitch, yaw = np.moveaxis(euler, -1, 0)
    return np.stack([yaw, -pitch, roll], axis=-1)


def _from_android(angles: Floats) -> Floats:
    azimuth, pitch, roll = np.moveaxis(angles, -1, 0)
    return np.stack([roll, -pitch, azimuth], axis=-1)


def _browser(euler: Floats) -> Floats:
    """Alpha in [0, 2 pi), beta in [-pi, pi) and gamma in [-pi/2, pi/2).

    They turn about up, right and forward one after the other, as yaw, pitch and roll do about down,
    right and forward. Where roll is beyond a right angle the other three angles of the same
    attitude are meant.
    """
    roll, pitch, yaw = np.moveaxis(euler, -1, 0)
    over = ~((roll >= -np.pi / 2) & (roll < np.pi / 2))
    half = np.where(over, np.pi, 0.0)
    # At an end of a range a sum may round to what lies outside.
    alpha = (wrap_angle(-yaw + half - np.pi) + np.pi) % (2 * np.pi)
    beta = wrap_angle(np.where(over, np.pi - pitch, pitch))
    gamma = np.maximum(wrap_angle(roll + half), -np.pi / 2)
    return np.stack([alpha, beta, gamma], axis=-1)


def _from_browser(angles: Floats) -> Floats:
    alpha, beta, gamma = np.moveaxis(angles, -1, 0)
    return np.stack([gamma, beta, -alpha], axis=-1)


_SYSTEMS = {
    "notes": _System("ned", "frd"),
    "ros": _System("enu", "flu"),
    "android": _System("enu", "rfu", _android, _from_android),
    "browser": _System("enu", "rfu", _browser, _from_browser),
}


def change_axes(vector: ArrayLike, source: Axes, target: Axes) -> Floats:
    """Write vectors in other axes of the body, or of the room.

    Parameters
    ----------
    vector
        Any unit, shape (..., 3).
    source, target
        Of a body: "frd" (forward, right, down), "flu" (forward, left, up: z up, ROS) or "rfu"
        (right, forward, up: a phone's screen). Of the room: "ned" or "enu".

    Returns
    -------
    ndarray
        The same vectors, shape (..., 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 3, a name is unknown, or one is of a body and the other of
        the room.

    Examples
    --------
    An accelerometer with z up, at rest and level, reads +g; here it is -g:

    >>> import chr_notes
    >>> print(chr_notes.change_axes([0.0, 0.0, 9.81], "flu", "frd") + 0.0)
    [ 0.    0.   -9.81]
    """
    array = floats("vector", vector, 3)
    for table in (_BODY, _NAVIGATION):
        if source in table and target in table:
            with np.errstate(all="ignore"):
                return np.asarray(array @ (table[target].T @ table[source]).T)
    msg = (
        f"expected source and target of {', '.join(_BODY)}, or both of {', '.join(_NAVIGATION)}, "
        f"got {source!r} and {target!r}"
    )
    raise ValueError(msg)


def change_quaternion(q: ArrayLike, source: System, target: System) -> Floats:
    """Write attitude quaternions for the axes of another system.

    Parameters
    ----------
    q
        Scalar first, `v = q u q*` with u in the body's and v in the room's axes of the source, of
        any norm but zero, shape (..., 4). (ROS messages have the scalar last.)
    source, target
        "notes", "ros", "android" or "browser".

    Returns
    -------
    ndarray
        Quaternions of the same attitudes for the target's axes, with the norm of q, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a name is unknown.

    Examples
    --------
    Level and facing north is no turn here, and a quarter to the left of east for ROS:

    >>> import chr_notes
    >>> print(chr_notes.change_quaternion([1.0, 0.0, 0.0, 0.0], "notes", "ros").round(4) + 0.0)
    [0.7071 0.     0.     0.7071]
    """
    given, wanted = _system("source", source), _system("target", target)
    room = _turn(_NAVIGATION[wanted.navigation].T @ _NAVIGATION[given.navigation])
    body = _turn(_BODY[wanted.body].T @ _BODY[given.body])
    return quaternion_multiply(quaternion_multiply(room, q), quaternion_conjugate(body))


def change_angles(angles: ArrayLike, source: System, target: System) -> Floats:
    """Write the three angles of an attitude as another system does.

    Parameters
    ----------
    angles
        Of the source, in its order, radians, shape (..., 3): see the list of this module.
    source, target
        "notes", "ros", "android" or "browser".

    Returns
    -------
    ndarray
        Of the target, in its order, radians, shape (..., 3), in the ranges that it uses: angles
        that turn about forward and about the vertical in [-pi, pi], the one between in
        [-pi/2, pi/2]; of a browser alpha in [0, 2 pi), beta in [-pi, pi), gamma in [-pi/2, pi/2).
        At gimbal lock as `euler_from_quaternion`, without a warning.

    Raises
    ------
    ValueError
        If the last axis is not of size 3, or a name is unknown.

    Examples
    --------
    Roll 10°, pitch 20°, yaw 30°, counted from north to the right; for ROS from east to the left:

    >>> import numpy as np
    >>> import chr_notes
    >>> euler = np.radians([10.0, 20.0, 30.0])
    >>> print(np.degrees(chr_notes.change_angles(euler, "notes", "ros")).round(6))
    [ 10. -20.  60.]
    >>> print(np.degrees(chr_notes.change_angles(euler, "notes", "browser")).round(6))
    [330.  20.  10.]
    """
    given, wanted = _system("source", source), _system("target", target)
    array = floats("angles", angles, 3)
    if given.euler is not None:
        array, source = given.euler(array), "notes"
    away = "notes" if wanted.angles is not None else target
    q = change_quaternion(quaternion_from_euler(array), source, away)
    euler = euler_from_quaternion(q, on_gimbal_lock="ignore")
    return euler if wanted.angles is None else wanted.angles(euler)


def _system(name: str, value: str) -> _System:
    """Find a system by its name."""
    if value not in _SYSTEMS:
        msg = f"{name}: expected one of {', '.join(_SYSTEMS)}, got {value!r}"
        raise ValueError(msg)
    return _SYSTEMS[value]


def _turn(matrix: Floats) -> Floats:
    """Quaternion t with `M v = t v t*`; matrices of this package turn the other way."""
    return quaternion_from_matrix(matrix.T)
