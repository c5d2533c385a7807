"""Calibration from data: what a sensor read, and what it should have read.

The fits are least squares on NumPy's linear algebra. Samples that hold NaN are left out.
"""

import warnings

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes._samples import complete, positive, samples
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.errors import CalibrationWarning
from chr_notes.sensors.models import ThreeAxisCalibration
from chr_notes.sensors.still import STILL_LIMIT, without_glitches

_POSITIONS = ("+x", "-x", "+y", "-y", "+z", "-z")


def fit_accelerometer(
    readings: ArrayLike, gravity: float = STANDARD_GRAVITY
) -> ThreeAxisCalibration:
    """Find misalignment, sensitivity and bias from six positions at rest.

    Each axis points once up, where it reads plus one gravity, and once down. The difference of
    the two readings is twice gravity times a column of misalignment and sensitivity, and the mean
    of what the axis itself read in the two is what the bias adds.

    Parameters
    ----------
    readings
        Mean readings in any unit, shape (6, 3), in the order: x up, x down, y up, y down, z up,
        z down.
    gravity
        Magnitude of gravity at the place, in the unit that corrected readings are to have.

    Returns
    -------
    ThreeAxisCalibration
        With a misalignment matrix whose diagonal is 1. An axis that reads less when it points up
        than when it points down gets a negative sensitivity.

    Raises
    ------
    ValueError
        If the shape is not (6, 3), a reading is NaN, gravity is not positive, or the readings do
        not tell the six positions apart.

    Warns
    -----
    CalibrationWarning
        If one axis or all three are backwards, which makes the axes left-handed. Two are a sensor
        that was mounted the other way round.

    See Also
    --------
    chr_notes.sensors.poses.fit_accelerometer_from_log : Cuts the poses out of a log by itself.

    Notes
    -----
    Ledger: sensors.2.3.

    Examples
    --------
    >>> import numpy as np
    >>> ups = np.repeat(np.eye(3), 2, axis=0) * np.resize([1, -1], (6, 1))
    >>> # Each axis up, then down.
    >>> found = fit_accelerometer(1.02 * 9.80665 * ups + [0.1, 0, 0])
    >>> found.correct([0.1, 0, -1.02 * 9.80665]).round(4)
    array([ 0.    ,  0.    , -9.8066])
    """
    positions = floats("readings", readings, 6, 3)
    if positions.ndim != 2:  # noqa: PLR2004 (positions by axes)
        msg = f"readings: expected shape (6, 3), got {positions.shape}"
        raise ValueError(msg)
    missing = np.flatnonzero(~complete(positions))
    if missing.size:
        msg = (
            f"readings: expected numbers, got NaN or infinity in position {_POSITIONS[missing[0]]}"
        )
        raise ValueError(msg)
    magnitude = positive("gravity", gravity)
    up, down = positions[0::2], positions[1::2]
    columns = (up - down).T / (2 * magnitude)
    sensitivity = np.diagonal(columns)
    for axis, name in enumerate("xyz"):
        others = np.abs(np.delete(columns[axis], axis)).max()
        if not abs(sensitivity[axis]) > others:
            msg = (
                f"readings: expected the {name}-axis to change most between {name} up and "
                f"{name} down, got a change of {up[axis, axis] - down[axis, axis]:.4g} there and "
                f"of {2 * magnitude * others:.4g} elsewhere"
            )
            raise ValueError(msg)
    if np.prod(sensitivity) < 0:
        backward = [name for name, value in zip("xyz", sensitivity, strict=True) if value < 0]
        warnings.warn(
            f"readings: backwards along {', '.join(backward)}, so that the axes are left-handed: "
            "were up and down mixed up, or does the sensor read gravity for specific force?",
            CalibrationWarning,
            stacklevel=2,
        )
    misalignment = columns / sensitivity
    # Of a position that is not quite upright the vertical axis notices least.
    offset = np.diagonal(up + down) / 2
    bias = -np.asarray(np.linalg.solve(misalignment, offset), dtype=np.float64)
    return ThreeAxisCalibration(misalignment, sensitivity, bias)


def fit_gyro_bias(body_rates: ArrayLike, *, still_limit: float = STILL_LIMIT) -> Floats:
    """Find the bias of a gyro from its readings at rest.

    Parameters
    ----------
    body_rates
        Readings of a sensor that lies still, rad/s, shape (N, 3). Rows with NaN are left out, and
        glitches of one or two rows.
    still_limit
        Largest standard deviation, rad/s, that passes for still.

    Returns
    -------
    ndarray
        The bias b of the notes' model and of `RateGyroCalibration`, rad/s, shape (3,): `correct`
        adds it to readings, so it is minus the mean reading r. `averaging_observer` takes the same.
        Coupling C and misalignment M count as bias; where they are known, the model's own one is
        `C a - M⁻¹ r`, with the specific force a in which the sensor lies.

    Raises
    ------
    ValueError
        If there is no sample without NaN, or the rates vary by more than `still_limit`.

    See Also
    --------
    chr_notes.sensors.gyro.fit_gyro_at_rest

    Notes
    -----
    Ledger: sensors.3.2.

    Examples
    --------
    >>> import numpy as np
    >>> noise = np.random.default_rng(0).normal(0, 0.001, (1000, 3))
    >>> fit_gyro_bias(noise + [0.01, 0, -0.02]).round(3)
    array([-0.01, -0.  ,  0.02])
    """
    rates = samples("body_rates", body_rates)
    rates = rates[complete(rates)]
    if not len(rates):
        msg = "body_rates: expected at least one row without NaN, got none"
        raise ValueError(msg)
    # A glitch is left out where it would count.
    away = np.abs(rates - np.median(rates, axis=0)).max(axis=1)
    rates = rates[~(without_glitches(rates)[1] & (away > still_limit))]
    with np.errstate(all="ignore"):
        spread = rates.std(axis=0)
    if not spread.max() <= still_limit:
        msg = (
            f"body_rates: expected a sensor at rest, with a standard deviation of at most "
            f"{still_limit} rad/s, got {spread.max():.3g} rad/s about the "
            f"{'xyz'[int(spread.argmax())]}-axis"
        )
        raise ValueError(msg)
    return np.asarray(-rates.mean(axis=0))
