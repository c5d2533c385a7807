"""Which sensor to hold out: the accelerometer, the magnetometer, or the attitude itself."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats
from chr_notes._samples import complete, lengths, number, periods, positive, same_length, samples
from chr_notes._units import warn_of_force
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.estimation.earth_field import TOLERANCE
from chr_notes.validation import part_down, validation_factor

_LIMIT = 0.5  # of gravity


class Doubts(NamedTuple):
    """What is not to be trusted, sample by sample.

    Parameters
    ----------
    accel
        The accelerometer reads more than gravity, or did a moment ago, shape (N,).
    mag
        The field has another strength, or another direction while roll and pitch are good.
    attitude
        The field has another direction, its strength is right, and roll and pitch have come from
        the gyros for a moment: so they are wrong.

    See Also
    --------
    doubtful_sensors
    """

    accel: NDArray[np.bool_]
    mag: NDArray[np.bool_]
    attitude: NDArray[np.bool_]


def accelerated(
    accel: ArrayLike,
    dt: ArrayLike,
    *,
    limit: float = _LIMIT,
    patience: float = 1.0,
    gravity: float = STANDARD_GRAVITY,
) -> NDArray[np.bool_]:
    """Say when an accelerometer shows more than gravity, and is better held out.

    A body that is shaken reads gravity's magnitude now and then, on its way from more to less. So
    the accelerometer is held out for a while after each reading that is off. The while is the
    rule: holding out only the readings that are off makes an observer worse, since those that
    are left have the right length and a wrong direction.

    Parameters
    ----------
    accel
        Specific force, in the unit of gravity, shape (N, 3).
    dt
        Time step before each sample, seconds: a number, or shape (N,).
    limit
        Of the magnitude less gravity, over gravity.
    patience
        Seconds after the last such reading.
    gravity
        Its magnitude.

    Returns
    -------
    ndarray
        Shape (N,). A missing row says nothing.

    Raises
    ------
    ValueError
        If a shape is wrong, a time step is negative, or a limit is not positive.

    Warns
    -----
    UnitWarning
        If the accelerometer mostly reads less than half or more than twice the gravity, as in g.

    See Also
    --------
    doubtful_sensors

    Notes
    -----
    Figures on three trials of the BROAD data set, roll and pitch of the fixed-gain observer with
    gain 0.02 at 95 Hz, bias removed: slow rotation 0.75° root mean square with and 0.75° without
    this rule, fast rotation 2.0° and 2.1°, fast translation 9.2° and 24°; with gain 0.005 the last
    is 1.5° and 14°. A false alarm holds out 2 % of the slow rotation and nothing at rest. A limit
    of 0.3 for half a second brings the fast translation to 1.2° and the fast rotation to 2.4°.
    `averaging_observer` needs no such rule.

    On a simulated swing with noise a sideways push of 1.5 g, as a sine of 1, 2 or 5 Hz, is noticed
    after 0.14, 0.07 and 0.03 s. A steady one is noticed at once above 1.12 g, and below it never:
    together with gravity it is not yet half of gravity too long.

    Examples
    --------
    >>> import numpy as np
    >>> accel = np.tile([0, 0, -9.8], (500, 1))
    >>> accel[100:120] = [12, 0, -9.8]
    >>> np.flatnonzero(accelerated(accel, 0.01))[[0, -1]].tolist()
    [100, 219]
    >>> heard = np.where(accelerated(accel, 0.01)[:, np.newaxis], np.nan, accel)
    """
    forces, pull = samples("accel", accel), positive("gravity", gravity)
    warn_of_force(forces, pull)
    return _accelerated(forces, dt, limit, patience, pull)


def _accelerated(
    forces: Floats, dt: ArrayLike, limit: float, patience: float, pull: float
) -> NDArray[np.bool_]:
    sizes = lengths(np.where(complete(forces)[:, np.newaxis], forces, pull))
    off = complete(forces) & (np.abs(sizes - pull) > positive("limit", limit) * pull)
    return _lasting(off, periods(dt, len(forces)), patience)


def doubtful_sensors(  # noqa: PLR0913 (what is known of the field, and three limits)
    accel: ArrayLike,
    mag: ArrayLike,
    euler: ArrayLike,
    dt: ArrayLike,
    *,
    strength: float,
    reference_down: float,
    factor_limit: float = TOLERANCE,
    strength_limit: float = 0.2,
    patience: float = 1.0,
    gravity: float = STANDARD_GRAVITY,
) -> Doubts:
    """Tell which sensor lies when the factor E or a magnitude says that one does.

    E compares the field with roll and pitch, and does not say which of them is wrong. The
    magnitudes do: an accelerometer that reads more than gravity is accelerated, a magnetometer
    that reads another strength is near iron. If both are right, roll and pitch are to blame where
    the accelerometer had to be held out a moment ago, and the field where it was heard all along.

    Parameters
    ----------
    accel, dt, gravity
        As for `accelerated`, whose limit counts.
    mag
        Calibrated field, any unit, shape (N, 3).
    euler
        The estimated attitude, radians, shape (N, 3); yaw does not matter.
    strength
        Of the Earth's field in the unit of mag.
    reference_down
        Its part down over its strength, from -1 to 1.
    factor_limit
        Of E, the same as the tolerance of an `EarthField`.
    strength_limit
        Of the field's magnitude less its strength, over its strength.
    patience
        Seconds for which doubt lasts.

    Returns
    -------
    Doubts

    Raises
    ------
    ValueError
        As for `accelerated` and `validation_factor`.

    See Also
    --------
    accelerated
    chr_notes.estimation.monitor.monitored_observer

    Notes
    -----
    The limits follow from false alarms: on the three trials by the true attitude, in 99 of 100
    samples in motion E stays below 0.094 and the strength within 0.13. There is no delay, since
    one sample is enough; but what grows slowly is noticed when it has reached a limit. In a field
    of 20 µT north and 45 µT down, iron that adds along either is noticed at 10 to 12 µT. East or
    west it adds at a right angle, which neither E nor strength notices below 25 µT: heading is 51°
    off by then. For magnitude and E tell as much as the horizontal part h and the part down; iron e
    across lengthens h to √(h² + e²), and an E of 0.1, which roll and pitch may cause, lets that be
    1.6 h. Ledger: validation.17.

    Examples
    --------
    >>> import numpy as np
    >>> accel, mag = np.tile([0, 0, -9.8], (500, 1)), np.tile([20.0, 0, 45], (500, 1))
    >>> mag[200:250, 2] += 30
    >>> level = np.zeros((500, 3))
    >>> down = 45 / np.hypot(20, 45)
    >>> found = doubtful_sensors(accel, mag, level, 0.01, strength=49.2, reference_down=down)
    >>> [int(each.sum()) for each in found]
    [0, 150, 0]
    """
    forces, field, angles = samples("accel", accel), samples("mag", mag), samples("euler", euler)
    count = same_length(("accel", forces), ("mag", field), ("euler", angles))
    steps = periods(dt, count)
    whole, known = positive("strength", strength), complete(field)
    down = part_down(number("reference_down", reference_down))
    pull = positive("gravity", gravity)
    warn_of_force(forces, pull)
    shaken = _accelerated(forces, steps, _LIMIT, patience, pull)
    sizes = lengths(np.where(known[:, np.newaxis], field, 0.0))
    iron = known & (np.abs(sizes - whole) > positive("strength_limit", strength_limit) * whole)
    factor = np.asarray(validation_factor(field, angles[:, :2], down))
    turned = known & (factor > positive("factor_limit", factor_limit)) & ~iron
    # What the gyros alone have led astray is pulled back no faster than that.
    unheard = _lasting(shaken, steps, _RECOVERY * patience)
    return Doubts(
        accel=shaken,
        mag=_lasting(iron | (turned & ~unheard), steps, patience),
        attitude=turned & unheard,
    )


_RECOVERY = 3.0  # times the patience, until an observer has come back to the vertical


def _lasting(off: NDArray[np.bool_], steps: Floats, patience: float) -> NDArray[np.bool_]:
    """Keep true for a while after the last true sample."""
    wait = positive("patience", patience) * (1 + 1e-9)
    with np.errstate(all="ignore"):
        time = np.cumsum(np.broadcast_to(steps, off.shape))
        last = np.maximum.accumulate(np.where(off, time, -np.inf)) if len(off) else time
        return np.asarray(time - last < wait)
