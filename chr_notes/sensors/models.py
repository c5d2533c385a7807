"""Models of three-axis sensors: what they measure of what is there, and back.

Vectors stand on the last axis, leading axes broadcast. Sensitivity and bias may each be a
polynomial in temperature: coefficients along the first axis, the constant one first.
"""

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes._rows import Rows
from chr_notes.generated.arrays import sensors as generated

# Terms have a row for each temperature, so an error about their shape is one about its.
_TERMS = ("misalignment", "temperature", "temperature")
_sensor_measures = Rows(generated.sensor_measures, names=_TERMS, checked=3)
_sensor_corrected = Rows(generated.sensor_corrected, names=_TERMS, checked=3)
_gyro_measures = Rows(generated.gyro_measures, names=_TERMS, checked=4)
_gyro_corrected = Rows(generated.gyro_corrected, names=_TERMS, checked=4)
_iron_added = Rows(generated.iron_added, checked=2)
_iron_removed = Rows(generated.iron_removed, checked=2)

_SINGULAR = 1e-12  # smallest singular value over the largest


@dataclass(frozen=True, eq=False)
class _Checked:
    """What is checked when it is made, and so when it is copied or read from a file too."""

    def __reduce__(self) -> tuple[type, tuple[Floats, ...]]:
        """Make it again from its fields."""
        return type(self), tuple(getattr(self, field.name) for field in fields(self))

    @cached_property
    def _inverse(self) -> Floats:
        """Of the matrix, which is the first field."""
        matrix = getattr(self, fields(self)[0].name)
        return np.asarray(np.linalg.inv(matrix), dtype=np.float64)


@dataclass(frozen=True, eq=False)
class ThreeAxisCalibration(_Checked):
    """Misalignment M, sensitivity S and bias b of a sensor: of a vector v it measures M (S v - b).

    Parameters
    ----------
    misalignment
        M, invertible, shape (3, 3).
    sensitivity
        Diagonal of S, reading per unit of v, not zero: shape (3,), or (n, 3) for a polynomial in
        temperature.
    bias
        b in the unit of the reading, added back when a measurement is corrected: shape (3,), or
        (n, 3) for a polynomial in temperature.

    Raises
    ------
    ValueError
        If a shape is wrong, a number is not finite, the misalignment is singular or a sensitivity
        is zero.

    Notes
    -----
    Ledger: sensors.2.3, sensors.2.4, sensors.2.5, sensors.4.1.
    """

    misalignment: Floats
    sensitivity: Floats
    bias: Floats

    def __post_init__(self) -> None:
        """Check the parameters and keep them as arrays."""
        _keep(self, "misalignment", _invertible("misalignment", self.misalignment))
        _keep(self, "sensitivity", _polynomial("sensitivity", self.sensitivity))
        _keep(self, "bias", _polynomial("bias", self.bias))
        _refuse_zeros(np.abs(self.sensitivity).max(axis=0))

    def measure(
        self,
        actual: ArrayLike,
        temperature: ArrayLike | None = None,
        *,
        out: Floats | None = None,
    ) -> Floats:
        """Tell what the sensor reads.

        Parameters
        ----------
        actual
            What is there, shape (..., 3).
        temperature
            In the unit of the polynomials, shape (...); needed if something depends on it.
        out
            An array for the result.

        Returns
        -------
        ndarray
            Shape (..., 3).

        Raises
        ------
        ValueError
            If a shape is wrong, the temperature is missing, or a sensitivity is zero at it.
        """
        sensitivity, bias = _at(self, temperature)
        return _sensor_measures.compute(self.misalignment, sensitivity, bias, actual, out)

    def correct(
        self,
        measured: ArrayLike,
        temperature: ArrayLike | None = None,
        *,
        out: Floats | None = None,
    ) -> Floats:
        """Tell what is there from what the sensor reads; parameters and errors as in `measure`."""
        sensitivity, bias = _at(self, temperature)
        return _sensor_corrected.compute(self._inverse, sensitivity, bias, measured, out)


@dataclass(frozen=True, eq=False)
class RateGyroCalibration(_Checked):
    """A rate gyro, whose reading acceleration adds to: it measures M (S w - b + C a).

    Parameters
    ----------
    misalignment, sensitivity, bias
        As for `ThreeAxisCalibration`.
    g_sensitivity
        C, reading before misalignment per m/s² along each axis, shape (3, 3).

    Raises
    ------
    ValueError
        As for `ThreeAxisCalibration`.

    Notes
    -----
    Ledger: sensors.3.2.
    """

    misalignment: Floats
    sensitivity: Floats
    bias: Floats
    g_sensitivity: Floats

    def __post_init__(self) -> None:
        """Check the parameters and keep them as arrays."""
        _keep(self, "misalignment", _invertible("misalignment", self.misalignment))
        _keep(self, "sensitivity", _polynomial("sensitivity", self.sensitivity))
        _keep(self, "bias", _polynomial("bias", self.bias))
        _keep(self, "g_sensitivity", _finite("g_sensitivity", self.g_sensitivity, 3, 3))
        _refuse_zeros(np.abs(self.sensitivity).max(axis=0))

    def measure(
        self,
        actual: ArrayLike,
        accel: ArrayLike,
        temperature: ArrayLike | None = None,
        *,
        out: Floats | None = None,
    ) -> Floats:
        """Tell what the gyro reads.

        Parameters
        ----------
        actual
            Body rates, rad/s, shape (..., 3).
        accel
            Specific force, as a corrected accelerometer gives it, m/s², shape (..., 3).
        temperature
            In the unit of the polynomials, shape (...); needed if something depends on it.
        out
            An array for the result.

        Returns
        -------
        ndarray
            Shape (..., 3).

        Raises
        ------
        ValueError
            If a shape is wrong, the temperature is missing, or a sensitivity is zero at it.
        """
        sensitivity, bias = _at(self, temperature)
        terms = self.misalignment, sensitivity, bias, self.g_sensitivity
        return _gyro_measures.compute(*terms, accel, actual, out)

    def correct(
        self,
        measured: ArrayLike,
        accel: ArrayLike,
        temperature: ArrayLike | None = None,
        *,
        out: Floats | None = None,
    ) -> Floats:
        """Tell the body rates from what the gyro reads; parameters and errors as in `measure`."""
        sensitivity, bias = _at(self, temperature)
        terms = self._inverse, sensitivity, bias, self.g_sensitivity
        return _gyro_corrected.compute(*terms, accel, measured, out)


@dataclass(frozen=True, eq=False)
class MagnetometerCalibration(_Checked):
    """Soft iron D and hard iron h: a distorted field b is corrected to D b - h.

    Parameters
    ----------
    soft_iron
        D, invertible, shape (3, 3).
    hard_iron
        h in the unit of the corrected field, shape (3,).

    Raises
    ------
    ValueError
        If a shape is wrong, a number is not finite or the soft-iron matrix is singular.

    Notes
    -----
    Ledger: sensors.4.2, sensors.4.3.
    """

    soft_iron: Floats
    hard_iron: Floats

    def __post_init__(self) -> None:
        """Check the parameters and keep them as arrays."""
        _keep(self, "soft_iron", _invertible("soft_iron", self.soft_iron))
        _keep(self, "hard_iron", _finite("hard_iron", self.hard_iron, 3))

    def measure(self, actual: ArrayLike, *, out: Floats | None = None) -> Floats:
        """Tell what a magnetometer near the iron reads of a field, shape (..., 3)."""
        return _iron_added.compute(self._inverse, self.hard_iron, actual, out)

    def correct(self, field: ArrayLike, *, out: Floats | None = None) -> Floats:
        """Tell the field without the iron from a reading, shape (..., 3)."""
        return _iron_removed.compute(self.soft_iron, self.hard_iron, field, out)


def _keep(calibration: object, name: str, value: Floats) -> None:
    # A frozen dataclass sets its fields so. Nobody may change what has been checked.
    value.setflags(write=False)
    object.__setattr__(calibration, name, value)


def _finite(name: str, value: ArrayLike, *shape: int) -> Floats:
    array = np.array(floats(name, value, *shape), dtype=np.float64)
    if array.ndim != len(shape):
        msg = f"{name}: expected shape {shape}, got {array.shape}"
        raise ValueError(msg)
    if not np.isfinite(array).all():
        msg = f"{name}: expected finite numbers, got {array.tolist()}"
        raise ValueError(msg)
    return array


def _invertible(name: str, value: ArrayLike) -> Floats:
    matrix = _finite(name, value, 3, 3)
    singular = np.linalg.svd(matrix, compute_uv=False)
    if not singular[-1] > _SINGULAR * singular[0]:
        msg = f"{name}: expected an invertible matrix, got a singular one: {matrix.tolist()}"
        raise ValueError(msg)
    return matrix


def _polynomial(name: str, value: ArrayLike) -> Floats:
    """Take coefficients by power of temperature and axis, shape (n, 3)."""
    array = floats(name, value)
    if array.ndim not in (1, 2) or array.shape[-1] != 3 or not array.size:  # noqa: PLR2004 (axes)
        msg = f"{name}: expected shape (3,) or (n, 3), got {array.shape}"
        raise ValueError(msg)
    return np.atleast_2d(_finite(name, array, *array.shape))


def _refuse_zeros(sensitivity: Floats, where: str = "") -> None:
    for axis, name in enumerate("xyz"):
        if not (sensitivity[..., axis] != 0).all():
            msg = f"sensitivity: expected no zeros, got one on the {name}-axis{where}"
            raise ValueError(msg)


def _at(
    calibration: ThreeAxisCalibration | RateGyroCalibration, temperature: ArrayLike | None
) -> tuple[Floats, Floats]:
    """Sensitivity and bias at a temperature, shapes (..., 3)."""
    sensitivity, bias = calibration.sensitivity, calibration.bias
    if len(sensitivity) == len(bias) == 1:
        return sensitivity[0], bias[0]
    if temperature is None:
        msg = "temperature: expected one, because sensitivity or bias depends on it, got None"
        raise ValueError(msg)
    degrees = floats("temperature", temperature)
    here = _evaluated(sensitivity, degrees)
    _refuse_zeros(here, " at one of the temperatures")
    return here, _evaluated(bias, degrees)


def _evaluated(coefficients: Floats, temperature: Floats) -> Floats:
    values = np.polynomial.polynomial.polyval(temperature, coefficients)
    return np.asarray(np.moveaxis(values, 0, -1), dtype=np.float64)
