"""A watch over the factor E that adapts an observer's gain first, and raises an alarm after."""

from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats
from chr_notes._samples import WILD_RATE, complete, number, periods, same_length, samples
from chr_notes.generated.scalar.validation import validation_factor
from chr_notes.observer import check_gain, first_tilt, way_of
from chr_notes.validation import part_down

if TYPE_CHECKING:
    from collections.abc import Callable


@dataclass(frozen=True)
class Monitor:
    """Rules by which E is watched.

    While E is above the threshold, the gain first goes to the upper end of its range, so that the
    accelerometer pulls back an estimate that the gyros have led astray. If that does not help in
    time, it goes to the lower end, so that an accelerometer that vibrates is heard less. If that
    does not help either, there is an alarm. As soon as E falls to the threshold, all is as usual.

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
        if not self.patience >= 1:
            msg = f"patience: expected at least 1 sample, got {self.patience}"
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
        if np.isnan(factor):
            return before
        above = before.above + 1 if factor > self.threshold else 0
        if above == 0 or above > 2 * self.patience:
            return Watch(above, self.gain, alarm=above > 0)
        gain = self.highest if above <= self.patience else self.lowest
        return Watch(above, gain, alarm=False)


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

    Notes
    -----
    Ledger: validation.10, validation.11, validation.17.
    """
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    field = samples("mag", mag)
    count = same_length(("body_rates", rates), ("accel", forces), ("mag", field))
    down = float(part_down(number("reference_down", reference_down)))
    steps = np.broadcast_to(periods(dt, count), count)
    way = way_of("quaternion")
    judge: Callable[..., float] = validation_factor
    begin, first = first_tilt(forces)
    state, watch = way.begin(*first), monitor.begin()
    euler, factors = np.full((count, 3), np.nan), np.full(count, np.nan)
    gains, alarms = np.full(count, watch.gain), np.full(count, watch.alarm)
    given = zip(rates.tolist(), forces.tolist(), field.tolist(), steps.tolist(), strict=True)
    for sample, (turning, force, flux, step) in enumerate(islice(given, begin, None), begin):
        gains[sample] = watch.gain
        if sample > begin:
            state = way.advance(*state, *turning, *force, step, watch.gain)
        euler[sample] = angles = way.angles(state).tolist()
        factors[sample] = factor = judge(*flux, *angles[:2], down)
        watch = monitor.watch(watch, factor)
        alarms[sample] = watch.alarm
    euler[~complete(rates, WILD_RATE)] = np.nan
    return Monitored(euler, factors, gains, alarms)
