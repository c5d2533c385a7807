"""What "Understanding Euler Angles" prints."""

from sympy import (
    Basic,
    EmptySet,
    Eq,
    FiniteSet,
    Identity,
    ImmutableMatrix,
    Limit,
    MatMul,
    MatrixSymbol,
    Ne,
    Symbol,
    cos,
    oo,
    pi,
    sin,
    tan,
)
from sympy.matrices.expressions.matexpr import MatrixElement

from chr_notes.printed.statement import InOrder, Printed, Rotation, as_printed, words
from chr_notes.symbols import BODY_RATES, EULER_RATES, Angle, p, phi, psi, q, r, theta

E_Y = ImmutableMatrix([0, 1, 0])
E_Z = ImmutableMatrix([0, 0, 1])

# Names that the document, or the proposition that its words state, gives to things.
D = MatrixSymbol(r"D\left(\phi, \theta, \psi\right)", 3, 3)
V_I = MatrixSymbol(r"\mathbf{v}_I", 3, 1)
V_B = MatrixSymbol(r"\mathbf{v}_B", 3, 1)
PITCH_AXIS = MatrixSymbol(r"\mathbf{e}_{\text{pitch}}^{I}", 3, 1)
RATES = ImmutableMatrix(EULER_RATES)
GYROS = ImmutableMatrix(BODY_RATES)
ALTITUDE = Symbol("h", positive=True)
Z_I = Symbol("z_I", real=True)
LOCK_PITCHES = words("pitch, up from level, at gimbal lock")
ROLL_FOR_YAW = Angle(r"\phi_{\psi}", real=True)  # a roll that makes up for a yaw
OTHER_ARGUMENTS = words("what else D depends on")
FIGURE_3_FRAME = words("frame of Figure 3")

R_YAW = Rotation("I", "v1", psi)
R_PITCH = Rotation("v1", "v2", theta)
R_ROLL = Rotation("v2", "B", phi)
TURNS_BACK = (
    Rotation("I", "v1", -psi),
    Rotation("v1", "v2", -theta),
    Rotation("v2", "B", -phi),
)
R_IV2 = Rotation("I", "v2", theta, psi)
R_IB = Rotation("I", "B", phi, theta, psi)
R_BI = Rotation("B", "I", phi, theta, psi)


def _component(row: int, *factors: Basic) -> MatrixElement:
    return MatrixElement(MatMul(*factors), row, 0)


with as_printed():
    ROTATED_ONE_BY_ONE = Eq(
        RATES,
        ImmutableMatrix(
            [
                _component(0, Rotation("B", "v2"), ImmutableMatrix([p, 0, 0])),
                _component(1, Rotation("B", "v1"), ImmutableMatrix([0, q, 0])),
                _component(2, Rotation("B", "I"), ImmutableMatrix([0, 0, r])),
            ]
        ),
    )
    PRINTED = (
        Printed(
            "euler.2.a",
            "claim",
            "section 2, paragraph 1",
            "Altitude above ground has a negative z, because the z-axis points down.",
            Z_I < 0,
        ),
        Printed(
            "euler.3.1",
            "equation",
            "section 3, paragraph 2",
            "Yaw: the matrix from the inertial frame to vehicle-1.",
            Eq(
                R_YAW,
                ImmutableMatrix([[cos(psi), sin(psi), 0], [-sin(psi), cos(psi), 0], [0, 0, 1]]),
            ),
        ),
        Printed(
            "euler.3.a",
            "claim",
            "section 3, paragraph 1",
            "Yaw leaves the z-axis where it was.",
            Eq(MatMul(R_YAW, E_Z), E_Z),
        ),
        Printed(
            "euler.4.1",
            "equation",
            "section 4, paragraph 2",
            "Pitch: the matrix from vehicle-1 to vehicle-2.",
            Eq(
                R_PITCH,
                ImmutableMatrix(
                    [[cos(theta), 0, -sin(theta)], [0, 1, 0], [sin(theta), 0, cos(theta)]]
                ),
            ),
        ),
        Printed(
            "euler.4.2",
            "equation",
            "section 4, paragraph 3",
            "Inertial frame to vehicle-2, as a product.",
            Eq(R_IV2, MatMul(R_PITCH, R_YAW)),
        ),
        Printed(
            "euler.4.a",
            "claim",
            "section 4, paragraph 1",
            "After some yaw, pitch does not turn about the inertial y-axis.",
            Ne(PITCH_AXIS, E_Y),
        ),
        Printed(
            "euler.4.b",
            "claim",
            "section 4, Figure 3",
            "The caption of Figure 3 names the frame that yaw and pitch lead to.",
            Eq(FIGURE_3_FRAME, words("vehicle-3")),
        ),
        Printed(
            "euler.5.1",
            "equation",
            "section 5, paragraph 3",
            "Roll: the matrix from vehicle-2 to the body.",
            Eq(
                R_ROLL,
                ImmutableMatrix([[1, 0, 0], [0, cos(phi), sin(phi)], [0, -sin(phi), cos(phi)]]),
            ),
        ),
        Printed(
            "euler.5.2",
            "equation",
            "section 5, paragraph 4",
            "Inertial frame to body, as a product of three.",
            Eq(R_IB, MatMul(R_ROLL, R_PITCH, R_YAW)),
        ),
        Printed(
            "euler.5.3",
            "equation",
            "section 5, paragraph 5",
            "Inertial frame to body, multiplied out.",
            Eq(
                R_IB,
                ImmutableMatrix(
                    [
                        [cos(psi) * cos(theta), cos(theta) * sin(psi), -sin(theta)],
                        [
                            cos(psi) * sin(phi) * sin(theta) - cos(phi) * sin(psi),
                            cos(phi) * cos(psi) + sin(phi) * sin(psi) * sin(theta),
                            cos(theta) * sin(phi),
                        ],
                        [
                            sin(phi) * sin(psi) + cos(phi) * cos(psi) * sin(theta),
                            cos(phi) * sin(psi) * sin(theta) - cos(psi) * sin(phi),
                            cos(phi) * cos(theta),
                        ],
                    ]
                ),
            ),
        ),
        Printed(
            "euler.5.4",
            "equation",
            "section 5, paragraph 6",
            "Body to inertial frame, as a product with negated angles.",
            Eq(R_BI, MatMul(*TURNS_BACK)),
        ),
        Printed(
            "euler.5.5",
            "equation",
            "section 5, paragraph 7",
            "The opposite direction multiplied out, under the symbol that stands in front of it.",
            Eq(
                R_IB,
                ImmutableMatrix(
                    [
                        [
                            cos(psi) * cos(theta),
                            cos(psi) * sin(phi) * sin(theta) - cos(phi) * sin(psi),
                            sin(phi) * sin(psi) + cos(phi) * cos(psi) * sin(theta),
                        ],
                        [
                            cos(theta) * sin(psi),
                            cos(phi) * cos(psi) + sin(phi) * sin(psi) * sin(theta),
                            cos(phi) * sin(psi) * sin(theta) - cos(psi) * sin(phi),
                        ],
                        [-sin(theta), cos(theta) * sin(phi), cos(phi) * cos(theta)],
                    ]
                ),
            ),
        ),
        Printed(
            "euler.5.a",
            "claim",
            "section 5, paragraph 8",
            "To go back, take the turns in reverse order and each the other way round.",
            Eq(MatMul(*TURNS_BACK, R_ROLL, R_PITCH, R_YAW), Identity(3)),
        ),
        Printed(
            "euler.6.a",
            "claim",
            "section 6, paragraph 1",
            "Pitching up, Euler angles stop being unique at 90 degrees.",
            Eq(LOCK_PITCHES, FiniteSet(pi / 2)),
        ),
        Printed(
            "euler.6.b",
            "claim",
            "section 6, paragraph 2",
            "An orientation with a pitch of 90 degrees can be obtained by yawing and then "
            "pitching, or by pitching and then rolling: to every yaw there is such a roll.",
            Eq(Rotation("I", "B", 0, pi / 2, psi), Rotation("I", "B", ROLL_FOR_YAW, pi / 2, 0)),
        ),
        Printed(
            "euler.7.1",
            "equation",
            "section 7, paragraph 2",
            "A vector measured in the body frame, taken to the inertial frame.",
            Eq(V_I, MatMul(R_BI, V_B)),
        ),
        Printed(
            "euler.7.2",
            "equation",
            "section 7, paragraph 6",
            "The matrix D from body rates to Euler rates.",
            Eq(
                D,
                ImmutableMatrix(
                    [
                        [1, sin(phi) * tan(theta), cos(phi) * tan(theta)],
                        [0, cos(phi), -sin(phi)],
                        [0, sin(phi) / cos(theta), cos(phi) / cos(theta)],
                    ]
                ),
            ),
        ),
        Printed(
            "euler.7.3",
            "equation",
            "section 7, paragraph 7",
            "The Euler rates written out.",
            Eq(
                RATES,
                ImmutableMatrix(
                    [
                        p + q * sin(phi) * tan(theta) + r * cos(phi) * tan(theta),
                        q * cos(phi) - r * sin(phi),
                        q * sin(phi) / cos(theta) + r * cos(phi) / cos(theta),
                    ]
                ),
            ),
        ),
        Printed(
            "euler.7.a",
            "claim",
            "section 7, paragraph 5",
            "How D comes about: gyro x is rotated into vehicle-2, y into vehicle-1, z into "
            "inertial.",
            ROTATED_ONE_BY_ONE,
        ),
        Printed(
            "euler.7.b",
            "claim",
            "section 7, paragraph 5",
            "The gyros do not report the derivatives of the Euler angles: in general the matrix "
            "that makes one of the other is not the identity.",
            Ne(D, Identity(3)),
        ),
        Printed(
            "euler.7.c",
            "claim",
            "section 7, paragraph 8",
            "The last row of D divides by cos(pitch) in two places; towards ±90 degrees its "
            "elements in general diverge.",
            InOrder(
                Eq(Limit(abs(D[2, 1]), theta, pi / 2, "+-"), oo),
                Eq(Limit(abs(D[2, 2]), theta, pi / 2, "+-"), oo),
                Eq(Limit(abs(D[2, 1]), theta, -pi / 2, "+-"), oo),
                Eq(Limit(abs(D[2, 2]), theta, -pi / 2, "+-"), oo),
            ),
        ),
        Printed(
            "euler.7.d",
            "claim",
            "section 7, paragraph 6",
            "D is written as a function of roll, pitch and yaw.",
            Eq(OTHER_ARGUMENTS, EmptySet),
        ),
    )
