"""The averaging filter on a stream, sample by sample."""

from collections.abc import Iterable, Iterator
from math import inf, isfinite, pi

from chr_notes._kernels import of_numbers
from chr_notes._samples import one_sample, period
from chr_notes._units import warn_of_turn
from chr_notes.estimation.averaging import AVERAGED, HEADING_AVERAGED, Averaged
from chr_notes.estimation.averaging_bound import BIAS, SPEED
from chr_notes.estimation.averaging_settings import Settings
from chr_notes.estimation.bias import REST, Bias, check_bias
from chr_notes.estimation.earth_field import EarthField
from chr_notes.estimation.fixed_gain import way_of
from chr_notes.estimation.streams import Sample
from chr_notes.generated.scalar import estimation as steps


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
    return _observed(stream, settings, None if isinstance(checked, str) else checked.tolist())


def _observed(
    stream: Iterable[Sample], settings: Settings, given: float | list[float] | None
) -> Iterator[Averaged]:
    rest = (REST, float(settings.longest_step))
    constant = float(settings.time_constant)
    learn, angles = of_numbers(steps.bias_at_rest), way_of("quaternion").angles
    p, q, r = given if isinstance(given, list) else [given or 0.0] * 3
    learnt, state = (0.0,) * 10, None
    last, most = inf, 0.0
    for body_rates, accel, dt, *field in stream:
        rates, force = one_sample("body_rates", body_rates), one_sample("accel", accel)
        mag = one_sample("mag", field[0]) if field else ()
        step = period(dt)
        if not sum(map(abs, rates)) * step < pi:
            warn_of_turn(rates, step, rest[1])
        if given is None:
            learnt = learn(*learnt, *rates, *force, step, *rest)
            p, q, r = learnt[7:]
        sample = (rates[0] - p, rates[1] - q, rates[2] - r, *force, *mag)
        if state is None:
            tilt = steps.tilt_from_accelerometer(*force)
            if not isfinite(tilt[0]):
                continue
            state = settings.begin((*tilt, 0.0), sample, heading=bool(field))
            generated, constants = settings.step(heading=bool(field))
            advance = of_numbers(generated)
        else:
            state = advance(*state, *sample, step, *constants)
        averaged = state[AVERAGED]
        heading = state[HEADING_AVERAGED] if field else 0.0
        if averaged != last:  # once it has run in, it is the same each time
            last, most = averaged, steps.averaging_bound(averaged, constant, SPEED, BIAS)
        yield Averaged(angles(state[:4]), averaged, most, heading)
