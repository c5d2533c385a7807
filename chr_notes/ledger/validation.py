"""The paper on validating Euler angles before the judgement: filter, field, factor E."""

from sympy import (
    Eq,
    ImmutableMatrix,
    MatMul,
    Rational,
    cos,
    sin,
)

from chr_notes.derivations import estimation
from chr_notes.derivations.steps import Step
from chr_notes.ledger import ranges
from chr_notes.ledger.case import DEGREE, Case, complete
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.validation_attitude import LABEL
from chr_notes.ledger.validation_attitude import SETTLED as ON_ATTITUDE
from chr_notes.ledger.validation_claims import SETTLED as WORDS
from chr_notes.ledger.validation_rates import SETTLED as ON_RATES
from chr_notes.ledger.validation_reading import (
    LEVEL,
    LEVEL_X,
    LEVEL_Y,
    PITCH_STEP,
    READ,
    READ_STEPS,
    READ_YAW,
    READINGS,
    ROLL_STEP,
    SOME_ATTITUDE,
    SOME_FIELD,
)
from chr_notes.printed import DOCUMENTS
from chr_notes.printed import validation as printed
from chr_notes.printed.statement import InOrder
from chr_notes.symbols import phi, psi, theta

POLE = (
    "It needs a field with a horizontal part. Over a magnetic pole A is zero, and no compass can "
    "tell yaw."
)
TO_LEVEL = Step(
    "Roll and pitch are known, so the reading can be brought to the level: this much of the field "
    "points forward and this much to the right.",
    InOrder(
        Eq(
            LEVEL_X,
            printed.M_ZB * cos(phi) * sin(theta)
            + printed.M_YB * sin(phi) * sin(theta)
            + printed.M_XB * cos(theta),
        ),
        Eq(LEVEL_Y, printed.M_YB * cos(phi) - printed.M_ZB * sin(phi)),
    ),
)
TURNED_BY_YAW = Step(
    "Turned by yaw, that is the level part of the field in the inertial frame: the first two "
    "lines of equation 12, two equations for the cosine and the sine.",
    Eq(
        ImmutableMatrix([printed.M_XI, printed.M_YI]),
        MatMul(
            ImmutableMatrix([[cos(psi), -sin(psi)], [sin(psi), cos(psi)]]), ImmutableMatrix(LEVEL)
        ),
    ),
)
DIVISOR = Step(
    "The determinant of the two equations, with the paper's sign, is A: minus the square of the "
    "level field.",
    Eq(printed.A, -(LEVEL_X**2) - LEVEL_Y**2),
)

SETTLED = (
    Case(
        "validation.10",
        condition=ranges.short_turn(ROLL_STEP, printed.ROLL_ACCEL),
        witness={
            printed.ROLL_BEFORE: 170 * DEGREE,
            printed.ROLL_RATE: 0,
            printed.DT: Rational(1, 100),
            printed.ROLL_ACCEL: -80 * DEGREE,
            printed.ALPHA: Rational(2, 100),
        },
        root="seam",
        weight="misleads",
        steps=(
            Step(
                "A weighted mean of two directions goes the shorter way from one to the other: "
                "take the difference less whole turns.",
                Eq(
                    printed.ROLL,
                    ROLL_STEP
                    + printed.ALPHA * estimation.shortest_turn(printed.ROLL_ACCEL - ROLL_STEP),
                ),
            ),
        ),
        remark="Equation 3 gives angles between −90° and 90°. A filter that has gone far beyond, "
        "to 170°, is 110° from −80° the shorter way, but the difference of the numbers is −250°. "
        "With a roll from all four quadrants the seam lies in wait everywhere: between 179° and "
        "−179° lies 180°, not zero. Whole turns must come off first.",
    ),
    Case(
        "validation.11",
        steps=(
            Step(
                "The angle before and what the gyro has added since, its rate held through the "
                "time dt, is one witness; the accelerometer's angle is the other. The angle that "
                "fits both best, their squares weighted by 1 − α and α, is where the slope of the "
                "misfit is zero.",
                Eq(
                    (1 - printed.ALPHA) * (printed.PITCH - PITCH_STEP)
                    + printed.ALPHA * (printed.PITCH - printed.PITCH_ACCEL),
                    0,
                ),
            ),
        ),
    ),
    Case(
        "validation.12",
        edits=(Edit(printed.R_IB, printed.R_BI),),
        witness={**SOME_ATTITUDE, **SOME_FIELD},
        root="matrix-label",
        weight="label",
        told_in="validation.13",
        readings=READINGS,
        steps=(
            Step(
                "What is measured in the body frame goes to the inertial frame by the transpose.",
                Eq(printed.R_BI, printed.R_IB.T, evaluate=False),
            ),
        ),
        remark="Written out it is right, and so is what follows from it, see validation.13; "
        "the symbol in front names the other direction. " + LABEL,
    ),
    Case(
        "validation.13",
        READ_STEPS,
        steps=(
            TO_LEVEL,
            TURNED_BY_YAW,
            DIVISOR,
            Step(
                "Cramer's rule solves them.",
                Eq(
                    cos(psi),
                    (-printed.M_YI * LEVEL_Y - printed.M_XI * LEVEL_X) / printed.A,
                ),
            ),
        ),
        remark=POLE,
    ),
    Case(
        "validation.14",
        READ_STEPS,
        steps=(
            TO_LEVEL,
            TURNED_BY_YAW,
            DIVISOR,
            Step(
                "Cramer's rule solves them.",
                Eq(
                    sin(psi),
                    (printed.M_XI * LEVEL_Y - printed.M_YI * LEVEL_X) / printed.A,
                ),
            ),
        ),
        remark=POLE,
    ),
    Case(
        "validation.15",
        definition=True,
        remark="A is minus the square of the horizontal field, so it is never positive: to drop it "
        "from both arguments of equation 16 would turn yaw by 180°.",
    ),
    Case(
        "validation.16",
        READ_YAW,
        steps=(
            Step(
                "Sine and cosine are what equations 14 and 13 give; their squares add up to one, "
                "and one angle in a turn has both.",
                Eq(sin(psi) ** 2 + cos(psi) ** 2, 1),
            ),
        ),
    ),
)

CASES = complete(DOCUMENTS["validation"], READ, (*ON_ATTITUDE, *ON_RATES, *SETTLED, *WORDS))
