"""Calibration of a recording from itself: each step that it allows, and what it lacks for more."""

import warnings
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._samples import complete, lengths
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.estimation.gyro import integrate_gyro
from chr_notes.quaternions.algebra import rotate_to_inertial
from chr_notes.quaternions.conversions import quaternion_from_euler
from chr_notes.sensors.gyro import fit_gyro_at_rest
from chr_notes.sensors.magnetometer import fit_magnetometer
from chr_notes.sensors.poses import fit_accelerometer_from_log
from chr_notes.sensors.recording import Recording, counted
from chr_notes.sensors.still import static_intervals, steady_mean, without_glitches

_SPIKES = {"body_rates": 2.0, "accel": 50.0}  # rad/s and m/s², from the readings before and after
_EDGE = 0.2  # seconds of a rest, at either end, in which the sensor may still be let go
_LEAST_WARMING = 5.0  # °C, over which a bias shows how it goes with temperature
_HELD = 1.0  # seconds over which a gyro says how a field should turn


@dataclass(frozen=True, eq=False)
class CalibratedRecording:
    """A recording, calibrated as far as it allows. `print` says what was done and what was not.

    Parameters
    ----------
    recording
        With the corrected readings; spikes are NaN. Its report is that of the log.
    done
        A sentence for each step that was taken.
    left
        A sentence for each that was not, with what to do for it.

    See Also
    --------
    calibrate_recording
    """

    recording: Recording
    done: tuple[str, ...] = ()
    left: tuple[str, ...] = ()

    @property
    def bias(self) -> float | str:
        """What `averaging_observer` should be told, 0 if the gyro's bias was taken off."""
        return 0.0 if any(each.startswith("gyro at rest:") for each in self.done) else "stillest"

    def __str__(self) -> str:
        """Say it in lines."""
        return "\n".join([f"done: {each}" for each in self.done] + [f"NOT: {e}" for e in self.left])


@dataclass
class _Steps:
    """What is known so far."""

    log: Recording
    rests: list[slice] = field(default_factory=list)
    done: list[str] = field(default_factory=list)
    left: list[str] = field(default_factory=list)

    def take(self, name: str, step: Callable[[], str]) -> None:
        """Take a step, or keep why the log does not allow it, and what it warns of."""
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            try:
                self.done.append(f"{name}: {step()}")
            except ValueError as error:
                self.left.append(f"{name}: {error}")
        for each in said:
            self.done.append(f"{name}: take note: {each.message}")


def calibrate_recording(
    recording: Recording, gravity: float = STANDARD_GRAVITY
) -> CalibratedRecording:
    """Take each step of calibration that a recording allows, and say which it does not.

    Spikes of gyro and accelerometer are taken out, the gyro's bias is found where the sensor lay
    still, with temperature where it is recorded and changes, sensitivity and bias of the
    accelerometer from still poses on six sides, hard and soft iron of the magnetometer from turns
    in all directions. A calibration of the magnetometer is not taken where the strength of the
    field varies more after it, or the field turns less as the gyro says.

    Parameters
    ----------
    recording
        As `read_log` gives it.
    gravity
        At the place, m/s².

    Returns
    -------
    CalibratedRecording

    See Also
    --------
    chr_notes.sensors.logs.read_log
    chr_notes.estimation.averaging.averaged_attitude

    Examples
    --------
    >>> import chr_notes
    >>> log = chr_notes.read_log({"ax_g": [0.0] * 200, "ay_g": [0.0] * 200, "az_g": [1.0] * 200})
    >>> print(calibrate_recording(log))
    NOT: gyro at rest: there is no gyro in the log
    NOT: accelerometer: there is no gyro in the log, so no rests can be told from slow turns
    NOT: magnetometer: there is none in the log, and yaw comes from the gyro alone
    """
    steps = _Steps(recording)
    if recording.body_rates is not None:
        kept = _spikes(steps, "body_rates", recording.body_rates)
        steps.log = replace(steps.log, body_rates=kept)
    if recording.accel is not None:
        steps.log = replace(steps.log, accel=_spikes(steps, "accel", recording.accel))
    rates, accel, dt = steps.log.body_rates, steps.log.accel, steps.log.dt
    if rates is not None and dt is None:
        steps.left.append("all that needs time: the log has none; pass rate= to read_log, in Hz")
    elif rates is not None and accel is not None and dt is not None:
        steps.rests = static_intervals(rates, accel, dt)
    steps.take("gyro at rest", lambda: _gyro(steps))
    steps.take("accelerometer", lambda: _accelerometer(steps, gravity))
    steps.take("magnetometer", lambda: _magnetometer(steps))
    return CalibratedRecording(steps.log, tuple(steps.done), tuple(steps.left))


def _spikes(steps: _Steps, name: str, values: Floats) -> Floats:
    """Make readings NaN that no body can have had."""
    steady, glitches = without_glitches(values)
    with np.errstate(all="ignore"):
        spikes = glitches & (np.abs(values - steady).max(axis=1) > _SPIKES[name])
    if not spikes.any():
        return values
    steps.done.append(f"{name}: {counted(int(spikes.sum()), 'spike')} left out")
    return np.where(spikes[:, np.newaxis], np.nan, values)


def _gyro(steps: _Steps) -> str:
    log = steps.log
    if log.body_rates is None:
        msg = "there is no gyro in the log"
        raise ValueError(msg)
    if not steps.rests or log.dt is None:
        msg = (
            "no rest of a second or more; the observer takes the stillest two seconds for one. Let "
            "the sensor lie for some seconds, first and last"
        )
        raise ValueError(msg)
    edge = round(_EDGE / float(np.median(log.dt)))
    rows = np.concatenate([np.arange(rest.start + edge, rest.stop - edge) for rest in steps.rests])
    warmth = None if log.temperature is None else log.temperature[rows]
    if warmth is not None and not float(np.ptp(warmth[np.isfinite(warmth)])) >= _LEAST_WARMING:
        warmth = None
    found = fit_gyro_at_rest(log.body_rates[rows], warmth, degree=0 if warmth is None else 1)
    known = None if warmth is None else log.temperature
    corrected = found.correct(log.body_rates, np.zeros(3), known)  # at rest no coupling is seen
    taken = np.degrees(np.nanmedian(log.body_rates - corrected, axis=0)).round(2) + 0.0
    steps.log = replace(log, body_rates=corrected)
    how = "one bias for all temperatures" if warmth is None else "a bias that goes with temperature"
    many = counted(len(steps.rests), "rest")
    return f"{how}, from {many}: {taken.tolist()} °/s taken off"


def _accelerometer(steps: _Steps, gravity: float) -> str:
    log = steps.log
    if log.accel is None:
        msg = "there is none in the log, and roll and pitch drift with the gyro"
        raise ValueError(msg)
    if log.body_rates is None or log.dt is None:
        missing = "gyro" if log.body_rates is None else "time"
        msg = f"there is no {missing} in the log, so no rests can be told from slow turns"
        raise ValueError(msg)
    try:
        found = fit_accelerometer_from_log(log.body_rates, log.accel, log.dt, gravity)
    except ValueError as error:
        norms = _at_rest(steps, log.accel)
        span = (
            f"; at rest it reads {norms.min():.2f} to {norms.max():.2f} m/s²" if len(norms) else ""
        )
        msg = f"{error}{span}"
        raise ValueError(msg) from None
    corrected = found.correct(log.accel)
    before, after = _at_rest(steps, log.accel), _at_rest(steps, corrected)
    steps.log = replace(log, accel=corrected)
    return (
        f"at rest it read {before.min():.2f} to {before.max():.2f} m/s², and reads "
        f"{after.min():.2f} to {after.max():.2f} m/s² now"
    )


def _at_rest(steps: _Steps, accel: Floats) -> Floats:
    parts = [accel[rest][complete(accel[rest])] for rest in steps.rests]
    return lengths(np.array([steady_mean(part) for part in parts]).reshape(-1, 3))


def _magnetometer(steps: _Steps) -> str:
    log = steps.log
    if log.mag is None:
        msg = "there is none in the log, and yaw comes from the gyro alone"
        raise ValueError(msg)
    found = fit_magnetometer(log.mag)
    corrected = found.correct(log.mag)
    before, after = _spread(log.mag), _spread(corrected)
    said = f"the strength of the field varied by {before:.1%}, and varies by {after:.1%} now"
    worse = after > before
    if log.body_rates is not None and log.dt is not None:
        before, after = (_misfit(log.body_rates, each, log.dt) for each in (log.mag, corrected))
        said += f"; by the gyro it turned wrongly by {before:.1%} in a second, now by {after:.1%}"
        worse |= after > before
    if worse:
        msg = (
            f"the fit is not taken: {said}. Where the field differs from place to place there is "
            "nothing to gain; else turn the sensor about all axes in one place, away from iron"
        )
        raise ValueError(msg)
    steps.log = replace(log, mag=corrected)
    return said


def _spread(field: Floats) -> float:
    """Half of the width that holds four fifths of the strengths, over their median."""
    low, middle, high = np.nanquantile(lengths(field), [0.1, 0.5, 0.9])
    return float((high - low) / 2 / middle)


def _misfit(rates: Floats, field: Floats, dt: Floats) -> float:
    """By how much a field changes in a second that the gyro has turned back, over its strength."""
    known = np.where(complete(rates)[:, np.newaxis], rates, 0.0)
    attitudes = quaternion_from_euler(integrate_gyro(known, dt))
    still = rotate_to_inertial(attitudes, field)
    rows = max(1, round(_HELD / float(np.median(dt))))
    change = lengths(still[rows:] - still[:-rows]) / np.nanmedian(lengths(field))
    # What comes and goes, such as a spike, has its say up to the strength itself.
    return float(np.sqrt(np.nanmean(np.minimum(change, 1.0) ** 2)))
