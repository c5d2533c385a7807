"""Heading from a magnetometer, and a check of roll and pitch against the Earth's field."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats, common_shape, components, evaluate, floats
from chr_notes.generated.arrays import validation as generated


def heading_from_magnetometer(
    mag: ArrayLike, tilt: ArrayLike, reference: ArrayLike = (1.0, 0.0)
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

    Notes
    -----
    Ledger: validation.12, validation.13, validation.14, validation.15, validation.16.
    """
    field, angles = direction(mag), floats("tilt", tilt, 2)
    level = np.asarray(floats("reference", reference, 2), dtype=np.float64)
    zero = np.asarray(~level.any(axis=-1))
    if zero.any():
        msg = f"reference: expected a horizontal field, got none at {_first(zero)}"
        raise ValueError(msg)
    out = np.empty(common_shape(("mag", field, 1), ("tilt", angles, 1), ("reference", level, 1)))
    given = [*components(field), *components(angles), *components(level)]
    evaluate(generated.heading_from_magnetometer, given, [out])
    return out[()]


def validation_factor(mag: ArrayLike, tilt: ArrayLike, reference_down: ArrayLike) -> Floats:
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

    Returns
    -------
    ndarray
        The factor E, from 0 to 2, shape (...). A field of zero gives NaN.

    Raises
    ------
    ValueError
        If a last axis has the wrong size, the leading axes do not broadcast, or the reference is
        not from -1 to 1.

    Notes
    -----
    Ledger: validation.17, validation.d, validation.f, validation.g.
    """
    field, angles = direction(mag), floats("tilt", tilt, 2)
    down = part_down(reference_down)
    shape = common_shape(("mag", field, 1), ("tilt", angles, 1), ("reference_down", down, 0))
    out = np.empty(shape)
    given = [*components(field), *components(angles), down]
    evaluate(generated.validation_factor, given, [out])
    return out[()]


def direction(mag: ArrayLike) -> Floats:
    """Scale readings so that no square overflows or vanishes; a reading of zero gives NaN."""
    field = np.asarray(floats("mag", mag, 3), dtype=np.float64)
    with np.errstate(invalid="ignore"):
        return np.asarray(field / np.max(np.abs(field), axis=-1, keepdims=True))


def part_down(value: ArrayLike) -> Floats:
    """Take the part down of a field of magnitude 1; refuse what is not from -1 to 1."""
    down = np.asarray(floats("reference_down", value), dtype=np.float64)
    beyond = np.asarray(np.abs(down) > 1)
    if beyond.any():
        msg = (
            "reference_down: expected the part down of a field of magnitude 1, from -1 to 1, "
            f"got {down[beyond][0]} at {_first(beyond)}"
        )
        raise ValueError(msg)
    return down


def _first(where: NDArray[np.bool_]) -> str:
    """Name the first place where something holds."""
    return f"index {tuple(map(int, np.argwhere(where)[0]))}" if where.ndim else "the only one"
