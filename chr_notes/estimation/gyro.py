"""Roll, pitch and yaw from gyros alone."""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._recordings import run
from chr_notes._samples import WILD_RATE, complete, periods, samples, start
from chr_notes._units import warn_of_rates
from chr_notes.euler import wrap_angle
from chr_notes.generated.scalar.estimation import gyro_step, gyro_turn
from chr_notes.quaternions.conversions import euler_from_quaternion, quaternion_from_euler


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

    Warns
    -----
    UnitWarning
        If a sample turns by more than half a revolution within its time step, which nobody can tell
        from less; or if, of 100 samples or more, more than one in a hundred are faster than 70
        rad/s (4000 °/s), or most time steps are above 1 s. So it is with rates in °/s, with
        milliseconds, and where a clock has jumped. Slow turns in °/s look like fast ones in rad/s,
        and nothing is said: filters that are given another sensor too compare it with them.

    See Also
    --------
    chr_notes.estimation.fixed_gain.fixed_gain_observer
    chr_notes.estimation.averaging.averaging_observer

    Notes
    -----
    Ledger: estimation.3.2, estimation.3.3, estimation.3.a.

    Examples
    --------
    >>> import numpy as np
    >>> rates = np.tile([0, 0, np.radians(30)], (100, 1))  # a second of turning
    >>> np.degrees(integrate_gyro(rates, 0.01)[-1]).round(6)
    array([ 0.,  0., 30.])
    """
    if method not in ("quaternion", "euler"):
        msg = f'method: expected "quaternion" or "euler", got {method!r}'
        raise ValueError(msg)
    rates = samples("body_rates", body_rates)
    missing = ~complete(rates, WILD_RATE)
    if missing.any():
        rates = np.where(missing[:, np.newaxis], np.nan, rates)
    steps = periods(dt, len(rates))
    warn_of_rates(rates, steps)
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
