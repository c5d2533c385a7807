"""The note on dead reckoning before the judgement."""

from sympy import (
    Eq,
    Expr,
    ImmutableMatrix,
    Integral,
    Le,
    MatAdd,
    MatMul,
    MatrixSymbol,
    Ne,
    Rational,
    Symbol,
    cos,
    exp,
    expand,
    pi,
    sin,
    symbols,
)

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.estimation import euler_step, weight
from chr_notes.derivations.euler import Z, rotation
from chr_notes.derivations.steps import Step
from chr_notes.ledger import table_1
from chr_notes.ledger.case import DEGREE, Case, Condition, complete
from chr_notes.ledger.reading import reading
from chr_notes.printed import DOCUMENTS
from chr_notes.printed import dead_reckoning as printed
from chr_notes.printed import dead_reckoning_claims as claims
from chr_notes.printed.statement import InOrder
from chr_notes.symbols import T, g, m, phi, psi, theta

# The gravity that is added, which may not be the local one; the accelerometer's own error.
ADDED_G = Symbol(r"\hat{g}", positive=True)
OWN_ERROR = ImmutableMatrix(symbols("varepsilon_x:z", real=True))
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
        claims.ERROR_OF_ACCELERATION: derived.residual_acceleration,
        SUMMED_POSITION: derived.position_by_steps,
        **table_1.MEANING,
    }
)

RESIDUE_OF_TILT = Step(
    "At rest the accelerometer reads minus gravity. Turned by an attitude of which the vertical is "
    "off by ε, it does not cancel the gravity that is added: along the ground g sin ε stays, in "
    "the direction of the tilt, and a little along the vertical.",
    Eq(
        printed.RESIDUE,
        ImmutableMatrix(
            [
                g * sin(derived.tilt_error) * cos(derived.azimuth),
                g * sin(derived.tilt_error) * sin(derived.azimuth),
                g * (1 - cos(derived.tilt_error)),
            ]
        ),
    ),
)

TILTED = Condition(Ne(cos(derived.tilt_error), 1))
ONLY_YAW = {
    derived.tilt_error: 0,
    derived.azimuth: 0,
    derived.yaw_error: 5 * DEGREE,
    g: table_1.PRINTED_G,
}
HELD = (
    "An estimate by Euler integration, as in the note on attitude estimation: the rate of change "
    "is held through the period. It is the better the shorter the period."
)

SETTLED = (
    Case(
        "dead_reckoning.2.1",
        steps=(
            Step(
                "An accelerometer feels what holds its proof mass, not the pull of gravity: all "
                "forces less that one, per mass.",
                Eq(printed.A_M, MatMul(1 / m, MatAdd(FORCES, -WEIGHT))),
            ),
            Step(
                "All forces together make the acceleration, by Newton's second law, and gravity "
                "points down in the inertial frame.",
                InOrder(
                    Eq(FORCES, MatMul(m, printed.A_B)),
                    Eq(WEIGHT, MatMul(m, printed.R_IB, printed.GRAVITY)),
                ),
            ),
        ),
    ),
    Case(
        "dead_reckoning.2.2",
        steps=(
            Step(
                "What the reading lacks of the acceleration is gravity, by the equation before.",
                Eq(MatAdd(printed.A_M, -printed.A_B), MatMul(-1, printed.R_IB, printed.GRAVITY)),
            ),
        ),
    ),
    Case(
        "dead_reckoning.2.3",
        steps=(
            Step(
                "The body's components are taken to the inertial frame.",
                Eq(printed.A_I, MatMul(printed.R_BI, printed.A_B)),
            ),
            Step(
                "Gravity has gone to the body and comes back as it was.",
                Eq(MatMul(printed.R_BI, printed.R_IB, printed.GRAVITY), printed.GRAVITY),
            ),
        ),
    ),
    Case(
        "dead_reckoning.2.b",
        remark="The normal forces are read as what keeps the sensor from falling, minus gravity: "
        "the equation that follows has this. In a lift that starts upwards the floor pushes "
        "harder than that; the surplus is what accelerates the sensor, and it must stay.",
    ),
    Case(
        "dead_reckoning.3.1",
        steps=(
            Step(
                "The acceleration is how fast the velocity changes; so the velocity is what "
                "changes as fast.",
                Eq(VELOCITY_RATE, ACCELERATION_THEN),
            ),
        ),
        remark="An integral without limits has its constant: here the velocity at the start. An "
        "accelerometer cannot know it; at a steady 10 m/s it reads what it reads at rest. To "
        "start from zero there is a mistake that stays.",
    ),
    Case(
        "dead_reckoning.3.2",
        steps=(
            Step("The velocity is how fast the position changes.", Eq(POSITION_RATE, printed.V_I)),
        ),
        remark="Its two constants are position and velocity at the start. With 10 m/s at the start "
        "left out, the position is 600 m off after a minute.",
    ),
    Case(
        "dead_reckoning.3.3",
        steps=(
            Step(
                "With the acceleration held through one period, each component gains its area.",
                Eq(
                    Integral(derived.ACCELERATION[0], (derived.t, 0, T)),
                    T * derived.ACCELERATION[0],
                ),
            ),
            Step(
                "If the acceleration changes at the rate j meanwhile, this is what the step leaves "
                "out.",
                Eq(MatAdd(EXACT_VELOCITY, -printed.V_NEXT), T**2 / 2 * derived.JERK),
            ),
        ),
        remark=HELD,
    ),
    Case(
        "dead_reckoning.3.4",
        steps=(
            Step(
                "With the velocity held through one period, each component gains its area.",
                Eq(Integral(derived.VELOCITY[0], (derived.t, 0, T)), T * derived.VELOCITY[0]),
            ),
            Step(
                "With an acceleration a that changes at the rate j meanwhile, this is what the "
                "step leaves out.",
                Eq(
                    MatAdd(EXACT_POSITION, -printed.R_NEXT),
                    T**2 / 2 * derived.ACCELERATION + T**3 / 6 * derived.JERK,
                ),
            ),
            Step(
                "With a constant acceleration from rest, n of the note's two steps add up to the "
                "exact ½ a (nT)² less a remainder, as if each velocity came one period late.",
                Eq(
                    SUMMED_POSITION,
                    derived.a * (derived.n * T) ** 2 / 2 - derived.a * T * (derived.n * T) / 2,
                ),
            ),
        ),
        remark=f"{HELD} The remainder, ½ a T times the time, shrinks with the period T; adding "
        "½ T² a[k] to the step removes it.",
    ),
    Case(
        "dead_reckoning.4.f",
        condition=Condition(Eq(ADDED_G, g)),
        witness={
            **dict.fromkeys((phi, theta, psi, *derived.ACCELERATION, *OWN_ERROR), 0),
            ADDED_G: table_1.PRINTED_G,
            g: Rational(9832, 1000),
        },
        root="local-gravity",
        weight="small print",
        remark="The gravity that is added must be the local one. It runs from 9.780 m/s² at the "
        "equator to 9.832 at the poles; with the note's 9.8 a body at rest at a pole seems to "
        "accelerate by 0.032 m/s², more than 0.1° of tilt would make.",
    ),
    Case(
        "dead_reckoning.4.g",
        condition=TILTED,
        witness=ONLY_YAW,
        root="tilt-only",
        weight="small print",
        steps=(RESIDUE_OF_TILT,),
        remark="It takes an error of tilt. An error of yaw alone turns everything about the "
        "vertical, and gravity with it into itself: at rest nothing is left over.",
    ),
    Case("dead_reckoning.4.h", reported=Le(claims.PRODUCT_ERROR, 2 * pi / 180, evaluate=False)),
    Case(
        "dead_reckoning.4.i",
        condition=TILTED,
        witness=ONLY_YAW,
        root="tilt-only",
        weight="small print",
        steps=(RESIDUE_OF_TILT,),
        remark="What shows is a tilt. An error of yaw alone shows only while the body accelerates "
        "along the ground.",
    ),
)

CASES = complete(DOCUMENTS["dead_reckoning"], READ, (*SETTLED, *table_1.SETTLED))
