"""The Euler-angle note's section 6, gimbal lock, before the judgement."""

from sympy import FiniteSet, ImmutableMatrix, Integer, MatMul, cos, pi, sin

from chr_notes.derivations.steps import Step, equation
from chr_notes.ledger.case import Case
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.euler_reading import DETERMINANT_313, DETERMINANT_321, SHIFT
from chr_notes.printed import euler as printed
from chr_notes.printed import euler_claims as claims
from chr_notes.printed.statement import InOrder, Rotation
from chr_notes.symbols import phi, psi, theta

OPPOSITE = (
    "At +90° the two turn the sensor about one line in opposite senses: a yaw by some angle is "
    "made up for by a roll by the same angle. At −90° they turn it in the same sense."
)

SETTLED = (
    Case(
        "euler.6.a",
        steps=(
            Step(
                "At 90° yaw and roll may grow together by any angle δ, and the attitude is the "
                "same: it has more than one set of angles.",
                equation(
                    Rotation("I", "B", phi + SHIFT, pi / 2, psi + SHIFT),
                    Rotation("I", "B", phi, pi / 2, psi),
                ),
            ),
        ),
        remark="Within the usual range of pitch, that is; beyond it each attitude has a second set "
        "of angles. Straight down, at −90°, it is locked as well; the note's first and last "
        "section say so.",
    ),
    Case(
        "euler.6.b",
        steps=(
            Step(
                "At a pitch of 90° the matrix depends on roll and yaw only through their "
                "difference.",
                equation(
                    Rotation("I", "B", phi, pi / 2, psi),
                    ImmutableMatrix(
                        [
                            [0, 0, -1],
                            [sin(phi - psi), cos(phi - psi), 0],
                            [cos(phi - psi), -sin(phi - psi), 0],
                        ]
                    ),
                ),
            ),
        ),
        remark=f"The roll is the negative of the yaw. {OPPOSITE}",
    ),
    Case(
        "euler.6.c",
        edits=(Edit(claims.E_X, -claims.E_X),),
        witness={theta: pi / 2, phi: 0, psi: 0},
        root="opposite-at-the-lock",
        weight="small print",
        told_in="euler.6.b",
        steps=(
            Step(
                "Roll turns about x of the body, yaw about z of the inertial frame, which is this "
                "line seen from the body.",
                equation(
                    MatMul(printed.R_IB, printed.E_Z),
                    ImmutableMatrix([-sin(theta), sin(phi) * cos(theta), cos(phi) * cos(theta)]),
                ),
            ),
        ),
        remark=f"The same line, which is why one of the two angles is lost. {OPPOSITE} "
        "What the note makes of it has the right sign, see euler.6.b.",
    ),
    Case(
        "euler.6.d",
        steps=(
            Step(
                "The middle angle, from 0° to 180°, at which yaw, pitch and roll lock, and at "
                "which turns about z, x and z again do.",
                InOrder(
                    equation(claims.LOCK_321, FiniteSet(pi / 2)),
                    equation(claims.LOCK_313, FiniteSet(0, pi)),
                ),
            ),
        ),
    ),
    Case(
        "euler.6.e",
        edits=(Edit(Integer(0), Integer(1)),),
        root="lock-without-a-cure",
        weight="small print",
        told_in="euler.6.d",
        steps=(
            Step(
                "Three turns lock where their axes lie in a plane, so where the determinant of the "
                "three axes is zero. That of yaw, pitch, roll, and that of turns about z, x and z, "
                "of which the middle one is 90° where the nose points straight up:",
                InOrder(
                    equation(DETERMINANT_321, cos(theta)),
                    equation(DETERMINANT_313, sin(theta)),
                ),
            ),
        ),
        remark="Every sequence of three angles locks somewhere, and another one somewhere else: "
        "where the nose points straight up, turns about z, x and z are as far from their lock as "
        "can be. So an estimator that changes between two sequences gets by, and the quaternion "
        "note says itself that the filter can fail “if special precautions aren't taken”. "
        "Another representation is the simple cure, and not the only one: where the lock lies "
        "depends on the order of the turns, see euler.6.d.",
    ),
)
