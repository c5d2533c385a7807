"""More of what "Understanding Quaternions" says in words."""

from sympy import Eq, MatrixSymbol, Ne
from sympy.matrices.expressions.matexpr import MatrixElement

from chr_notes.printed.hamilton import Product, Pure, Reciprocal
from chr_notes.printed.quaternions import V_I, Q
from chr_notes.printed.statement import Printed, as_printed
from chr_notes.symbols import Angle

# Names for what the words speak of: a vector turned by any angle about any axis; the first angle
# of one attitude in two orders of the turns.
TURNED = MatrixSymbol(r"\mathbf{v}_{\text{turned}}", 3, 1)
ROLL_321, ROLL_123 = (
    Angle(rf"\phi_{{\text{{{order}}}}}", real=True) for order in ("3-2-1", "1-2-3")
)

with as_printed():
    ADDITIONS = (
        Printed(
            "quaternions.2.b",
            "claim",
            "section 2, paragraph 1",
            "A quaternion can encode any rotation of three dimensions.",
            Eq(Pure(TURNED), Product(Q, Pure(V_I), Reciprocal(Q))),
        ),
        Printed(
            "quaternions.3.d",
            "claim",
            "section 3, paragraph 2",
            "A vector is rotated as a quaternion with real part zero: the product has real part "
            "zero as well.",
            Eq(MatrixElement(Product(Q, Pure(V_I), Reciprocal(Q)), 0, 0), 0),
        ),
        Printed(
            "quaternions.4.c",
            "claim",
            "section 4, paragraph 3",
            "The equations for the Euler angles depend on the order of the rotations.",
            Ne(ROLL_321, ROLL_123),
        ),
    )
