"""Vectors and attitudes in the axes of other systems: z up, east-north-up, phones.

- `notes`: north-east-down and forward-right-down; roll, pitch, yaw of this package.
- `ros`: east-north-up and forward-left-up; roll, pitch, yaw of REP 103.
- `android`: east-north-up and right-forward-up; azimuth, pitch, roll of `getOrientation`.
- `browser`: east-north-up and right-forward-up; alpha, beta, gamma of `deviceorientation`.

Angles stand in an array in this order. `chr_notes.convert` knows more systems, and matrices; here
quaternions keep sign and length, angles are in radians, and those of a browser in its own ranges.
"""

from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes.euler import wrap_angle
from chr_notes.quaternions.algebra import quaternion_conjugate, quaternion_multiply
from chr_notes.quaternions.conversions import quaternion_from_matrix
from chr_notes.systems.convention import PRESETS, Convention
from chr_notes.systems.converting import convert

Axes = Literal["frd", "flu", "rfu", "ned", "enu"]
System = Literal["notes", "ros", "android", "browser"]

_BODY = {name: Convention(body=name) for name in ("frd", "flu", "rfu")}
_NAVIGATION = {name: Convention(navigation=name) for name in ("ned", "enu")}
_SYSTEMS = {
    "notes": PRESETS["this book"],
    "ros": PRESETS["ROS"],
    "android": PRESETS["Android"],
    "browser": replace(PRESETS["browser"], degrees=False),
}


def _in_ranges_of_a_browser(angles: Floats) -> Floats:
    """Alpha in [0, 2 pi), beta in [-pi, pi) and gamma in [-pi/2, pi/2).

    Where gamma is beyond a right angle the other three angles of the same attitude are meant.
    """
    alpha, beta, gamma = np.moveaxis(angles, -1, 0)
    over = ~((gamma >= -np.pi / 2) & (gamma < np.pi / 2))
    half = np.where(over, np.pi, 0.0)
    # At an end of a range a sum may round to what lies outside.
    alpha = (wrap_angle(alpha + half - np.pi) + np.pi) % (2 * np.pi)
    beta = wrap_angle(np.where(over, np.pi - beta, beta))
    gamma = np.maximum(wrap_angle(gamma + half), -np.pi / 2)
    return np.stack([alpha, beta, gamma], axis=-1)


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

    See Also
    --------
    change_angles
    change_quaternion

    Examples
    --------
    An accelerometer with z up, at rest and level, reads +g; here it is -g:

    >>> import chr_notes
    >>> print(chr_notes.change_axes([0.0, 0.0, 9.81], "flu", "frd") + 0.0)
    [ 0.    0.   -9.81]
    """
    array = floats("vector", vector, 3)
    if source in _BODY and target in _BODY:
        return convert(array, _BODY[source], _BODY[target], kind="body vector")
    if source in _NAVIGATION and target in _NAVIGATION:
        return convert(array, _NAVIGATION[source], _NAVIGATION[target], kind="navigation vector")
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

    See Also
    --------
    change_angles
    change_axes
    chr_notes.systems.converting.convert

    Examples
    --------
    Level and facing north is no turn here, and a quarter to the left of east for ROS:

    >>> import chr_notes
    >>> print(chr_notes.change_quaternion([1.0, 0.0, 0.0, 0.0], "notes", "ros").round(4) + 0.0)
    [0.7071 0.     0.     0.7071]
    """
    given, wanted = _system("source", source), _system("target", target)
    room, body = (
        # Quaternion t with `M v = t v t*`; matrices of this package turn the other way.
        quaternion_from_matrix((wanted.axes(frame).T @ given.axes(frame)).T)
        for frame in ("navigation", "body")
    )
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

    See Also
    --------
    change_axes
    change_quaternion
    chr_notes.systems.converting.convert

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
    changed = convert(floats("angles", angles, 3), given, wanted, kind="angles")
    return _in_ranges_of_a_browser(changed) if target == "browser" else changed


def _system(name: str, value: str) -> Convention:
    """Find a system by its name."""
    if value not in _SYSTEMS:
        msg = f"{name}: expected one of {', '.join(_SYSTEMS)}, got {value!r}"
        raise ValueError(msg)
    return _SYSTEMS[value]
