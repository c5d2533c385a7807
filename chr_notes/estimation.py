"""Roll and pitch from an accelerometer at rest, and roll, pitch and yaw from gyros."""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._recordings import run
from chr_notes._rows import Rows
from chr_notes._samples import WILD_RATE, held_out, periods, start
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.euler import wrap_angle
from chr_notes.generated.arrays import estimation as generated
from chr_notes.generated.arrays import sensors
from chr_notes.generated.scalar.estimation import gyro_step, gyro_turn
from chr_notes.quaternions import euler_from_quaternion, quaternion_from_euler

_tilt_from_accelerometer = Rows(generated.tilt_from_accelerometer, scaled="nothing")
_accelerometer_at_rest = Rows(sensors.accelerometer_at_rest)


def tilt_from_accelerometer(accel: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Tell roll and pitch from which way an accelerometer at rest reads gravity.

    Only the direction of the reading counts, so that a wrong scale or more than one g on the
    same line does no harm. A reading of zero, as in free fall, has no direction: it gives NaN, as
    does one with NaN or infinity.
    Straight up or down roll is not determined, and 0.

    Parameters
    ----------
    accel
        Specific force in any unit, shape (..., 3); level and at rest it is (0, 0, -g).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Roll in (-pi, pi] and pitch in [-pi/2, pi/2], radians, shape (..., 2).

    Raises
    ------
    ValueError
        If the last axis is not of size 3.

    Notes
    -----
    Ledger: estimation.2.5, estimation.2.6, validation.3, validation.4.
    """
    return _tilt_from_accelerometer(accel, out=out)


def accelerometer_at_rest(
    euler: ArrayLike, gravity: ArrayLike = STANDARD_GRAVITY, *, out: Floats | None = None
) -> Floats:
    """Tell what an ideal accelerometer reads at rest.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.
    gravity
        Magnitude of gravity, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Specific force in the unit of gravity, shape (..., 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 3 or the leading axes do not broadcast.

    Notes
    -----
    Ledger: estimation.2.4, sensors.2.2, sensors.2.c.
    """
    return _accelerometer_at_rest(euler, gravity, out=out)


def integrate_gyro(
    body_rates: ArrayLike,
    dt: ArrayLike,
    initial: ArrayLike = (0.0, 0.0, 0.0),
    *,
    method: Literal["quaternion", "euler"] = "quaternion",
) -> Floats:
    """Integrate gyros from a known attitude.

    Parameters
    ----------
    body_rates
        Rates p, q, r about the body axes, rad/s, shape (N, 3), each held for its time step.
    dt
        Time step before each sample, seconds: a number, or shape (N,).
    initial
        Roll, pitch, yaw before the first time step, radians, shape (3,).
    method
        "quaternion" turns the attitude by each sample exactly; "euler" steps the three angles by
        their rates, as the notes do, which is off by the square of the step and fails near a
        pitch of ±90°.

    Returns
    -------
    ndarray
        Roll, pitch, yaw after each sample, roll and yaw in [-pi, pi), pitch in [-pi/2, pi/2],
        shape (N, 3). A row whose rates hold NaN, or 1e12 rad/s and more, comes out as NaN, and the
        next goes on as if the body had stood still.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative or no number, the initial attitude is not
        finite, or the method is neither of the two.

    Notes
    -----
    Ledger: estimation.3.2, estimation.3.3, estimation.3.a.
    """
    if method not in ("quaternion", "euler"):
        msg = f'method: expected "quaternion" or "euler", got {method!r}'
        raise ValueError(msg)
    rates, missing = held_out("body_rates", body_rates, WILD_RATE)
    steps = periods(dt, len(rates))
    first = start("initial", initial)
    if method == "quaternion":
        begin = quaternion_from_euler(first).tolist()
        out = run(gyro_turn, begin, rates, steps, finish=attitudes_in_range)
    else:
        out = run(gyro_step, first, rates, steps, finish=in_range)
    out[missing] = np.nan
    return out


def attitudes_in_range(states: Floats) -> Floats:
    """Turn quaternions, shape (N, 4), to Euler angles with roll and yaw in [-pi, pi)."""
    euler = euler_from_quaternion(states, on_gimbal_lock="ignore")
    half = euler >= np.pi
    if half.any():
        euler[half] = -np.pi
    return euler


def in_range(euler: Floats) -> Floats:
    """Write the same attitudes with roll and yaw in [-pi, pi) and pitch in [-pi/2, pi/2].

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (N, 3); it is changed.
    """
    roll, pitch, yaw = euler.T
    for angle in (roll, yaw):
        beyond = (angle < -np.pi) | (angle >= np.pi)
        if beyond.any():
            angle[beyond] = wrap_angle(angle[beyond])
    steep = np.abs(pitch) > np.pi / 2
    if steep.any():
        turned = quaternion_from_euler(euler[steep])
        euler[steep] = euler_from_quaternion(turned, on_gimbal_lock="ignore")
    return np.ascontiguousarray(euler)
