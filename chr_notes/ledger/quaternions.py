"""The quaternion note before the judgement; how it is read, `quaternions_reading` says."""

from sympy import (
    Eq,
    ImmutableMatrix,
    MatAdd,
    MatMul,
    cos,
    sin,
    sqrt,
    symbols,
)

from chr_notes.derivations import quaternions as derived
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import Case, complete
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.quaternions_angles import SETTLED as ANGLES
from chr_notes.ledger.quaternions_angles import YAW
from chr_notes.ledger.quaternions_reading import (
    ANY_VECTOR,
    NORM,
    READ,
    READ_AXIS,
    READ_ROTATION,
    READINGS,
    UNIT,
    UNIT_AXIS,
    X_TURNED,
    X,
    Z,
)
from chr_notes.printed import BY_ID, DOCUMENTS
from chr_notes.printed import quaternions as printed
from chr_notes.printed import quaternions_claims as claims
from chr_notes.printed.hamilton import Conjugate, Product, Pure, Reciprocal
from chr_notes.printed.statement import InOrder, Rotation
from chr_notes.symbols import (
    FIRST,
    VECTOR,
    a,
    b,
    c,
    d,
)

TO_INERTIAL = Rotation("b", "i", printed.Q)
TO_BODY = Rotation("i", "b", printed.Q)
MATRIX = BY_ID["quaternions.3.3"].statement.rhs
E_1, E_I, E_J, E_K = (ImmutableMatrix([int(n == place) for n in range(4)]) for place in range(4))

YAW_ONLY = derived.from_axis_angle(Z, YAW)
YAW_90 = {a: sqrt(2) / 2, b: 0, c: 0, d: sqrt(2) / 2}
NORTH = dict(zip(VECTOR, X, strict=True))

S, T = symbols("s t", real=True)
TURN_ABOUT_Z = ImmutableMatrix([S, 0, 0, T])
HALF_ABOUT_Z = {S: cos(printed.TURN / 2), T: sin(printed.TURN / 2)}
TURN_ABOUT_AXIS = ImmutableMatrix([cos(printed.TURN / 2), *(sin(printed.TURN / 2) * UNIT_AXIS)])

CONTRADICTION = (
    "Sections 3 and 4 of the note contradict each other. Take a yaw of 90°, nose to the east, "
    "q = (√½, 0, 0, √½). Section 4 finds this yaw from it. Section 3 makes of a vector to the "
    "north one to the right of the nose, where south is. The sensors use the reading of section "
    "4: they send Euler angles made by its formulas, together with the quaternion."
)
SETTLED = (
    Case("quaternions.2.1", definition=True),
    Case(
        "quaternions.2.2",
        READ_AXIS,
        steps=(
            Step(
                "To turn a vector about an axis, leave its part along the axis as it is and let "
                "the part across it go round a circle. Turned about z, x moves towards y.",
                Eq(X_TURNED, ImmutableMatrix([cos(printed.TURN), sin(printed.TURN), 0])),
            ),
            Step(
                "Multiplied out, q v q* with q = s + t k makes of x a vector with s² − t² and 2st. "
                "The first must be the cosine of the angle and the second its sine: s and t are "
                "the cosine and the sine of half the angle.",
                InOrder(
                    Eq(
                        Product(TURN_ABOUT_Z, Pure(X), Conjugate(TURN_ABOUT_Z)),
                        ImmutableMatrix([0, S**2 - T**2, 2 * S * T, 0]),
                    ),
                    Eq(
                        Pure(X_TURNED),
                        ImmutableMatrix([0, S**2 - T**2, 2 * S * T, 0]).subs(HALF_ABOUT_Z),
                    ),
                ),
            ),
            Step(
                "With these, q v q* is the turn for every vector and every unit axis.",
                Eq(
                    Product(TURN_ABOUT_AXIS, Pure(ANY_VECTOR), Conjugate(TURN_ABOUT_AXIS)),
                    Pure(claims.TURNED),
                ),
            ),
        ),
        remark="What is turned are the axes: the turn takes the inertial axes to the body axes. "
        "The negative of the quaternion stands for the same attitude.",
    ),
    Case(
        "quaternions.2.a",
        edits=(Edit(3 * printed.COMPLEX, 3 * printed.IMAGINARY),),
        root="complex-for-imaginary",
        weight="label",
        told_in="quaternions.2.1",
        steps=(
            Step(
                "A complex number is a real one and a real multiple of i: two numbers. One real "
                "and three complex elements would be seven numbers.",
                Eq(printed.REALS + 3 * printed.COMPLEX, 7),
            ),
            Step("A quaternion is four numbers.", Eq(printed.QUATERNIONS, 4)),
        ),
        remark="One real element and three **imaginary** ones: real multiples of i, j and k, each "
        "of which squares to −1. With its four elements it stands in quaternions.2.1.",
    ),
    Case(
        "quaternions.3.1",
        edits=(
            Edit(
                Product(printed.Q, Pure(printed.V_I), Reciprocal(printed.Q)),
                Product(Reciprocal(printed.Q), Pure(printed.V_I), printed.Q),
            ),
        ),
        witness={**YAW_90, **NORTH},
        root="quaternion-direction",
        weight="misleads",
        readings=READINGS,
        steps=(
            Step(
                "The attitude quaternion turns the inertial axes to the body axes. With a yaw the "
                "nose, x in the body frame, points to where q v q* takes x.",
                InOrder(
                    Eq(
                        Product(printed.Q, Pure(X), Conjugate(printed.Q)),
                        ImmutableMatrix(
                            [
                                0,
                                a**2 + b**2 - c**2 - d**2,
                                2 * b * c + 2 * a * d,
                                2 * b * d - 2 * a * c,
                            ]
                        ),
                    ),
                    Eq(
                        Product(YAW_ONLY, Pure(X), Conjugate(YAW_ONLY)),
                        ImmutableMatrix([0, cos(YAW), sin(YAW), 0]),
                    ),
                ),
            ),
            Step(
                "So q v q⁻¹ makes inertial components of body components. To go the other way, "
                "undo it: q⁻¹ from the left, q from the right.",
                Eq(
                    Product(
                        Reciprocal(printed.Q),
                        Product(printed.Q, Pure(ANY_VECTOR), Reciprocal(printed.Q)),
                        printed.Q,
                    ),
                    Pure(ANY_VECTOR),
                ),
            ),
        ),
        remark=f"{CONTRADICTION} The vector on the left is read as the one on the right is "
        "written, with a zero in front: the note says so in its next sentence.",
    ),
    Case(
        "quaternions.3.2",
        steps=(
            Step(
                "By the table of the units i before j gives k, and the other way round −k.",
                InOrder(Eq(Product(E_I, E_J), E_K), Eq(Product(E_J, E_I), -E_K)),
            ),
            Step(
                "A product of sums is the sum of all products. Each unit that multiplies the "
                "second quaternion changes the places of its elements, and some signs.",
                Eq(
                    Product(printed.Q_1, printed.Q_2),
                    MatAdd(
                        *(
                            MatMul(element, Product(unit, printed.Q_2))
                            for element, unit in zip(FIRST, (E_1, E_I, E_J, E_K), strict=True)
                        )
                    ),
                ),
            ),
        ),
    ),
    Case(
        "quaternions.3.3",
        edits=(Edit(TO_BODY, TO_INERTIAL),),
        witness=YAW_90,
        root="quaternion-direction",
        weight="misleads",
        readings=READINGS,
        steps=(
            Step(
                "Multiplied out, q v q* is the printed matrix times v. So the matrix leads where "
                "the products lead: from the body to the inertial frame.",
                Eq(
                    Product(printed.Q, Pure(ANY_VECTOR), Conjugate(printed.Q)),
                    Pure(MatMul(MATRIX, ANY_VECTOR)),
                ),
            ),
            Step(
                "For a yaw it is the matrix with the minus sign in the first row, which is that "
                "from vehicle-1 back to the inertial frame.",
                Eq(
                    Rotation("b", "i", YAW_ONLY),
                    ImmutableMatrix([[cos(YAW), -sin(YAW), 0], [sin(YAW), cos(YAW), 0], [0, 0, 1]]),
                ),
            ),
        ),
        remark="The elements are right; the symbol in front of them names the other direction.",
    ),
    Case(
        "quaternions.3.4",
        readings=READINGS,
        steps=(
            Step(
                "The symbol names the matrix from the inertial to the body frame, which does for "
                "a vector what the products do in that direction.",
                Eq(
                    Pure(MatMul(TO_BODY, printed.V_I)),
                    Product(Reciprocal(printed.Q), Pure(printed.V_I), printed.Q),
                ),
            ),
        ),
        remark="Right for the matrix that the symbol names. With the elements that the note has "
        "printed under this symbol it leads the other way, see quaternions.3.3: that error counts "
        "there.",
    ),
    Case(
        "quaternions.3.a",
        condition=UNIT,
        witness={a: 2, b: 0, c: 0, d: 0},
        root="inverse-is-conjugate",
        weight="small print",
        told_in="quaternions.2.1",
        steps=(
            Step(
                "A quaternion times its conjugate is a number, the sum of the squares.",
                Eq(Product(printed.Q, Conjugate(printed.Q)), ImmutableMatrix([NORM, 0, 0, 0])),
            ),
            Step(
                "So the inverse is the conjugate divided by that number, which is one for a unit "
                "quaternion and for no other.",
                Eq(Reciprocal(printed.Q), ImmutableMatrix([a, -b, -c, -d]) / NORM),
            ),
        ),
        remark="The sentence speaks of quaternions in general. Of the attitude quaternion it is "
        "true, because that one has norm one, see quaternions.2.1; of 2, whose inverse is ½, it is "
        "not.",
    ),
    Case(
        "quaternions.3.b",
        readings=READINGS,
        remark="The sentence says body to inertial, and that is where the products and the printed "
        "matrix lead. The formulas before and after it say the opposite.",
    ),
    Case("quaternions.3.c", readings=READINGS),
    Case(
        "quaternions.2.b",
        READ_ROTATION,
        remark="Any rotation is a turn about one axis, and for every axis and angle there is a "
        "quaternion, with its elements as in quaternions.2.2.",
    ),
)

CASES = complete(DOCUMENTS["quaternions"], READ, (*SETTLED, *ANGLES))
