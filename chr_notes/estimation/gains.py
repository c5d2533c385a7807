"""Gains of a filter as time constants, which say the same at every rate."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats, floats
from chr_notes._rows import Rows
from chr_notes.generated.arrays import estimation as generated

_gain_from_time_constant = Rows(generated.gain_from_time_constant)
_time_constant_from_gain = Rows(generated.time_constant_from_gain)


def gain_from_time_constant(
    time_constant: ArrayLike, dt: ArrayLike, *, out: Floats | None = None
) -> Floats:
    """Tell the gain per sample that has the effect of a time constant.

    A gain counts per sample: the same gain at three times the rate is another filter, which
    forgets three times as fast. The time constant is what stays: after so many seconds 37 % of an
    error, 1/e, are left.

    Parameters
    ----------
    time_constant
        Seconds, positive, shape (...).
    dt
        Time step, seconds, not negative, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Gain from 0 to 1, shape (...).

    Raises
    ------
    ValueError
        If a time constant is not positive, a time step is negative, or the two do not broadcast.

    See Also
    --------
    time_constant_from_gain
    chr_notes.estimation.fixed_gain.fixed_gain_observer

    Examples
    --------
    >>> gain_from_time_constant(0.5, [0.01, 0.02]).round(4)
    array([0.0198, 0.0392])
    """
    constants, steps = floats("time_constant", time_constant), _steps(dt)
    _refuse("time_constant", "positive seconds", constants, np.asarray(~(constants > 0)))
    gain = _gain_from_time_constant(constants, steps, out=out)
    return gain[()] if out is None else gain


def time_constant_from_gain(gain: ArrayLike, dt: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Tell the time constant that a gain has at a rate: `gain_from_time_constant` undone.

    Parameters
    ----------
    gain
        Between 0 and 1, shape (...).
    dt
        Time step, seconds, not negative, shape (...).
    out
        An array for the result.

    Returns
    -------
    ndarray
        Seconds, shape (...).

    Raises
    ------
    ValueError
        If a gain is not between 0, which never forgets, and 1, which forgets at once; if a time
        step is negative, or the two do not broadcast.

    See Also
    --------
    gain_from_time_constant

    Examples
    --------
    >>> float(time_constant_from_gain(0.02, 0.01).round(3))
    0.495
    """
    gains, steps = floats("gain", gain), _steps(dt)
    _refuse("gain", "numbers between 0 and 1", gains, np.asarray(~((gains > 0) & (gains < 1))))
    constant = _time_constant_from_gain(gains, steps, out=out)
    return constant[()] if out is None else constant


def _steps(dt: ArrayLike) -> Floats:
    steps = floats("dt", dt)
    _refuse("dt", "seconds, not negative", steps, np.asarray(steps < 0))
    return steps


def _refuse(name: str, expected: str, values: Floats, wrong: NDArray[np.bool_]) -> None:
    """Refuse values that have no meaning; NaN passes through."""
    refused = np.asarray(wrong & ~np.isnan(values))
    if refused.any():
        place = tuple(map(int, np.argwhere(refused)[0]))
        where = f" at index {place}" if place else ""
        msg = f"{name}: expected {expected}, got {values[place]}{where}"
        raise ValueError(msg)
