"""The quaternion note before the judgement.

The note contradicts itself. Its section 3 takes vectors from the inertial to the body frame by
`q v q⁻¹`; the Euler angles of its section 4 are right only if the same product leads from the
body to the inertial frame. Everything is judged in the second reading, which is the sensors' own,
and the statements that differ are tried in the first one as well.
"""

from sympy import (
    Abs,
    Basic,
    Eq,
    Gt,
    ImmutableMatrix,
    MatMul,
    Symbol,
    Transpose,
    cos,
    pi,
    sin,
    symbols,
)

from chr_notes.derivations import hamilton
from chr_notes.derivations import quaternions as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import Case, Condition, complete
from chr_notes.ledger.quaternions_reading import (
    AS_QUATERNION,
    BY_ID,
    DERIVED,
    ELEMENTS,
    MATRIX,
    MEANING,
    NORM,
    NORTH,
    READ,
    READ_AT_LOCK,
    READ_AXIS,
    READ_BACK,
    READ_MATRIX,
    READ_PRODUCT,
    ROLL_120,
    TO_BODY,
    TO_INERTIAL,
    UNIT,
    YAW_90,
    YAW_120,
    readings,
)
from chr_notes.printed import quaternions as printed
from chr_notes.printed.hamilton import Conjugate, Product, Pure, Reciprocal
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import (
    EULER,
    QUATERNION,
    VECTOR,
    Angle,
    a,
    alpha,
    b,
    c,
    d,
    theta,
)

# The angles of the three turns, as distinct from those that a formula finds.
OWN_ANGLES = symbols(r"\phi \theta \psi", real=True, cls=Angle)
TURN_ABOUT_Z = derived.from_axis_angle(ImmutableMatrix([0, 0, 1]), OWN_ANGLES[2])
CONTRADICTION = (
    "Sections 3 and 4 of the note contradict each other. Take a yaw of 90°, nose to the east, "
    "q = (√½, 0, 0, √½). Section 4 finds this yaw from it. Section 3 makes of a vector to the "
    "north one to the right of the nose, where south is. The sensors use the reading of section "
    "4: they send Euler angles made by its formulas, together with the quaternion."
)
ALSO = (
    "Sections 3 and 4 of the note contradict each other, see quaternions.3.1. The sensors use the "
    "reading of section 4."
)
_S, _T = symbols("s t", real=True)
_TILT, _HEADING = symbols("tau eta", real=True)
_UNIT_AXIS = ImmutableMatrix([sin(_TILT) * cos(_HEADING), sin(_TILT) * sin(_HEADING), cos(_TILT)])
_POSITIVE = Symbol("k", positive=True)


def _cosine_positive(parts: tuple[Basic, Basic]) -> Condition:
    """Give the condition under which arctan finds an angle from its sine and cosine."""
    cosine = parts[1].doit()
    return Condition(Gt(cosine, 0), ({cosine: _POSITIVE},))


def _arctan_steps(angle: Angle, parts: tuple[Basic, Basic]) -> tuple[Step, ...]:
    own = dict(zip(EULER, OWN_ANGLES, strict=True))
    elements = dict(zip(QUATERNION, derived.from_euler().xreplace(own), strict=True))
    pitch = own[theta]
    return (
        Step(
            "Put the quaternion of the three turns in place of a, b, c, d: numerator and "
            "denominator are sine and cosine of the angle, times the cosine of pitch, which is "
            "not negative from −90° to 90°.",
            Eq(
                ImmutableMatrix([part.subs(elements) for part in parts]),
                ImmutableMatrix([sin(angle) * cos(pitch), cos(angle) * cos(pitch)]),
                evaluate=False,
            ),
        ),
        Step(
            "The fraction is the tangent, and half a turn more does not change a tangent. The "
            "arctangent, which gives angles from −90° to 90°, cannot tell the two apart.",
            Eq(sin(angle + pi) / cos(angle + pi), sin(angle) / cos(angle), evaluate=False),
        ),
    )


SETTLED = (
    Case(BY_ID["quaternions.2.1"], DERIVED),
    Case(
        BY_ID["quaternions.2.2"],
        READ_AXIS,
        steps=(
            Step(
                "To turn a vector about an axis, leave its part along the axis as it is and let "
                "the part across it go round a circle. Turned about z, x moves towards y.",
                Eq(
                    derived.turned(ImmutableMatrix([0, 0, 1]), alpha, ImmutableMatrix([1, 0, 0])),
                    ImmutableMatrix([cos(alpha), sin(alpha), 0]),
                    evaluate=False,
                ),
            ),
            Step(
                "Multiplied out, q v q* with q = s + t k makes of x the vector below. So s² − t² "
                "must be the cosine of the angle and 2st its sine: s and t are the cosine and "
                "the sine of half the angle.",
                Eq(
                    hamilton.sandwich(ImmutableMatrix([_S, 0, 0, _T]), ImmutableMatrix([1, 0, 0])),
                    ImmutableMatrix([_S**2 - _T**2, 2 * _S * _T, 0]),
                    evaluate=False,
                ),
            ),
            Step(
                "With these, q v q* is the turn for every vector and every unit axis.",
                Eq(
                    hamilton.sandwich(
                        derived.from_axis_angle(_UNIT_AXIS, alpha), ImmutableMatrix(VECTOR)
                    ),
                    derived.turned(_UNIT_AXIS, alpha, ImmutableMatrix(VECTOR)),
                    evaluate=False,
                ),
            ),
        ),
        remark="What is turned are the axes: the turn takes the inertial axes to the body axes. "
        "The negative of the quaternion stands for the same attitude.",
    ),
    Case(
        BY_ID["quaternions.2.a"],
        READ,
        correction=Eq(printed.QUATERNIONS, printed.REALS + 3 * printed.IMAGINARY),
        remark="One real element and three **imaginary** ones: real multiples of i, j and k, each "
        "of which squares to −1. A complex number is made of two real ones, so a real element and "
        "three complex ones would be seven numbers, not four.",
    ),
    Case(
        BY_ID["quaternions.3.1"],
        READ_PRODUCT,
        given=(UNIT,),
        correction=Eq(
            printed.V_B,
            Product(Reciprocal(printed.Q), Pure(printed.V_I), printed.Q),
            evaluate=False,
        ),
        witness={**YAW_90, **NORTH},
        readings=readings({**AS_QUATERNION, **ELEMENTS}),
        steps=(
            Step(
                "The attitude quaternion turns the inertial axes to the body axes. With a yaw the "
                "nose, x in the body frame, points to where q v q* takes x.",
                Eq(
                    hamilton.sandwich(TURN_ABOUT_Z, ImmutableMatrix([1, 0, 0])),
                    ImmutableMatrix([cos(OWN_ANGLES[2]), sin(OWN_ANGLES[2]), 0]),
                    evaluate=False,
                ),
            ),
            Step(
                "So q v q⁻¹ makes inertial components of body components. To go the other way, "
                "undo it: q⁻¹ from the left, q from the right.",
                Eq(
                    Pure(printed.V_I),
                    Product(
                        Reciprocal(printed.Q),
                        Product(printed.Q, Pure(printed.V_I), Reciprocal(printed.Q)),
                        printed.Q,
                    ),
                ),
            ),
        ),
        remark=f"{CONTRADICTION} Besides, the line equates a vector of three with a quaternion of "
        "four; the vector on the left is read as the one on the right, with a zero in front.",
    ),
    Case(
        BY_ID["quaternions.3.3"],
        READ,
        given=(UNIT,),
        correction=Eq(Rotation("b", "i", printed.Q), printed.MATRIX),
        witness=YAW_90,
        readings=readings(ELEMENTS),
        steps=(
            Step(
                "Multiplied out, q v q* is the printed matrix times v. So the matrix leads where "
                "the products lead: from the body to the inertial frame.",
                Eq(
                    derived.rotate_to_inertial(),
                    ImmutableMatrix(printed.MATRIX * ImmutableMatrix(VECTOR)),
                    evaluate=False,
                ),
            ),
            Step(
                "For a yaw it is the matrix with the minus sign in the first row, which is that "
                "from vehicle-1 back to the inertial frame.",
                Eq(
                    printed.MATRIX.subs(dict(zip(QUATERNION, TURN_ABOUT_Z, strict=True))),
                    ImmutableMatrix(
                        [
                            [cos(OWN_ANGLES[2]), -sin(OWN_ANGLES[2]), 0],
                            [sin(OWN_ANGLES[2]), cos(OWN_ANGLES[2]), 0],
                            [0, 0, 1],
                        ]
                    ),
                    evaluate=False,
                ),
            ),
        ),
        remark="The elements are right; the symbol in front of them names the other direction. "
        + ALSO,
    ),
    Case(
        BY_ID["quaternions.3.4"],
        READ_MATRIX,
        given=(UNIT,),
        correction=Eq(printed.V_B, MatMul(Transpose(printed.R_IB), printed.V_I)),
        witness={**YAW_90, **NORTH},
        readings=readings({**TO_BODY, **ELEMENTS, **MATRIX}),
        steps=(
            Step(
                "The matrix that stands before it is that of q v q*, from body to inertial frame. "
                "The vector in the body frame is what its transpose makes of the inertial one.",
                Eq(
                    derived.rotate_to_body(),
                    ImmutableMatrix(printed.MATRIX.T * ImmutableMatrix(VECTOR)),
                    evaluate=False,
                ),
            ),
        ),
        remark="R stands here for the matrix that the note has just defined under that symbol. "
        "With the matrix that the symbol names, its transpose, the line would be right. " + ALSO,
    ),
    Case(
        BY_ID["quaternions.3.a"],
        READ,
        condition=UNIT,
        witness={a: 2, b: 0, c: 0, d: 0},
        steps=(
            Step(
                "A quaternion times its conjugate is a number, the sum of the squares.",
                Eq(
                    Product(printed.Q, Conjugate(printed.Q)),
                    ImmutableMatrix([NORM, 0, 0, 0]),
                ),
            ),
            Step(
                "So the inverse is the conjugate divided by that number, which is one for a unit "
                "quaternion and for no other.",
                Eq(Reciprocal(printed.Q), ImmutableMatrix([a, -b, -c, -d]) / NORM),
            ),
        ),
        remark="The sentence speaks of quaternions in general. Of the attitude quaternion it is "
        "true, because that one has norm one; of 2, whose inverse is ½, it is not.",
    ),
    Case(
        BY_ID["quaternions.3.b"],
        READ_BACK,
        given=(UNIT,),
        readings=readings({**TO_INERTIAL, **ELEMENTS}),
        remark="The sentence says body to inertial, and that is where the products and the printed "
        "matrix lead. The formulas before and after it say the opposite. " + ALSO,
    ),
    Case(
        BY_ID["quaternions.4.1"],
        READ,
        condition=_cosine_positive(printed.ROLL_PARTS),
        witness=ROLL_120,
        readings=readings({**MEANING, **ELEMENTS}),
        steps=_arctan_steps(OWN_ANGLES[0], printed.ROLL_PARTS),
        remark="Right for a roll between −90° and 90°. Beyond, in an aircraft on its back, it is "
        "off by 180°; the note then says to use atan2. " + ALSO,
    ),
    Case(
        BY_ID["quaternions.4.2"],
        READ,
        given=(UNIT,),
        readings=readings({**MEANING, **ELEMENTS}),
        remark="Pitch lies between −90° and 90°, as the arcsine does. In rounded numbers the "
        "argument can exceed one; atan2 of the sine and cosine of pitch avoids that. " + ALSO,
    ),
    Case(
        BY_ID["quaternions.4.3"],
        READ,
        condition=_cosine_positive(printed.YAW_PARTS),
        witness=YAW_120,
        readings=readings({**MEANING, **ELEMENTS}),
        steps=_arctan_steps(OWN_ANGLES[2], printed.YAW_PARTS),
        remark="Right for a heading between west and east by way of north. For any other it is off "
        "by 180°; the note then says to use atan2. " + ALSO,
    ),
    Case(
        BY_ID["quaternions.4.b"],
        READ_AT_LOCK,
        given=(Condition(Eq(Abs(theta), pi / 2), ({theta: pi / 2}, {theta: -pi / 2})),),
        remark="Only the sum or the difference of roll and yaw is left at the lock. The quaternion "
        "notices nothing: its derivative is a product of its elements and the body rates.",
    ),
)

CASES = complete(printed.PRINTED, READ, SETTLED)
