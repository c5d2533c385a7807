"""The fixed-gain observer, over a recording or on a stream.

A sample with NaN or infinity is held out, and the estimate goes on without it.
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, components, floats
from chr_notes._loops import run
from chr_notes._samples import complete, held_out, periods, same_length, start
from chr_notes.estimation import in_range, tilt_from_accelerometer
from chr_notes.generated.loops import estimation as loops


def fixed_gain_observer(
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: ArrayLike,
    gain: float,
    initial: ArrayLike | None = None,
) -> Floats:
    """Predict by the gyros, and correct roll and pitch by the accelerometer.

    Each sample moves the prediction towards the tilt that the accelerometer shows, by the gain
    times the difference; the difference of rolls goes the shorter way round. Yaw comes from the
    gyros alone.

    Within 15° of straight up or down two things are done otherwise, because the rates of the
    angles grow without bound there, and roll and yaw turn about nearly the same axis: the
    prediction is an exact turn, and a correction of roll changes yaw so that the body keeps its
    heading.

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
        Roll, pitch, yaw before the first time step, radians, shape (3,). Without it, the tilt of
        the first accelerometer sample, and a yaw of 0.

    Returns
    -------
    ndarray
        Roll and yaw in [-pi, pi), pitch in [-pi/2, pi/2], after each sample, shape (N, 3). A row
        whose rates hold NaN comes out as NaN; one whose accelerometer does, or reads zero, comes
        out as predicted.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative or no number, the gain is not from 0 to 1,
        the initial attitude is not finite, or no accelerometer sample can stand in for it.

    Notes
    -----
    Ledger: estimation.4.1, estimation.4.2, estimation.4.3, estimation.4.4, validation.10,
    validation.11.
    """
    rates, missing = held_out("body_rates", body_rates)
    forces, _ = held_out("accel", accel)
    count = same_length(("body_rates", rates), ("accel", forces))
    tilt = tilt_from_accelerometer(forces)
    first = first_attitude(tilt) if initial is None else start("initial", initial)
    out = _observe(first, rates, tilt, periods(dt, count), gain)
    out[missing] = np.nan
    return out


def observe_sample(
    euler: ArrayLike, body_rates: ArrayLike, accel: ArrayLike, dt: float, gain: float
) -> Floats:
    """Take one step of `fixed_gain_observer`.

    Parameters
    ----------
    euler
        Roll, pitch, yaw before the time step, radians, shape (3,).
    body_rates, accel
        One sample each, shape (3,). What holds NaN is left out.
    dt
        Time step, seconds.
    gain
        L, from 0 to 1; it may differ from sample to sample.

    Returns
    -------
    ndarray
        Roll, pitch, yaw after it, radians, shape (3,).

    Raises
    ------
    ValueError
        As `fixed_gain_observer`.
    """
    rates, _ = held_out("body_rates", floats("body_rates", body_rates, 3)[np.newaxis])
    force, _ = held_out("accel", floats("accel", accel, 3)[np.newaxis])
    tilt = tilt_from_accelerometer(force)
    return np.asarray(_observe(start("euler", euler), rates, tilt, periods(dt, 1), gain)[0])


class Estimate(NamedTuple):
    """What an observer says after a sample.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (3,).
    held_out
        How many samples so far held NaN in a reading, which was left out.
    """

    euler: Floats
    held_out: int


def observe(
    stream: Iterable[tuple[ArrayLike, ArrayLike, float]],
    gain: float,
    initial: ArrayLike | None = None,
) -> Iterator[Estimate]:
    """Run the fixed-gain observer on a stream, sample by sample.

    Parameters
    ----------
    stream
        Body rates (3,), specific force (3,) and time step of each sample, as they come.
    gain, initial
        As for `fixed_gain_observer`, which gives the same numbers. Without an initial attitude
        nothing comes out before the first sample whose accelerometer shows a tilt.

    Yields
    ------
    Estimate
        After each sample. One without rates is predicted to stay as it was.

    Raises
    ------
    ValueError
        As for `fixed_gain_observer`, when the sample comes.
    """
    euler = None if initial is None else np.array(start("initial", initial))
    incomplete = 0
    for body_rates, accel, dt in stream:
        incomplete += not (np.isfinite(body_rates).all() and np.isfinite(accel).all())
        if euler is None:
            tilt = tilt_from_accelerometer(accel)
            if not np.isfinite(tilt).all():
                continue
            euler = np.array([*tilt, 0.0])
        euler = observe_sample(euler, body_rates, accel, dt, gain)
        yield Estimate(euler, incomplete)


def first_attitude(tilt: Floats) -> list[float]:
    """Take the first tilt that is known, with a yaw of 0.

    Parameters
    ----------
    tilt
        Roll and pitch, shape (N, 2).

    Raises
    ------
    ValueError
        If there are samples and none shows a tilt.
    """
    known = np.flatnonzero(complete(tilt))
    if len(tilt) and not known.size:
        msg = "accel: expected a sample that shows a tilt to start from, got none; pass initial"
        raise ValueError(msg)
    return [*tilt[known[0]].tolist(), 0.0] if len(tilt) else [0.0, 0.0, 0.0]


def _observe(first: list[float], rates: Floats, tilt: Floats, steps: Floats, gain: float) -> Floats:
    check_gain("gain", gain)
    inputs = [*components(rates), *components(tilt), steps]
    return in_range(run(loops.fixed_gain_observer, first, (float(gain),), inputs))


def check_gain(name: str, gain: float) -> None:
    """Refuse a gain that is not from 0 to 1."""
    if not 0 <= gain <= 1:
        msg = f"{name}: expected a number from 0 to 1, got {gain}"
        raise ValueError(msg)
