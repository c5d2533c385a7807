"""Motions of which everything is known, and what ideal sensors read along them.

A `Curve` is a smooth function of time with its exact first and second derivatives. Three
of them for the angles and three for the position make a `Trajectory`, from which readings follow
without any numerical differentiation. `chr_notes.sensors.simulated` spoils them.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes._samples import per_axis, same_length, start, times
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.dead_reckoning import accelerometer_from_acceleration
from chr_notes.euler import body_rates_from_euler_rates, matrix_from_euler


class Curve(NamedTuple):
    """Three smooth functions of time, with exact derivatives.

    Parameters
    ----------
    value, first, second
        The functions and their first and second derivatives, each of shape (N, 3).
    """

    value: Floats
    first: Floats
    second: Floats


@dataclass(frozen=True, eq=False)
class Trajectory:
    """The true motion of a body.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    euler
        Roll, pitch, yaw in radians, smooth in time, so pitch may pass 90°, shape (N, 3).
    body_rates
        p, q, r in rad/s, shape (N, 3).
    position, velocity, acceleration
        North, east, down, in m, m/s and m/s², each of shape (N, 3).
    """

    time: Floats
    euler: Floats
    body_rates: Floats
    position: Floats
    velocity: Floats
    acceleration: Floats


@dataclass(frozen=True, eq=False)
class Readings:
    """What the three sensors read.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    body_rates
        Of the gyros, rad/s, shape (N, 3).
    accel
        Specific force, m/s², shape (N, 3).
    mag
        Magnetic field in the unit of the reference field, shape (N, 3).
    """

    time: Floats
    body_rates: Floats
    accel: Floats
    mag: Floats


def at_rest(time: ArrayLike, value: ArrayLike = (0.0, 0.0, 0.0)) -> Curve:
    """Stay at one value.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    value
        Shape (3,).

    Raises
    ------
    ValueError
        If a shape is wrong, the times do not rise or a number is not finite.
    """
    still = np.zeros((len(times(time)), 3))
    return Curve(still + start("value", value), still, still.copy())


def swing(  # noqa: PLR0913 (a sine and a line have five numbers)
    time: ArrayLike,
    amplitude: ArrayLike,
    frequency: ArrayLike,
    phase: ArrayLike = 0.0,
    *,
    offset: ArrayLike = 0.0,
    slope: ArrayLike = 0.0,
) -> Curve:
    """Swing as a sine about a straight line.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    amplitude
        Of each of the three functions, shape (3,) or a number for all.
    frequency
        Hz, shape (3,) or a number.
    phase
        Radians, shape (3,) or a number.
    offset, slope
        The line: its value at time 0 and its derivative, shape (3,) or a number.

    Notes
    -----
    Sums of swings are `Curve(*(a + b for a, b in zip(first, second)))`.
    """
    seconds = times(time)[:, np.newaxis]
    names = ("amplitude", "frequency", "phase", "offset", "slope")
    height, hertz, start, base, climb = (
        per_axis(name, value)
        for name, value in zip(names, (amplitude, frequency, phase, offset, slope), strict=True)
    )
    rate = 2 * np.pi * hertz
    angle = rate * seconds + start
    return Curve(
        base + climb * seconds + height * np.sin(angle),
        climb + rate * height * np.cos(angle),
        -(rate**2) * height * np.sin(angle),
    )


def minimum_jerk(time: ArrayLike, stops: ArrayLike, values: ArrayLike) -> Curve:
    """Go from stop to stop, at rest at each, by the smoothest polynomial of fifth order.

    Before the first stop and after the last the value stays. Two equal values make a pause.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    stops
        Seconds, rising, shape (K,), K at least 2.
    values
        At the stops, shape (K, 3).

    Raises
    ------
    ValueError
        If a shape is wrong or the stops do not rise.
    """
    seconds, knots, targets = times(time), floats("stops", stops), floats("values", values, 3)
    if knots.ndim != 1 or len(knots) < 2 or targets.shape != (len(knots), 3):  # noqa: PLR2004
        msg = (
            "expected stops of shape (K,), K at least 2, and values of shape (K, 3), "
            f"got {knots.shape} and {targets.shape}"
        )
        raise ValueError(msg)
    if not (np.diff(knots) > 0).all():
        msg = f"stops: expected rising times, got {knots.tolist()}"
        raise ValueError(msg)
    leg = np.clip(np.searchsorted(knots, seconds, side="right") - 1, 0, len(knots) - 2)
    lasts = np.diff(knots)[leg][:, np.newaxis]
    way = np.diff(targets, axis=0)[leg]
    # Share of the time of the leg that has passed, held before the first and after the last stop
    s = np.clip((seconds[:, np.newaxis] - knots[leg][:, np.newaxis]) / lasts, 0.0, 1.0)
    return Curve(
        targets[leg] + way * s**3 * (10 - 15 * s + 6 * s**2),
        way / lasts * 30 * s**2 * (1 - s) ** 2,
        way / lasts**2 * 60 * s * (1 - s) * (1 - 2 * s),
    )


def trajectory(time: ArrayLike, attitude: Curve, motion: Curve) -> Trajectory:
    """Put a motion together from angles and positions.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    attitude
        Roll, pitch, yaw, radians.
    motion
        Position north, east, down, m.

    Raises
    ------
    ValueError
        If the curves have not as many rows as there are times.

    Notes
    -----
    Ledger: euler.7.a.
    """
    seconds = times(time)
    same_length(("time", seconds), ("attitude", attitude.value), ("motion", motion.value))
    return Trajectory(
        time=seconds,
        euler=attitude.value,
        body_rates=body_rates_from_euler_rates(attitude.value, attitude.first),
        position=motion.value,
        velocity=motion.first,
        acceleration=motion.second,
    )


def ideal_readings(
    truth: Trajectory, field: ArrayLike = (20.0, 0.0, 45.0), gravity: float = STANDARD_GRAVITY
) -> Readings:
    """Tell what sensors without any error read.

    Parameters
    ----------
    truth
        The motion.
    field
        Magnetic field north, east, down, any unit, shape (3,), or (N, 3) where it changes; the
        default is near that of Europe in microtesla.
    gravity
        Magnitude of gravity, m/s².

    Raises
    ------
    ValueError
        If the field has another shape.

    Notes
    -----
    Ledger: dead_reckoning.2.1.
    """
    to_body = matrix_from_euler(truth.euler)
    outside = floats("field", field, 3)
    if outside.shape not in ((3,), truth.euler.shape):
        msg = f"field: expected shape (3,) or {truth.euler.shape}, got {outside.shape}"
        raise ValueError(msg)
    return Readings(
        time=truth.time,
        body_rates=truth.body_rates,
        accel=accelerometer_from_acceleration(truth.acceleration, truth.euler, gravity),
        mag=(to_body @ outside[..., np.newaxis])[..., 0],
    )
