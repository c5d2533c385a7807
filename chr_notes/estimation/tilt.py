"""Roll and pitch from an accelerometer at rest."""

from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.generated.arrays import estimation as generated
from chr_notes.generated.arrays import sensors

_tilt_from_accelerometer = Rows(generated.tilt_from_accelerometer, scaled="nothing")
_accelerometer_at_rest = Rows(sensors.accelerometer_at_rest)


def tilt_from_accelerometer(accel: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Tell roll and pitch from which way an accelerometer at rest reads gravity.

    Only the direction of the reading counts, so that a wrong scale or more than one g on the
    same line does no harm. A reading of zero, as in free fall, has no direction: it gives NaN, as
    does one with NaN or infinity.
    Straight up or down roll is not determined, and 0.

    Parameters
    ----------
    accel
        Specific force in any unit, shape (..., 3); level and at rest it is (0, 0, -g).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Roll in (-pi, pi] and pitch in [-pi/2, pi/2], radians, shape (..., 2).

    Raises
    ------
    ValueError
        If the last axis is not of size 3.

    See Also
    --------
    accelerometer_at_rest

    Notes
    -----
    Ledger: estimation.2.5, estimation.2.6, validation.3, validation.4.

    Examples
    --------
    >>> import numpy as np
    >>> np.degrees(tilt_from_accelerometer([4.903, -1.475, -8.364])).round(2)  # roll and pitch
    array([10., 30.])
    """
    return _tilt_from_accelerometer.compute(accel, out)


def accelerometer_at_rest(
    euler: ArrayLike, gravity: ArrayLike = STANDARD_GRAVITY, *, out: Floats | None = None
) -> Floats:
    """Tell what an ideal accelerometer reads at rest.

    Parameters
    ----------
    euler
        Roll, pitch, yaw in radians, shape (..., 3); yaw does not matter.
    gravity
        Magnitude of gravity, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Specific force in the unit of gravity, shape (..., 3).

    Raises
    ------
    ValueError
        If the last axis is not of size 3 or the leading axes do not broadcast.

    See Also
    --------
    tilt_from_accelerometer

    Notes
    -----
    Ledger: estimation.2.4, sensors.2.2, sensors.2.c.

    Examples
    --------
    >>> import numpy as np
    >>> accelerometer_at_rest(np.radians([10, 30, 0])).round(3)  # nose up, right wing down
    array([ 4.903, -1.475, -8.364])
    """
    return _accelerometer_at_rest.compute(euler, gravity, out)
