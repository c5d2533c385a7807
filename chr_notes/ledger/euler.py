"""The Euler-angle note before the judgement, up to the body frame.

`euler_lock` and `euler_rates` have the rest.
"""

from sympy import (
    Expr,
    Identity,
    ImmutableMatrix,
    MatAdd,
    MatMul,
    MatrixSymbol,
    Transpose,
    cos,
    sin,
)

from chr_notes.derivations.steps import Step, equation
from chr_notes.ledger.case import DEGREE, Case, complete
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.euler_lock import SETTLED as LOCK
from chr_notes.ledger.euler_rates import SETTLED as RATES
from chr_notes.ledger.euler_reading import (
    AXES_B,
    AXES_V1,
    AXES_V2,
    BEFORE,
    READ,
    V_V1,
    V_V2,
    VECTOR,
)
from chr_notes.printed import DOCUMENTS
from chr_notes.printed import euler as printed
from chr_notes.printed import euler_claims as claims
from chr_notes.printed.statement import InOrder, Rotation, words
from chr_notes.symbols import phi, psi, theta

YAW_AND_PITCH = ImmutableMatrix(
    [
        [cos(theta) * cos(psi), cos(theta) * sin(psi), -sin(theta)],
        [-sin(psi), cos(psi), 0],
        [sin(theta) * cos(psi), sin(theta) * sin(psi), cos(theta)],
    ]
)


def projected(
    axes: tuple[MatrixSymbol, ...],
    turned: int,
    matrix: Rotation,
    before: ImmutableMatrix,
    *to: Expr,
) -> Step:
    """Tell that the rows of a matrix are the new axes: what it takes a vector to, one by one."""
    return Step(
        "Each new component is the dot product of the vector with a new axis. So the new axes are "
        "the rows of the matrix.",
        InOrder(
            equation(MatMul(Transpose(axes[turned]), before), ImmutableMatrix([to[turned]])),
            equation(MatMul(matrix, before), ImmutableMatrix(to)),
        ),
    )


UNDONE = Step(
    "A turn is undone by one through the same angle, the other way round. So the inverse of each "
    "matrix is that of the negative angle.",
    equation(MatMul(Rotation("I", "v1", -psi), printed.R_YAW), Identity(3)),
)

SETTLED = (
    Case(
        "euler.1.a",
        remark="About axes such as these three, of which the middle one is at right angles to both "
        "others. Three axes that lie close together do not reach every orientation.",
        steps=(
            Step(
                "Let the x-axis of any frame have some heading ψ and climb θ. These two reach "
                "every direction.",
                equation(
                    MatMul(Transpose(claims.ANY_ROTATION), claims.E_X),
                    ImmutableMatrix([cos(theta) * cos(psi), cos(theta) * sin(psi), -sin(theta)]),
                ),
            ),
            Step(
                "The y-axis is at right angles to it: it has turned by some ϕ from where it would "
                "be level. The z-axis has no choice then.",
                equation(
                    MatMul(Transpose(claims.ANY_ROTATION), printed.E_Y),
                    MatAdd(
                        MatMul(cos(phi), ImmutableMatrix([-sin(psi), cos(psi), 0])),
                        MatMul(
                            sin(phi),
                            ImmutableMatrix(
                                [sin(theta) * cos(psi), sin(theta) * sin(psi), cos(theta)]
                            ),
                        ),
                    ),
                ),
            ),
        ),
    ),
    Case(
        "euler.2.a",
        remark="What is negative is the coordinate z; the altitude is not. Counted from the "
        "ground, that is: with the frame's origin 100 m above it, a point 30 m above the ground "
        "has z = +70 m.",
    ),
    Case(
        "euler.3.1",
        steps=(
            Step(
                "Yaw leaves the z-axis where it is and turns x towards y. The new axes, in the old "
                "frame:",
                InOrder(
                    equation(AXES_V1[0], ImmutableMatrix([cos(psi), sin(psi), 0])),
                    equation(AXES_V1[1], ImmutableMatrix([-sin(psi), cos(psi), 0])),
                ),
            ),
            projected(
                AXES_V1,
                0,
                printed.R_YAW,
                VECTOR,
                cos(psi) * VECTOR[0] + sin(psi) * VECTOR[1],
                -sin(psi) * VECTOR[0] + cos(psi) * VECTOR[1],
                VECTOR[2],
            ),
        ),
    ),
    Case(
        "euler.4.1",
        steps=(
            Step(
                "Pitch leaves the y-axis where it is and turns z towards x: the nose comes up. The "
                "new axes, in the frame before:",
                InOrder(
                    equation(AXES_V2[0], ImmutableMatrix([cos(theta), 0, -sin(theta)])),
                    equation(AXES_V2[2], ImmutableMatrix([sin(theta), 0, cos(theta)])),
                ),
            ),
            projected(
                AXES_V2,
                0,
                printed.R_PITCH,
                BEFORE,
                cos(theta) * BEFORE[0] - sin(theta) * BEFORE[2],
                BEFORE[1],
                sin(theta) * BEFORE[0] + cos(theta) * BEFORE[2],
            ),
        ),
    ),
    Case(
        "euler.4.2",
        steps=(
            Step(
                "Yaw takes the components of a vector to vehicle-1, pitch from there to vehicle-2.",
                InOrder(
                    equation(V_V1, MatMul(printed.R_YAW, printed.V_I)),
                    equation(V_V2, MatMul(printed.R_PITCH, V_V1)),
                ),
            ),
            Step(
                "Put one into the other. It holds for every vector, so the product is the matrix; "
                "the turn that comes first stands next to the vector.",
                equation(V_V2, MatMul(printed.R_PITCH, printed.R_YAW, printed.V_I)),
            ),
        ),
    ),
    Case(
        "euler.4.a",
        remark="Pitch turns about the y-axis of vehicle-1. Without yaw that one coincides with the "
        "inertial y-axis.",
    ),
    Case(
        "euler.4.b",
        edits=(Edit(words("vehicle-3"), words("vehicle-2")),),
        root="vehicle-3",
        weight="small print",
        steps=(
            Step(
                "Yaw leads to vehicle-1 and pitch from there to vehicle-2: this is the matrix of "
                "both.",
                equation(printed.R_IV2, YAW_AND_PITCH),
            ),
        ),
        remark="There are four frames in all, and no vehicle-3 among them.",
    ),
    Case(
        "euler.5.1",
        steps=(
            Step(
                "Roll leaves the x-axis where it is and turns y towards z. The new axes, in the "
                "frame before:",
                InOrder(
                    equation(AXES_B[1], ImmutableMatrix([0, cos(phi), sin(phi)])),
                    equation(AXES_B[2], ImmutableMatrix([0, -sin(phi), cos(phi)])),
                ),
            ),
            projected(
                AXES_B,
                1,
                printed.R_ROLL,
                BEFORE,
                BEFORE[0],
                cos(phi) * BEFORE[1] + sin(phi) * BEFORE[2],
                -sin(phi) * BEFORE[1] + cos(phi) * BEFORE[2],
            ),
        ),
    ),
    Case(
        "euler.5.2",
        steps=(
            Step(
                "Yaw and pitch take the components of a vector to vehicle-2, roll from there to "
                "the body.",
                InOrder(
                    equation(V_V2, MatMul(printed.R_IV2, printed.V_I)),
                    equation(printed.V_B, MatMul(printed.R_ROLL, V_V2)),
                ),
            ),
            Step(
                "Put one into the other, with the product of pitch and yaw in its place.",
                equation(
                    printed.V_B,
                    MatMul(printed.R_ROLL, printed.R_PITCH, printed.R_YAW, printed.V_I),
                ),
            ),
        ),
    ),
    Case(
        "euler.5.3",
        steps=(
            Step("Multiply pitch and yaw first.", equation(printed.R_IV2, YAW_AND_PITCH)),
            Step(
                "Roll keeps the first row and mixes the other two.",
                equation(printed.R_IB, MatMul(printed.R_ROLL, YAW_AND_PITCH)),
            ),
        ),
    ),
    Case(
        "euler.5.4",
        steps=(
            UNDONE,
            Step(
                "To go back, undo the last turn first: roll, then pitch, then yaw.",
                equation(
                    MatMul(*printed.TURNS_BACK, printed.R_ROLL, printed.R_PITCH, printed.R_YAW),
                    Identity(3),
                ),
            ),
        ),
    ),
    Case(
        "euler.5.5",
        edits=(Edit(printed.R_IB, printed.R_BI),),
        witness={phi: 30 * DEGREE, theta: 20 * DEGREE, psi: 60 * DEGREE},
        root="body-to-inertial-symbol",
        weight="label",
        told_in="euler.5.4",
        steps=(
            Step(
                "The rows of the matrix are three axes at right angles, of length one. So its "
                "transpose undoes it.",
                equation(MatMul(Transpose(printed.R_IB), printed.R_IB), Identity(3)),
            ),
            Step(
                "The way back is the transpose of the way there: what is printed, without the "
                "symbol in front.",
                equation(printed.R_BI, Transpose(printed.R_IB)),
            ),
        ),
        remark="The right-hand side is the matrix from body to inertial, as the sentence before "
        "it says; the symbol on the left repeats the one of the opposite direction. "
        "The line before has the right one, see euler.5.4.",
    ),
    Case("euler.5.a", steps=(UNDONE,)),
    Case("euler.7.e", remark="As euler.3.a says of the first."),
)

CASES = complete(DOCUMENTS["euler"], READ, (*SETTLED, *LOCK, *RATES))
