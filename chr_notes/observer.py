"""The fixed-gain observer, over a recording or on a stream.

A sample with NaN or infinity, or with a rate of 1e12 rad/s and more, which no gyro reads, is held
out, and the estimate goes on without it.
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats, components
from chr_notes._loops import run
from chr_notes._samples import WILD_RATE, held_out, number, one_sample, periods, same_length, start
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
        Roll, pitch, yaw before the first time step, radians, shape (3,). Without it, the estimate
        starts at the first sample whose accelerometer shows a tilt, with that and a yaw of 0.

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
    samples_held_out : The rows of which something was left out.
    observe : The same on a stream.

    Notes
    -----
    Ledger: estimation.4.1, estimation.4.2, estimation.4.3, estimation.4.4, validation.10,
    validation.11.
    """
    rates, missing = held_out("body_rates", body_rates, WILD_RATE)
    forces, _ = held_out("accel", accel)
    count = same_length(("body_rates", rates), ("accel", forces))
    tilt = tilt_from_accelerometer(forces)
    steps = periods(dt, count)
    begin, first = first_tilt(tilt) if initial is None else (0, canonical("initial", initial))
    out = np.full((count, 3), np.nan)
    out[begin:] = in_range(_observe(first, rates[begin:], tilt[begin:], steps[begin:], gain))
    out[missing] = np.nan
    return out


def samples_held_out(body_rates: ArrayLike, accel: ArrayLike) -> NDArray[np.bool_]:
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
    rates, missing = held_out("body_rates", body_rates, WILD_RATE)
    forces, _ = held_out("accel", accel)
    same_length(("body_rates", rates), ("accel", forces))
    return np.asarray(missing | np.isnan(tilt_from_accelerometer(forces)[:, 0]))


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
    rates = one_sample("body_rates", body_rates, WILD_RATE)
    tilt = tilt_from_accelerometer(one_sample("accel", accel))
    after = _step(canonical("euler", euler), rates, tilt, dt, gain)
    return np.asarray(in_range(after)[0])


class Estimate(NamedTuple):
    """What an observer says after a sample.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (3,).
    held_out
        How many samples so far had a reading that was left out: one that holds NaN or infinity,
        or an accelerometer that reads zero.
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
    check_gain("gain", gain)
    state = None if initial is None else canonical("initial", initial)
    incomplete = 0
    for body_rates, accel, dt in stream:
        rates = one_sample("body_rates", body_rates, WILD_RATE)
        tilt = tilt_from_accelerometer(one_sample("accel", accel))
        incomplete += bool(np.isnan(rates[0]) or np.isnan(tilt[0]))
        if state is None:
            if np.isnan(tilt[0]):
                continue
            _, state = first_tilt(tilt[np.newaxis])
        # Angles go on past half a turn, as within a recording, so that no digit differs.
        after = _step(state, rates, tilt, dt, gain)
        state = after[0].tolist()
        yield Estimate(in_range(after)[0], incomplete)


def first_tilt(tilt: Floats) -> tuple[int, list[float]]:
    """Find the first tilt that is known.

    Parameters
    ----------
    tilt
        Roll and pitch, shape (N, 2).

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
    if not len(tilt):
        return 0, [0.0, 0.0, 0.0]
    known = ~np.isnan(tilt[:, 0])
    first = int(np.argmax(known))
    if not known[first]:
        msg = "accel: expected a sample that shows a tilt to start from, got none; pass initial"
        raise ValueError(msg)
    return first, [*tilt[first].tolist(), 0.0]


def canonical(name: str, euler: ArrayLike) -> list[float]:
    """Take an attitude to start from, with pitch in [-pi/2, pi/2] and roll and yaw in [-pi, pi).

    Corrections go towards a tilt that is in these ranges, so the start has to be too.
    """
    return list(in_range(np.array([start(name, euler)]))[0].tolist())


def _observe(first: list[float], rates: Floats, tilt: Floats, steps: Floats, gain: float) -> Floats:
    inputs = [*components(rates), *components(tilt), steps]
    return run(loops.fixed_gain_observer, first, (check_gain("gain", gain),), inputs)


def _step(first: list[float], rates: Floats, tilt: Floats, dt: float, gain: float) -> Floats:
    steps = periods(number("dt", dt), 1)
    return _observe(first, rates[np.newaxis], tilt[np.newaxis], steps, gain)


def check_gain(name: str, gain: float) -> float:
    """Take a gain; refuse one that is not from 0 to 1."""
    checked = number(name, gain)
    if not 0 <= checked <= 1:
        msg = f"{name}: expected a number from 0 to 1, got {checked}"
        raise ValueError(msg)
    return checked
