"""Tilt from the reading of an accelerometer, and what one number decides in an observer."""

from types import MappingProxyType

from sympy import ImmutableMatrix, Integer, MatrixSymbol, Symbol, cos, sin, sqrt

from chr_notes.derivations import estimation as derived
from chr_notes.derivations.estimation import L, accel_noise, gyro_noise
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.told import Told
from chr_notes.symbols import ACCELEROMETER, Angle, AngularRate, T, g, phi, theta

READING = MatrixSymbol(r"\mathbf{a}", 3, 1)
_X, _Y, _Z = ACCELEROMETER
_AT_REST = derived.accelerometer_at_rest()

TILT = Told(
    (
        Step(
            "At rest the reading is minus gravity, seen from the body. Yaw is not in it.",
            equation(
                READING,
                ImmutableMatrix(
                    [g * sin(theta), -g * sin(phi) * cos(theta), -g * cos(phi) * cos(theta)]
                ),
            ),
        ),
        Step(
            "Minus y and minus z are sine and cosine of roll with one factor, which is positive, "
            "unless the nose points straight up or down: atan2 needs no more, and it drops out.",
            equation(
                ImmutableMatrix([-_Y, -_Z]), g * cos(theta) * ImmutableMatrix([sin(phi), cos(phi)])
            ),
        ),
        Step(
            "Together they are as long as that factor. So x and this length are sine and cosine of "
            "pitch, again with one factor.",
            equation(
                ImmutableMatrix([_X, sqrt(_Y**2 + _Z**2)]),
                g * ImmutableMatrix([sin(theta), cos(theta)]),
            ),
        ),
    ),
    MappingProxyType({READING: _AT_REST, **dict(zip(ACCELEROMETER, _AT_REST, strict=True))}),
)
"""Roll and pitch from the three numbers of a reading at rest."""

# Errors before and after a step, of the prediction, and those that the sensors add.
BEFORE, PREDICTED, AFTER = (Angle(name, real=True) for name in ("e_k", "e_k^{+}", "e_{k+1}"))
GYRO, ACCEL = AngularRate(r"\delta_k", real=True), Angle(r"\eta_k", real=True)
# Their variances; that of the settled error, and the gain at which it is least.
VARIANCE, NEXT = Symbol("V_k", positive=True), Symbol("V_{k+1}", positive=True)
SETTLED = Symbol(r"V_{\infty}", positive=True)
BEST = Symbol(r"L_{\text{best}}", positive=True)
# The same by Kalman's filter: variance of the settled prediction, and the gain.
P_PLUS, K = Symbol("P^{+}", positive=True), Symbol("K", positive=True)

_new, _errors = derived.error_step()
_ERRORS = {_errors["before"]: BEFORE, _errors["gyro"]: GYRO, _errors["accel"]: ACCEL}
_STEP = _new.subs(_ERRORS)

ERROR = Told(
    (
        Step(
            "The gyro reads the rate and an error δ, and holds both for one period. So the error "
            "of the prediction is the one before and T times that of the gyro.",
            equation(PREDICTED, BEFORE + T * GYRO),
        ),
        Step(
            "The update keeps the part 1 − L of it, and takes in the part L of the accelerometer's "
            "error η.",
            equation(AFTER, (1 - L) * PREDICTED + L * ACCEL),
        ),
        Step(
            "That is all. The truth has dropped out: whatever the angle does, its errors obey one "
            "line.",
            equation(AFTER, (1 - L) * (BEFORE + T * GYRO) + L * ACCEL),
        ),
    ),
    MappingProxyType({AFTER: _STEP, PREDICTED: _STEP.subs(L, 0)}),
)
"""One step of the observer, for its error."""

_VARIANCE = sum(
    (
        _STEP.coeff(each) ** 2 * size
        for each, size in ((BEFORE, VARIANCE), (GYRO, gyro_noise**2), (ACCEL, accel_noise**2))
    ),
    Integer(0),
)

VARIANCES = Told(
    (
        Step(
            "Let both errors be white noise. The three parts of the new error have nothing to do "
            "with one another, so their squares add up.",
            equation(
                NEXT,
                (1 - L) ** 2 * (VARIANCE + T**2 * gyro_noise**2) + L**2 * accel_noise**2,
            ),
        ),
        Step(
            "It has settled when a step leaves it as it is. What is lost in one step, 1 − (1 − L)² "
            "of it, is what the two sensors bring.",
            equation(
                L * (2 - L) * SETTLED,
                (1 - L) ** 2 * T**2 * gyro_noise**2 + L**2 * accel_noise**2,
            ),
        ),
    ),
    MappingProxyType({NEXT: _VARIANCE, SETTLED: derived.steady_variance()}),
)
"""From the error of one step to the variance that stays."""

BEST_GAIN = Told(
    (
        Step(
            "Where the settled variance is least, its slope by L is zero. By the quotient's rule, "
            "halved and sorted:",
            equation(
                (BEST * accel_noise**2 - (1 - BEST) * T**2 * gyro_noise**2) / (1 - BEST),
                ((1 - BEST) ** 2 * T**2 * gyro_noise**2 + BEST**2 * accel_noise**2)
                / (BEST * (2 - BEST)),
            ),
        ),
        Step(
            "Sort by the two noises. L(2 − L) and (1 − L)² are one together, and that is all that "
            "is left.",
            equation(BEST**2 * accel_noise**2, (1 - BEST) * T**2 * gyro_noise**2),
        ),
        Step(
            "Only the quotient of the two noises counts. Where L is small against one, the left "
            "side is L itself:",
            equation(BEST / sqrt(1 - BEST), T * gyro_noise / accel_noise),
        ),
    ),
    MappingProxyType({BEST: derived.best_gain()}),
)
"""The gain with the least variance."""

_K = derived.kalman_gain()

KALMAN = Told(
    (
        Step(
            "Kalman's filter carries along the variance P⁺ of its prediction, and weighs both by "
            "the inverse of their variances.",
            equation(K, P_PLUS / (P_PLUS + accel_noise**2)),
        ),
        Step(
            "The update keeps (1 − K)² of it and takes in K² of the accelerometer's, as above. "
            "With this very K that is 1 − K of it.",
            equation((1 - K) ** 2 * P_PLUS + K**2 * accel_noise**2, (1 - K) * P_PLUS),
        ),
        Step(
            "The next gyro step adds its own. Settled, that brings back what there was.",
            equation((1 - K) * P_PLUS + T**2 * gyro_noise**2, P_PLUS),
        ),
        Step(
            "So what the update takes away is what the gyro step adds.",
            equation(K * P_PLUS, T**2 * gyro_noise**2),
        ),
        Step(
            "And the first line, multiplied by its denominator, says what the update leaves.",
            equation((1 - K) * P_PLUS, K * accel_noise**2),
        ),
        Step(
            "Divide one by the other, and the variance drops out. This is the line from above.",
            equation(K**2 * accel_noise**2, (1 - K) * T**2 * gyro_noise**2),
        ),
    ),
    MappingProxyType({K: _K, P_PLUS: T**2 * gyro_noise**2 / _K}),
)
"""The settled gain of Kalman's filter, from its own recursion."""
