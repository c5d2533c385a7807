"""How the note on dead reckoning is read: what its symbols mean."""

from sympy import (
    Expr,
    ImmutableMatrix,
    MatrixSymbol,
    Ne,
    Symbol,
    cos,
    exp,
    expand,
    symbols,
)

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.estimation import euler_step, weight
from chr_notes.derivations.euler import Z, rotation
from chr_notes.ledger import table_1
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.reading import reading
from chr_notes.printed import dead_reckoning as printed
from chr_notes.printed import dead_reckoning_claims as claims
from chr_notes.symbols import g, m

# The gravity that is added, which may not be the local one; the accelerometer's own error.
ADDED_G = Symbol(r"\hat{g}", positive=True)
OWN_ERROR = ImmutableMatrix(symbols("varepsilon_x:z", real=True))
TILTED = Condition(Ne(cos(derived.tilt_error), 1))
# What steps speak of: the forces on the body, all and that of gravity; how fast velocity and
# position change; both exactly one period later; the position after n steps.
FORCES, WEIGHT = (MatrixSymbol(rf"\mathbf{{F}}{of}", 3, 1) for of in ("", "_g"))
VELOCITY_RATE, POSITION_RATE = (
    MatrixSymbol(rf"\dot{{\mathbf{{{of}}}}}_I", 3, 1) for of in ("v", "r")
)
ACCELERATION_THEN = MatrixSymbol(r"\mathbf{a}_I(t)", 3, 1)
EXACT_VELOCITY, EXACT_POSITION = (
    MatrixSymbol(rf"\mathbf{{{of}}}_I(t_k + T)", 3, 1) for of in ("v", "r")
)
SUMMED_POSITION = Symbol("r_n", real=True)


def _by_exponentials(expression: Expr) -> Expr:
    return expand(expand(expression).rewrite(exp))


def estimated_acceleration() -> ImmutableMatrix:
    """Follow the note's step: the attitude exact, the reading and the added gravity not.

    The reading is the specific force in the body frame and an error of the accelerometer's own.
    """
    there_and_back = (rotation("B", "I") * rotation("I", "B")).applyfunc(_by_exponentials)
    measured = there_and_back * (derived.ACCELERATION - g * Z) + rotation("B", "I") * OWN_ERROR
    return ImmutableMatrix(measured + ADDED_G * Z)


def held(before: ImmutableMatrix, rate: ImmutableMatrix) -> ImmutableMatrix:
    """Take a step of Euler integration, each component with its rate held."""
    return ImmutableMatrix([euler_step(*pair) for pair in zip(before, rate, strict=True)])


def antiderivative(gained: ImmutableMatrix, constant: ImmutableMatrix) -> ImmutableMatrix:
    """Read an integral without limits: it has its constant, the value at the start."""
    return ImmutableMatrix(gained + constant)


def error_by_yaw() -> ImmutableMatrix:
    """Take the error of acceleration by an error of yaw alone, north along the acceleration."""
    zero = (derived.tilt_error, derived.azimuth, *derived.ACCELERATION[1:])
    return ImmutableMatrix(derived.error_of_acceleration().subs(dict.fromkeys(zero, 0)))


READ = reading(
    {
        printed.A_I: derived.ACCELERATION,
        printed.A_B: lambda: ImmutableMatrix(rotation("I", "B") * derived.ACCELERATION),
        printed.A_M: derived.accelerometer_reading,
        printed.IN_GRAVITIES: lambda: derived.accelerometer_reading() / g,
        FORCES: lambda: ImmutableMatrix(m * rotation("I", "B") * derived.ACCELERATION),
        WEIGHT: weight,
        # What holds the body up against gravity.
        claims.NORMAL: lambda: ImmutableMatrix(-weight()),
        printed.V_I: lambda: derived.velocity_after(derived.velocity_gained()),
        printed.R_I: lambda: derived.position_after(derived.position_gained()),
        printed.INTEGRAL: lambda: antiderivative(derived.velocity_gained(), derived.VELOCITY),
        printed.DOUBLE_INTEGRAL: lambda: antiderivative(
            derived.position_gained(), derived.POSITION + derived.VELOCITY * derived.t
        ),
        VELOCITY_RATE: lambda: derived.velocity_after(derived.velocity_gained()).diff(derived.t),
        POSITION_RATE: lambda: derived.position_after(derived.position_gained()).diff(derived.t),
        ACCELERATION_THEN: derived.acceleration_then,
        printed.A_K: derived.ACCELERATION,
        printed.V_K: derived.VELOCITY,
        printed.R_K: derived.POSITION,
        printed.V_NEXT: held(derived.VELOCITY, derived.ACCELERATION),
        printed.R_NEXT: held(derived.POSITION, derived.VELOCITY),
        EXACT_VELOCITY: derived.velocity_after_step,
        EXACT_POSITION: derived.position_after_step,
        printed.ESTIMATED: estimated_acceleration,
        printed.OWN_ERROR: OWN_ERROR,
        printed.RESIDUE: derived.residual_acceleration,
        claims.BY_TILT: derived.residual_acceleration,
        claims.BY_YAW: error_by_yaw,
        SUMMED_POSITION: lambda: derived.position_by_steps().subs(
            derived.a, derived.ACCELERATION[0]
        ),
        **table_1.MEANING,
    },
    presumed=(
        Presumed(TILTED, "in general", "dead_reckoning.4.g"),
        Presumed(TILTED, "one of tilt at rest", "dead_reckoning.4.i"),
        Presumed(Condition(Ne(cos(derived.yaw_error), 1)), "one of yaw", "dead_reckoning.4.i"),
        Presumed(Condition(Ne(derived.ACCELERATION[0], 0)), "gathers speed", "dead_reckoning.4.i"),
    ),
)
