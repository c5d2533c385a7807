"""The Euler-angle note's section 7, vectors and rates in other frames, before the judgement."""

from sympy import (
    Identity,
    ImmutableMatrix,
    Inverse,
    MatAdd,
    MatMul,
    cos,
    sin,
)
from sympy.matrices.expressions.matexpr import MatrixElement

from chr_notes.derivations.steps import Step, equation
from chr_notes.ledger.case import DEGREE, Case
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.euler_reading import PITCH_TURN, ROLL_TURN, YAW_TURN
from chr_notes.printed import euler as printed
from chr_notes.printed.statement import InOrder, Rotation
from chr_notes.symbols import p, phi, pitch_rate, psi, q, r, roll_rate, theta, yaw_rate

AXES_OF_THE_TURNS = ImmutableMatrix(
    [
        [1, 0, -sin(theta)],
        [0, cos(phi), sin(phi) * cos(theta)],
        [0, -sin(phi), cos(phi) * cos(theta)],
    ]
)
# Gyro x taken to vehicle-2, y to vehicle-1, z to the inertial frame, and one component of each.
PROJECTIONS = ImmutableMatrix(
    [
        MatrixElement(MatMul(Rotation("B", frame), reading), row, 0)
        for row, (frame, reading) in enumerate(
            (
                ("v2", ImmutableMatrix([p, 0, 0])),
                ("v1", ImmutableMatrix([0, q, 0])),
                ("I", ImmutableMatrix([0, 0, r])),
            )
        )
    ]
)
TURNS = (
    Step(
        "Each Euler rate is a turn about one known axis. Roll's is x of the body. Pitch's is y of "
        "vehicle-2, from where roll's matrix leads to the body. Yaw's is down, and both pitch and "
        "roll come after it.",
        InOrder(
            equation(ROLL_TURN, ImmutableMatrix([roll_rate, 0, 0])),
            equation(PITCH_TURN, MatMul(printed.R_ROLL, ImmutableMatrix([0, pitch_rate, 0]))),
            equation(
                YAW_TURN,
                MatMul(printed.R_ROLL, printed.R_PITCH, ImmutableMatrix([0, 0, yaw_rate])),
            ),
        ),
    ),
    Step(
        "Multiplied out, in the body frame:",
        InOrder(
            equation(
                PITCH_TURN, ImmutableMatrix([0, pitch_rate * cos(phi), -pitch_rate * sin(phi)])
            ),
            equation(
                YAW_TURN,
                ImmutableMatrix(
                    [
                        -yaw_rate * sin(theta),
                        yaw_rate * sin(phi) * cos(theta),
                        yaw_rate * cos(phi) * cos(theta),
                    ]
                ),
            ),
        ),
    ),
)
SUM = Step(
    "They add up to what the gyros read.",
    equation(printed.GYROS, MatMul(AXES_OF_THE_TURNS, printed.RATES)),
)
INVERSE = Step(
    "Roll's and yaw's axes are at right angles only while the nose is level. So their rates cannot "
    "be read off as projections; one has to solve for the three together. D is the inverse.",
    equation(MatMul(printed.D, AXES_OF_THE_TURNS), Identity(3)),
)

SETTLED = (
    Case(
        "euler.7.1",
        steps=(
            Step(
                "What the sensor reads in its body frame are the components of one vector, taken "
                "there from the inertial frame.",
                equation(printed.V_B, MatMul(printed.R_IB, printed.V_I)),
            ),
            Step(
                "The matrix of the other direction undoes that.",
                equation(MatMul(printed.R_BI, printed.R_IB), Identity(3)),
            ),
        ),
    ),
    Case("euler.7.2", steps=(*TURNS, SUM, INVERSE)),
    Case(
        "euler.7.3",
        steps=(
            Step(
                "Multiply the gyros' readings by the matrix D.",
                equation(printed.RATES, MatMul(printed.D, printed.GYROS)),
            ),
        ),
    ),
    Case(
        "euler.7.a",
        edits=(Edit(PROJECTIONS, MatMul(Inverse(AXES_OF_THE_TURNS), printed.GYROS)),),
        witness={phi: 0, theta: 60 * DEGREE, psi: 0, p: 0, q: 0, r: 90 * DEGREE},
        root="rates-by-projection",
        weight="misleads",
        steps=(*TURNS, SUM, INVERSE),
        remark="The matrix D that follows is right, but these words do not lead to it: rotating "
        "each gyro's output and reading off one component gives factors of cos(pitch) where D "
        "divides by it. The rotation has to go from the Euler rates to the body, and then be "
        "inverted.",
    ),
    Case(
        "euler.7.b",
        steps=(
            SUM,
            Step(
                "D less the identity makes of the readings what they lack of the Euler rates. This "
                "is not zero.",
                equation(
                    MatMul(MatAdd(printed.D, -Identity(3)), printed.GYROS),
                    ImmutableMatrix(
                        [
                            yaw_rate * sin(theta),
                            pitch_rate * (1 - cos(phi)) - yaw_rate * sin(phi) * cos(theta),
                            pitch_rate * sin(phi) - yaw_rate * (cos(phi) * cos(theta) - 1),
                        ]
                    ),
                ),
            ),
        ),
        remark="In general: here with some roll. The two agree while the sensor does "
        "nothing but roll, in level flight without roll, where D is the identity, and while it "
        "only rolls and pitches with a roll of zero.",
    ),
    Case(
        "euler.7.c",
        remark="In general. With no roll the middle element is zero at every pitch and does not "
        "diverge; with 90° of roll the last one is. One of the two always does. The first row "
        "diverges as well, for tan(pitch) divides by cos(pitch) too.",
    ),
    Case(
        "euler.7.d",
        steps=(
            Step(
                "Turning the whole picture about the vertical changes yaw and nothing else, so "
                "yaw cannot matter: none of the axes from which D comes has it.",
                equation(Inverse(printed.D), AXES_OF_THE_TURNS),
            ),
        ),
        remark="Nor does it depend on yaw: roll and pitch are enough.",
    ),
    Case(
        "euler.7.f",
        remark="At rest the measured one points up with one g, see sensors.2.a. Gravity added to "
        "it leaves the actual one.",
    ),
)
