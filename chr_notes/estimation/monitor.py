"""A watch over the factor E that adapts an observer's gain first, and raises an alarm after."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats
from chr_notes._recordings import run
from chr_notes._rows import Rows
from chr_notes._samples import WILD_RATE, complete, number, periods, same_length, samples
from chr_notes._units import warn_of_rates
from chr_notes.estimation.fixed_gain import WAYS
from chr_notes.estimation.gyro import attitudes_in_range
from chr_notes.estimation.starts import check_gain, first_tilt
from chr_notes.generated.arrays import validation as generated
from chr_notes.generated.scalar.validation import monitor_count, monitor_gain, monitored_turn
from chr_notes.validation import part_down, validation_factor

_monitor_gain = Rows(generated.monitor_gain)


@dataclass(frozen=True)
class Monitor:
    """Rules by which E is watched.

    While E is above the threshold, the gain first goes to the upper end of its range, so that the
    accelerometer pulls back an estimate that the gyros have led astray. If that does not help in
    time, it goes to the lower end, so that an accelerometer that vibrates is heard less. If that
    does not help either, there is an alarm. As soon as E falls to the threshold, all is as usual.

    This is the paper's rule. On no trial of the BROAD data set that was tried does it help an
    observer of gain 0.02: E rises where the accelerometer is accelerated, and the first answer is
    to hear it more. Roll and pitch of three trials, slow rotation, fast rotation, and fast
    translation, are 0.75°, 2.1° and 24° off without it, and 0.75°, 2.4° and 32° with a threshold
    of 0.1 and a patience of 10 samples. `accelerated` says when to hold the accelerometer out
    instead, and `doubtful_sensors` which sensor lies.

    Parameters
    ----------
    threshold
        Of E, positive.
    patience
        Samples in a row for which each of the two gains is tried, at least 1.
    gain
        As long as E is not above the threshold, and once there is an alarm.
    lowest, highest
        The range of the gain; the paper takes 0.01 to 0.07.

    Raises
    ------
    ValueError
        If the threshold or the patience is not positive, or the gains are not in order.

    See Also
    --------
    monitored_observer

    Notes
    -----
    Ledger: validation.17, validation.g.
    """

    threshold: float
    patience: int
    gain: float = 0.02
    lowest: float = 0.01
    highest: float = 0.07

    def __post_init__(self) -> None:
        """Check the rules."""
        if not self.threshold > 0:
            msg = f"threshold: expected a positive number, got {self.threshold}"
            raise ValueError(msg)
        if not (self.patience >= 1 and self.patience == int(self.patience)):
            msg = f"patience: expected a whole number of samples, 1 or more, got {self.patience}"
            raise ValueError(msg)
        for name in ("gain", "lowest", "highest"):
            check_gain(name, getattr(self, name))
        if not self.lowest <= self.gain <= self.highest:
            msg = (
                "expected lowest <= gain <= highest, "
                f"got {self.lowest}, {self.gain} and {self.highest}"
            )
            raise ValueError(msg)

    def begin(self) -> "Watch":
        """Give what holds before the first sample."""
        return Watch(0, self.gain, alarm=False)

    def watch(self, before: "Watch", factor: float) -> "Watch":
        """Judge one more sample.

        Parameters
        ----------
        before
            What held so far.
        factor
            E of the sample; NaN tells nothing, and all stays as it was.

        Returns
        -------
        Watch
            With the gain to use for the next sample.
        """
        above = int(monitor_count(before.above, factor, self.threshold))
        gain = monitor_gain(above, self.patience, self.gain, self.lowest, self.highest)
        return Watch(above, gain, alarm=above > 2 * self.patience)


class Watch(NamedTuple):
    """What a monitor says after a sample.

    Parameters
    ----------
    above
        For how many samples in a row E has been above the threshold.
    gain
        To use for the next sample.
    alarm
        Whether no gain has helped.

    See Also
    --------
    Monitor
    monitored_observer
    """

    above: int
    gain: float
    alarm: bool


class Monitored(NamedTuple):
    """What a monitored observer says.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (N, 3).
    factor
        E, shape (N,).
    gain
        That each sample was corrected by, shape (N,).
    alarm
        Shape (N,).

    See Also
    --------
    monitored_observer
    """

    euler: Floats
    factor: Floats
    gain: Floats
    alarm: NDArray[np.bool_]


def monitored_observer(  # noqa: PLR0913 (three sensors, and what they are measured against)
    body_rates: ArrayLike,
    accel: ArrayLike,
    mag: ArrayLike,
    dt: ArrayLike,
    *,
    reference_down: float,
    monitor: Monitor,
) -> Monitored:
    """Run the fixed-gain observer with the gain that a monitor of E asks for.

    Parameters
    ----------
    body_rates, accel, dt
        As for `fixed_gain_observer`.
    mag, reference_down
        As for `validation_factor`, mag of shape (N, 3).
    monitor
        The rules.

    Returns
    -------
    Monitored
        A row without rates has NaN for its angles, one without field for E, and a row before the
        first tilt for both.

    Raises
    ------
    ValueError
        As for the two functions.

    Warns
    -----
    UnitWarning
        As `integrate_gyro`.

    See Also
    --------
    chr_notes.estimation.fixed_gain.fixed_gain_observer
    chr_notes.validation.validation_factor
    chr_notes.estimation.doubt.doubtful_sensors

    Notes
    -----
    Ledger: validation.10, validation.11, validation.17.

    Examples
    --------
    >>> import numpy as np
    >>> from chr_notes import Monitor
    >>> rates, accel = np.zeros((300, 3)), np.tile([0, 0, -9.8], (300, 1))
    >>> mag = np.tile([0.5, 0, 0.866], (300, 1))
    >>> mag[200:] = [0.866, 0, 0.5]  # iron comes near
    >>> monitor = Monitor(threshold=0.1, patience=20)
    >>> found = monitored_observer(rates, accel, mag, 0.01, reference_down=0.866, monitor=monitor)
    >>> int(found.alarm.argmax())
    240
    """
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    field = samples("mag", mag)
    count = same_length(("body_rates", rates), ("accel", forces), ("mag", field))
    down = part_down(number("reference_down", reference_down))
    dt = periods(dt, count)
    warn_of_rates(rates, dt, forces, field)
    begin, first = first_tilt(forces)
    watch = monitor.begin()
    if begin < count:
        factor = validation_factor(field[begin], first[:2], down)
        watch = monitor.watch(watch, float(factor))
    rest = slice(begin + 1, None)
    rules = (monitor.threshold, monitor.patience, monitor.gain, monitor.lowest, monitor.highest)
    before = np.full((min(begin + 1, count), 4), np.nan)
    before[:, 3], before[begin:] = 0.0, (*first, watch.above)
    found = run(
        monitored_turn,
        (*WAYS["quaternion"].begin(*first), float(watch.above)),
        *(rates[rest], forces[rest], field[rest], dt[rest] if dt.ndim else dt, down),
        *map(np.array, map(float, rules)),
        finish=_angles_and_count,
        before=before,
    )
    euler, above = np.ascontiguousarray(found[:, :3]), found[:, 3]
    factors = validation_factor(field, euler[:, :2], down)
    gains = _monitor_gain(np.r_[0.0, above[:-1]], *rules[1:])
    alarms = above > 2 * monitor.patience
    euler[~complete(rates, WILD_RATE)] = np.nan
    return Monitored(euler, factors, gains, alarms)


def _angles_and_count(states: Floats) -> Floats:
    """Take from states, shape (N, 5), Euler angles, and how many samples E has been too high."""
    found = np.empty((len(states), 4))
    found[:, :3], found[:, 3] = attitudes_in_range(states[:, :4]), states[:, 4]
    return found
