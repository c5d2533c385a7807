"""The quaternion note's section 4, conversion to Euler angles, before the judgement."""

from sympy import Eq, ImmutableMatrix, cos, pi, sin, symbols

from chr_notes.derivations import quaternions as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import Case
from chr_notes.ledger.quaternions_reading import (
    READ,
    READ_AT_ITS_WORD,
    READ_AT_LOCK,
    READ_ORDERS,
    READINGS,
    SOMEWHERE,
)
from chr_notes.printed import quaternions_claims as claims
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import Angle, phi, psi, theta

# The angles of the three turns, and the elements that they make, as distinct from the angles that
# a formula finds of any elements.
ROLL, PITCH, YAW = OWN_ANGLES = symbols(r"\phi \theta \psi", real=True, cls=Angle)
A, B, C, D = OWN_ELEMENTS = symbols("a b c d")  # not those that are known to be real
BY_TURNS = derived.from_euler().xreplace(dict(zip((phi, theta, psi), OWN_ANGLES, strict=True)))
READ_TURNS = READ.also(dict(zip(OWN_ELEMENTS, BY_TURNS, strict=True)))
ELEMENTS = Step(
    "The quaternion of the three turns is a product of three, each with half its angle: yaw on the "
    "left, then pitch, then roll.",
    Eq(ImmutableMatrix(OWN_ELEMENTS), ImmutableMatrix(BY_TURNS), evaluate=False),
)
ATAN = (
    "Read as the note says two sentences later, by atan2. Taken at its word, atan gives angles "
    "from −90° to 90° only, and any other comes out wrong by 180°."
)


def _by_turns(left: ImmutableMatrix, right: ImmutableMatrix) -> Step:
    return Step(
        "With these in place of a, b, c, d numerator and denominator are sine and cosine of the "
        "angle, times the cosine of pitch. That one is not negative from −90° to 90°, so it drops "
        "out of the quotient and leaves the signs alone.",
        Eq(left, right, evaluate=False),
    )


SETTLED = (
    Case(
        "quaternions.4.1",
        READ_TURNS,
        readings=READINGS,
        steps=(
            ELEMENTS,
            _by_turns(
                ImmutableMatrix([2 * (A * B + C * D), A**2 - B**2 - C**2 + D**2]),
                ImmutableMatrix([sin(ROLL) * cos(PITCH), cos(ROLL) * cos(PITCH)]),
            ),
        ),
        remark=ATAN,
    ),
    Case(
        "quaternions.4.2",
        READ_TURNS,
        readings=READINGS,
        steps=(
            ELEMENTS,
            Step(
                "With these in place of a, b, c, d what stands in the brackets is minus the sine "
                "of pitch.",
                Eq(2 * (B * D - A * C), -sin(PITCH), evaluate=False),
            ),
        ),
        remark="Pitch lies between −90° and 90°, as the arcsine does. In rounded numbers the "
        "argument can exceed one; atan2 of the sine and cosine of pitch avoids that.",
    ),
    Case(
        "quaternions.4.3",
        READ_TURNS,
        readings=READINGS,
        steps=(
            ELEMENTS,
            _by_turns(
                ImmutableMatrix([2 * (A * D + B * C), A**2 + B**2 - C**2 - D**2]),
                ImmutableMatrix([sin(YAW) * cos(PITCH), cos(YAW) * cos(PITCH)]),
            ),
        ),
        remark=ATAN,
    ),
    Case("quaternions.4.a", READ_AT_ITS_WORD, readings=READINGS),
    Case(
        "quaternions.4.c",
        READ_ORDERS.also(SOMEWHERE),
        steps=(
            Step(
                "One attitude is enough to show it: q = (6, 4, 2, 5)/9. In the order of the note, "
                "yaw, pitch, roll, its roll is this many degrees.",
                Approximately(claims.ROLL_321 * 180 / pi, "58.9"),
            ),
            Step(
                "Reached by roll first, then pitch, then yaw, it takes this roll.",
                Approximately(claims.ROLL_123 * 180 / pi, "34.3"),
            ),
        ),
    ),
    Case(
        "quaternions.4.b",
        READ_AT_LOCK,
        remark="Only the sum or the difference of roll and yaw is left at the lock. The quaternion "
        "notices nothing: its derivative is a product of its elements and the body rates.",
    ),
)
