"""The paper's statements on rotations, gravity and rates before the judgement."""

from sympy import (
    Eq,
    ImmutableMatrix,
    MatMul,
    Rational,
    S,
    atan2,
    cos,
    sin,
    sqrt,
    tan,
)

from chr_notes.derivations.steps import Step
from chr_notes.ledger import ranges
from chr_notes.ledger.case import DEGREE, Case
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.validation_reading import (
    NOT_EAST,
    NOT_NORTH,
    READ_STEPS,
    READ_TILT,
    READINGS,
    SOME_ATTITUDE,
)
from chr_notes.printed import BY_ID
from chr_notes.printed import validation as printed
from chr_notes.printed.statement import InOrder
from chr_notes.symbols import (
    g,
    phi,
    psi,
    theta,
)

LABEL = (
    "The label and the words that go with it say: from the inertial frame to the body. The paper "
    "uses it so in equation 2, but the other way round in equations 1, 5, 8 and 12. The ledger "
    "reads it by its label everywhere."
)
ACCELEROMETER = (
    "The paper takes what an accelerometer reads for gravity; at rest it reads minus gravity, see "
    "validation.h."
)
WAY_BACK = Step(
    "The way back from the body is the transpose.", Eq(printed.R_BI, printed.R_IB.T, evaluate=False)
)
NUMERATOR = (
    -printed.G_ZB * cos(phi) * sin(theta)
    - printed.G_YB * sin(phi) * sin(theta)
    - printed.G_XB * cos(theta)
)
SIDEWAYS = printed.G_ZB * sin(phi) - printed.G_YB * cos(phi)
WHOLE = printed.G_XB**2 + printed.G_YB**2 + printed.G_ZB**2
TANGENT = tan(printed.YAW_ACCEL)
NO_INFORMATION = Step(
    "But gravity is vertical. Its components in the body frame, put into the numerator and the "
    "denominator, make both vanish at every attitude.",
    InOrder(Eq(NUMERATOR, 0), Eq(SIDEWAYS, 0)),
)
TANGENT_REMARK = (
    "Numerator and denominator are both zero at every attitude, so the line says 0 · tan ψ = 0 "
    "and nothing about yaw. Dividing by the zero makes a formula without a value. The tangent at "
    "the witness is that of its true yaw, which gravity does not tell."
)
ROTATED_GRAVITY = MatMul(printed.R_IB, printed.G_I)


def _for_vector(name: str, vector: tuple[S, ...]) -> Eq:
    """Print what an equation gives for another vector than gravity."""
    quotient = BY_ID[name].statement.rhs
    return Eq(TANGENT, quotient.xreplace(dict(zip(printed.GRAVITY, vector, strict=True))))


SETTLED = (
    Case(
        "validation.1",
        edits=(Edit(printed.R_IB, printed.R_BI, times=2),),
        witness=SOME_ATTITUDE,
        root="matrix-label",
        weight="misleads",
        readings=READINGS,
        steps=(
            Step(
                "Yaw turns the axes about z. A vector that has the components x, y in the turned "
                "axes has x cos ψ − y sin ψ along the old x-axis; pitch and roll likewise.",
                InOrder(
                    Eq(
                        printed.R_Z,
                        ImmutableMatrix(
                            [[cos(psi), -sin(psi), 0], [sin(psi), cos(psi), 0], [0, 0, 1]]
                        ),
                    ),
                    Eq(
                        printed.R_Y,
                        ImmutableMatrix(
                            [[cos(theta), 0, sin(theta)], [0, 1, 0], [-sin(theta), 0, cos(theta)]]
                        ),
                    ),
                    Eq(
                        printed.R_X,
                        ImmutableMatrix(
                            [[1, 0, 0], [0, cos(phi), -sin(phi)], [0, sin(phi), cos(phi)]]
                        ),
                    ),
                ),
            ),
            Step(
                "From the body one undoes roll first, which stands on the right, and yaw last. So "
                "the product leads from the body to the inertial frame, and its transpose back.",
                InOrder(
                    Eq(printed.R_BI, MatMul(printed.R_Z, printed.R_Y, printed.R_X)),
                    Eq(printed.R_IB, MatMul(printed.R_X.T, printed.R_Y.T, printed.R_Z.T)),
                ),
            ),
        ),
        remark="Product and elements are right for the matrix from the body to the inertial frame. "
        + LABEL,
    ),
    Case(
        "validation.2",
        readings=READINGS,
        steps=(
            Step(
                "To the body the three turns are undone in the other order. Yaw leaves the "
                "vertical where it is.",
                Eq(ROTATED_GRAVITY, MatMul(printed.R_X.T, printed.R_Y.T, printed.G_I)),
            ),
            Step(
                "Pitch brings some of it to the tail.",
                Eq(
                    MatMul(printed.R_Y.T, printed.G_I),
                    ImmutableMatrix([-g * sin(theta), 0, g * cos(theta)]),
                ),
            ),
            Step(
                "Roll shares out what is left between right and down.",
                Eq(
                    printed.G_B,
                    ImmutableMatrix(
                        [-g * sin(theta), g * cos(theta) * sin(phi), g * cos(theta) * cos(phi)]
                    ),
                ),
            ),
        ),
    ),
    Case(
        "validation.3",
        READ_TILT,
        condition=ranges.acute(phi),
        witness={phi: 150 * DEGREE, theta: 0, g: Rational(98, 10)},
        root="roll-quadrant",
        weight="misleads",
        steps=(
            Step(
                "With both components of gravity the two-argument arctangent finds the quadrant.",
                Eq(printed.ROLL_ACCEL, atan2(printed.G_YB, printed.G_ZB)),
            ),
        ),
        remark="Beyond 90° of roll the quotient is the same as 180° away. With the nose straight "
        "up or down both components are zero, and roll is not defined. With an accelerometer's "
        "readings, minus gravity, the quotient stays what it is, but both arguments of the "
        "two-argument arctangent need a minus. " + ACCELEROMETER,
    ),
    Case(
        "validation.4",
        READ_TILT,
        edits=(Edit(printed.G_XB / sqrt(WHOLE), -printed.G_XB / sqrt(WHOLE)),),
        witness={phi: 0, theta: 30 * DEGREE, g: Rational(98, 10)},
        root="gravity-or-reading",
        weight="misleads",
        steps=(
            Step(
                "By the paper's own equation 2 the x component of gravity is minus g sin θ, and "
                "its magnitude is g.",
                InOrder(Eq(printed.G_XB, -g * sin(theta)), Eq(sqrt(WHOLE), g)),
            ),
            Step(
                "Minus the quotient is the sine of pitch, and pitch lies between −90° and 90°, as "
                "the arcsine does.",
                Eq(sin(printed.PITCH_ACCEL), -printed.G_XB / sqrt(WHOLE)),
            ),
        ),
        remark="Nose up, gravity points to the tail. Without the minus it is right for what an "
        "accelerometer reads. " + ACCELEROMETER,
    ),
    Case(
        "validation.5",
        edits=(Edit(printed.R_IB, printed.R_BI),),
        witness={**SOME_ATTITUDE, g: Rational(98, 10)},
        root="matrix-label",
        weight="label",
        told_in="validation.2",
        readings=READINGS,
        steps=(WAY_BACK,),
        remark="Equation 2 has the same symbol for the opposite direction, see validation.2. With "
        "the elements that equation 1 prints the numbers are right. " + LABEL,
    ),
    *(
        Case(
            f"validation.{equation}",
            READ_STEPS,
            edits=(
                Edit(TANGENT, below * TANGENT),
                Edit(above / below, above),
            ),
            witness={**SOME_ATTITUDE, g: Rational(98, 10)},
            root="no-information",
            weight="misleads",
            steps=(
                Step(
                    f"Take a vector without a part to the {part}. Then the {line} line of equation "
                    "5, divided by the cosine of yaw, gives its tangent, as long as the divisor is "
                    "not zero.",
                    _for_vector(f"validation.{equation}", vector),
                ),
                NO_INFORMATION,
            ),
            remark=TANGENT_REMARK,
        )
        for equation, above, below, part, line, vector in (
            (6, NUMERATOR, SIDEWAYS, "north", "first", NOT_NORTH),
            (7, SIDEWAYS, -NUMERATOR, "east", "second", NOT_EAST),
        )
    ),
)
