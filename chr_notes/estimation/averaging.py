"""Attitude by averaging the specific force in a frame that does not turn, over a recording.

The idea is that of D. Laidig and T. Seel, "VQF: Highly accurate IMU orientation estimation with
bias estimation and magnetic disturbance rejection", Information Fusion 91 (2023), 187-204.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._recordings import parts, run
from chr_notes._samples import (
    WILD_RATE,
    complete,
    periods,
    same_length,
    samples,
)
from chr_notes._units import warn_of_rates
from chr_notes.estimation.averaging_bound import averaging_bound
from chr_notes.estimation.averaging_settings import Settings
from chr_notes.estimation.bias import Bias, bias_of
from chr_notes.estimation.calibrated import doubt_of_calibration
from chr_notes.estimation.earth_field import EarthField
from chr_notes.estimation.gyro import attitudes_in_range
from chr_notes.estimation.starts import first_tilt

AVERAGED, HEADING_AVERAGED = 8, 10  # in the state


class Averaged(NamedTuple):
    """What the averaging filter says, of a recording or of one sample of a stream.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (N, 3), or (3,).
    averaged
        Seconds of specific force that the estimate of the vertical stands for, shape (N,): from
        the first sample to `time_constant`. Missing readings and gaps take it back by what the
        body may have turned meanwhile, so that what comes after them counts the more.
    tilt_bound
        Bound of the angle between true and estimated vertical, radians, shape (N,), for a body
        whose speed stays below 1 m/s: `averaging_bound` has it for others. It takes gyro and
        accelerometer to be calibrated; with bias="running" the gyro is so from the first rest on.
    heading_averaged
        The same seconds for the heading, at most `heading_time_constant`: 0 until a magnetometer
        is heard. They fall while it is held out.

    See Also
    --------
    averaged_attitude
    chr_notes.estimation.averaging_stream.observe_averaging
    chr_notes.estimation.averaging_bound.averaging_bound
    """

    euler: Floats
    averaged: Floats | float
    tilt_bound: Floats | float
    heading_averaged: Floats | float


def averaging_observer(  # noqa: PLR0913 (a recording, and how to run through it)
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: ArrayLike,
    *,
    mag: ArrayLike | None = None,
    time_constant: float = 3.0,
    heading_time_constant: float = 9.0,
    bias: Bias = "stillest",
    field: EarthField = EarthField(),  # noqa: B008 (frozen)
    longest_step: float = 0.15,
) -> Floats:
    """Estimate attitude by a mean of the specific force in a frame that does not turn.

    The gyros alone turn the attitude, and with it the specific force is brought to a frame that
    does not turn with the body. There it is the reaction to gravity, which stands still, and the
    true acceleration, whose mean over a time t is the velocity gained divided by t: of a body that
    stays about its place, nothing in the end. A low-pass (Butterworth, second order) takes the
    mean, and the attitude is turned such that the mean points up. Until the low-pass has run in, a
    plain mean stands in. Of the field of a magnetometer, brought to the same frame, the horizontal
    direction corrects yaw, with weights that fall off exponentially.

    A longer time constant averages more true acceleration and noise away, a shorter one less of
    the gyros' error: a bias b tilts the estimate by b times the time constant, noise comes through
    with its variance times dt over twice the time constant, and a body whose speed stays below v
    tilts it by 1.35 v over g times the time constant at most.

    Parameters
    ----------
    body_rates
        Rates p, q, r about the body axes, rad/s, shape (N, 3).
    accel
        Specific force in any unit, shape (N, 3). What is more than 50 times the mean counts as so
        much, and what is less than a quarter of it, as in free fall, is not heard while the gyros
        keep the vertical, which is 14 s at a time constant of 3 s.
    dt
        Time step before each sample, seconds: a number, or shape (N,).
    mag
        Magnetic field, calibrated, in any unit, shape (N, 3). Without it yaw starts at 0 and comes
        from the gyros.
    time_constant, heading_time_constant
        Mean age of what is averaged, seconds.
    bias
        Of the gyros: "stillest" takes off the mean over the stillest two seconds of the
        recording, and so looks ahead; "running" is learnt anew in each rest of two seconds, from
        zero on, and does not; a number or shape (3,), rad/s, is that of a calibration, as
        `fit_gyro_bias` gives it: minus what the gyros read at rest. For rates that are
        calibrated it is 0.
    field
        What is known of the Earth's field, and when a reading of `mag` is held out.
    longest_step
        A longer time step, seconds, is a gap: how the body turned in it nobody knows, and it is
        taken not to have. At an angular acceleration of 3 rad/s² a rate that is held for 0.15 s
        is off by 2° in the end.

    Returns
    -------
    ndarray
        Roll and yaw in [-pi, pi), pitch in [-pi/2, pi/2], after each sample, shape (N, 3). A row
        whose rates hold NaN, or before the first force, comes out as NaN; one whose force does,
        or reads nearly zero, comes out as predicted.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative or no number, most are longer than
        `longest_step`, a constant is not positive, or no accelerometer sample shows a tilt.

    Warns
    -----
    UserWarning
        If the stillest two seconds are not still, or read more than 0.05 rad/s.
    UnitWarning
        As `integrate_gyro`; a gap is no turn. And if accelerometer or magnetometer turn clearly
        better by the rates as °/s: by a quarter of a second, and more than a bias explains.

    See Also
    --------
    averaged_attitude : The same, and how far to trust it.
    chr_notes.estimation.averaging_stream.observe_averaging : The same on a stream.

    Examples
    --------
    A body lies at a roll of 0.2 rad and is shaken by 2 m/s², under gyros with a bias.

    >>> import numpy as np
    >>> from chr_notes import accelerometer_at_rest, fixed_gain_observer
    >>> time = 0.01 * np.arange(3000)
    >>> rates = np.full((3000, 3), 0.01)
    >>> accel = accelerometer_at_rest(np.array([0.2, 0.0, 0.0])) + np.zeros((3000, 3))
    >>> accel[:, 1] += 2 * np.sin(20 * time)
    >>> averaging_observer(rates, accel, 0.01)[-1].round(3) + 0.0
    array([0.2, 0. , 0. ])
    >>> fixed_gain_observer(rates, accel, 0.01, 0.02)[-1].round(3)
    array([0.181, 0.004, 0.353])
    """
    settings = Settings(time_constant, heading_time_constant, bias, field, longest_step)
    found, _ = _run(
        lambda states: attitudes_in_range(states[:, :4]), (body_rates, accel, mag), dt, settings
    )
    return found


def averaged_attitude(  # noqa: PLR0913 (a recording, and how to run through it)
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: ArrayLike,
    *,
    mag: ArrayLike | None = None,
    time_constant: float = 3.0,
    heading_time_constant: float = 9.0,
    bias: Bias = "stillest",
    field: EarthField = EarthField(),  # noqa: B008 (frozen)
    longest_step: float = 0.15,
) -> Averaged:
    """Run `averaging_observer`, and say of each sample how far to trust it.

    The bound takes what is read to be calibrated, as `calibrate_recording` does it: an error of
    the accelerometer tilts the answer, and mostly nothing tells. Where the norm at rest shows one,
    differing by more than 4 % from rest to rest, the bound is widened and a warning says so. So it
    is where there is no rest to take the gyros' bias from: by as much as they read steadily, or by
    the 0.05 rad/s that a cheap one may have.

    Parameters
    ----------
    body_rates, accel, dt, mag, time_constant, heading_time_constant, bias, field, longest_step
        As for `averaging_observer`.

    Returns
    -------
    Averaged
        A row that is NaN for the angles because its rates are missing has numbers for the rest.

    Raises
    ------
    ValueError
        As `averaging_observer`.

    Warns
    -----
    UserWarning
        As `averaging_observer`.
    CalibrationWarning
        If the accelerometer's norm at rest, or the strength of the field, differs by so much that
        they cannot be calibrated.

    See Also
    --------
    chr_notes.sensors.log_calibration.calibrate_recording
    chr_notes.estimation.averaging_stream.observe_averaging
    chr_notes.estimation.averaging_bound.averaging_bound
    chr_notes.estimation.fixed_gain.fixed_gain_observer

    Examples
    --------
    A gap of a second: the estimate goes on, and is hardly to be trusted at first.

    >>> import numpy as np
    >>> dt = np.full(600, 0.01)
    >>> dt[400] = 1.0
    >>> found = averaged_attitude(np.zeros((600, 3)), np.full((600, 3), [0, 0, -9.8]), dt)
    >>> np.degrees(found.tilt_bound[[100, 399, 400, 599]]).round(1)
    array([12.5,  3.5, 35.1,  5.9])
    """
    settings = Settings(time_constant, heading_time_constant, bias, field, longest_step)
    last = HEADING_AVERAGED if mag is not None else AVERAGED

    def finish(states: Floats) -> Floats:
        kept = states[:, [AVERAGED, last]]
        return np.column_stack([attitudes_in_range(states[:, :4]), kept])

    found, bias_left = _run(finish, (body_rates, accel, mag), dt, settings)
    averaged = np.nan_to_num(found[:, 3])
    heading = np.nan_to_num(found[:, 4]) if mag is not None else np.zeros(len(found))
    bound = averaging_bound(averaged, time_constant, bias=bias_left)
    bound = np.minimum(bound + doubt_of_calibration(body_rates, accel, dt, mag), np.pi)
    return Averaged(np.ascontiguousarray(found[:, :3]), averaged, bound, heading)


def _run(
    finish: Callable[[Floats], Floats],
    recording: tuple[ArrayLike, ArrayLike, ArrayLike | None],
    dt: ArrayLike,
    settings: Settings,
) -> tuple[Floats, float]:
    """Run the filter, and give of each state what is wanted of it; NaN before the first force.

    And how much of the gyros' bias may be left, rad/s.
    """
    body_rates, accel, mag = recording
    read = [("body_rates", samples("body_rates", body_rates)), ("accel", samples("accel", accel))]
    if mag is not None:
        read.append(("mag", samples("mag", mag)))
    count = same_length(*read)
    rates, forces, *field = (array for _, array in read)
    dt = _steps(dt, count, settings.longest_step)
    warn_of_rates(rates, dt, forces, *field, longest=settings.longest_step, inner=1)
    begin, tilt = first_tilt(forces)
    ahead = min(begin + 1, count)
    rest = slice(ahead, None)
    at_rest, bias_left = bias_of(settings.bias, rates, forces, dt, settings.longest_step, ahead)
    turning = (
        rates[rest][part] - each for part, each in zip(parts(count - ahead), at_rest, strict=False)
    )
    first = [array[begin] if count else np.zeros(3) for array in (rates, forces, *field)]
    state = settings.begin(tilt, *first, heading=bool(field))
    step, constants = settings.step(heading=bool(field))
    later = (array[rest] for array in (forces, *field))
    each_dt = dt[rest] if dt.ndim else dt
    shown = finish(state[np.newaxis])
    start = np.full((ahead, shown.shape[1]), np.nan)
    start[begin:] = shown
    limits = [np.array(constant) for constant in constants]
    found = run(step, state, turning, *later, each_dt, *limits, finish=finish, before=start)
    found[~complete(rates, WILD_RATE), :3] = np.nan
    return found, bias_left


def _steps(dt: ArrayLike, count: int, longest: float) -> Floats:
    """Take time steps of which most are no gaps."""
    found = periods(dt, count)
    if found.size and np.median(found) > longest:
        msg = (
            f"dt: expected steps of at most longest_step = {longest} s, for how a body turns in a "
            f"longer one no gyro tells, got {np.median(found)} s for half of them and more"
        )
        raise ValueError(msg)
    return found
