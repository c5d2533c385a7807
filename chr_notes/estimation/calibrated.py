"""Whether readings show that they are not calibrated, and what that adds to a bound."""

import warnings

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._samples import complete, lengths, samples
from chr_notes._units import ENOUGH
from chr_notes.errors import CalibrationWarning
from chr_notes.sensors.still import static_intervals, steady_mean

_REST = 0.02  # of the norm at rest, by which it may lie on either side of the middle
_FIELD = 0.15  # of the strength, in which four fifths of the readings of a field may lie
_ALL_AXES = np.sqrt(3.0)  # the norm shows the error of one axis, and three may have it


def doubt_of_calibration(
    body_rates: ArrayLike, accel: ArrayLike, dt: ArrayLike, mag: ArrayLike | None
) -> float:
    """Warn of readings that are not calibrated by what they show, and say how far that may tilt.

    Returns
    -------
    float
        Radians; 0 where the norm at rest hardly differs, or there are not two rests.

    Warns
    -----
    CalibrationWarning
        If the norm of the accelerometer at rest, or that of the field, differs too much.
    """
    forces, tilt = samples("accel", accel), 0.0
    parts = [forces[rest] for rest in static_intervals(body_rates, forces, dt)]
    means = [steady_mean(part[complete(part)]) for part in parts]
    norms = lengths(np.array(means).reshape(-1, 3))
    if len(norms) > 1 and norms.min() > 0:
        off = float(np.ptp(norms) / (norms.max() + norms.min()))
        if off > _REST:
            tilt = float(_ALL_AXES * off)
            warnings.warn(
                f"accel: expected one norm at rest, got {norms.min():.4g} to {norms.max():.4g}: "
                f"calibrate it; the bound is widened by {np.degrees(tilt):.1f}°",
                CalibrationWarning,
                stacklevel=3,
            )
    if mag is not None:
        field = samples("mag", mag)
        field = field[complete(field)]
        if len(field) >= ENOUGH:
            low, middle, high = np.quantile(lengths(field), [0.1, 0.5, 0.9])
            if high - low > 2 * _FIELD * middle:
                warnings.warn(
                    f"mag: expected a field of one strength, got mostly {low:.4g} to {high:.4g}: "
                    "calibrate it, or there is iron; the heading is not to be trusted",
                    CalibrationWarning,
                    stacklevel=3,
                )
    return tilt
