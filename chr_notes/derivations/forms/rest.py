"""Form of a gyro's bias, learnt whenever the sensor has been at rest for a while.

At rest is a sensor whose rates and force stay near their means over the rest so far. What leaves
them begins a new one.
"""

from functools import cache

from sympy import Abs, And, Expr, ImmutableMatrix, Integer, Rational, Symbol, symbols

from chr_notes.derivations.computation import Choice, Computation, Let, otherwise
from chr_notes.derivations.forms import filters
from chr_notes.derivations.forms.averaging import LONGEST, WILD_FORCE, ZERO, share_of_mean
from chr_notes.symbols import ACCELEROMETER, BODY_RATES, T

RATE_MEANS = symbols("rest_p rest_q rest_r", real=True)
FORCE_MEANS = symbols("rest_x rest_y rest_z", real=True)
STILL = Symbol("still", real=True)
LEARNT = symbols("learnt_p learnt_q learnt_r", real=True)
STATE = (*RATE_MEANS, *FORCE_MEANS, STILL, *LEARNT)
REST = Symbol("rest", real=True)

STILL_RATE = Rational(35, 1000)
"""Off the mean, rad/s: 2 degrees per second, far above a gyro's noise, far below a hand's turns."""
STILL_FORCE = Rational(1, 20)
"""Off the mean, as part of it."""
LARGEST = Rational(1, 20)
"""A steady reading of more, rad/s, is a steady turn."""
REMEMBERED = Integer(10)
"""Times `REST`, the mean looks back no further, for a bias drifts as the sensor warms up."""


def _size(vector: tuple[Expr, ...]) -> Expr:
    return sum(map(Abs, vector))


@cache
def bias() -> Computation:
    """Means over the rest so far, for how long it has been one, and the bias learnt last."""
    known, stays, lasts = symbols("sample_known stays lasts", real=True)
    share, length, size = symbols("share rest_length force_size", real=True)
    now = (*BODY_RATES, *ACCELEROMETER)
    before = (*RATE_MEANS, *FORCE_MEANS)
    means = symbols("mean_p mean_q mean_r mean_x mean_y mean_z", real=True)
    still = Symbol("still_after", real=True)
    found = symbols("bias_p bias_q bias_r", real=True)
    off = tuple(n - b for n, b in zip(now, before, strict=True))
    nearer = tuple(b + share * o for b, o in zip(before, off, strict=True))
    taken = (REST, REMEMBERED * REST)
    return Computation(
        (
            Let(size, _size(ACCELEROMETER)),
            Let(
                known,
                And(
                    filters.are_rates(filters.SPEED_SQUARED),
                    size > 1 / WILD_FORCE,
                    size < WILD_FORCE,
                ),
            ),
            Let(
                stays,
                And(
                    known,
                    T <= LONGEST,
                    _size(off[:3]) <= STILL_RATE,
                    _size(off[3:]) <= STILL_FORCE * _size(FORCE_MEANS),
                ),
            ),
            Let(length, STILL + T),
            share_of_mean(share, T, length),
            Choice(
                (*means, still),
                (
                    (And(stays, length <= taken[1]), (*nearer, length)),
                    (stays, (*nearer, STILL)),
                    (known, (*now, ZERO)),
                    otherwise(*before, STILL),
                ),
            ),
            Let(lasts, And(stays, still >= REST, *(Abs(m) <= LARGEST for m in means[:3]))),
            Choice(found, ((lasts, means[:3]), otherwise(*LEARNT))),
        ),
        ImmutableMatrix([*means, still, *found]),
    )
