"""How far dead reckoning goes astray, by cause, and how long it may go on."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats, floats
from chr_notes._rows import Rows
from chr_notes._samples import positive
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.generated.arrays import dead_reckoning as generated

_position_errors = Rows(generated.position_errors)
_LONGEST = 1e9  # s, thirty years


@dataclass(frozen=True, eq=False)
class DriftBudget:
    """Errors of position along the ground after a time, by cause, m.

    Parameters
    ----------
    tilt
        From an error of the vertical at the start: g sin(tilt) t²/2.
    accel_bias
        From the accelerometer's bias: b t²/2.
    gyro_bias
        From the gyro's bias, which turns the vertical: g b t³/6.
    motion
        From a wrong sensitivity of the accelerometer while the body accelerates: k a t²/2.
    noise
        Standard deviation from the white noise of both sensors.

    See Also
    --------
    drift_budget
    """

    tilt: Floats
    accel_bias: Floats
    gyro_bias: Floats
    motion: Floats
    noise: Floats

    @property
    def worst(self) -> Floats:
        """All that is constant in one direction, m; noise apart."""
        return np.asarray(
            np.abs(self.tilt)
            + np.abs(self.accel_bias)
            + np.abs(self.gyro_bias)
            + np.abs(self.motion)
        )

    @property
    def likely(self) -> Floats:
        """Root of the sum of squares, m, to which causes add up that know nothing of each other."""
        parts = (self.tilt, self.accel_bias, self.gyro_bias, self.motion, self.noise)
        return np.asarray(np.sqrt(sum(part**2 for part in parts)))


def drift_budget(  # noqa: PLR0913 (an error for each cause)
    time: ArrayLike,
    *,
    tilt: ArrayLike = 0.0,
    accel_bias: ArrayLike = 0.0,
    gyro_bias: ArrayLike = 0.0,
    scale_error: ArrayLike = 0.0,
    acceleration: ArrayLike = 0.0,
    accel_noise: ArrayLike = 0.0,
    gyro_noise: ArrayLike = 0.0,
    gravity: ArrayLike = STANDARD_GRAVITY,
) -> DriftBudget:
    """Separate by cause how far dead reckoning goes astray along the ground.

    Parameters
    ----------
    time
        Since the last known position and velocity, s, shape (...).
    tilt
        Error of the vertical at the start, radians.
    accel_bias, gyro_bias
        What the sensors read too much: the accelerometer along the ground, m/s², the gyro about a
        level axis, rad/s.
    scale_error, acceleration
        Relative error of the accelerometer's sensitivity, and the acceleration of the body along
        the ground, m/s².
    accel_noise, gyro_noise
        Densities of white noise, m/s²/√Hz and rad/s/√Hz, as data sheets give them.
    gravity
        m/s².

    Returns
    -------
    DriftBudget

    Raises
    ------
    ValueError
        If a shape does not broadcast, or a time is negative.

    See Also
    --------
    coasting_time
    chr_notes.dead_reckoning.drift_from_tilt_error

    Notes
    -----
    Tilt errors are taken as small where they grow. The tilt's part is that of
    `drift_from_tilt_error`. Ledger: dead_reckoning.4.a.

    Examples
    --------
    A minute with half a degree of tilt, 0.01 m/s², and 0.01 °/s:

    >>> import numpy as np
    >>> half, slow = np.radians(0.5), np.radians(0.01)
    >>> found = drift_budget(60, tilt=half, accel_bias=0.01, gyro_bias=slow)
    >>> [round(float(part), 1) for part in (found.tilt, found.accel_bias, found.gyro_bias)]
    [154.0, 18.0, 61.6]
    """
    passed = floats("time", time)
    if (passed < 0).any():
        msg = f"time: expected seconds, not negative, got {passed.min():g}"
        raise ValueError(msg)
    constant = (tilt, accel_bias, gyro_bias, scale_error, acceleration)
    found = _position_errors(*constant, accel_noise, gyro_noise, passed, gravity)
    by_tilt, by_accel, by_gyro, by_motion, *variances = map(np.asarray, np.moveaxis(found, -1, 0))
    noise = np.asarray(np.sqrt(sum(variances)))
    return DriftBudget(by_tilt, by_accel, by_gyro, by_motion, noise)


def coasting_time(distance: float = 1.0, **errors: float) -> float:
    """Tell how long dead reckoning may go on until it is likely to be off by a distance.

    Parameters
    ----------
    distance
        Along the ground, m.
    **errors
        Of the sensors, as for `drift_budget`.

    Returns
    -------
    float
        Seconds until `DriftBudget.likely` reaches the distance, infinite without any error.

    Raises
    ------
    ValueError
        If the distance is not positive, or an error is not one number.

    See Also
    --------
    drift_budget

    Examples
    --------
    >>> import numpy as np
    >>> round(coasting_time(1.0, tilt=np.radians(0.5), gyro_bias=np.radians(0.01)), 1)
    4.8
    >>> round(coasting_time(1.0, gyro_bias=np.radians(0.01)), 1)  # (6 d / g b)^(1/3)
    15.2
    """
    far = positive("distance", distance)

    def off(time: float) -> float:
        return float(drift_budget(time, **errors).likely)

    for name, error in errors.items():
        if np.ndim(error) != 0 or np.isnan(error):
            msg = f"{name}: expected a number, got {error}"
            raise ValueError(msg)
    longest = 1.0
    while not off(longest) >= far:
        longest *= 2
        if longest > _LONGEST:
            return np.inf
    # Errors only grow, so halving finds the time.
    shortest = 0.0
    for _ in range(60):
        middle = (shortest + longest) / 2
        shortest, longest = (shortest, middle) if off(middle) >= far else (middle, longest)
    return (shortest + longest) / 2
