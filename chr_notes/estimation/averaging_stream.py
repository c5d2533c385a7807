"""The averaging filter on a stream, sample by sample."""

from collections.abc import Callable, Iterable, Iterator
from math import inf, isfinite
from typing import Any

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._kernels import kernels_in_use, of_arrays, sampled
from chr_notes._samples import one_sample, one_vector, period
from chr_notes._units import warn_of_turn
from chr_notes.estimation.averaging import AVERAGED, HEADING_AVERAGED, Averaged
from chr_notes.estimation.averaging_bound import BIAS, SPEED
from chr_notes.estimation.averaging_settings import Settings
from chr_notes.estimation.bias import REST, Bias, check_bias
from chr_notes.estimation.earth_field import EarthField
from chr_notes.estimation.fixed_gain import WAYS
from chr_notes.estimation.streams import Sample, parts
from chr_notes.generated.scalar.estimation import averaging_bound as bound
from chr_notes.generated.scalar.estimation import bias_at_rest, tilt_from_accelerometer
from chr_notes.generated.scalar.quaternions import euler_from_quaternion


def observe_averaging(  # noqa: PLR0913 (as for a recording)
    stream: Iterable[Sample],
    *,
    time_constant: float = 3.0,
    heading_time_constant: float = 9.0,
    bias: Bias = "running",
    field: EarthField = EarthField(),  # noqa: B008 (frozen)
    longest_step: float = 0.15,
) -> Iterator[Averaged]:
    """Run `averaging_observer` on a stream, sample by sample.

    Parameters
    ----------
    stream
        Body rates (3,), specific force (3,) and time step of each sample, as they come, and after
        them the magnetic field (3,) where there is a magnetometer: in each sample, or in none.
    time_constant, heading_time_constant, field, longest_step
        As for `averaging_observer`.
    bias
        As there, and with the same one the numbers are the same. "stillest" looks ahead, and is
        refused.

    Yields
    ------
    Averaged
        After each sample from the first force on. A sample without rates is taken for one that
        stood still.

    Raises
    ------
    ValueError
        As for `averaging_observer`, when the sample comes.

    Warns
    -----
    UnitWarning
        If a sample turns by more than half a revolution within its time step.

    See Also
    --------
    chr_notes.estimation.averaging.averaged_attitude
    chr_notes.estimation.streams.observe

    Examples
    --------
    >>> import numpy as np
    >>> sample = np.zeros(3), np.array([0.0, -2.0, -9.6]), 0.01
    >>> *_, last = observe_averaging([sample] * 500)
    >>> last.euler.round(3) + 0.0, float(last.averaged)
    (array([0.205, 0.   , 0.   ]), 3.0)
    """
    settings = Settings(time_constant, heading_time_constant, bias, field, longest_step)
    checked = check_bias(bias)
    if isinstance(checked, str) and checked != "running":
        msg = f'bias: expected "running" or numbers for a stream, got {bias!r}, which looks ahead'
        raise ValueError(msg)
    return _observed(stream, settings, None if isinstance(checked, str) else checked)


def _observed(
    stream: Iterable[Sample], settings: Settings, given: Floats | None
) -> Iterator[Averaged]:
    # A bias that is given is known at first, and never learnt.
    known, rest = (np.zeros(3), REST) if given is None else (given, inf)
    longest, constant = float(settings.longest_step), float(settings.time_constant)
    fast, learn, angles = kernels_in_use(), of_arrays(bias_at_rest), WAYS["quaternion"].angles
    learnt, spare = np.concatenate([np.zeros(7), known]), np.empty(10)
    at_rest, next_at_rest, turning = learnt[7:], spare[7:], np.empty(3)
    quick: Callable[..., Any] | None = None
    state, constants = np.empty(0), tuple[float, ...]()
    last, most, fields = inf, 0.0, 0
    for body_rates, accel, dt, field in map(parts, stream):
        rates, force, step = body_rates, accel, dt
        found = learn(learnt, rates, force, step, rest, longest, spare) if fast else None
        if found is None:
            rates, force = one_vector("body_rates", rates), one_vector("accel", force)
            step = period(dt)
            learn(learnt, rates, force, step, rest, longest, spare)
        learnt, spare, at_rest, next_at_rest = spare, learnt, next_at_rest, at_rest
        np.subtract(rates, at_rest, turning)
        if len(state) and len(field) != fields:
            msg = "stream: expected a magnetic field in each sample or in none, got both"
            raise ValueError(msg)
        euler = None
        if quick is not None:
            euler = quick(state, turning, force, *field, step, *constants)
        if euler is None or euler is False:
            step = period(dt)
            force = one_vector("accel", force)
            mag = (one_vector("mag", field[0]),) if field else ()
            warn_of_turn(one_sample("body_rates", rates), step, longest)
            if not len(state):
                tilt = tilt_from_accelerometer(*force.tolist())
                if not isfinite(tilt[0]):
                    continue
                state = settings.begin((*tilt, 0.0), turning, force, *mag, heading=bool(field))
                fields = len(field)
                generated, constants = settings.step(heading=bool(field))
                quick, advance = sampled(generated, euler_from_quaternion), of_arrays(generated)
            elif euler is None:
                state = advance(state, turning, force, *mag, step, *constants, None)
            euler = angles(state[:4].tolist())
        averaged = state.item(AVERAGED)
        heading = state.item(HEADING_AVERAGED) if field else 0.0
        if averaged != last:  # once it has run in, it is the same each time
            last, most = averaged, bound(averaged, constant, SPEED, BIAS)
        yield Averaged(euler, averaged, most, heading)
