"""Velocity and position from an accelerometer whose attitude is known.

The inertial frame is north-east-down.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats, floats, handed_out
from chr_notes._recordings import run
from chr_notes._rows import Rows
from chr_notes._samples import complete, number, periods, same_length, samples, start
from chr_notes._units import warn_of_angles, warn_of_force, warn_of_steps
from chr_notes.conventions import NOTES_GRAVITY, STANDARD_GRAVITY
from chr_notes.generated.arrays import dead_reckoning as generated
from chr_notes.generated.scalar.dead_reckoning import dead_reckoning_held

_inertial_acceleration = Rows(generated.inertial_acceleration)
_accelerometer_from_acceleration = Rows(generated.accelerometer_from_acceleration)
_drift_from_tilt_error = Rows(generated.drift_from_tilt_error)


def inertial_acceleration(
    accel: ArrayLike,
    euler: ArrayLike,
    gravity: ArrayLike = STANDARD_GRAVITY,
    *,
    out: Floats | None = None,
) -> Floats:
    """Turn what an accelerometer reads into the acceleration of the body.

    Parameters
    ----------
    accel
        Specific force in the body frame, in the unit of gravity, shape (..., 3).
    euler
        Roll, pitch, yaw in radians, shape (..., 3).
    gravity
        Magnitude of gravity, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Acceleration north, east, down, in the unit of gravity, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis is not of size 3 or the leading axes do not broadcast.

    See Also
    --------
    accelerometer_from_acceleration
    dead_reckon

    Notes
    -----
    Ledger: dead_reckoning.2.3.

    Examples
    --------
    >>> inertial_acceleration([2.0, 0, -9.80665], [0, 0, 0]).round(6)
    array([2., 0., 0.])
    """
    return _inertial_acceleration.compute(accel, euler, gravity, out)


def accelerometer_from_acceleration(
    acceleration: ArrayLike,
    euler: ArrayLike,
    gravity: ArrayLike = STANDARD_GRAVITY,
    *,
    out: Floats | None = None,
) -> Floats:
    """Tell what an ideal accelerometer reads on a body that accelerates.

    Parameters
    ----------
    acceleration
        North, east, down, in the unit of gravity, shape (..., 3).
    euler
        Roll, pitch, yaw in radians, shape (..., 3).
    gravity
        Magnitude of gravity, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Specific force in the body frame, in the unit of gravity, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis is not of size 3 or the leading axes do not broadcast.

    See Also
    --------
    inertial_acceleration

    Notes
    -----
    Ledger: dead_reckoning.2.1.

    Examples
    --------
    >>> accelerometer_from_acceleration([2.0, 0, 0], [0, 0, 0]).round(3)  # speeding up
    array([ 2.   ,  0.   , -9.807])
    """
    return _accelerometer_from_acceleration.compute(acceleration, euler, gravity, out)


def dead_reckon(  # noqa: PLR0913 (an initial value for each integral)
    accel: ArrayLike,
    euler: ArrayLike,
    dt: ArrayLike,
    *,
    velocity: ArrayLike = (0.0, 0.0, 0.0),
    position: ArrayLike = (0.0, 0.0, 0.0),
    gravity: float = STANDARD_GRAVITY,
    still: ArrayLike | None = None,
) -> tuple[Floats, Floats]:
    """Integrate an accelerometer twice, by the discrete steps of the notes.

    In each step the position goes on by the velocity before it, and the velocity by the
    acceleration. Nothing holds the errors: they grow with time and with its square. `drift_budget`
    says how fast.

    Where the body is known to stand still, such as a foot on the ground, the velocity is zero
    whatever the integral says. What it says instead is an error that has grown since the last
    rest; a constant error of acceleration explains it, and that is taken off all that way.

    Parameters
    ----------
    accel
        Specific force in the body frame, m/s², shape (N, 3), each held for its time step.
    euler
        Roll, pitch, yaw in radians, shape (N, 3).
    dt
        Time step of each sample, seconds: a number, or shape (N,).
    velocity, position
        Before the first step, north, east, down, in m/s and m, shape (3,).
    gravity
        Magnitude of gravity, m/s².
    still
        Whether the body stands still in each sample, shape (N,), as `zero_velocity` says; nothing
        is corrected after the last rest.

    Returns
    -------
    velocity, position
        After each step, each of shape (N, 3). A row with NaN or infinity in the accelerometer or
        attitude comes out as NaN; the next goes on as if the velocity had not changed through it.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative or no number, or a start is not finite.

    Warns
    -----
    UnitWarning
        If the accelerometer, over 100 samples or more, mostly reads less than half or more than
        twice the gravity, as it does in g, or in counts; if the attitude leaves more than a quarter
        of gravity in most of them, and in degrees would leave less than a quarter of that; or most
        time steps are above 1 s, as they are in milliseconds.

    See Also
    --------
    inertial_acceleration
    chr_notes.drift.drift_budget
    chr_notes.zero_velocity.zero_velocity

    Notes
    -----
    Ledger: dead_reckoning.3.3, dead_reckoning.3.4. On a recorded walk with the sensor on a foot,
    41.6 s and back to its start, the end is 17 m off without `still` and 0.4 m with it.

    Examples
    --------
    A bias of 0.1 m/s² for ten seconds, with a rest at either end:

    >>> import numpy as np
    >>> accel = np.tile([0.1, 0.0, -9.80665], (1000, 1))
    >>> dead_reckon(accel, np.zeros((1000, 3)), 0.01)[1][-1].round(2).tolist()
    [5.0, 0.0, 0.0]
    >>> still = np.r_[np.ones(100), np.zeros(800), np.ones(100)]
    >>> position = dead_reckon(accel, np.zeros((1000, 3)), 0.01, still=still)[1]
    >>> bool(np.abs(position[-1]).max() < 1e-9)
    True
    """
    forces, angles = samples("accel", accel), samples("euler", euler)
    count = same_length(("accel", forces), ("euler", angles))
    steps = periods(dt, count)
    begin = np.array(start("velocity", velocity))
    magnitude = number("gravity", gravity)
    warn_of_force(forces, magnitude)
    warn_of_steps(steps, count)
    accelerations = inertial_acceleration(forces, angles, magnitude)
    some = slice(None, None, 1 + count // 2000)
    with np.errstate(under="ignore"):
        as_degrees = np.radians(angles[some])
    by_degrees = inertial_acceleration(forces[some], as_degrees, magnitude)
    warn_of_angles(accelerations[some], by_degrees, magnitude)
    missing = ~complete(accelerations)
    accelerations[missing] = np.nan
    if still is not None:
        resting = _flags("still", still, count)
        begin = np.zeros(3) if resting[:1].any() else begin
        accelerations = _held_at_rest(accelerations, resting, steps, begin)
    state = [*begin.tolist(), *start("position", position)]
    out = run(dead_reckoning_held, state, accelerations, steps)
    out[missing] = np.nan
    return out[:, :3], out[:, 3:]


def _held_at_rest(
    accelerations: Floats, still: NDArray[np.bool_], steps: Floats, velocity: Floats
) -> Floats:
    """Take what leaves a velocity where there is none for an error of acceleration before it."""
    held = np.where(still[:, np.newaxis], 0.0, accelerations)
    known = ~still & complete(accelerations)
    lasts = np.where(known, steps, 0.0)
    edges = np.flatnonzero(np.diff(np.r_[True, still, True]))
    for first, last in edges.reshape(-1, 2):
        if last == len(still):
            break  # no rest comes after
        part = slice(first, last)
        moving = float(lasts[part].sum())
        if moving > 0:
            gained = np.where(known[part, np.newaxis], accelerations[part], 0.0)
            left = (velocity if first == 0 else 0.0) + lasts[part] @ gained
            held[part] -= left / moving
    return held


def _flags(name: str, value: ArrayLike, count: int) -> NDArray[np.bool_]:
    flags = floats(name, value)
    if flags.shape != (count,) or not np.isin(flags, (0, 1)).all():
        msg = f"{name}: expected true or false for each sample, shape ({count},), got {flags.shape}"
        raise ValueError(msg)
    return np.asarray(flags != 0)


def drift_from_tilt_error(
    angle_error: ArrayLike,
    time: ArrayLike,
    gravity: ArrayLike = NOTES_GRAVITY,
    *,
    out: tuple[Floats, Floats, Floats] | None = None,
) -> tuple[Floats, Floats, Floats]:
    """Tell how far dead reckoning goes astray along the ground when the attitude is off.

    Parameters
    ----------
    angle_error
        Constant angle between the true and the estimated vertical, radians, shape (...).
    time
        Since the start, seconds, shape (...).
    gravity
        Magnitude of gravity, m/s², shape (...).
    out
        Arrays for acceleration, velocity and position.

    Returns
    -------
    acceleration, velocity, position
        Errors in m/s², m/s and m, each of shape (...).

    Raises
    ------
    ValueError
        If the arguments do not broadcast.

    See Also
    --------
    chr_notes.drift.drift_budget
    chr_notes.drift.coasting_time

    Notes
    -----
    Ledger: dead_reckoning.4.a, dead_reckoning.4.b, and the cells of Table 1.

    Examples
    --------
    >>> import numpy as np
    >>> acceleration, velocity, position = drift_from_tilt_error(np.radians(1.0), 60.0)
    >>> round(float(position), 1)  # metres after a minute, by one degree
    307.9
    """
    errors = _drift_from_tilt_error(angle_error, time, gravity)
    parts = tuple(np.moveaxis(errors, -1, 0))
    acceleration, velocity, position = handed_out(tuple(map(np.asarray, parts)), out)
    return acceleration, velocity, position
