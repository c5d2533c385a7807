"""Heading from a magnetometer, and a check of roll and pitch against the Earth's field."""

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, at_first, floats
from chr_notes._rows import Rows
from chr_notes.generated.arrays import validation as generated

_heading_from_magnetometer = Rows(
    generated.heading_from_magnetometer, scaled="nothing", spreads=True
)
_validation_factor = Rows(generated.validation_factor, scaled="nothing", spreads=True)
_NORTH = (1.0, 0.0)
_ALONG_NORTH = np.array(_NORTH)


def heading_from_magnetometer(
    mag: ArrayLike,
    tilt: ArrayLike,
    reference: ArrayLike = _NORTH,
    *,
    out: Floats | None = None,
) -> Floats:
    """Tell yaw from a magnetometer once roll and pitch are known.

    Parameters
    ----------
    mag
        Magnetic field in the body frame, any unit, shape (..., 3).
    tilt
        Roll and pitch, radians, shape (..., 2).
    reference
        The Earth's horizontal field, north and east, any unit, shape (..., 2): (1, 0) counts yaw
        from magnetic north, (cos(declination), sin(declination)) from true north.
    out
        An array for the result.

    Returns
    -------
    ndarray
        Yaw in [-pi, pi], radians, shape (...). A field of zero gives NaN; one without horizontal
        part, straight above a magnetic pole, any angle.

    Raises
    ------
    ValueError
        If a last axis has the wrong size, the leading axes do not broadcast, or the reference is
        zero.

    See Also
    --------
    chr_notes.estimation.tilt.tilt_from_accelerometer
    chr_notes.estimation.earth_field.EarthField

    Notes
    -----
    Ledger: validation.12, validation.16.

    Examples
    --------
    >>> import numpy as np
    >>> field = [0.2, -0.2, 0.4]  # level, in any unit
    >>> float(np.degrees(heading_from_magnetometer(field, [0, 0])).round(6))
    45.0
    """
    level = _ALONG_NORTH if reference is _NORTH else floats("reference", reference, 2)
    if level.ndim > 1 or not any(level.tolist()):
        zero = np.asarray(~level.any(axis=-1))
        if zero.any():
            msg = f"reference: expected a horizontal field, got none{at_first(zero)}"
            raise ValueError(msg)
    yaw = _heading_from_magnetometer.compute(mag, tilt, level, out)
    return yaw[()] if out is None else yaw


def validation_factor(
    mag: ArrayLike, tilt: ArrayLike, reference_down: ArrayLike, *, out: Floats | None = None
) -> Floats:
    """Tell by how much the field's part that points down is not what roll and pitch make of it.

    Parameters
    ----------
    mag
        Magnetic field in the body frame, any unit, shape (..., 3); it is divided by its magnitude.
    tilt
        Roll and pitch, radians, shape (..., 2).
    reference_down
        Part down of the Earth's field divided by its magnitude: the sine of the inclination,
        from -1 to 1, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        The factor E, from 0 to 2, shape (...). A field of zero gives NaN.

    Raises
    ------
    ValueError
        If a last axis has the wrong size, the leading axes do not broadcast, or the reference is
        not from -1 to 1.

    See Also
    --------
    chr_notes.estimation.doubt.doubtful_sensors

    Notes
    -----
    Ledger: validation.17.

    Examples
    --------
    >>> import numpy as np
    >>> dip = np.radians(60)
    >>> field = [np.cos(dip), 0, np.sin(dip)]
    >>> float(validation_factor(field, [0, 0], np.sin(dip)).round(6))
    0.0
    >>> tilt = np.radians([0, 10])  # pitch is 10° off
    >>> float(validation_factor(field, tilt, np.sin(dip)).round(3))
    0.1
    """
    factor = _validation_factor.compute(mag, tilt, part_down(reference_down), out)
    return factor[()] if out is None else factor


def part_down(value: ArrayLike) -> Floats:
    """Take the part down of a field of magnitude 1; refuse what is not from -1 to 1."""
    down = floats("reference_down", value)
    beyond = np.asarray(np.abs(down) > 1)
    if beyond.any():
        msg = (
            "reference_down: expected the part down of a field of magnitude 1, from -1 to 1, "
            f"got {down[beyond][0]}{at_first(beyond)}"
        )
        raise ValueError(msg)
    return down
