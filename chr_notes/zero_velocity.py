"""When a body stands still for a moment, such as a foot on the ground."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._samples import WILD_RATE, complete, lengths, periods, positive, same_length, samples
from chr_notes._units import warn_of_force
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.sensors.still import window_sums


def zero_velocity(  # noqa: PLR0913 (three thresholds)
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: ArrayLike,
    *,
    window: float = 0.1,
    rate_limit: float = 0.6,
    force_limit: float = 0.1,
    gravity: float = STANDARD_GRAVITY,
) -> NDArray[np.bool_]:
    """Say when a body stands still, from rates that are low and a force that is gravity's.

    This is for short rests, as of a foot between two steps; a foot on the ground rolls a little,
    so the limits are far above noise. `static_intervals` finds rests of a second and more.

    Parameters
    ----------
    body_rates
        rad/s, shape (N, 3), the bias taken off.
    accel
        Specific force, in the unit of gravity, shape (N, 3).
    dt
        Time step before each sample, seconds: a number, or shape (N,).
    window
        Seconds over which both are averaged.
    rate_limit
        Largest root mean square of the rate, rad/s.
    force_limit
        Largest root mean square of the force's magnitude less gravity, over gravity.
    gravity
        Its magnitude.

    Returns
    -------
    ndarray
        Shape (N,), False where a row is missing.

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
    chr_notes.dead_reckoning.dead_reckon
    chr_notes.sensors.still.static_intervals

    Notes
    -----
    Both limits are those of Skog, Händel, Nilsson and Rantakokko, Zero-velocity detection, an
    algorithm evaluation, 2010, applied one by one. A slow ride at constant speed cannot be told
    from rest. On a recorded walk any rate limit from 0.3 to 1.5 rad/s leaves the end between 0.2
    and 0.9 m off, where it is 5 to 18 m off without rests.

    Examples
    --------
    >>> import numpy as np
    >>> rates = np.zeros((300, 3))
    >>> rates[100:200, 1] = 3.0
    >>> still = zero_velocity(rates, np.tile([0, 0, -9.8], (300, 1)), 0.01)
    >>> np.flatnonzero(~still)[[0, -1]].tolist()
    [96, 204]
    """
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    count = same_length(("body_rates", rates), ("accel", forces))
    steps = np.broadcast_to(periods(dt, count), (count,))
    for name, limit in (
        ("window", window),
        ("rate_limit", rate_limit),
        ("force_limit", force_limit),
        ("gravity", gravity),
    ):
        positive(name, limit)
    warn_of_force(forces, float(gravity))
    if not count:
        return np.zeros(0, dtype=np.bool_)
    usual = float(np.median(steps))
    width = min(count, max(1, round(min(window / usual, count)))) if usual > 0 else 1
    known = complete(rates, WILD_RATE) & complete(forces, WILD_RATE)
    whole = np.where(known, 1.0, 0.0)
    turning = lengths(np.where(known[:, np.newaxis], rates, 0.0))
    sizes = lengths(np.where(known[:, np.newaxis], forces, 0.0))
    with np.errstate(all="ignore"):
        pushed = np.where(known, sizes / gravity - 1, 0.0)
        mean_turning, mean_pushed = (_around(part**2, whole, width) for part in (turning, pushed))
    return known & (mean_turning <= rate_limit**2) & (mean_pushed <= force_limit**2)


def _around(
    values: NDArray[np.float64], whole: NDArray[np.float64], width: int
) -> NDArray[np.float64]:
    """Average over a window around each row, of the rows that are there."""
    before, after = width // 2, (width - 1) // 2
    total, rows = (window_sums(np.pad(part, (before, after)), width) for part in (values, whole))
    return np.asarray(total / np.maximum(rows, 1.0))
