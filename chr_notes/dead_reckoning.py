"""Velocity and position from an accelerometer whose attitude is known.

The inertial frame is north-east-down.
"""

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._recordings import run
from chr_notes._rows import Rows, handed_out
from chr_notes._samples import complete, number, periods, same_length, samples, start
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

    Notes
    -----
    Ledger: dead_reckoning.2.3.
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

    Notes
    -----
    Ledger: dead_reckoning.2.1.
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
) -> tuple[Floats, Floats]:
    """Integrate an accelerometer twice, by the discrete steps of the notes.

    In each step the position goes on by the velocity before it, and the velocity by the
    acceleration. Nothing holds the errors: they grow with time and with its square.

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

    Returns
    -------
    velocity, position
        After each step, each of shape (N, 3). A row with NaN or infinity in the accelerometer or
        attitude comes out as NaN; the next goes on as if the velocity had not changed through it.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative or no number, or a start is not finite.

    Notes
    -----
    Ledger: dead_reckoning.3.3, dead_reckoning.3.4.
    """
    forces, angles = samples("accel", accel), samples("euler", euler)
    count = same_length(("accel", forces), ("euler", angles))
    state = [*start("velocity", velocity), *start("position", position)]
    accelerations = inertial_acceleration(forces, angles, number("gravity", gravity))
    missing = ~complete(accelerations)
    accelerations[missing] = np.nan
    out = run(dead_reckoning_held, state, accelerations, periods(dt, count))
    out[missing] = np.nan
    return out[:, :3], out[:, 3:]


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

    Notes
    -----
    Ledger: dead_reckoning.4.a, dead_reckoning.4.b, and the cells of Table 1.
    """
    errors = _drift_from_tilt_error(angle_error, time, gravity)
    parts = tuple(np.moveaxis(errors, -1, 0))
    acceleration, velocity, position = handed_out(tuple(map(np.asarray, parts)), out)
    return acceleration, velocity, position
