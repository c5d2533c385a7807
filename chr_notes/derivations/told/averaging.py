"""Up as an average in a frame that does not turn."""

from types import MappingProxyType

from sympy import (
    Function,
    ImmutableMatrix,
    Integral,
    MatrixSymbol,
    Symbol,
    exp,
    oo,
    pi,
    sin,
    sqrt,
)

from chr_notes.derivations import averaging as derived
from chr_notes.derivations import dead_reckoning
from chr_notes.derivations.averaging import speed, t, tau
from chr_notes.derivations.estimation import accel_noise, bias
from chr_notes.derivations.euler import rotation
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.told import Told
from chr_notes.symbols import T, g

FORCE = MatrixSymbol(r"\mathbf{f}_I", 3, 1)
MEAN = Symbol(r"\overline{a}", real=True)
LEAN, BIAS_LEAN = (
    Symbol(rf"\epsilon_{{\text{{{name}}}}}", positive=True) for name in ("mean", "bias")
)
WEIGHT, MEAN_AGE = Symbol("h(u)"), Symbol(r"\overline{u}")
HILL, NEXT_HILL = Symbol("h_1", positive=True), Symbol("h_2", negative=True)
NOISE = Symbol(r"\operatorname{var}_{\text{accel}}", positive=True)
BEST = Symbol(r"\tau_{\text{best}}", positive=True)
_AGE = Symbol("u", positive=True)
_VELOCITY = Function("v")
_north, _east, _down = dead_reckoning.ACCELERATION
_WEIGHTS = derived.impulse_response().subs(t, _AGE)

MEAN_OF_MOTION = Told(
    (
        Step(
            "Bring what the accelerometer feels to a frame that does not turn. Gravity stands "
            "still there, one g upwards, and the acceleration of the body is added to it.",
            equation(FORCE, ImmutableMatrix([_north, _east, _down - g])),
        ),
        Step(
            "Take the mean over a time t. Of a true acceleration it is the velocity gained, "
            "divided by the time, whatever happened in between.",
            equation(MEAN, (_VELOCITY(t) - _VELOCITY(0)) / t),
        ),
        Step(
            "A body that stays in the room has some speed V that it does not exceed. From −V to V "
            "is the most that it can gain: by no more than this angle does the mean lean.",
            equation(LEAN, 2 * speed / (g * t)),
        ),
    ),
    MappingProxyType(
        {
            FORCE: rotation("B", "I") * dead_reckoning.accelerometer_reading(),
            MEAN: derived.mean_acceleration(),
            LEAN: derived.mean_motion_error(),
        }
    ),
)
"""Why motion averages out in a frame at rest."""

WEIGHTED_MOTION = Told(
    (
        Step(
            "The filter gives this weight to what came in a time u ago. (Of all of second order "
            "it lets the slow pass most evenly.)",
            equation(WEIGHT, 2 / tau * exp(-_AGE / tau) * sin(_AGE / tau)),
        ),
        Step(
            "It goes up to a hill at u = π τ/4 and down to a smaller one below zero at 5 π τ/4, "
            "and so on. Each is smaller than the last by this factor.",
            equation(NEXT_HILL / HILL, -exp(-pi)),
        ),
        Step(
            "The first hill is so high.",
            equation(HILL, sqrt(2) * exp(-pi / 4) / tau),
        ),
        Step(
            "By parts, weights on an acceleration are their slopes on its velocity. So the mean "
            "is at most V times all the way that the weights go up and down: twice the sum of "
            "all hills, a geometric series.",
            equation(LEAN, 2 * speed * HILL / (g * (1 - exp(-pi)))),
        ),
        Step(
            "In numbers the factor is 1.35.",
            equation(LEAN, 2 * sqrt(2) * exp(-pi / 4) / (1 - exp(-pi)) * speed / (g * tau)),
        ),
    ),
    MappingProxyType(
        {
            WEIGHT: _WEIGHTS,
            HILL: _WEIGHTS.subs(_AGE, pi * tau / 4),
            NEXT_HILL: _WEIGHTS.subs(_AGE, 5 * pi * tau / 4),
            LEAN: derived.motion_error(),
        }
    ),
)
"""How much of a motion in bounds the weights of the filter let through."""

TIME_CONSTANT = Told(
    (
        Step(
            "By these weights, what is averaged is on average as old as the time constant.",
            equation(MEAN_AGE, tau),
        ),
        Step(
            "A bias b turns gravity in the frame evenly, while the body does not turn, and the "
            "mean lags behind by its age.",
            equation(BIAS_LEAN, bias * tau),
        ),
        Step(
            "White noise of the accelerometer is averaged over more samples, the longer the time "
            "constant.",
            equation(NOISE, accel_noise**2 * T / (2 * tau)),
        ),
        Step(
            "One falls with the time constant, the other grows. The sum of the squares has its "
            "least where the slope is zero:",
            equation(BEST**3, accel_noise**2 * T / (4 * bias**2)),
        ),
    ),
    MappingProxyType(
        {
            MEAN_AGE: Integral(_AGE * _WEIGHTS, (_AGE, 0, oo)),
            BIAS_LEAN: derived.bias_error(),
            NOISE: accel_noise**2 * derived.noise_share(),
            BEST: derived.best_time_constant(),
        }
    ),
)
"""How long to average."""
