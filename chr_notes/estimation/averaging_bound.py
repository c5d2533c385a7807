"""How far off the vertical of the averaging filter may be."""

from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes._samples import number, positive
from chr_notes.generated.arrays import estimation as generated

SPEED, BIAS = 1.0, 0.005
"""That body and gyros stay below where nothing else is said, m/s and rad/s."""

_averaging_bound = Rows(generated.averaging_bound)


def averaging_bound(
    averaged: ArrayLike,
    time_constant: float = 3.0,
    *,
    speed: float = SPEED,
    bias: float = BIAS,
    out: Floats | None = None,
) -> Floats:
    """Bound the angle between the true vertical and that of the averaging filter.

    Parameters
    ----------
    averaged
        Seconds that have been averaged, shape (...).
    time_constant
        Of the filter, seconds.
    speed
        That the body stays below, m/s.
    bias
        That the gyros' bias stays below once the known one is taken off, rad/s.
    out
        An array for the result.

    Returns
    -------
    ndarray
        Radians, at most pi, shape (...).

    Raises
    ------
    ValueError
        If the time constant is not positive, or another number is negative.

    See Also
    --------
    chr_notes.estimation.averaging.averaged_attitude

    Examples
    --------
    How far off may up be for a body that moves by less than 3 m/s?

    >>> import numpy as np
    >>> float(np.degrees(averaging_bound(3.0, speed=3.0, bias=0.0)).round(1))
    7.9
    """
    positive("time_constant", time_constant)
    for name, value in (("speed", speed), ("bias", bias)):
        if not number(name, value) >= 0:
            msg = f"{name}: expected a number, not negative, got {value}"
            raise ValueError(msg)
    given = (averaged, float(time_constant), float(speed), float(bias))
    bound = _averaging_bound(*given, out=out)
    return bound[()] if out is None else bound
