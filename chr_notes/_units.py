"""Warnings of readings of a size that they hardly have in the unit in which they are expected."""

import warnings
from collections.abc import Sequence
from math import hypot, inf, pi, sqrt

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._samples import WILD_RATE, complete, lengths
from chr_notes._turning import in_doubt
from chr_notes.errors import UnitWarning

ENOUGH = 100
"""Samples that a recording needs, so that its readings on the whole tell the unit."""
FAST = 70.0
"""More than gyros read, rad/s: those with the widest usual range end at 4000 °/s."""
_SELDOM = 0.01  # share of samples that damage may explain
_SLOW = 1.0  # seconds from sample to sample, of which no inertial sensor takes more


def warn_of_force(forces: Floats, gravity: float, inner: int = 0) -> None:
    """Notice a recording of readings that gravity cannot explain."""
    sizes = lengths(forces[complete(forces)])
    if len(sizes) < ENOUGH or not gravity > 0:
        return
    usual = float(np.median(sizes))
    if not gravity / 2 <= usual <= 2 * gravity:
        _warn(
            f"accel: expected readings of about {gravity:.4g}, in the unit of gravity, got mostly "
            f"{usual:.4g}: are they in g, or in counts?",
            inner,
        )


def warn_of_angles(accelerations: Floats, by_degrees: Floats, gravity: float) -> None:
    """Notice angles by which gravity is not taken off, and as degrees would be.

    Parameters
    ----------
    accelerations, by_degrees
        What is left of a specific force by the angles as radians, and as degrees, shape (N, 3).
    gravity
        Its magnitude.
    """
    known = complete(accelerations)
    if known.sum() < ENOUGH:
        return
    left, by_other = (float(np.median(lengths(a[known]))) for a in (accelerations, by_degrees))
    if left > gravity / 4 and by_other < left / 4:
        _warn(
            f"euler: expected radians, by which gravity is taken off, got mostly {left:.3g} left "
            f"of it, and {by_other:.3g} if they were degrees: are they in °?"
        )


def warn_of_steps(steps: Floats, count: int, inner: int = 0) -> None:
    """Notice a recording whose time steps are long.

    Parameters
    ----------
    steps
        Seconds, shape () or (N,).
    count
        How many samples there are.
    inner
        How many functions lie between the public one and this.
    """
    if count < ENOUGH or not steps.max() > _SLOW:
        return
    usual = float(np.median(steps))
    if usual > _SLOW:
        _warn(f"dt: expected seconds, got mostly {usual:.4g}: are they milliseconds?", inner)


def warn_of_rates(
    rates: Floats, steps: Floats, *vectors: Floats, longest: float = inf, inner: int = 0
) -> None:
    """Notice a recording whose rates are faster than gyros, than the sampling, or than the body.

    Parameters
    ----------
    rates
        Of the gyros, rad/s, shape (N, 3).
    steps
        Seconds, shape () or (N,).
    *vectors
        What accelerometer and magnetometer read, shape (N, 3), which turn as the body does.
    longest
        A longer step is a gap, through which no rate is held.
    inner
        How many functions lie between the public one and this.
    """
    if not rates.size:
        return
    most = sqrt(3) * float(max(rates.max(), -rates.min()))  # or NaN, of which the rest can tell
    if most < FAST and most * float(steps.max()) < pi:
        warn_of_steps(steps, len(rates), inner + 1)
        for vector in vectors:
            doubt = in_doubt(rates, vector, steps)
            if doubt:
                _warn(
                    "body_rates: expected rad/s, got readings that another factor lets turn the "
                    f"other sensor's readings as they do: {doubt}",
                    inner,
                )
                return
        return
    sizes = lengths(np.where(complete(rates, WILD_RATE)[:, np.newaxis], rates, 0.0))
    if len(sizes) >= ENOUGH and np.mean(sizes > FAST) > _SELDOM:
        fast = float(np.median(sizes[sizes > FAST]))
        _warn(
            f"body_rates: expected rad/s, got {fast:.4g} and the like, faster than gyros tell: are "
            "they in °/s?",
            inner,
        )
        return
    warn_of_steps(steps, len(rates), inner + 1)
    with np.errstate(all="ignore"):
        turns = np.where(steps <= longest, sizes * steps, 0.0)
    beyond = np.flatnonzero(turns > pi)
    if beyond.size:
        _warn(_turn(turns[beyond[0]], f" at {beyond[0]}, the first of {beyond.size}"), inner)


def warn_of_turn(rates: Sequence[float], step: float, longest: float = inf) -> None:
    """Notice one sample of a stream that turns farther than the sampling can follow."""
    size = hypot(*rates)
    if step <= longest and size < WILD_RATE and size * step > pi:
        _warn(_turn(size * step, ""))


def _turn(turn: float, where: str) -> str:
    return (
        "body_rates and dt: expected turns of half a revolution at most in a time step, got "
        f"{turn:.4g} rad{where}: are the rates in rad/s, and dt in seconds?"
    )


def _warn(message: str, inner: int = 0) -> None:
    # The caller of the public function that calls one of these.
    warnings.warn(message, UnitWarning, stacklevel=4 + inner)
