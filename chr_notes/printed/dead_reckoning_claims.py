"""More of what "Using Accelerometers to Estimate Position and Velocity" says in words."""

from sympy import Eq, Le, MatAdd, MatMul, MatrixSymbol, Ne, Symbol, ZeroMatrix, pi

from chr_notes.printed.dead_reckoning import A_B, A_M
from chr_notes.printed.statement import InOrder, Printed, as_printed
from chr_notes.symbols import m

# Names for what the words speak of: the normal forces, in the body frame; the product's error; the
# errors of acceleration that an error of tilt and one of yaw make.
NORMAL = MatrixSymbol(r"\mathbf{N}", 3, 1)
PRODUCT_ERROR = Symbol(r"\text{error of attitude of the UM7}", real=True)
BY_TILT, BY_YAW = (
    MatrixSymbol(rf"\delta\mathbf{{a}}_I\left(\text{{{error}}}\right)", 3, 1)
    for error in ("tilt, at rest", "yaw, gathering speed")
)

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
            "Position and velocity can be used to estimate attitude: errors of attitude show in "
            "the acceleration, one of tilt at rest, one of yaw while the body gathers speed.",
            InOrder(Ne(BY_TILT, ZeroMatrix(3, 1)), Ne(BY_YAW, ZeroMatrix(3, 1))),
        ),
    )
