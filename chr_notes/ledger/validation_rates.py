"""The paper's statements on rates before the judgement: equations 8 and 9 and what follows."""

from sympy import Derivative, Eq, ImmutableMatrix, MatMul, cos, sin

from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import DEGREE, Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.validation_attitude import LABEL
from chr_notes.ledger.validation_reading import (
    RATES_READINGS,
    READ_BODY_RATES,
    READ_EULER_RATES,
    SOME_ATTITUDE,
)
from chr_notes.printed import validation as printed
from chr_notes.printed.statement import InOrder
from chr_notes.symbols import (
    BODY_RATES,
    EULER_RATES,
    p,
    phi,
    pitch_rate,
    q,
    r,
    roll_rate,
    theta,
    yaw_rate,
)

SETTLED = (
    Case(
        "validation.8",
        READ_BODY_RATES,
        edits=(Edit(printed.R_IB.T, printed.R_IB, times=2),),
        witness={**SOME_ATTITUDE, roll_rate: 10 * DEGREE, pitch_rate: 0, yaw_rate: 0},
        root="matrix-label",
        weight="label",
        told_in="validation.9",
        readings=RATES_READINGS,
        steps=(
            Step(
                "Yaw turns about the vertical, pitch about the y-axis as yaw has left it, roll "
                "about the x-axis as both have left it.",
                InOrder(
                    Eq(
                        printed.PITCH_AXIS,
                        MatMul(printed.R_Z_IN_8, ImmutableMatrix([0, 1, 0])),
                    ),
                    Eq(
                        printed.ROLL_AXIS,
                        MatMul(printed.R_Z_IN_8, printed.R_Y_IN_8, ImmutableMatrix([1, 0, 0])),
                    ),
                ),
            ),
            Step(
                "The three angular velocities stand in the inertial frame and add up there; the "
                "matrix from the inertial frame takes the sum to the body. Its transpose leads "
                "from the body to the inertial frame.",
                Eq(printed.R_IB.T, printed.R_BI, evaluate=False),
            ),
        ),
        remark="With the matrix that equation 1 prints the transpose is right, with what its label "
        "says it is one too many. What follows from it is right, see validation.9. " + LABEL,
    ),
    Case(
        "validation.9",
        READ_EULER_RATES,
        steps=(
            Step(
                "Equation 8 multiplied out, line by line: yaw does not matter to it.",
                Eq(
                    ImmutableMatrix(BODY_RATES),
                    MatMul(
                        ImmutableMatrix(
                            [
                                [1, 0, -sin(theta)],
                                [0, cos(phi), sin(phi) * cos(theta)],
                                [0, -sin(phi), cos(phi) * cos(theta)],
                            ]
                        ),
                        ImmutableMatrix(EULER_RATES),
                    ),
                ),
            ),
            Step(
                "The last two lines, turned back by roll, are two equations for the rates of "
                "pitch and yaw.",
                InOrder(
                    Eq(pitch_rate, q * cos(phi) - r * sin(phi)),
                    Eq(yaw_rate * cos(theta), q * sin(phi) + r * cos(phi)),
                ),
            ),
            Step(
                "The first line gives the rate of roll.",
                Eq(roll_rate, p + sin(theta) * yaw_rate),
            ),
        ),
    ),
    Case(
        "validation.j",
        READ_EULER_RATES,
        condition=Condition(Eq(printed.ROLL_BEFORE, phi) & Eq(printed.PITCH_BEFORE, theta)),
        witness={
            printed.ROLL_BEFORE: 0,
            printed.PITCH_BEFORE: 0,
            phi: DEGREE,
            theta: 2 * DEGREE,
            p: 0,
            q: 0,
            r: 90 * DEGREE,
        },
        root="angles-before",
        weight="small print",
        told_in="validation.9",
        steps=(
            Step(
                "With a roll that is late by some angle, the rate of pitch is off by that angle "
                "times this slope.",
                Eq(
                    Derivative(q * cos(phi) - r * sin(phi), phi),
                    -q * sin(phi) - r * cos(phi),
                ),
            ),
            Step(
                "For it belongs to the roll of the same moment, by equation 9.",
                Eq(pitch_rate, q * cos(phi) - r * sin(phi)),
            ),
        ),
        remark="Exact only where roll and pitch are still what they were one loop before. "
        "Otherwise the rates come one loop late; the error shrinks with the time between loops. "
        "The rates themselves are right, see validation.9.",
    ),
)
