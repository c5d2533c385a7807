"""Attitudes and vectors from one convention into another."""

from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes.quaternions.algebra import quaternion_conjugate
from chr_notes.quaternions.conversions import (
    axis_angle_from_quaternion,
    matrix_from_quaternion,
    quaternion_from_axis_angle,
    quaternion_from_matrix,
)
from chr_notes.sequences import angles_from_matrix, matrix_from_angles
from chr_notes.systems.convention import DOCUMENTED, PRESETS, Convention

Kind = Literal["angles", "matrix", "quaternion", "axis angle", "body vector", "navigation vector"]


_VECTORS = {"body vector", "navigation vector"}
_ATTITUDES = tuple(kind for kind in get_args(Kind) if kind not in _VECTORS)


def convert(
    value: ArrayLike,
    source: Convention | str,
    target: Convention | str,
    *,
    kind: Kind,
    to: Kind | None = None,
) -> Floats:
    """Write what stands for an attitude, or a vector, in another convention.

    Parameters
    ----------
    value
        Angles or vectors, shape (..., 3); matrices, (..., 3, 3); quaternions of any norm but zero,
        (..., 4); axes of any length but zero, each with its angle behind it, (..., 4).
    source, target
        Conventions, or their names in `PRESETS` or `DOCUMENTED` of
        `chr_notes.systems.convention`.
    kind
        What the value is: "angles", "matrix", "quaternion", "axis angle" (of the turn that the
        convention's quaternion stands for), "body vector" or "navigation vector".
    to
        As what to write an attitude: "angles", "matrix", "quaternion" or "axis angle"; what the
        value is if None.

    Returns
    -------
    ndarray
        The same attitude or vector for the target, in the shape of its kind. Angles lie in the
        ranges of `chr_notes.sequences.angles_from_matrix`, at gimbal lock without a warning;
        quaternions are unit quaternions with a scalar part of at least 0; axes have length 1, and
        their angles go from 0 to half a turn.

    Raises
    ------
    ValueError
        If a shape is wrong, a name unknown, a value stands for no attitude, or a vector is to
        become one.

    See Also
    --------
    chr_notes.systems.detective.find_conventions : Which convention numbers are in.
    chr_notes.frames.change_angles : Also the angles of Android and of browsers.

    Examples
    --------
    A UM7 says roll 10°, pitch 20°, yaw 30°. For ROS, whose z points up, the pitch has the other
    sign and yaw counts from east to the left:

    >>> import numpy as np
    >>> import chr_notes
    >>> angles = chr_notes.convert([10.0, 20.0, 30.0], "CHR", "ROS", kind="angles")
    >>> print(np.degrees(angles).round(4))
    [ 10. -20.  60.]

    The same as a quaternion, x, y, z, w:

    >>> q = chr_notes.convert([10.0, 20.0, 30.0], "CHR", "ROS", kind="angles", to="quaternion")
    >>> print(q.round(4))
    [ 0.1608 -0.1069  0.5036  0.8421]

    Level and facing north, scalar first there and last here:

    >>> q = chr_notes.convert([1.0, 0.0, 0.0, 0.0], "CHR", "ROS", kind="quaternion")
    >>> print(q.round(4) + 0.0)
    [0.     0.     0.7071 0.7071]
    """
    given, wanted = named("source", source), named("target", target)
    if kind not in get_args(Kind):
        msg = f"kind: expected one of {get_args(Kind)}, got {kind!r}"
        raise ValueError(msg)
    wanted_kind = kind if to is None else to
    if wanted_kind not in get_args(Kind) or (
        kind != wanted_kind and _VECTORS & {kind, wanted_kind}
    ):
        msg = f"to: expected one of {_ATTITUDES} for an attitude, got {to!r} for kind {kind!r}"
        raise ValueError(msg)
    if kind in _VECTORS:
        frame: Literal["body", "navigation"] = "body" if kind == "body vector" else "navigation"
        change = wanted.axes(frame).T @ given.axes(frame)
        with np.errstate(all="ignore"):
            return np.asarray(floats("value", value, 3) @ change.T)
    own = to_body(value, given, kind)
    room = given.axes("navigation").T @ wanted.axes("navigation")
    return from_matrix(wanted.axes("body").T @ given.axes("body") @ own @ room, wanted, wanted_kind)


def to_body(value: ArrayLike, convention: Convention, kind: str) -> Floats:
    """Matrix from navigation to body in the convention's own axes, of what stands for it."""
    if kind == "angles":
        angles = floats("value", value, 3)[..., convention.order] * convention.signs
        angles = np.radians(angles) if convention.degrees else angles
        return matrix_from_angles(angles, convention.sequence)
    if kind == "matrix":
        matrix = floats("value", value, 3, 3)
        return np.swapaxes(matrix, -1, -2) if convention.matrix_is_transposed else matrix
    q = floats("value", value, 4)
    if kind == "axis angle":
        angle = np.radians(q[..., 3]) if convention.degrees else q[..., 3]
        q = quaternion_from_axis_angle(q[..., :3], angle)
    elif not convention.scalar_first:
        q = np.roll(q, 1, axis=-1)
    return matrix_from_quaternion(
        quaternion_conjugate(q) if convention.quaternion_is_conjugated else q
    )


def from_matrix(matrix: Floats, convention: Convention, kind: str) -> Floats:
    """Write a matrix from navigation to body, in the convention's own axes, as it does."""
    if kind == "angles":
        angles = angles_from_matrix(matrix, convention.sequence, on_gimbal_lock="ignore")
        angles = np.degrees(angles) if convention.degrees else angles
        angles *= convention.signs
        return angles[..., np.argsort(convention.order)]
    if kind == "matrix":
        quaternion_from_matrix(matrix)  # refuses what is no rotation
        return np.swapaxes(matrix, -1, -2).copy() if convention.matrix_is_transposed else matrix
    q = quaternion_from_matrix(matrix)
    q = quaternion_conjugate(q) if convention.quaternion_is_conjugated else q
    if kind == "axis angle":
        axis, angle = axis_angle_from_quaternion(q)
        angle = np.degrees(angle) if convention.degrees else angle
        return np.concatenate([axis, np.asarray(angle)[..., np.newaxis]], axis=-1)
    return q if convention.scalar_first else np.roll(q, -1, axis=-1)


def named(argument: str, convention: Convention | str) -> Convention:
    """Find a convention by its name; one that is given is returned."""
    if isinstance(convention, Convention):
        return convention
    known = PRESETS | DOCUMENTED
    if convention not in known:
        msg = f"{argument}: expected a Convention or one of {', '.join(known)}, got {convention!r}"
        raise ValueError(msg)
    return known[convention]
