"""What the paper on real-time validation says in words."""

from sympy import (
    Abs,
    EmptySet,
    Eq,
    ImmutableMatrix,
    IndexedBase,
    Limit,
    MatMul,
    MatrixSymbol,
    Ne,
    Rational,
    Subs,
    Symbol,
    cos,
    oo,
    sec,
    sin,
    tan,
)

from chr_notes.printed.statement import (
    Approximately,
    InOrder,
    Leads,
    Printed,
    as_printed,
    words,
)
from chr_notes.printed.validation import (
    ALPHA,
    G_B,
    INCLINATION,
    M_E,
    M_I,
    PITCH_BEFORE,
    R_IB,
    R_X,
    R_Y,
    R_Z,
    ROLL_ACCEL,
    ROLL_BEFORE,
    SETTLING,
    V_B,
    V_I,
    E,
    n,
)
from chr_notes.symbols import BODY_RATES, EULER_RATES, g

# Names for what the words speak of: what equations 6 and 7 say the tangent of yaw is; the yaws that
# they leave; the Earth's field at the
# ground and at an altitude; how fast E grows with an error of attitude.
BY_6, BY_7 = (
    Symbol(rf"\tan{{\psi_{{accelerometer}}}}^{{(\text{{{n}}})}}", real=True) for n in (6, 7)
)
YAWS = words("yaws that agree with the accelerometer")
GROUND_MAGNITUDE, HIGH_MAGNITUDE = (
    Symbol(rf"\left\lVert\mathbf{{M}}({where})\right\rVert", positive=True) for where in ("0", "h")
)

E_X, E_Y, E_Z = (ImmutableMatrix([int(row == axis) for row in range(3)]) for axis in range(3))

# Names for what the words speak of: the accelerometer's reading, at a yaw and without one; the
# shares of the two sensors in the filter's angle; the error of the integrated gyro after n steps;
# the magnetometer's reading at zero angles; what of it stands in the filter's angles.
READING = MatrixSymbol(r"\mathbf{a}_m", 3, 1)
READING_AT_YAW, READING_WITHOUT_YAW = (
    MatrixSymbol(rf"\mathbf{{a}}_m\left({yaw}\right)", 3, 1) for yaw in (r"\psi", "0")
)
ACCELEROMETER_SHARE, GYRO_SHARE = (
    Symbol(rf"\text{{share of the {sensor}}}", real=True) for sensor in ("accelerometer", "gyro")
)
DRIFT = IndexedBase(r"e^{\text{gyro}}")[n]
READING_AT_ZERO = MatrixSymbol(r"\mathbf{M}_b\left(0, 0, 0\right)", 3, 1)
MAGNETOMETER_IN_FILTER = words("readings of the magnetometer in the angles of the filter")
SHOWN_BY_E = words("angles whose error E tells")

with as_printed():
    CLAIMS = (
        Printed(
            "validation.a",
            "claim",
            "after equation 4, paragraph 1",
            "The paper's matrix takes a vector's components from the inertial to the body frame.",
            Eq(V_B, MatMul(R_IB, V_I)),
        ),
        Printed(
            "validation.b",
            "claim",
            "after equation 7, paragraph 1",
            "By equations 6 and 7 the tangent of yaw would equal minus its own inverse: a "
            "contradiction, so that no yaw is left.",
            Leads(Eq(BY_6, -1 / BY_7), Eq(YAWS, EmptySet)),
        ),
        Printed(
            "validation.c",
            "claim",
            "after equation 11, paragraph 1",
            "At rest the angle of the filter converges to that of the accelerometer.",
            Eq(Limit(SETTLING, n, oo), ROLL_ACCEL),
        ),
        Printed(
            "validation.d",
            "claim",
            "after equation 16, paragraph 1",
            "E is zero when roll and pitch are exact.",
            Eq(E, 0),
        ),
        Printed(
            "validation.e",
            "claim",
            "after equation 17, paragraph 4",
            "The field in the inertial frame when its x-axis points south.",
            Eq(M_I, ImmutableMatrix([M_E * cos(INCLINATION), 0, M_E * sin(INCLINATION)])),
        ),
        Printed(
            "validation.f",
            "claim",
            "after equation 11, paragraph 2",
            "The magnitude of the Earth's field can differ from one altitude to another.",
            Ne(HIGH_MAGNITUDE, GROUND_MAGNITUDE),
        ),
        Printed(
            "validation.g",
            "claim",
            "after equation 17, paragraph 1",
            "E tells an error of the Euler angles, of each of the three.",
            Eq(SHOWN_BY_E, 3),
        ),
    )
    ADDITIONS = (
        Printed(
            "validation.h",
            "claim",
            "before equation 1, paragraph 3",
            "An accelerometer is said to report the components of gravity.",
            Eq(READING, G_B),
        ),
        Printed(
            "validation.i",
            "claim",
            "after equation 11, paragraph 1",
            "With alpha from 0.01 to 0.07 the accelerometer has a share of 1 to 7 percent, the "
            "rest one of 99 to 93.",
            InOrder(
                *(
                    Eq(Subs(share, ALPHA, Rational(alpha, 100)), Rational(percent, 100))
                    for share, alpha, percent in (
                        (ACCELEROMETER_SHARE, 1, 1),
                        (ACCELEROMETER_SHARE, 7, 7),
                        (GYRO_SHARE, 1, 99),
                        (GYRO_SHARE, 7, 93),
                    )
                )
            ),
        ),
        Printed(
            "validation.j",
            "claim",
            "after equation 9, paragraph 1",
            "The Euler rates of one loop follow from its gyro readings and the angles of the loop "
            "before.",
            Eq(
                ImmutableMatrix(EULER_RATES),
                MatMul(
                    ImmutableMatrix(
                        [
                            [
                                1,
                                sin(ROLL_BEFORE) * tan(PITCH_BEFORE),
                                cos(ROLL_BEFORE) * tan(PITCH_BEFORE),
                            ],
                            [0, cos(ROLL_BEFORE), -sin(ROLL_BEFORE)],
                            [
                                0,
                                sin(ROLL_BEFORE) * sec(PITCH_BEFORE),
                                sec(PITCH_BEFORE) * cos(ROLL_BEFORE),
                            ],
                        ]
                    ),
                    ImmutableMatrix(BODY_RATES),
                ),
            ),
        ),
        Printed(
            "validation.k",
            "claim",
            "after equation 7, paragraph 1",
            "Yaw cannot be calculated from an accelerometer alone: its reading is the same at "
            "every yaw.",
            Eq(READING_AT_YAW, READING_WITHOUT_YAW),
        ),
        Printed(
            "validation.l",
            "claim",
            "after equation 4, paragraph 1",
            "Roll, pitch and yaw turn about x\u2033, y\u2032 and z: each turn leaves its axis "
            "where it is.",
            InOrder(
                Eq(MatMul(R_X, E_X), E_X),
                Eq(MatMul(R_Y, E_Y), E_Y),
                Eq(MatMul(R_Z, E_Z), E_Z),
            ),
        ),
        Printed(
            "validation.m",
            "claim",
            "after equation 9, paragraph 2",
            "Euler rates, integrated over time, drift by the bias of the gyro.",
            Eq(Limit(Abs(DRIFT), n, oo), oo),
        ),
        Printed(
            "validation.n",
            "claim",
            "after equation 11, paragraph 2",
            "The normalised field in the inertial frame is what the compass reads when all angles "
            "are zero.",
            Eq(M_I, READING_AT_ZERO),
        ),
        Printed(
            "validation.o",
            "claim",
            "after equation 4, paragraph 1",
            "The magnitude of gravity.",
            Approximately(g, "9.8"),
        ),
        Printed(
            "validation.p",
            "claim",
            "after equation 17, paragraph 1",
            "Roll and pitch of the filter come without the magnetometer.",
            Eq(MAGNETOMETER_IN_FILTER, EmptySet),
        ),
    )
