"""What "Real-time Validation of Euler Angles Using IMU Data Fusion in Robotic Applications" prints.

The paper writes R_i^b for the matrix from the inertial frame to the body. Which matrix that is,
the ledger's readings say: the paper contradicts itself there.
"""

from sympy import (
    Abs,
    Eq,
    ImmutableMatrix,
    IndexedBase,
    MatAdd,
    MatMul,
    MatrixSymbol,
    Symbol,
    asin,
    atan,
    atan2,
    cos,
    sec,
    sin,
    sqrt,
    symbols,
    tan,
)

from chr_notes.printed.statement import Leads, Printed, Rotation, as_printed, chain
from chr_notes.symbols import (
    BODY_RATES,
    EULER_RATES,
    Angle,
    AngularRate,
    g,
    phi,
    pitch_rate,
    psi,
    roll_rate,
    theta,
    yaw_rate,
)

R_IB, R_BI = Rotation("i", "b"), Rotation("b", "i")
# Equation 1 names the turns by their axes as they then lie, equation 8 names two of them anew.
R_Z = MatrixSymbol(r"\mathbf{R}_z(\psi)", 3, 3)
R_Y = MatrixSymbol(r"\mathbf{R}_{y'}(\theta)", 3, 3)
R_X = MatrixSymbol(r"\mathbf{R}_{x''}(\phi)", 3, 3)
R_Z_IN_8 = MatrixSymbol(r"\mathbf{R}_Z(\psi)", 3, 3)
R_Y_IN_8 = MatrixSymbol(r"\mathbf{R}_Y(\theta)", 3, 3)
AXES = YAW_AXIS, PITCH_AXIS, ROLL_AXIS = tuple(
    MatrixSymbol(rf"\mathbf{{{letter}}}{primes}", 3, 1)
    for letter, primes in (("k", ""), ("j", "'"), ("i", "''"))
)
V_I = MatrixSymbol(r"\mathbf{v}_i", 3, 1)
V_B = MatrixSymbol(r"\mathbf{v}_b", 3, 1)

G_XB, G_YB, G_ZB = GRAVITY = symbols("g_{xb} g_{yb} g_{zb}", real=True)
G_B = ImmutableMatrix(GRAVITY)
G_I = ImmutableMatrix([0, 0, g])
ROLL_ACCEL, PITCH_ACCEL, YAW_ACCEL = (
    Angle(rf"\{name}_{{accelerometer}}", real=True) for name in ("phi", "theta", "psi")
)

# The complementary filter, its angles now and one sample before.
ALPHA = Symbol("alpha", real=True)
DT = Symbol("dt", positive=True)
n = Symbol("n", integer=True, positive=True)
(ROLL, ROLL_BEFORE), (PITCH, PITCH_BEFORE) = (
    tuple(Angle(rf"\{name}_{{Comp({when})}}", real=True) for when in ("n", "n-1"))
    for name in ("phi", "theta")
)
ROLL_RATE, PITCH_RATE = (
    AngularRate(rf"\dot{{\{name}}}_{{gyro}}", real=True) for name in ("phi", "theta")
)
SETTLING = IndexedBase(r"\phi_{Comp}")[n]

# The magnetic field, normalised, in the two frames.
M_XB, M_YB, M_ZB = FIELD_B = symbols("M_{xb} M_{yb} M_{zb}", real=True)
M_XI, M_YI, M_ZI = FIELD_I = symbols("M_{xi} M_{yi} M_{zi}", real=True)
M_B, M_I = ImmutableMatrix(FIELD_B), ImmutableMatrix(FIELD_I)
A = Symbol("A", real=True)
YAW = Angle(r"\psi_{mag\_comp}", real=True)
ROLL_COMP, PITCH_COMP = (Angle(rf"\{name}_{{Comp}}", real=True) for name in ("phi", "theta"))
E = Symbol("E", real=True)
M_E = Symbol("M_e", positive=True)
INCLINATION = Angle("alpha", real=True)

with as_printed():
    MATRIX = ImmutableMatrix(
        [
            [
                cos(psi) * cos(theta),
                cos(psi) * sin(phi) * sin(theta) - cos(phi) * sin(psi),
                sin(phi) * sin(psi) + cos(phi) * cos(psi) * sin(theta),
            ],
            [
                cos(theta) * sin(psi),
                cos(phi) * cos(psi) + sin(psi) * sin(phi) * sin(theta),
                cos(phi) * sin(psi) * sin(theta) - cos(psi) * sin(phi),
            ],
            [-sin(theta), cos(theta) * sin(phi), cos(phi) * cos(theta)],
        ]
    )
    TURNS = MatMul(R_Z, R_Y, R_X)
    RATES_I = MatAdd(
        MatMul(yaw_rate, ImmutableMatrix([0, 0, 1])),
        MatMul(R_Z_IN_8, pitch_rate, ImmutableMatrix([0, 1, 0])),
        MatMul(R_Z_IN_8, R_Y_IN_8, roll_rate, ImmutableMatrix([1, 0, 0])),
    )
    RATES_BY_AXES = MatAdd(
        MatMul(yaw_rate, YAW_AXIS), MatMul(pitch_rate, PITCH_AXIS), MatMul(roll_rate, ROLL_AXIS)
    )
    FIELD_WRITTEN_OUT = ImmutableMatrix(
        [
            M_ZB * (sin(phi) * sin(psi) + cos(phi) * cos(psi) * sin(theta))
            - M_YB * (cos(phi) * sin(psi) - cos(psi) * sin(phi) * sin(theta))
            + M_XB * cos(psi) * cos(theta),
            -M_ZB * (cos(psi) * sin(phi) - cos(phi) * sin(psi) * sin(theta))
            + M_YB * (cos(phi) * cos(psi) + sin(phi) * sin(psi) * sin(theta))
            + M_XB * cos(theta) * sin(psi),
            M_ZB * cos(phi) * cos(theta) + M_YB * cos(theta) * sin(phi) - M_XB * sin(theta),
        ]
    )
    LEVEL_X = M_ZB * cos(phi) * sin(theta) + M_YB * sin(phi) * sin(theta) + M_XB * cos(theta)
    GRAVITY_X = G_ZB * cos(phi) * sin(theta) + G_YB * sin(phi) * sin(theta) + G_XB * cos(theta)
    GRAVITY_Y = G_ZB * sin(phi) - G_YB * cos(phi)

with as_printed():
    PRINTED = (
        Printed(
            "validation.1",
            "equation",
            "equation 1",
            "The 3-2-1 rotation matrix, as a product and multiplied out.",
            chain(R_IB, TURNS, MATRIX),
        ),
        Printed(
            "validation.2",
            "equation",
            "equation 2",
            "Gravity in the body frame.",
            Leads(
                Eq(G_B, MatMul(R_IB, G_I)),
                Eq(
                    G_B,
                    ImmutableMatrix(
                        [-g * sin(theta), g * cos(theta) * sin(phi), g * cos(theta) * cos(phi)]
                    ),
                ),
            ),
        ),
        Printed(
            "validation.3",
            "equation",
            "equation 3",
            "Roll from the accelerometer.",
            Eq(ROLL_ACCEL, atan(G_YB / G_ZB)),
        ),
        Printed(
            "validation.4",
            "equation",
            "equation 4",
            "Pitch from the accelerometer.",
            Eq(PITCH_ACCEL, asin(G_XB / sqrt(G_XB**2 + G_YB**2 + G_ZB**2))),
        ),
        Printed(
            "validation.5",
            "equation",
            "equation 5",
            "Gravity, taken from the body to the inertial frame.",
            Eq(G_I, MatMul(R_IB, G_B)),
        ),
        Printed(
            "validation.6",
            "equation",
            "equation 6",
            "Tangent of yaw from the first line of the equation before.",
            Eq(
                tan(YAW_ACCEL),
                (-G_ZB * cos(phi) * sin(theta) - G_YB * sin(phi) * sin(theta) - G_XB * cos(theta))
                / GRAVITY_Y,
            ),
        ),
        Printed(
            "validation.7",
            "equation",
            "equation 7",
            "Tangent of yaw from the second line.",
            Eq(tan(YAW_ACCEL), GRAVITY_Y / GRAVITY_X),
        ),
        Printed(
            "validation.8",
            "equation",
            "equation 8",
            "Body rates from Euler rates, as three angular velocities brought to the body.",
            chain(
                ImmutableMatrix(BODY_RATES),
                MatMul(R_IB.T, RATES_BY_AXES),
                MatMul(R_IB.T, RATES_I),
            ),
        ),
        Printed(
            "validation.9",
            "equation",
            "equation 9",
            "Euler rates from body rates.",
            Eq(
                ImmutableMatrix(EULER_RATES),
                MatMul(
                    ImmutableMatrix(
                        [
                            [1, sin(phi) * tan(theta), cos(phi) * tan(theta)],
                            [0, cos(phi), -sin(phi)],
                            [0, sin(phi) * sec(theta), sec(theta) * cos(phi)],
                        ]
                    ),
                    ImmutableMatrix(BODY_RATES),
                ),
            ),
        ),
        Printed(
            "validation.10",
            "equation",
            "equation 10",
            "Complementary filter for roll.",
            Eq(ROLL, (1 - ALPHA) * (ROLL_BEFORE + ROLL_RATE * DT) + ALPHA * ROLL_ACCEL),
        ),
        Printed(
            "validation.11",
            "equation",
            "equation 11",
            "Complementary filter for pitch.",
            Eq(PITCH, (1 - ALPHA) * (PITCH_BEFORE + PITCH_RATE * DT) + ALPHA * PITCH_ACCEL),
        ),
        Printed(
            "validation.12",
            "equation",
            "equation 12",
            "The magnetic field, taken from the body to the inertial frame, and written out.",
            Leads(Eq(M_I, MatMul(R_IB, M_B)), Eq(M_I, FIELD_WRITTEN_OUT)),
        ),
        Printed(
            "validation.13",
            "equation",
            "equation 13",
            "Cosine of yaw.",
            Eq(cos(psi), (M_YI * (M_ZB * sin(phi) - M_YB * cos(phi)) - M_XI * LEVEL_X) / A),
        ),
        Printed(
            "validation.14",
            "equation",
            "equation 14",
            "Sine of yaw.",
            Eq(sin(psi), (M_XI * (-M_ZB * sin(phi) + M_YB * cos(phi)) - M_YI * LEVEL_X) / A),
        ),
        Printed(
            "validation.15",
            "equation",
            "equation 15",
            "The divisor A of both.",
            Eq(
                A,
                -LEVEL_X * LEVEL_X
                + (M_ZB * sin(phi) - M_YB * cos(phi)) * (-M_ZB * sin(phi) + M_YB * cos(phi)),
            ),
        ),
        Printed(
            "validation.16",
            "equation",
            "equation 16",
            "Yaw by the two-argument arctangent.",
            Eq(YAW, atan2(sin(psi), cos(psi))),
        ),
        Printed(
            "validation.17",
            "equation",
            "equation 17",
            "The factor E.",
            Eq(
                E,
                Abs(
                    M_ZI
                    - (
                        M_ZB * cos(ROLL_COMP) * cos(PITCH_COMP)
                        + M_YB * cos(PITCH_COMP) * sin(ROLL_COMP)
                        - M_XB * sin(PITCH_COMP)
                    )
                ),
            ),
        ),
    )
