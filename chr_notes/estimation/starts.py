"""From where filters start, and with which gains."""

from collections.abc import Sequence
from math import isfinite

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._samples import number, start
from chr_notes.estimation.gyro import in_range
from chr_notes.generated.scalar import estimation as steps
from chr_notes.generated.scalar.validation import heading_from_magnetometer


def first_tilt(forces: Floats, advice: str = "") -> tuple[int, Sequence[float]]:
    """Find the first tilt that is known.

    Parameters
    ----------
    forces
        Specific force, shape (N, 3).
    advice
        What may be passed in its place.

    Returns
    -------
    sample
        Where it is.
    euler
        It, with a yaw of 0.

    Raises
    ------
    ValueError
        If there are samples and none shows a tilt.
    """
    for sample, force in enumerate(forces):
        roll, pitch = steps.tilt_from_accelerometer(*force.tolist())
        if roll == roll:  # noqa: PLR0124 (NaN is not itself)
            return sample, (roll, pitch, 0.0)
    if len(forces):
        found = "zero" if (forces == 0).all() else "zero, missing or infinite"
        msg = (
            "accel: expected a sample that shows a tilt to start from, got all "
            f"{len(forces)} of them {found}{advice}"
        )
        raise ValueError(msg)
    return 0, (0.0, 0.0, 0.0)


def canonical(name: str, euler: ArrayLike) -> list[float]:
    """Take an attitude to start from, with pitch in [-pi/2, pi/2] and roll and yaw in [-pi, pi).

    Corrections go towards a tilt that is in these ranges, so the start has to be too.
    """
    return list(in_range(np.array([start(name, euler)]))[0].tolist())


def check_gain(name: str, gain: float) -> float:
    """Take a gain; refuse one that is not from 0 to 1."""
    checked = gain if isinstance(gain, float) else number(name, gain)
    if not 0 <= checked <= 1:
        msg = f"{name}: expected a number from 0 to 1, got {checked}"
        raise ValueError(msg)
    return checked


def with_heading(
    tilt: Sequence[float], field: Sequence[float], reference: tuple[float, float]
) -> tuple[float, float, float]:
    """Give a tilt the yaw that a magnetometer shows, and none where it shows none."""
    (roll, pitch, _), (x, y, z), (north, east) = tilt, field, reference
    yaw = heading_from_magnetometer(x, y, z, roll, pitch, north, east)
    return roll, pitch, yaw if isfinite(yaw) else 0.0
