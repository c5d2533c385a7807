"""Calibration of an accelerometer from the still poses of a log."""

import warnings
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._recordings import run
from chr_notes._samples import complete, periods, positive, samples
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.errors import CalibrationWarning
from chr_notes.generated.scalar.estimation import gyro_turn
from chr_notes.quaternions.conversions import matrix_from_quaternion
from chr_notes.sensors.coverage import WIDEST_GAP, named, sphere_centre, widest_gap
from chr_notes.sensors.models import ThreeAxisCalibration
from chr_notes.sensors.norms import ALL, SCALES, norms_less_one, refined
from chr_notes.sensors.still import static_intervals, steady_mean

_FEWEST = 6
_MANY = 12  # poses from which on the axes' angles can be found too
_ALIKE = np.cos(np.radians(15.0))
_LARGEST_MISFIT = 0.05  # of the norm
_FLIPS = np.array([[1, 1, 1], [-1, 1, 1], [1, -1, 1], [1, 1, -1]])
_CLEARLY = 0.25  # of the squared misfit that is left when an axis is turned round


def fit_accelerometer_from_log(
    body_rates: ArrayLike,
    accel: ArrayLike,
    dt: ArrayLike,
    gravity: float = STANDARD_GRAVITY,
) -> ThreeAxisCalibration:
    """Find sensitivity and bias of an accelerometer that was laid down in six poses or more.

    The still poses are cut out of the log by `static_intervals`; what the sensor reads in them
    has to have one norm, gravity, in any pose. Poses need not be upright, only differ. Six tell
    sensitivity and bias; from twelve on the angles between the axes are found too.

    Parameters
    ----------
    body_rates
        Readings, rad/s, shape (N, 3). Between poses they tell how the sensor was turned, and so
        whether an axis of the accelerometer is backwards.
    accel
        Readings in any unit, shape (N, 3).
    dt
        Time step before each sample, seconds: a number, or shape (N,).
    gravity
        Magnitude of gravity at the place, in the unit that corrected readings are to have.

    Returns
    -------
    ThreeAxisCalibration

    Raises
    ------
    ValueError
        If there are fewer than six poses, or a direction is missing: it says which. If the poses
        have no common norm, which is no matter of sensitivity and bias then.

    Warns
    -----
    CalibrationWarning
        If an axis is backwards by the gyro. That the sensor as a whole has the other sign cannot
        be seen.

    See Also
    --------
    chr_notes.sensors.calibration.fit_accelerometer : From six upright poses.

    Notes
    -----
    Ledger: sensors.2.3. The method is that of Tedaldi, Pretto and Menegatti, A robust and easy to
    implement method for IMU calibration without external equipments, 2014.

    Examples
    --------
    >>> import numpy as np
    >>> noise = np.random.default_rng(0).normal(0, 0.001, (2400, 3))
    >>> ups = np.repeat(np.eye(3), 2, axis=0) * np.resize([1, -1], (6, 1))
    >>> accel = np.repeat(1.02 * 9.80665 * ups + [0.1, 0, 0], 400, axis=0) + noise
    >>> turning = (np.arange(2400) % 400 > 300)[:, np.newaxis]  # a second between two poses
    >>> rates = noise + turning * np.sin(np.arange(2400) / 5)[:, np.newaxis]
    >>> fit_accelerometer_from_log(rates, accel, 0.01).correct([0.1, 0, -10.0028]).round(2)
    array([ 0.  ,  0.  , -9.81])
    """
    rates, forces = samples("body_rates", body_rates), samples("accel", accel)
    magnitude = positive("gravity", gravity)
    parts = static_intervals(rates, forces, dt)
    poses = np.array([_mean(forces[part]) for part in parts]).reshape(-1, 3)
    centre = _centre(poses)
    scale = float(np.median(np.linalg.norm(poses - centre, axis=1)))
    free = ALL if _directions(poses - centre) >= _MANY else SCALES
    fitted = refined(poses / scale, np.eye(3), centre / scale, free)
    if fitted is None:
        msg = f"accel: no sensitivities make the {len(poses)} still poses equally long"
        raise ValueError(msg)
    misfit = np.abs(norms_less_one(poses / scale, *fitted)[0])
    if misfit.max() > _LARGEST_MISFIT:
        worst = parts[int(misfit.argmax())]
        msg = (
            f"accel: expected one norm in all {len(poses)} still poses, got one that is "
            f"{misfit.max():.0%} off in rows {worst.start} to {worst.stop}"
        )
        raise ValueError(msg)
    matrix, centre = fitted[0] * magnitude / scale, fitted[1] * scale
    upward = (poses - centre) @ matrix / magnitude
    steps = np.broadcast_to(periods(dt, len(rates)), (len(rates),))
    _warn_of_backward_axis(rates, steps, parts, upward)
    inverse = np.linalg.inv(matrix)
    sensitivity = np.diagonal(inverse)
    return ThreeAxisCalibration(
        misalignment=inverse / sensitivity,
        sensitivity=sensitivity,
        bias=-sensitivity * (matrix @ centre),
    )


def _mean(readings: Floats) -> Floats:
    return steady_mean(readings[complete(readings)])


def _centre(poses: Floats) -> Floats:
    """Find what the poses centre on; refuse poses that are too few or leave a direction out."""
    advice = "lay the sensor down still, a second or more, on each of its six sides"
    if len(poses) < _FEWEST:
        msg = (
            f"expected at least {_FEWEST} still poses, got {len(poses)}: {advice}; rates in °/s, "
            "too, leave no pose still"
        )
        raise ValueError(msg)
    centre = sphere_centre(poses)
    outward = poses - centre
    count = _directions(outward)
    gap, missing = widest_gap(outward / np.linalg.norm(outward, axis=1, keepdims=True))
    if count < _FEWEST or gap > WIDEST_GAP:
        msg = (
            f"accel: expected at least {_FEWEST} different poses all around, got {count} in "
            f"{len(poses)} still stretches, and in none of them pointed {named(missing)}, or what "
            f"is within {np.degrees(gap):.0f}° of it, up: {advice}"
        )
        raise ValueError(msg)
    return centre


def _directions(outward: Floats) -> int:
    left, count = outward / np.linalg.norm(outward, axis=1, keepdims=True), 0
    while len(left):
        left = left[left @ left[0] < _ALIKE]
        count += 1
    return count


def _warn_of_backward_axis(
    rates: Floats, steps: Floats, parts: list[slice], upward: Floats
) -> None:
    """Compare how the vertical went from pose to pose with how the gyro says that it went."""
    misfit = np.zeros(len(_FLIPS))
    for (one, other), (before, after) in zip(pairwise(parts), pairwise(upward), strict=True):
        between = slice(one.stop, other.start)
        if between.start >= between.stop:
            continue
        turning = np.where(complete(rates[between])[:, np.newaxis], rates[between], 0.0)
        turned = run(gyro_turn, (1.0, 0.0, 0.0, 0.0), turning - _mean(rates[one]), steps[between])
        matrix = matrix_from_quaternion(turned[-1])
        misfit += [np.sum((flip * after - matrix @ (flip * before)) ** 2) for flip in _FLIPS]
    best = int(np.argmin(misfit))
    if best and misfit[best] < _CLEARLY * misfit[0]:
        warnings.warn(
            f"accel: by the gyro, the {'xyz'[best - 1]}-axis of the accelerometer runs against its "
            "other two: an axis is backwards, or two are swapped",
            CalibrationWarning,
            stacklevel=3,
        )
