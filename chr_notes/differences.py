"""How far attitudes are apart, what lies between them, and series of them without jumps of sign."""

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, at_first, floats
from chr_notes._rows import Rows
from chr_notes.generated.arrays import quaternions as generated
from chr_notes.quaternions.algebra import quaternion_multiply
from chr_notes.quaternions.conversions import axis_angle_from_quaternion, quaternion_from_axis_angle

_inclination_from_quaternion = Rows(generated.inclination_from_quaternion, scaled="refused")
# Zero is refused under the argument's name.
_inclination_between = Rows(generated.inclination_from_quaternion, scaled="refused", names=("p",))
_inverse_of_p = Rows(generated.quaternion_inverse, scaled="refused", degree=-1, names=("p",))
_inverse_of_q = Rows(generated.quaternion_inverse, scaled="refused", degree=-1)


def inclination_from_quaternion(q: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Tell by how much the body is tilted: the angle between its z-axis and the vertical.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Angle in [0, pi], radians, shape (...): 0 is level, pi upside down.

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a quaternion is zero; it names the first one.

    See Also
    --------
    angle_between_verticals

    Examples
    --------
    >>> import numpy as np
    >>> import chr_notes
    >>> q = chr_notes.quaternion_from_euler(np.radians([30.0, 0.0, 120.0]))
    >>> print(f"{np.degrees(chr_notes.inclination_from_quaternion(q)):.1f}")
    30.0
    """
    return _inclination_from_quaternion(q, out=out)


def angle_between_attitudes(p: ArrayLike, q: ArrayLike) -> Floats:
    """Tell by how much two attitudes differ: the angle of the one turn from p to q.

    Parameters
    ----------
    p, q
        Attitude quaternions of any norm but zero, shape (..., 4); q and -q are one attitude.

    Returns
    -------
    ndarray
        Angle in [0, pi], radians, shape (...).

    Raises
    ------
    ValueError
        If a last axis is not of size 4, the leading axes do not broadcast, or a quaternion is zero.

    See Also
    --------
    angle_between_verticals

    Examples
    --------
    >>> import numpy as np
    >>> import chr_notes
    >>> p, q = chr_notes.quaternion_from_euler(np.radians([[0.0, 0.0, 170.0], [0.0, 0.0, -170.0]]))
    >>> print(f"{np.degrees(chr_notes.angle_between_attitudes(p, q)):.1f}")
    20.0
    """
    return axis_angle_from_quaternion(quaternion_multiply(_inverse_of_p(p), q))[1]


def angle_between_verticals(p: ArrayLike, q: ArrayLike) -> Floats:
    """Tell by how much two attitudes differ in tilt: the angle between their verticals.

    What it leaves out is a turn about the vertical, so it is what an accelerometer can know of the
    difference. It is not larger than `angle_between_attitudes`.

    Parameters
    ----------
    p, q
        Attitude quaternions of any norm but zero, shape (..., 4).

    Returns
    -------
    ndarray
        Angle in [0, pi], radians, shape (...).

    Raises
    ------
    ValueError
        If a last axis is not of size 4, the leading axes do not broadcast, or a quaternion is zero.

    See Also
    --------
    angle_between_attitudes

    Examples
    --------
    A yaw that is wrong by a right angle is no error of tilt:

    >>> import numpy as np
    >>> import chr_notes
    >>> p, q = chr_notes.quaternion_from_euler(np.radians([[5.0, 0.0, 0.0], [5.0, 0.0, 90.0]]))
    >>> print(f"{np.degrees(chr_notes.angle_between_verticals(p, q)):.1f}")
    0.0
    >>> print(f"{np.degrees(chr_notes.angle_between_attitudes(p, q)):.1f}")
    90.0
    """
    difference = quaternion_multiply(p, _inverse_of_q(q))
    return _inclination_between(difference)


def slerp(p: ArrayLike, q: ArrayLike, share: ArrayLike) -> Floats:
    """Interpolate between two attitudes: go a share of the one turn from p to q.

    The turn is the shorter one, at a constant rate about one axis (Shoemake, "Animating rotation
    with quaternion curves", SIGGRAPH 1985).

    Parameters
    ----------
    p, q
        Attitude quaternions of any norm but zero, shape (..., 4).
    share
        From 0, which gives p, to 1, which gives q, shape (...).

    Returns
    -------
    ndarray
        Unit quaternions on the side of p: at a share of 0 it is p itself, shape (..., 4).

    Raises
    ------
    ValueError
        If a last axis is not of size 4, the leading axes do not broadcast, a quaternion is zero,
        or a share is not from 0 to 1.

    See Also
    --------
    continuous_quaternions
    angle_between_attitudes

    Examples
    --------
    >>> import numpy as np
    >>> import chr_notes
    >>> p, q = chr_notes.quaternion_from_euler(np.radians([[0.0, 0.0, 0.0], [0.0, 0.0, 90.0]]))
    >>> halfway = chr_notes.euler_from_quaternion(chr_notes.slerp(p, q, 0.5))
    >>> print(np.degrees(halfway).round(1))
    [ 0.  0. 45.]
    """
    shares = floats("share", share)
    outside = (shares < 0) | (shares > 1)
    if outside.any():
        got = f"{shares[outside].flat[0]}{at_first(np.asarray(outside))}"
        msg = f"share: expected numbers from 0 to 1, got {got}"
        raise ValueError(msg)
    axis, angle = axis_angle_from_quaternion(quaternion_multiply(_inverse_of_p(p), q))
    start = floats("p", p, 4)
    with np.errstate(all="ignore"):
        part = quaternion_from_axis_angle(axis, shares * angle)
        # In units of the largest element, whose square is a number.
        start = start / np.abs(start).max(axis=-1, keepdims=True)
        start /= np.linalg.norm(start, axis=-1, keepdims=True)
    return quaternion_multiply(start, part)


def continuous_quaternions(q: ArrayLike) -> Floats:
    """Choose the signs of a series of quaternions so that it has no jumps.

    q and -q are one attitude, and conversions return the one with a >= 0: plotted, interpolated or
    filtered, the series jumps where a passes through zero. Here each has the sign that is nearer
    to the one before it.

    Parameters
    ----------
    q
        Quaternions one after another, shape (N, 4).

    Returns
    -------
    ndarray
        The same attitudes, the first one as it is, shape (N, 4). Rows with NaN stay, and are
        passed over.

    Raises
    ------
    ValueError
        If the shape differs.

    See Also
    --------
    slerp

    Examples
    --------
    >>> import numpy as np
    >>> import chr_notes
    >>> angles = np.radians([100.0, 170.0, 190.0, 260.0])
    >>> q = chr_notes.quaternion_from_axis_angle([1.0, 0.0, 0.0], angles)
    >>> print(q[:, 1].round(2))
    [ 0.77  1.   -1.   -0.77]
    >>> print(chr_notes.continuous_quaternions(q)[:, 1].round(2))
    [0.77 1.   1.   0.77]
    """
    series = floats("q", q, 4)
    if series.ndim != 2:  # noqa: PLR2004 (samples by elements)
        msg = f"q: expected shape (N, 4), got {series.shape}"
        raise ValueError(msg)
    result = series.copy()
    known = np.isfinite(series).all(axis=1)
    there = series[known]
    turns_back = np.einsum("ij,ij->i", there[1:], there[:-1]) < 0
    signs = np.ones(len(there))
    signs[1:] = np.where(turns_back, -1.0, 1.0).cumprod()
    result[known] = there * signs[:, np.newaxis]
    return result
