"""More of what "Using Accelerometers to Estimate Position and Velocity" says in words."""

from sympy import Eq, Le, MatAdd, MatMul, MatrixSymbol, Ne, Symbol, ZeroMatrix, pi

from chr_notes.printed.dead_reckoning import A_B, A_M
from chr_notes.printed.statement import InOrder, Printed, as_printed
from chr_notes.symbols import m

# Names for what the words speak of: the normal forces, in the body frame; the product's error; the
# error of acceleration that an error of attitude makes.
NORMAL = MatrixSymbol(r"\mathbf{N}", 3, 1)
PRODUCT_ERROR = Symbol(r"\text{error of attitude of the UM7}", real=True)
ERROR_OF_ACCELERATION = MatrixSymbol(r"\delta\mathbf{a}_I", 3, 1)

with as_printed():
    ADDITIONS = (
        Printed(
            "dead_reckoning.2.b",
            "claim",
            "section 2, paragraph 1",
            "The accelerometer measures the acceleration and the normal forces that hold it up; "
            "these must be removed.",
            InOrder(
                Eq(A_M, MatAdd(A_B, MatMul(NORMAL, 1 / m))),
                Eq(A_B, MatAdd(A_M, MatMul(-1, NORMAL, 1 / m))),
            ),
        ),
        Printed(
            "dead_reckoning.4.h",
            "claim",
            "section 4, paragraph 7",
            "The product's attitude is within about two degrees.",
            Le(PRODUCT_ERROR, 2 * pi / 180),
        ),
        Printed(
            "dead_reckoning.4.i",
            "claim",
            "section 4, paragraph 8",
            "Position and velocity can be used to estimate attitude: an error of attitude shows in "
            "the acceleration.",
            Ne(ERROR_OF_ACCELERATION, ZeroMatrix(3, 1)),
        ),
    )
