"""Models of three-axis sensors: what they measure of what is there, and back.

Vectors stand on the last axis, leading axes broadcast. Sensitivity and bias may each be a
polynomial in temperature: coefficients along the first axis, the constant one first.
"""

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes.generated.arrays import sensors as generated
from chr_notes.sensors.terms import at, finite, invertible, keep, polynomial, refuse_zeros

# Terms have a row for each temperature, so an error about their shape is one about its.
_TERMS = ("misalignment", "temperature", "temperature")
_sensor_measures = Rows(generated.sensor_measures, names=_TERMS, checked=3, spreads=True)
_sensor_corrected = Rows(generated.sensor_corrected, names=_TERMS, checked=3, spreads=True)
_gyro_measures = Rows(generated.gyro_measures, names=_TERMS, checked=4, spreads=True)
_gyro_corrected = Rows(generated.gyro_corrected, names=_TERMS, checked=4, spreads=True)
_iron_added = Rows(generated.iron_added, checked=2, spreads=True)
_iron_removed = Rows(generated.iron_removed, checked=2, spreads=True)


@dataclass(frozen=True, eq=False)
class _Checked:
    """What is checked when it is made, and so when it is copied or read from a file too."""

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
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

    See Also
    --------
    chr_notes.sensors.calibration.fit_accelerometer

    Notes
    -----
    Ledger: sensors.2.3, sensors.2.4, sensors.2.5, sensors.4.1.

    Examples
    --------
    >>> import numpy as np
    >>> sensor = ThreeAxisCalibration(np.eye(3), sensitivity=[2, 1, 1], bias=[0.1, 0, 0])
    >>> sensor.measure([1, 0, 0]).round(3)
    array([1.9, 0. , 0. ])
    >>> sensor.correct([1.9, 0, 0]).round(3)
    array([1., 0., 0.])
    """

    misalignment: Floats
    sensitivity: Floats
    bias: Floats

    def __post_init__(self) -> None:
        """Check the parameters and keep them as arrays."""
        keep(self, "misalignment", invertible("misalignment", self.misalignment))
        keep(self, "sensitivity", polynomial("sensitivity", self.sensitivity))
        keep(self, "bias", polynomial("bias", self.bias))
        refuse_zeros(np.abs(self.sensitivity).max(axis=0))

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
        sensitivity, bias = at(self.sensitivity, self.bias, temperature)
        return _sensor_measures.compute(self.misalignment, sensitivity, bias, actual, out)

    def correct(
        self,
        measured: ArrayLike,
        temperature: ArrayLike | None = None,
        *,
        out: Floats | None = None,
    ) -> Floats:
        """Tell what is there from what the sensor reads; parameters and errors as in `measure`."""
        sensitivity, bias = at(self.sensitivity, self.bias, temperature)
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
    temperatures
        Lowest and highest from which the polynomials were fitted. Further than a tenth of the way
        between them beyond, a `UserWarning` says that they are only continued.

    Raises
    ------
    ValueError
        As for `ThreeAxisCalibration`.

    See Also
    --------
    chr_notes.sensors.gyro.fit_gyro_at_rest
    chr_notes.sensors.gyro.fit_gyro_scale

    Notes
    -----
    Ledger: sensors.3.2.

    Examples
    --------
    >>> import numpy as np
    >>> gyro = RateGyroCalibration(np.eye(3), [1, 1, 1], [0.02, 0, 0], 0.001 * np.eye(3))
    >>> gyro.measure([0, 0, 0], [0, 0, -9.8]).round(4)  # at rest, level
    array([-0.02  ,  0.    , -0.0098])
    """

    misalignment: Floats
    sensitivity: Floats
    bias: Floats
    g_sensitivity: Floats
    temperatures: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        """Check the parameters and keep them as arrays."""
        keep(self, "misalignment", invertible("misalignment", self.misalignment))
        keep(self, "sensitivity", polynomial("sensitivity", self.sensitivity))
        keep(self, "bias", polynomial("bias", self.bias))
        keep(self, "g_sensitivity", finite("g_sensitivity", self.g_sensitivity, 3, 3))
        refuse_zeros(np.abs(self.sensitivity).max(axis=0))

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
        sensitivity, bias = at(self.sensitivity, self.bias, temperature, self.temperatures)
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
        sensitivity, bias = at(self.sensitivity, self.bias, temperature, self.temperatures)
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

    See Also
    --------
    chr_notes.sensors.magnetometer.fit_magnetometer
    chr_notes.sensors.magnetometer.fit_hard_iron

    Notes
    -----
    Ledger: sensors.4.2, sensors.4.3.

    Examples
    --------
    >>> import numpy as np
    >>> calibration = MagnetometerCalibration(soft_iron=np.eye(3), hard_iron=[0.1, 0, 0])
    >>> calibration.correct([0.6, 0.2, 0.4]).round(3)
    array([0.5, 0.2, 0.4])
    """

    soft_iron: Floats
    hard_iron: Floats

    def __post_init__(self) -> None:
        """Check the parameters and keep them as arrays."""
        keep(self, "soft_iron", invertible("soft_iron", self.soft_iron))
        keep(self, "hard_iron", finite("hard_iron", self.hard_iron, 3))

    def measure(self, actual: ArrayLike, *, out: Floats | None = None) -> Floats:
        """Tell what a magnetometer near the iron reads of a field, shape (..., 3)."""
        return _iron_added.compute(self._inverse, self.hard_iron, actual, out)

    def correct(self, field: ArrayLike, *, out: Floats | None = None) -> Floats:
        """Tell the field without the iron from a reading, shape (..., 3)."""
        return _iron_removed.compute(self.soft_iron, self.hard_iron, field, out)
