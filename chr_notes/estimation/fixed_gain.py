"""The fixed-gain observer, a complementary filter, over a recording.

A sample with NaN or infinity, or with a rate of 1e12 rad/s and more, which no gyro reads, is held
out, and the estimate goes on without it.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import pi
from struct import Struct
from typing import Any, Literal, NoReturn

import numpy as np
from numpy import empty
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats
from chr_notes._kernels import kernel, sampled
from chr_notes._recordings import run
from chr_notes._samples import (
    WILD_RATE,
    complete,
    horizontal,
    periods,
    same_length,
    samples,
)
from chr_notes._units import warn_of_rates
from chr_notes.estimation.gyro import attitudes_in_range, in_range
from chr_notes.estimation.starts import canonical, check_gain, first_tilt, with_heading
from chr_notes.generated.scalar import estimation as steps
from chr_notes.generated.scalar.quaternions import euler_from_quaternion, quaternion_from_euler

Method = Literal["quaternion", "euler"]
_LEAST, _DOWN, _UP = -pi, -pi / 2, pi / 2
# An array is filled by it in less time than it takes to make one of numbers.
_fill: Callable[..., None] = Struct("3d").pack_into


@dataclass(frozen=True)
class _Way:
    """One of the two methods.

    Parameters
    ----------
    step
        From state and sample to the next state.
    sample
        From Euler angles and sample to the next Euler angles.
    quick_advance
        Kernels that move a state on and give its Euler angles, if there are any.
    quick_sample
        A kernel that does as `sample` with arrays.
    begin
        From Euler angles to a state.
    end, angles
        From states, and from one, to Euler angles in their ranges.
    """

    step: Callable[..., tuple[float, ...]]
    sample: Callable[..., tuple[float, ...]]
    quick_advance: Callable[..., Any] | None
    quick_sample: Callable[..., Any] | None
    begin: Callable[..., Sequence[float]]
    end: Callable[[Floats], Floats]
    angles: Callable[[Sequence[float]], Floats]


def _angles(quaternion: Sequence[float]) -> Floats:
    a, b, c, d = quaternion
    roll, pitch, yaw, _ = euler_from_quaternion(a, b, c, d)
    angles = empty(3)
    _fill(angles, 0, roll if roll < pi else _LEAST, pitch, yaw if yaw < pi else _LEAST)
    return angles


def is_in_range(roll: float, pitch: float, yaw: float) -> bool:
    """Say whether three angles are in the ranges that filters write them in."""
    return _LEAST <= roll < pi and _LEAST <= yaw < pi and _DOWN <= pitch <= _UP


def angles_in_range(euler: Sequence[float] | Floats) -> Floats:
    """Write three angles in these ranges."""
    roll, pitch, yaw = euler
    # As is_in_range, to call which takes as long as to see it.
    if _LEAST <= roll < pi and _LEAST <= yaw < pi and _DOWN <= pitch <= _UP:
        angles = empty(3)
        _fill(angles, 0, roll, pitch, yaw)
        return angles
    return np.asarray(in_range(np.array([euler]))[0])


class _Ways(dict[str, _Way]):
    """The methods by their names; one that does not exist is refused."""

    def __missing__(self, method: object) -> NoReturn:
        msg = f'method: expected "quaternion" or "euler", got {method!r}'
        raise ValueError(msg)


WAYS = _Ways(
    {
        "quaternion": _Way(
            steps.observer_turn,
            steps.observer_step,
            sampled(steps.observer_turn, euler_from_quaternion),
            kernel("observer_step"),
            quaternion_from_euler,
            attitudes_in_range,
            _angles,
        ),
        "euler": _Way(
            steps.euler_observer_step,
            steps.euler_observer_step,
            None,
            kernel("euler_observer_step"),
            lambda *euler: euler,
            in_range,
            angles_in_range,
        ),
    }
)


def refuse_magnetometer(method: str) -> None:
    """Refuse one for a method that has no step for it."""
    if method == "euler":
        msg = 'mag: expected none for the method "euler", which has no step for it'
        raise ValueError(msg)


def fixed_gain_observer(  # noqa: PLR0913 (a recording, and how to run through it)
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: ArrayLike,
    gain: float,
    initial: ArrayLike | None = None,
    *,
    method: Method = "quaternion",
    mag: ArrayLike | None = None,
    heading_gain: float = 1.0,
    reference: ArrayLike = (1.0, 0.0),
) -> Floats:
    """Run a complementary filter: predict by gyros, correct roll and pitch by the accelerometer.

    Each sample turns the attitude by the gyros. If the accelerometer then reads gravity from
    elsewhere than the attitude says, the attitude is turned towards it, about a level axis, by
    the gain times the angle between the two. The turn about the vertical is corrected by a
    magnetometer, if there is one: yaw is turned towards the heading that it shows, by its own gain
    times the angle between the two. Without one yaw comes from the gyros.

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
        off by the square of the step, fails near a pitch of ±90°, and takes no magnetometer.
    mag
        Magnetic field in any unit, shape (N, 3). Without an initial attitude the first tilt comes
        with the heading that it shows.
    heading_gain
        From 0, yaw by the gyros alone, to 1, by the magnetometer alone, as the paper has it.
    reference
        As for `heading_from_magnetometer`, shape (2,).

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
        the initial attitude is not finite, or no accelerometer sample can stand in for it; if the
        reference is zero, or there is a magnetometer for the method "euler".

    Warns
    -----
    UnitWarning
        As `integrate_gyro`, and as `averaging_observer` by the other sensors.

    See Also
    --------
    rejected_samples : The rows of which something was left out.
    chr_notes.estimation.streams.observe : The same on a stream.
    chr_notes.estimation.gains.gain_from_time_constant : A gain for a rate.
    chr_notes.estimation.averaging.averaging_observer : What true acceleration does not lead astray.

    Notes
    -----
    Ledger: estimation.4.1, estimation.4.2, estimation.4.3, estimation.4.4, validation.10,
    validation.11, validation.16.

    Examples
    --------
    A body lies at a roll of 0.1 rad and a yaw of 0.5; its gyros have a bias, and its magnetometer
    reads a field that points north and down.

    >>> import numpy as np
    >>> from chr_notes import accelerometer_at_rest, matrix_from_euler
    >>> rates = np.full((2000, 3), 0.01)
    >>> accel = np.tile(accelerometer_at_rest([0.1, 0.0, 0.5]), (2000, 1))
    >>> mag = np.tile(matrix_from_euler([0.1, 0.0, 0.5]) @ [0.4, 0.0, 0.9], (2000, 1))
    >>> fixed_gain_observer(rates, accel, 0.01, 0.02)[-1].round(3)
    array([0.105, 0.004, 0.219])
    >>> fixed_gain_observer(rates, accel, 0.01, 0.02, mag=mag, heading_gain=0.02)[-1].round(3)
    array([0.105, 0.004, 0.51 ])
    """
    way, share = WAYS[method], np.array(check_gain("gain", gain))
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    field = [] if mag is None else [samples("mag", mag)]
    count = same_length(("body_rates", rates), ("accel", forces), *(("mag", f) for f in field))
    dt = periods(dt, count)
    warn_of_rates(rates, dt, forces, *field)
    step, constants, level = way.step, [share], (1.0, 0.0)
    if field:
        refuse_magnetometer(method)
        level = horizontal("reference", reference)
        step = steps.observer_heading_turn
        constants += map(np.array, (check_gain("heading_gain", heading_gain), *level))
    if initial is None:
        begin, first = first_tilt(forces, "; pass initial to do without")
        if field and count:
            first = with_heading(first, field[0][begin].tolist(), level)
        before = np.full((min(begin + 1, count), 3), np.nan)
        before[begin:] = first
    else:
        before, first = np.empty((0, 3)), canonical("initial", initial)
    rest = slice(len(before), None)
    each = dt[rest] if dt.ndim else dt
    given = (rates[rest], forces[rest], *(array[rest] for array in field), each)
    out = run(step, way.begin(*first), *given, *constants, finish=way.end, before=before)
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

    See Also
    --------
    fixed_gain_observer

    Examples
    --------
    >>> import numpy as np
    >>> rates = np.array([[0, 0, 0], [np.nan, 0, 0], [0, 0, 0]])
    >>> rejected_samples(rates, [[0, 0, -9.8], [0, 0, -9.8], [0, 0, 0]])
    array([False,  True,  True])
    """
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    same_length(("body_rates", rates), ("accel", forces))
    return ~(complete(rates, WILD_RATE) & complete(forces) & forces.any(axis=1))
