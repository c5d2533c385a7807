"""The fixed-gain observer, a complementary filter, on a stream, sample by sample.

A sample with NaN or infinity, or with a rate of 1e12 rad/s and more, which no gyro reads, is held
out, and the estimate goes on without it.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from math import hypot, inf, isfinite, pi
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._kernels import sampled
from chr_notes._samples import WILD_RATE, horizontal, one_sample, period, start
from chr_notes._units import warn_of_turn
from chr_notes.estimation.fixed_gain import (
    WAYS,
    Method,
    angles_in_range,
    is_in_range,
    refuse_magnetometer,
)
from chr_notes.estimation.starts import canonical, check_gain, with_heading
from chr_notes.generated.scalar import estimation as steps
from chr_notes.generated.scalar.quaternions import euler_from_quaternion


def observe_sample(  # noqa: PLR0913 (a state and a sample)
    euler: ArrayLike,
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: float,
    gain: float,
    *,
    method: Method = "quaternion",
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
    method
        As for `fixed_gain_observer`.

    Returns
    -------
    ndarray
        Roll, pitch, yaw after it, radians, shape (3,).

    Raises
    ------
    ValueError
        As `fixed_gain_observer`.

    Warns
    -----
    UnitWarning
        If the sample turns by more than half a revolution within its time step.

    See Also
    --------
    observe
    chr_notes.estimation.fixed_gain.fixed_gain_observer

    Examples
    --------
    >>> import numpy as np
    >>> euler = observe_sample([0, 0, 0], [0.1, 0, 0], [0, 0, -9.8], dt=0.01, gain=0.02)
    >>> np.degrees(euler).round(4)
    array([0.0561, 0.    , 0.    ])
    """
    way = WAYS[method]
    # The usual case is looked at here: to call another function takes as long as to see it, and
    # so does to compare a float with an integer.
    share = gain if type(gain) is float and 0.0 <= gain <= 1.0 else check_gain("gain", gain)
    step = dt if type(dt) is float and 0.0 <= dt < inf else period(dt)
    take = way.quick_sample
    if take is not None:
        found = take(euler, body_rates, accel, step, share, None)
        # Of what is not usual, of several samples, or a start that is no attitude, the rest says.
        if type(found) is np.ndarray and found.ndim == 1 and is_in_range(*found.tolist()):
            return found
    roll, pitch, yaw = before = one_sample("euler", euler)
    p, q, r = rates = one_sample("body_rates", body_rates)
    x, y, z = force = one_sample("accel", accel)
    if not (isfinite(roll + pitch + yaw) and hypot(p, q, r) * step < pi):
        start("euler", euler)
        warn_of_turn(rates, step)
    if take is None:
        return angles_in_range(way.sample(roll, pitch, yaw, p, q, r, x, y, z, step, share))
    found = take(before, rates, force, step, share, None)
    return angles_in_range(found[0] if isinstance(found, tuple) else found)


Sample = tuple[ArrayLike, ArrayLike, float] | tuple[ArrayLike, ArrayLike, float, ArrayLike]
"""Of a stream: body rates, specific force and time step, and the field of a magnetometer."""
_PARTS = _ALONE, _WITH_FIELD = 3, 4
_NEW = tuple.__new__  # of Estimate, in half the time of Estimate(...)


class Estimate(NamedTuple):
    """What an observer says after a sample.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (3,).
    held_out
        How many samples so far had a reading that was left out: one that holds NaN or infinity,
        or an accelerometer that reads zero.

    See Also
    --------
    observe
    observe_sample
    """

    euler: Floats
    held_out: int


def observe(  # noqa: PLR0913 (as for a recording)
    stream: Iterable[Sample],
    gain: float,
    initial: ArrayLike | None = None,
    *,
    method: Method = "quaternion",
    heading_gain: float = 1.0,
    reference: ArrayLike = (1.0, 0.0),
) -> Iterator[Estimate]:
    """Run the fixed-gain observer, a complementary filter, on a stream, sample by sample.

    Parameters
    ----------
    stream
        Body rates (3,), specific force (3,) and time step of each sample, as they come, and after
        them the magnetic field (3,) where there is a magnetometer. One that reads none, zero or
        NaN, leaves yaw to the gyros, and is not counted as held out.
    gain, initial, method, heading_gain, reference
        As for `fixed_gain_observer`, which gives the same numbers. Without an initial attitude
        nothing comes out before the first sample whose accelerometer shows a tilt.

    Yields
    ------
    Estimate
        After each sample. One without rates is predicted to stay as it was.

    Raises
    ------
    ValueError
        As for `fixed_gain_observer`; of a sample when it comes.

    Warns
    -----
    UnitWarning
        If a sample turns by more than half a revolution within its time step.

    See Also
    --------
    observe_sample
    chr_notes.estimation.fixed_gain.fixed_gain_observer

    Examples
    --------
    >>> import numpy as np
    >>> stream = [([0, 0, 0.1], [0, -1.0, -9.8], 0.01)] * 3
    >>> for estimate in observe(stream, gain=0.02):
    ...     print(np.degrees(estimate.euler).round(3))
    [5.826 0.    0.   ]
    [ 5.826 -0.006  0.057]
    [ 5.826 -0.011  0.114]

    A level body whose nose points east, in a field that points north and down:

    >>> sample = [0, 0, 0], [0, 0, -9.8], 0.01, [0, -20, 40]
    >>> for estimate in observe([sample] * 2, 0.02, heading_gain=0.02):
    ...     print(estimate.euler.round(4) + 0.0)
    [0.     0.     1.5708]
    [0.     0.     1.5708]
    """
    way, level = WAYS[method], horizontal("reference", reference)
    gains = check_gain("gain", gain), check_gain("heading_gain", heading_gain)
    state = None if initial is None else way.begin(*canonical("initial", initial))
    run = _by_numbers if way.quick_advance is None else _by_kernels
    return run(stream, method, state, (*gains, *level))


def _by_numbers(
    stream: Iterable[Any],
    method: Method,
    state: Sequence[float] | None,
    constants: Sequence[float],
) -> Iterator[Estimate]:
    heading: Callable[..., tuple[float, ...]] = steps.observer_heading_turn
    way, share, incomplete = WAYS[method], constants[0], 0
    turn, angles, by_angles = way.step, way.angles, method == "euler"
    for sample in stream:
        mag: Sequence[float] = ()
        if len(sample) == _ALONE:
            body_rates, accel, dt = sample
        else:
            body_rates, accel, dt, (field,) = parts(sample)
            refuse_magnetometer(method)
            mag = one_sample("mag", field)
        p, q, r = rates = one_sample("body_rates", body_rates)
        x, y, z = force = one_sample("accel", accel)
        step = dt if type(dt) is float and 0.0 <= dt < inf else period(dt)
        size = hypot(p, q, r)
        if not (z and isfinite(x + y + z) and size < WILD_RATE and size * step < pi):
            incomplete += _is_left_out(rates, force)
            warn_of_turn(rates, step)
        if state is None:
            first = _first(force, mag, constants)
            if first is None:
                continue
            state = way.begin(*first)
        elif mag:
            state = heading(*state, *rates, *force, *mag, step, *constants)
        elif by_angles:
            state = turn(*state, *rates, *force, step, share)
        else:  # as above, where arguments take a while to be put together
            a, b, c, d = state
            state = turn(a, b, c, d, p, q, r, x, y, z, step, share)
        yield _NEW(Estimate, (angles(state), incomplete))


def _by_kernels(
    stream: Iterable[Sample],
    method: Method,
    begin: Sequence[float] | None,
    constants: Sequence[float],
) -> Iterator[Estimate]:
    way, incomplete = WAYS[method], 0
    alone: Any = way.quick_advance, constants[:1]
    with_mag: Any = sampled(steps.observer_heading_turn, euler_from_quaternion), constants
    state = None if begin is None else np.array(begin)
    for sample in stream:
        body_rates, accel, dt, field = parts(sample)
        advance, own = with_mag if field else alone
        euler = None if state is None else advance(state, body_rates, accel, *field, dt, *own)
        if euler is None or euler is False:
            rates, force = one_sample("body_rates", body_rates), one_sample("accel", accel)
            mag, step = [one_sample("mag", each) for each in field], period(dt)
            incomplete += _is_left_out(rates, force)
            warn_of_turn(rates, step)
            if state is None:
                first = _first(force, mag[0] if mag else (), constants)
                if first is None:
                    continue
                state, euler = np.array(way.begin(*first)), False
            elif euler is None:
                euler = advance(state, rates, force, *mag, step, *own)
            euler = way.angles(state.tolist()) if euler is False else euler
        yield _NEW(Estimate, (euler, incomplete))


def _is_left_out(rates: Sequence[float], force: Sequence[float]) -> bool:
    """Say whether a reading is none: it holds NaN or infinity, is wild, or a force of zero."""
    return not (hypot(*rates) < WILD_RATE and any(force) and all(map(isfinite, force)))


def _first(
    force: Sequence[float], mag: Sequence[float], constants: Sequence[float]
) -> tuple[float, float, float] | None:
    """Find the Euler angles that a first sample shows, if it shows a tilt."""
    roll, pitch = steps.tilt_from_accelerometer(*force)
    if not isfinite(roll):
        return None
    _, _, north, east = constants
    return with_heading((roll, pitch, 0.0), mag, (north, east)) if mag else (roll, pitch, 0.0)


def parts(sample: Sample) -> tuple[ArrayLike, ArrayLike, float, Sequence[ArrayLike]]:
    """Take a sample of a stream apart: rates, force, time step, and one field or none.

    Raises
    ------
    ValueError
        If it has fewer parts or more.
    """
    if len(sample) not in _PARTS:
        msg = (
            "stream: expected samples of body rates, specific force, time step and perhaps a "
            f"magnetic field, got one of {len(sample)} parts"
        )
        raise ValueError(msg)
    body_rates, accel, dt, *field = sample
    return body_rates, accel, dt, field
