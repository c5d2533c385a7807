"""Terms of sensors' models: checked when a model is made, and told at a temperature."""

import warnings

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats

_BEYOND = 0.1  # of the span of temperatures
_SINGULAR = 1e-12  # smallest singular value over the largest


def keep(calibration: object, name: str, value: Floats) -> None:
    """Keep a checked array as a field."""
    # A frozen dataclass sets its fields so. Nobody may change what has been checked.
    value.setflags(write=False)
    object.__setattr__(calibration, name, value)


def finite(name: str, value: ArrayLike, *shape: int) -> Floats:
    """Take finite numbers of a shape, as a copy."""
    array = np.array(floats(name, value, *shape), dtype=np.float64)
    if array.ndim != len(shape):
        msg = f"{name}: expected shape {shape}, got {array.shape}"
        raise ValueError(msg)
    if not np.isfinite(array).all():
        msg = f"{name}: expected finite numbers, got {array.tolist()}"
        raise ValueError(msg)
    return array


def invertible(name: str, value: ArrayLike) -> Floats:
    """Take a matrix that has an inverse."""
    matrix = finite(name, value, 3, 3)
    singular = np.linalg.svd(matrix, compute_uv=False)
    if not singular[-1] > _SINGULAR * singular[0]:
        msg = f"{name}: expected an invertible matrix, got a singular one: {matrix.tolist()}"
        raise ValueError(msg)
    return matrix


def polynomial(name: str, value: ArrayLike) -> Floats:
    """Take coefficients by power of temperature and axis, shape (n, 3)."""
    array = floats(name, value)
    if array.ndim not in (1, 2) or array.shape[-1] != 3 or not array.size:  # noqa: PLR2004 (axes)
        msg = f"{name}: expected shape (3,) or (n, 3), got {array.shape}"
        raise ValueError(msg)
    return np.atleast_2d(finite(name, array, *array.shape))


def refuse_zeros(sensitivity: Floats, where: str = "") -> None:
    """Refuse a sensitivity of zero along an axis."""
    for axis, name in enumerate("xyz"):
        if not (sensitivity[..., axis] != 0).all():
            msg = f"sensitivity: expected no zeros, got one on the {name}-axis{where}"
            raise ValueError(msg)


def at(
    sensitivity: Floats,
    bias: Floats,
    temperature: ArrayLike | None,
    fitted: tuple[float, float] | None = None,
) -> tuple[Floats, Floats]:
    """Sensitivity and bias at a temperature, shapes (..., 3)."""
    if len(sensitivity) == len(bias) == 1:
        return sensitivity[0], bias[0]
    if temperature is None:
        msg = "temperature: expected one, because sensitivity or bias depends on it, got None"
        raise ValueError(msg)
    degrees = floats("temperature", temperature)
    if fitted is not None:
        _warn_beyond(degrees, *fitted)
    here = _evaluated(sensitivity, degrees)
    refuse_zeros(here, " at one of the temperatures")
    return here, _evaluated(bias, degrees)


def _warn_beyond(degrees: Floats, lowest: float, highest: float) -> None:
    """Notice temperatures at which a polynomial has not been fitted."""
    margin = _BEYOND * (highest - lowest)
    off = degrees[(degrees < lowest - margin) | (degrees > highest + margin)]
    if off.size:
        msg = (
            f"temperature: expected from {lowest:.4g} to {highest:.4g}, from which the calibration "
            f"was fitted, got {off[0]:.4g}: its polynomial is only continued"
        )
        warnings.warn(msg, stacklevel=4)


def _evaluated(coefficients: Floats, temperature: Floats) -> Floats:
    values = np.polynomial.polynomial.polyval(temperature, coefficients)
    return np.asarray(np.moveaxis(values, 0, -1), dtype=np.float64)
