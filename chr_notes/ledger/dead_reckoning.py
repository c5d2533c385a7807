"""The note on dead reckoning before the judgement."""

from sympy import (
    Eq,
    ImmutableMatrix,
    Integral,
    Le,
    MatAdd,
    MatMul,
    MatrixSymbol,
    Rational,
    cos,
    pi,
    sin,
)

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger import table_1
from chr_notes.ledger.case import Case, complete
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.dead_reckoning_reading import (
    ACCELERATION_THEN,
    ADDED_G,
    EXACT_POSITION,
    EXACT_VELOCITY,
    FORCES,
    OWN_ERROR,
    POSITION_RATE,
    READ,
    SUMMED_POSITION,
    VELOCITY_RATE,
    WEIGHT,
)
from chr_notes.printed import DOCUMENTS
from chr_notes.printed import dead_reckoning as printed
from chr_notes.printed import dead_reckoning_claims as claims
from chr_notes.printed.statement import InOrder
from chr_notes.symbols import T, g, m, phi, psi, theta


def tilt_leaves(residue: MatrixSymbol) -> Step:
    """Tell what an error of tilt leaves of gravity at rest, under the name that it has."""
    return Step(
        "At rest the accelerometer reads minus gravity. Turned by an attitude of which the "
        "vertical is off by ε, it does not cancel the gravity that is added: along the ground "
        "g sin ε stays, in the direction of the tilt, and a little along the vertical.",
        Eq(
            residue,
            ImmutableMatrix(
                [
                    g * sin(derived.tilt_error) * cos(derived.azimuth),
                    g * sin(derived.tilt_error) * sin(derived.azimuth),
                    g * (1 - cos(derived.tilt_error)),
                ]
            ),
        ),
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
        "accelerometer cannot know it; straight on at a steady 10 m/s it reads what it reads at "
        "rest. A sum that starts from zero there stays as far off.",
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
                InOrder(
                    Eq(printed.A_K, derived.ACCELERATION),
                    Eq(
                        Integral(derived.ACCELERATION[0], (derived.t, 0, T)),
                        T * derived.ACCELERATION[0],
                    ),
                ),
            ),
            Step(
                "If the acceleration changes at the rate j meanwhile, this is what the step leaves "
                "out.",
                Eq(MatAdd(EXACT_VELOCITY, -printed.V_NEXT), T**2 / 2 * derived.JERK),
            ),
        ),
        remark="An estimate by Euler integration, as in the note on attitude estimation: the rate "
        "of change is held through the period. It is the better the shorter the period.",
    ),
    Case(
        "dead_reckoning.3.4",
        steps=(
            Step(
                "With the velocity held through one period, each component gains its area.",
                InOrder(
                    Eq(printed.V_K, derived.VELOCITY),
                    Eq(Integral(derived.VELOCITY[0], (derived.t, 0, T)), T * derived.VELOCITY[0]),
                ),
            ),
            Step(
                "With a constant acceleration from rest, here to the north, n of the note's two "
                "steps add up to the exact ½ a (nT)² less a remainder, as if each velocity came "
                "one period late.",
                Eq(
                    SUMMED_POSITION,
                    derived.ACCELERATION[0] * (derived.n * T) ** 2 / 2
                    - derived.ACCELERATION[0] * T * (derived.n * T) / 2,
                ),
            ),
            Step(
                "With an acceleration a that changes at the rate j meanwhile, this is what one "
                "step leaves out.",
                Eq(
                    MatAdd(EXACT_POSITION, -printed.R_NEXT),
                    T**2 / 2 * derived.ACCELERATION + T**3 / 6 * derived.JERK,
                ),
            ),
        ),
        remark="The remainder, ½ a T times the time, shrinks with the period T; adding ½ T² a[k] "
        "to the step removes it as long as the acceleration is constant.",
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
        told_in="dead_reckoning.2.3",
        steps=(
            Step(
                "With an exact attitude the reading comes back as the acceleration less gravity, "
                "with the accelerometer's own error turned along. The gravity that is added, ĝ, "
                "leaves its difference from the local one.",
                Eq(
                    MatAdd(printed.ESTIMATED, -printed.A_I),
                    MatAdd(
                        MatMul(printed.R_BI, printed.OWN_ERROR),
                        ImmutableMatrix([0, 0, ADDED_G - g]),
                    ),
                ),
            ),
        ),
        remark="The gravity that is added must be the local one, as the symbol in "
        "dead_reckoning.2.3 says. It runs from 9.780 m/s² at the "
        "equator to 9.832 at the poles; with the note's 9.8 a body at rest at a pole seems to "
        "accelerate by 0.032 m/s², more than 0.1° of tilt would make.",
    ),
    Case(
        "dead_reckoning.4.g",
        steps=(tilt_leaves(printed.RESIDUE),),
        remark="In general: here with some error of tilt. An error of yaw alone turns everything "
        "about the vertical, and gravity with it into itself: at rest nothing is left over.",
    ),
    Case("dead_reckoning.4.h", reported=Le(claims.PRODUCT_ERROR, 2 * pi / 180, evaluate=False)),
    Case(
        "dead_reckoning.4.i",
        steps=(
            tilt_leaves(claims.BY_TILT),
            Step(
                "An error of yaw turns a level acceleration a, here to the north, about the "
                "vertical: this is what it is off by.",
                Eq(
                    claims.BY_YAW,
                    derived.ACCELERATION[0]
                    * ImmutableMatrix([cos(derived.yaw_error) - 1, sin(derived.yaw_error), 0]),
                ),
            ),
        ),
        remark="The errors are not zero, and the acceleration along the ground is not. While the "
        "motion is steady an error of yaw alone does not show, see dead_reckoning.4.g.",
    ),
)

CASES = complete(DOCUMENTS["dead_reckoning"], READ, (*SETTLED, *table_1.SETTLED))
