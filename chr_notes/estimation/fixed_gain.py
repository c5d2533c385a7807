"""The fixed-gain observer, a complementary filter, over a recording.

A sample with NaN or infinity, or with a rate of 1e12 rad/s and more, which no gyro reads, is held
out, and the estimate goes on without it.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import pi
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats
from chr_notes._kernels import kernel, of_numbers
from chr_notes._recordings import run
from chr_notes._samples import (
    WILD_RATE,
    complete,
    number,
    periods,
    same_length,
    samples,
    start,
)
from chr_notes.estimation.gyro import attitudes_in_range, in_range
from chr_notes.generated.scalar import estimation as steps
from chr_notes.generated.scalar.quaternions import euler_from_quaternion, quaternion_from_euler

Method = Literal["quaternion", "euler"]


@dataclass(frozen=True)
class _Way:
    """One of the two methods.

    Parameters
    ----------
    step
        From state and sample to the next state, for a recording.
    advance
        The same for one sample.
    sample
        From Euler angles and sample to the next Euler angles.
    quick_sample
        A kernel that does the same with arrays, if there is one.
    begin
        From Euler angles to a state.
    end, angles
        From states, and from one, to Euler angles in their ranges.
    """

    step: Callable[..., tuple[float, ...]]
    advance: Callable[..., tuple[float, ...]]
    sample: Callable[..., tuple[float, ...]]
    quick_sample: Callable[..., Floats | None] | None
    begin: Callable[..., Sequence[float]]
    end: Callable[[Floats], Floats]
    angles: Callable[[Sequence[float]], Floats]


_quick_quaternion = of_numbers(quaternion_from_euler)
_quick_euler = of_numbers(euler_from_quaternion)


def _quaternion(*euler: float) -> Sequence[float]:
    return _quick_quaternion(*euler) or quaternion_from_euler(*euler)


def _angles(quaternion: Sequence[float]) -> Floats:
    found = _quick_euler(*quaternion) or euler_from_quaternion(*quaternion)
    roll, pitch, yaw = found[:3]
    return np.array((roll if roll < pi else -pi, pitch, yaw if yaw < pi else -pi))


def is_in_range(roll: float, pitch: float, yaw: float) -> bool:
    """Say whether three angles are in the ranges that filters write them in."""
    return -pi <= roll < pi and -pi <= yaw < pi and -pi / 2 <= pitch <= pi / 2


def angles_in_range(euler: Sequence[float]) -> Floats:
    """Write three angles in these ranges."""
    if is_in_range(*euler):
        return np.array(euler)
    return np.asarray(in_range(np.array([euler]))[0])


_WAYS = {
    "quaternion": _Way(
        steps.observer_turn,
        of_numbers(steps.observer_turn),
        of_numbers(steps.observer_step),
        kernel("observer_step"),
        _quaternion,
        attitudes_in_range,
        _angles,
    ),
    "euler": _Way(
        steps.euler_observer_step,
        of_numbers(steps.euler_observer_step),
        of_numbers(steps.euler_observer_step),
        kernel("euler_observer_step"),
        lambda *euler: euler,
        in_range,
        angles_in_range,
    ),
}


def way_of(method: str) -> _Way:
    """Find a method by its name; refuse one that does not exist."""
    if method not in _WAYS:
        msg = f'method: expected "quaternion" or "euler", got {method!r}'
        raise ValueError(msg)
    return _WAYS[method]


def fixed_gain_observer(  # noqa: PLR0913 (a recording, and how to run through it)
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: ArrayLike,
    gain: float,
    initial: ArrayLike | None = None,
    *,
    method: Method = "quaternion",
) -> Floats:
    """Run a complementary filter: predict by gyros, correct roll and pitch by the accelerometer.

    Each sample turns the attitude by the gyros. If the accelerometer then reads gravity from
    elsewhere than the attitude says, the attitude is turned towards it, about a level axis, by
    the gain times the angle between the two. Nothing corrects the turn about the vertical: yaw
    comes from the gyros.

    Parameters
    ----------
    body_rates
        Rates p, q, r about the body axes, rad/s, shape (N, 3).
    accel
        Specific force in any unit, shape (N, 3).
    dt
        Time step before each sample, seconds: a number, or shape (N,).
    gain
        L, from 0, the gyros alone, to 1, the accelerometer alone.
    initial
        Roll, pitch, yaw before the first time step, radians, shape (3,). Without it, the estimate
        starts with the first tilt that the accelerometer shows, as that sample's, and a yaw of 0.
    method
        "quaternion" does as said, exactly, in every attitude. "euler" is the note's own step:
        the angles go on by their rates, and roll and pitch are moved towards those that the
        accelerometer shows, each by the gain times its difference, the shorter way round. It is
        off by the square of the step, and fails near a pitch of ±90°.

    Returns
    -------
    ndarray
        Roll and yaw in [-pi, pi), pitch in [-pi/2, pi/2], after each sample, shape (N, 3). A row
        whose rates hold NaN, or before the start, comes out as NaN; one whose accelerometer does,
        or reads zero, comes out as predicted.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative or no number, the gain is not from 0 to 1,
        the initial attitude is not finite, or no accelerometer sample can stand in for it.

    See Also
    --------
    rejected_samples : The rows of which something was left out.
    observe : The same on a stream.

    Notes
    -----
    Ledger: estimation.4.1, estimation.4.2, estimation.4.3, estimation.4.4, validation.10,
    validation.11.
    """
    way, share = way_of(method), np.array(check_gain("gain", gain))
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    count = same_length(("body_rates", rates), ("accel", forces))
    dt = periods(dt, count)
    if initial is None:
        begin, first = first_tilt(forces)
        before = np.full((min(begin + 1, count), 3), np.nan)
        before[begin:] = first
    else:
        before, first = np.empty((0, 3)), canonical("initial", initial)
    rest = slice(len(before), None)
    each = dt[rest] if dt.ndim else dt
    given = (rates[rest], forces[rest], each, share)
    out = run(way.step, way.begin(*first), *given, finish=way.end)
    if len(before):
        out = np.concatenate([before, out])
    out[~complete(rates, WILD_RATE)] = np.nan
    return out


def rejected_samples(body_rates: ArrayLike, accel: ArrayLike) -> NDArray[np.bool_]:
    """Say which samples of a recording `fixed_gain_observer` leaves out, whole or in part.

    Parameters
    ----------
    body_rates
        Rates about the body axes, shape (N, 3).
    accel
        Specific force, shape (N, 3).

    Returns
    -------
    ndarray
        Where the rates or the force hold NaN or infinity, a rate is 1e12 rad/s or more, or the
        force reads zero, shape (N,). Its sum is the number that `observe` counts.

    Raises
    ------
    ValueError
        If a shape is wrong.
    """
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    same_length(("body_rates", rates), ("accel", forces))
    return ~(complete(rates, WILD_RATE) & complete(forces) & forces.any(axis=1))


def first_tilt(forces: Floats) -> tuple[int, Sequence[float]]:
    """Find the first tilt that is known.

    Parameters
    ----------
    forces
        Specific force, shape (N, 3).

    Returns
    -------
    sample
        Where it is.
    euler
        It, with a yaw of 0.

    Raises
    ------
    ValueError
        If there are samples and none shows a tilt.
    """
    for sample, force in enumerate(forces):
        roll, pitch = steps.tilt_from_accelerometer(*force.tolist())
        if roll == roll:  # noqa: PLR0124 (NaN is not itself)
            return sample, (roll, pitch, 0.0)
    if len(forces):
        msg = "accel: expected a sample that shows a tilt to start from, got none; pass initial"
        raise ValueError(msg)
    return 0, (0.0, 0.0, 0.0)


def canonical(name: str, euler: ArrayLike) -> list[float]:
    """Take an attitude to start from, with pitch in [-pi/2, pi/2] and roll and yaw in [-pi, pi).

    Corrections go towards a tilt that is in these ranges, so the start has to be too.
    """
    return list(in_range(np.array([start(name, euler)]))[0].tolist())


def check_gain(name: str, gain: float) -> float:
    """Take a gain; refuse one that is not from 0 to 1."""
    checked = gain if isinstance(gain, float) else number(name, gain)
    if not 0 <= checked <= 1:
        msg = f"{name}: expected a number from 0 to 1, got {checked}"
        raise ValueError(msg)
    return checked
