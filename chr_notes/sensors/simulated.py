"""What real sensors add to ideal readings: bias, noise, drift of the bias, vibration, iron.

Everything random comes from the seed that is passed, so the same call gives the same readings.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._samples import per_axis, samples, times

PerAxis = float | tuple[float, float, float]


@dataclass(frozen=True)
class SensorErrors:
    """Errors of a three-axis sensor, each a number for all axes or three numbers.

    Parameters
    ----------
    bias
        Constant offset, in the unit of the sensor.
    noise_density
        Of white noise, unit/√Hz: its integral over t seconds has a standard deviation of this
        times √t, and a sample every T seconds one of this over √T.
    bias_drift
        Random walk of the bias, unit/√s: after t seconds its standard deviation is this times √t.
    vibration
        Amplitude of a sine that is added, in the unit of the sensor.
    vibration_frequency
        Of that sine, Hz; sampled too slowly it comes out at an alias.
    """

    bias: PerAxis = 0.0
    noise_density: PerAxis = 0.0
    bias_drift: PerAxis = 0.0
    vibration: PerAxis = 0.0
    vibration_frequency: float = 30.0

    def __post_init__(self) -> None:
        """Refuse what cannot be."""
        for name in ("bias", "noise_density", "bias_drift", "vibration", "vibration_frequency"):
            value = per_axis(name, getattr(self, name))
            if not np.isfinite(value).all():
                msg = f"{name}: expected finite numbers, got {value.tolist()}"
                raise ValueError(msg)
            if name in ("noise_density", "bias_drift") and not (value >= 0).all():
                msg = f"{name}: expected numbers that are not negative, got {value.tolist()}"
                raise ValueError(msg)


def add_errors(ideal: ArrayLike, time: ArrayLike, errors: SensorErrors, seed: int) -> Floats:
    """Add the errors of a sensor to ideal readings.

    Parameters
    ----------
    ideal
        Readings without error, shape (N, 3).
    time
        Seconds, rising, shape (N,), N at least 2; steps may vary.
    errors
        What to add.
    seed
        Of everything random: noise, walk of the bias, phases of the vibration.

    Returns
    -------
    ndarray
        Shape (N, 3).

    Raises
    ------
    ValueError
        If a shape is wrong or the times do not rise.
    """
    seconds, readings = times(time), samples("ideal", ideal)
    if len(seconds) != len(readings) or len(seconds) < 2:  # noqa: PLR2004 (a step takes two times)
        msg = (
            "expected as many times as readings, at least 2, "
            f"got {len(seconds)} times and {len(readings)} readings"
        )
        raise ValueError(msg)
    steps = np.diff(seconds)
    # The first sample stands for as long as the second.
    periods = np.concatenate([steps[:1], steps])[:, np.newaxis]
    # Each kind of error has its own stream, so that one can be changed and the others stay.
    noise, walk, phase = (
        np.random.default_rng(stream) for stream in np.random.SeedSequence(seed).spawn(3)
    )
    white = noise.standard_normal(readings.shape) / np.sqrt(periods)
    drift = np.cumsum(walk.standard_normal(readings.shape) * np.sqrt(periods), axis=0)
    angle = 2 * np.pi * (errors.vibration_frequency * seconds[:, np.newaxis] + phase.random(3))
    return np.asarray(
        readings
        + per_axis("bias", errors.bias)
        + per_axis("noise_density", errors.noise_density) * white
        + per_axis("bias_drift", errors.bias_drift) * (drift - drift[0])
        + per_axis("vibration", errors.vibration) * np.sin(angle)
    )


def passing_iron(
    time: ArrayLike, start: float, stop: float, strength: tuple[float, float, float]
) -> Floats:
    """Make a magnetic disturbance that comes, peaks and goes.

    Parameters
    ----------
    time
        Seconds, shape (N,).
    start, stop
        When it begins and ends, seconds, start before stop.
    strength
        Additional field at the peak, north, east, down.

    Returns
    -------
    ndarray
        Field to add to the reference field, shape (N, 3).

    Raises
    ------
    ValueError
        If a shape is wrong, the times do not rise, or start does not come before stop.
    """
    if not start < stop:
        msg = f"expected start before stop, got {start} and {stop}"
        raise ValueError(msg)
    share = np.clip((times(time) - start) / (stop - start), 0.0, 1.0)
    return np.asarray(np.sin(np.pi * share)[..., np.newaxis] ** 2 * per_axis("strength", strength))
