"""The paper's statements on rotations, gravity and rates before the judgement."""

from sympy import Eq, ImmutableMatrix, MatMul, Rational, asin, atan2, sin, sqrt

from chr_notes.derivations.steps import Step
from chr_notes.ledger import ranges
from chr_notes.ledger.case import DEGREE, Case
from chr_notes.ledger.validation_reading import (
    READ,
    READ_RATES,
    READINGS,
    SOME_ATTITUDE,
    VECTOR,
    WITHOUT_YAW,
)
from chr_notes.printed import validation as printed
from chr_notes.printed.statement import InOrder, chain
from chr_notes.symbols import BODY_RATES, g, phi, pitch_rate, psi, roll_rate, theta, yaw_rate

PITCH_RANGE = ranges.up_to_right_angle(theta)

LABEL = (
    "The label and the words that go with it say: from the inertial frame to the body. The paper "
    "uses it so in equation 2, but the other way round in equations 1, 5, 8 and 12. The ledger "
    "reads it by its label everywhere."
)
NO_INFORMATION = Step(
    "Gravity in the body frame, put into the numerator and the denominator, makes both vanish at "
    "every attitude.",
    InOrder(Eq(printed.GRAVITY_X, 0), Eq(printed.GRAVITY_Y, 0)),
)
TANGENT_REMARK = (
    "Numerator and denominator are both zero at every attitude, so the line says 0 · tan ψ = 0 "
    "and nothing about yaw. Dividing by the zero makes a formula without a value."
)

SETTLED = (
    Case(
        "validation.1",
        READ,
        correction=chain(printed.R_BI, printed.TURNS, printed.MATRIX),
        witness=SOME_ATTITUDE,
        readings=READINGS,
        steps=(
            Step(
                "The matrix from the inertial frame to the body has the three turns of the frame "
                "as factors, the first one on the right. Its transpose is the way back.",
                Eq(printed.R_IB.T, printed.R_BI),
            ),
        ),
        remark="Product and elements are right for the matrix from the body to the inertial frame. "
        + LABEL,
    ),
    Case("validation.2", READ, readings=READINGS),
    Case(
        "validation.3",
        READ,
        given=(PITCH_RANGE,),
        condition=ranges.acute(phi, theta),
        witness={phi: 150 * DEGREE, theta: 0, g: Rational(98, 10)},
        steps=(
            Step(
                "With both components of gravity the two-argument arctangent finds the quadrant.",
                Eq(printed.ROLL_ACCEL, atan2(printed.G_YB, printed.G_ZB)),
            ),
        ),
        remark="Beyond 90° of roll the quotient is the same as 180° away. These are components of "
        "gravity; an accelerometer at rest reads minus gravity, and with its readings both "
        "arguments of the arctangent need a minus.",
    ),
    Case(
        "validation.4",
        READ,
        given=(PITCH_RANGE,),
        correction=Eq(
            printed.PITCH_ACCEL,
            asin(-printed.G_XB / sqrt(printed.G_XB**2 + printed.G_YB**2 + printed.G_ZB**2)),
        ),
        witness={phi: 0, theta: 30 * DEGREE, g: Rational(98, 10)},
        steps=(
            Step(
                "By the paper's own equation 2, the x component of gravity is minus g sin θ.",
                Eq(printed.G_XB, -g * sin(theta)),
            ),
        ),
        remark="The sign is lost: nose up, gravity points to the tail. Without the minus it is "
        "right for what an accelerometer reads, minus gravity, which the paper does not "
        "distinguish from gravity.",
    ),
    Case(
        "validation.5",
        READ,
        correction=Eq(printed.G_I, MatMul(printed.R_BI, printed.G_B)),
        witness={**SOME_ATTITUDE, g: Rational(98, 10)},
        readings=READINGS,
        steps=(
            Step(
                "The way back from the body is the transpose.",
                Eq(printed.R_BI, printed.R_IB.T),
            ),
        ),
        remark="Equation 2 has the same symbol for the opposite direction. " + LABEL,
    ),
    *(
        Case(
            name,
            READ,
            correction=NO_INFORMATION.statement,
            witness={**SOME_ATTITUDE, g: Rational(98, 10)},
            steps=(NO_INFORMATION,),
            remark=TANGENT_REMARK,
        )
        for name in ("validation.6", "validation.7")
    ),
    Case(
        "validation.8",
        READ,
        correction=chain(
            ImmutableMatrix(BODY_RATES),
            MatMul(printed.R_IB, printed.RATES_BY_AXES),
            MatMul(printed.R_IB, printed.RATES_I),
        ),
        witness={**SOME_ATTITUDE, roll_rate: 10 * DEGREE, pitch_rate: 0, yaw_rate: 0},
        readings=READINGS,
        steps=(
            Step(
                "The three angular velocities stand in the inertial frame and add up there; the "
                "matrix from the inertial frame takes the sum to the body. Its transpose leads "
                "from the body to the inertial frame.",
                Eq(printed.R_IB.T, printed.R_BI),
            ),
        ),
        remark="With the matrix that equation 1 prints the transpose is right, with what its label "
        "says it is one too many. " + LABEL,
    ),
    Case("validation.9", READ_RATES),
    Case(
        "validation.a",
        READ,
        correction=Eq(printed.V_I, MatMul(printed.MATRIX, printed.V_B)),
        witness={**SOME_ATTITUDE, **dict(zip(VECTOR, (1, 0, 0), strict=True))},
        steps=(
            Step(
                "The printed elements are those of the derived matrix from the body to the "
                "inertial frame.",
                Eq(printed.R_BI, printed.MATRIX),
            ),
        ),
        remark="The sentence fits the label of the matrix, not its elements: these take the "
        "components from the body to the inertial frame.",
    ),
    Case(
        "validation.b",
        READ,
        correction=Eq(
            MatMul(printed.R_IB, printed.G_I), MatMul(WITHOUT_YAW, printed.G_I), evaluate=False
        ),
        witness={psi: 30 * DEGREE},
        steps=(
            NO_INFORMATION,
            Step(
                "The reason is this: a turn about the vertical leaves gravity as it is, so what "
                "the accelerometer reads is the same at every yaw.",
                Eq(
                    MatMul(printed.R_IB, printed.G_I),
                    MatMul(WITHOUT_YAW, printed.G_I),
                    evaluate=False,
                ),
            ),
        ),
        remark="The conclusion is right, the reason is not. Equations 6 and 7 do not contradict "
        "each other: both read 0/0, and from a division by zero anything seems to follow.",
    ),
)
