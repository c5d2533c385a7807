"""The paper on validating Euler angles before the judgement: filter, field, factor E."""

from sympy import Abs, Eq, ImmutableMatrix, MatMul, Ne, Rational, cos, sin, sqrt

from chr_notes.derivations import estimation
from chr_notes.derivations import validation as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger import ranges
from chr_notes.ledger.case import DEGREE, Case, Condition, complete
from chr_notes.ledger.validation_attitude import LABEL
from chr_notes.ledger.validation_attitude import SETTLED as ON_ATTITUDE
from chr_notes.ledger.validation_reading import (
    BIAS,
    DISTURBANCE,
    E_ALONG_FIELD,
    FIELD_READINGS,
    READ,
    READ_EARTH,
    READ_FIELD,
    READ_FILTER,
    READ_YAW,
    ROLL_STEP,
    SOME_ATTITUDE,
    SOME_FIELD,
    WEAKENING,
)
from chr_notes.printed import validation as printed
from chr_notes.printed.statement import Approximately, Leads

SETTLED = (
    Case(
        "validation.10",
        READ_FILTER,
        condition=ranges.short_turn(ROLL_STEP, printed.ROLL_ACCEL),
        witness={
            printed.ROLL_BEFORE: 179 * DEGREE,
            printed.ROLL_RATE: 0,
            printed.DT: Rational(1, 100),
            printed.ROLL_ACCEL: -179 * DEGREE,
            printed.ALPHA: Rational(2, 100),
        },
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
        remark="Between 179° and -179° lies 180°, not the zero that a mean of the numbers heads "
        "for. Where the two are more than half a turn apart as numbers, whole turns must come off "
        "first.",
    ),
    Case("validation.11", READ_FILTER),
    Case(
        "validation.12",
        READ_FIELD,
        correction=Leads(
            Eq(printed.M_I, MatMul(printed.R_BI, printed.M_B), evaluate=False),
            Eq(printed.M_I, printed.FIELD_WRITTEN_OUT, evaluate=False),
        ),
        witness={**SOME_ATTITUDE, **SOME_FIELD},
        readings=FIELD_READINGS,
        steps=(
            Step(
                "What is measured in the body frame goes to the inertial frame by the transpose.",
                Eq(printed.R_BI, printed.R_IB.T),
            ),
        ),
        remark="Written out it is right; the symbol in front names the other direction. " + LABEL,
    ),
    *(
        Case(
            name,
            READ_YAW,
            remark="It needs a field with a horizontal part. Over a magnetic pole A is zero, and "
            "no compass can tell yaw.",
        )
        for name in ("validation.13", "validation.14")
    ),
    Case(
        "validation.15",
        READ_YAW,
        remark="A is minus the square of the horizontal field, so it is never positive: to drop it "
        "from both arguments of equation 16 would turn yaw by 180°.",
    ),
    Case("validation.17", READ_YAW),
    Case(
        "validation.c",
        READ_FILTER,
        given=(ranges.above_0_to_1(printed.ALPHA),),
        condition=Condition(Eq(BIAS, 0)),
        witness={
            BIAS: DEGREE,
            printed.ALPHA: Rational(2, 100),
            printed.DT: Rational(1, 100),
            estimation.start_error: 0,
            printed.ROLL_ACCEL: 0,
        },
        steps=(
            Step(
                "Each sample multiplies the distance to the accelerometer's angle by 1 - α, after "
                "the gyro has added what it reads at rest.",
                Eq(
                    printed.SETTLING,
                    printed.ROLL_ACCEL
                    + (1 - printed.ALPHA) ** printed.n * estimation.start_error
                    + (1 - (1 - printed.ALPHA) ** printed.n)
                    * (1 - printed.ALPHA)
                    / printed.ALPHA
                    * BIAS
                    * printed.DT,
                ),
            ),
        ),
        remark="Only if the gyro reads zero when it does not move. The paper's own Figure 2 shows "
        "that it does not; with a bias the filter comes to rest beside the accelerometer's angle, "
        "by 0.49° for 1°/s at 100 samples a second and α = 0.02.",
    ),
    Case(
        "validation.d",
        READ_FIELD,
        condition=Condition(Eq(DISTURBANCE[2], 0)),
        witness={
            **SOME_ATTITUDE,
            **dict.fromkeys(DISTURBANCE, 0),
            **SOME_FIELD,
            DISTURBANCE[2]: Rational(5, 100),
        },
        remark="Exact angles are not enough: the field must be the one of the reference, and the "
        "magnetometer faultless. Iron that adds five percent downwards makes E = 0.05 with the "
        "best of angles.",
    ),
    Case(
        "validation.e",
        READ_EARTH,
        correction=Eq(
            printed.M_I,
            ImmutableMatrix(
                [
                    -printed.M_E * cos(printed.INCLINATION) * cos(derived.declination),
                    -printed.M_E * cos(printed.INCLINATION) * sin(derived.declination),
                    printed.M_E * sin(printed.INCLINATION),
                ]
            ),
            evaluate=False,
        ),
        witness={
            printed.INCLINATION: 68 * DEGREE,
            derived.declination: 0,
            printed.M_E: 49,
        },
        remark="The horizontal part of the field points to magnetic north, against an x-axis that "
        "points south: its sign is wrong. And unless south is magnetic south, the declination δ "
        "leaves a y component. (z is down, as for gravity in equation 2; normalised, $M_e$ is 1.)",
    ),
    Case(
        "validation.f",
        READ_EARTH,
        steps=(
            Step(
                "To first approximation the Earth is a dipole: its field falls with the third "
                "power of the distance from the centre, and keeps its direction above one place.",
                Eq(
                    printed.GROUND_MAGNITUDE,
                    derived.dipole_strength
                    * sqrt(1 + 3 * sin(derived.latitude) ** 2)
                    / derived.radius**3,
                ),
            ),
            Step(
                "A kilometre up it is weaker by half a thousandth only.",
                Approximately(WEAKENING, "0.9995"),
            ),
        ),
        remark="True, and small. What normalising removes above all is an error of the "
        "magnetometer's scale, and the difference between places.",
    ),
    Case(
        "validation.g",
        READ_FIELD,
        condition=Condition(
            Ne(derived.ERROR_AXIS[0] * printed.M_YI - derived.ERROR_AXIS[1] * printed.M_XI, 0)
        ),
        witness={
            **dict(zip(derived.ERROR_AXIS, (0, 0, 1), strict=True)),
            **SOME_FIELD,
        },
        steps=(
            Step(
                "For a small turn about an axis n, E grows by the vertical part of n × M. Yaw (n "
                "along the vertical) leaves it unchanged, and so does a tilt about the horizontal "
                "part of the field.",
                Eq(
                    printed.GROWTH,
                    derived.ERROR_AXIS[0] * printed.M_YI - derived.ERROR_AXIS[1] * printed.M_XI,
                ),
            ),
            Step(
                "A tilt ε about the field's own horizontal direction shows only by this, which is "
                "of second order.",
                Eq(E_ALONG_FIELD, Abs(printed.M_ZI * (1 - cos(derived.error_angle)))),
            ),
        ),
        remark="E sees a tilt about the horizontal line across the field, and hardly any other "
        "error. It is blind to yaw altogether: yaw does not stand in it.",
    ),
)


CASES = complete(printed.PRINTED, READ, (*ON_ATTITUDE, *SETTLED))
