"""Up as an average in a frame that does not turn."""

from types import MappingProxyType

from sympy import Function, ImmutableMatrix, Integral, MatrixSymbol, Symbol, exp, oo, sin

from chr_notes.derivations import averaging as derived
from chr_notes.derivations import dead_reckoning
from chr_notes.derivations.averaging import speed, t, tau
from chr_notes.derivations.estimation import accel_noise, bias
from chr_notes.derivations.euler import rotation
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.telling import Told
from chr_notes.symbols import T, g

FORCE = MatrixSymbol(r"\mathbf{f}_I", 3, 1)
MEAN = Symbol(r"\overline{a}", real=True)
LEAN, BIAS_LEAN = (
    Symbol(rf"\epsilon_{{\text{{{name}}}}}", positive=True) for name in ("mean", "bias")
)
WEIGHT, MEAN_AGE = Symbol("h(u)"), Symbol(r"\overline{u}")
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

TIME_CONSTANT = Told(
    (
        Step(
            "The frame is held still by gyros, and their bias turns it. So what is old must be "
            "forgotten. The flattest low-pass of second order gives this weight to what came in a "
            "time u ago,",
            equation(WEIGHT, 2 / tau * exp(-_AGE / tau) * sin(_AGE / tau)),
        ),
        Step(
            "so that on average it is as old as the time constant.",
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
            WEIGHT: _WEIGHTS,
            MEAN_AGE: Integral(_AGE * _WEIGHTS, (_AGE, 0, oo)),
            BIAS_LEAN: derived.bias_error(),
            NOISE: accel_noise**2 * derived.noise_share(),
            BEST: derived.best_time_constant(),
        }
    ),
)
"""How long to average."""
