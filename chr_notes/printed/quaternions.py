"""What "Understanding Quaternions" prints."""

from sympy import (
    EmptySet,
    Eq,
    ImmutableMatrix,
    MatMul,
    MatrixSymbol,
    Symbol,
    asin,
    atan,
    atan2,
    cos,
    sin,
)

from chr_notes.printed.hamilton import Conjugate, Product, Pure, Reciprocal
from chr_notes.printed.statement import InOrder, Printed, Rotation, as_printed, words
from chr_notes.symbols import AXIS, FIRST, SECOND, Angle, a, b, c, d, phi, psi, theta

# Names that the document, or the proposition that its words state, gives to things.
Q = MatrixSymbol(r"\mathbf{q}_i^b", 4, 1)
Q_1 = MatrixSymbol(r"\mathbf{q}_1", 4, 1)
Q_2 = MatrixSymbol(r"\mathbf{q}_2", 4, 1)
V_I = MatrixSymbol(r"\mathbf{v}_I", 3, 1)
V_B = MatrixSymbol(r"\mathbf{v}_B", 3, 1)
# Printed as the vector is, and equated with a product of quaternions: the note treats a vector as
# a quaternion without a real part.
V_B_AS_QUATERNION = MatrixSymbol(r"\mathbf{v}_B", 4, 1)
REALS = Symbol(r"\dim \mathbb{R}", integer=True)
COMPLEX = Symbol(r"\dim \mathbb{C}", integer=True)
QUATERNIONS = Symbol(r"\dim \mathbb{H}", integer=True)
IMAGINARY = Symbol(r"\dim i\mathbb{R}", integer=True)
# Written like pitch, and not pitch: the angle of one turn about one axis.
TURN = Angle(r"\theta", real=True)
NO_RATE = words("pitches without a rate of the quaternion")

a_1, b_1, c_1, d_1 = FIRST
a_2, b_2, c_2, d_2 = SECOND
R_IB = Rotation("i", "b", Q)

with as_printed():
    ROLL_PARTS = (2 * (a * b + c * d), a**2 - b**2 - c**2 + d**2)
    YAW_PARTS = (2 * (a * d + b * c), a**2 + b**2 - c**2 - d**2)
    MATRIX = ImmutableMatrix(
        [
            [a**2 + b**2 - c**2 - d**2, 2 * b * c - 2 * a * d, 2 * b * d + 2 * a * c],
            [2 * b * c + 2 * a * d, a**2 - b**2 + c**2 - d**2, 2 * c * d - 2 * a * b],
            [2 * b * d - 2 * a * c, 2 * c * d + 2 * a * b, a**2 - b**2 - c**2 + d**2],
        ]
    )

with as_printed():
    PRINTED = (
        Printed(
            "quaternions.2.1",
            "equation",
            "section 2, paragraph 3",
            "The attitude quaternion: four elements, of norm one.",
            Eq(Q, ImmutableMatrix([a, b, c, d])),
        ),
        Printed(
            "quaternions.2.2",
            "equation",
            "section 2, paragraph 3",
            "The elements from a unit axis and an angle.",
            Eq(
                ImmutableMatrix([a, b, c, d]),
                ImmutableMatrix([cos(0.5 * TURN), *(part * sin(0.5 * TURN) for part in AXIS)]),
            ),
        ),
        Printed(
            "quaternions.2.a",
            "claim",
            "section 2, paragraph 1",
            "A quaternion has one real element and three complex ones; counted in real numbers.",
            Eq(QUATERNIONS, REALS + 3 * COMPLEX),
        ),
        Printed(
            "quaternions.3.1",
            "equation",
            "section 3, paragraph 1",
            "A vector taken from the inertial to the body frame by two quaternion products.",
            Eq(V_B_AS_QUATERNION, Product(Q, Pure(V_I), Reciprocal(Q))),
        ),
        Printed(
            "quaternions.3.2",
            "equation",
            "section 3, paragraph 3",
            "The product of two quaternions.",
            Eq(
                Product(Q_1, Q_2),
                ImmutableMatrix(
                    [
                        a_1 * a_2 - b_1 * b_2 - c_1 * c_2 - d_1 * d_2,
                        a_1 * b_2 + b_1 * a_2 + c_1 * d_2 - d_1 * c_2,
                        a_1 * c_2 - b_1 * d_2 + c_1 * a_2 + d_1 * b_2,
                        a_1 * d_2 + b_1 * c_2 - c_1 * b_2 + d_1 * a_2,
                    ]
                ),
            ),
        ),
        Printed(
            "quaternions.3.3",
            "equation",
            "section 3, paragraph 4",
            "The rotation matrix from the quaternion, with the direction that its symbol gives it.",
            Eq(R_IB, MATRIX),
        ),
        Printed(
            "quaternions.3.4",
            "equation",
            "section 3, paragraph 5",
            "A vector taken from the inertial to the body frame by that matrix.",
            Eq(V_B, MatMul(R_IB, V_I)),
        ),
        Printed(
            "quaternions.3.a",
            "claim",
            "section 3, paragraph 2",
            "The inverse of a quaternion is its conjugate.",
            Eq(Reciprocal(ImmutableMatrix([a, b, c, d])), Conjugate(ImmutableMatrix([a, b, c, d]))),
        ),
        Printed(
            "quaternions.3.b",
            "claim",
            "section 3, paragraph 4",
            "From body to inertial frame, the matrix does at once what two quaternion products do.",
            InOrder(
                Eq(Pure(V_I), Product(Q, Pure(V_B), Reciprocal(Q))),
                Eq(V_I, MatMul(MATRIX, V_B)),
            ),
        ),
        Printed(
            "quaternions.3.c",
            "claim",
            "section 3, paragraph 6",
            "Negating the vector part reverses the rotation, by products and by the matrix.",
            InOrder(
                Eq(
                    Pure(V_I),
                    Product(
                        Conjugate(Q), Product(Q, Pure(V_I), Reciprocal(Q)), Reciprocal(Conjugate(Q))
                    ),
                ),
                Eq(V_I, MatMul(Rotation("i", "b", Conjugate(Q)), R_IB, V_I)),
            ),
        ),
        Printed(
            "quaternions.4.1",
            "equation",
            "section 4, paragraph 3",
            "Roll from the quaternion.",
            Eq(phi, atan(ROLL_PARTS[0] / ROLL_PARTS[1])),
        ),
        Printed(
            "quaternions.4.2",
            "equation",
            "section 4, paragraph 3",
            "Pitch from the quaternion.",
            Eq(theta, -asin(2 * (b * d - a * c))),
        ),
        Printed(
            "quaternions.4.3",
            "equation",
            "section 4, paragraph 3",
            "Yaw from the quaternion.",
            Eq(psi, atan(YAW_PARTS[0] / YAW_PARTS[1])),
        ),
        Printed(
            "quaternions.4.a",
            "claim",
            "section 4, paragraph 4",
            "With atan2 in place of atan, roll and yaw come out in their whole range.",
            InOrder(Eq(phi, atan2(*ROLL_PARTS)), Eq(psi, atan2(*YAW_PARTS))),
        ),
        Printed(
            "quaternions.4.b",
            "claim",
            "section 4, paragraph 4",
            "At a pitch of ±90° the conversion divides zero by zero; the quaternion goes on "
            "changing.",
            InOrder(
                *(Eq(part, 0) for part in (*ROLL_PARTS, *YAW_PARTS)),
                Eq(NO_RATE, EmptySet),
            ),
        ),
    )
