"""More of what "Sensors for Orientation Estimation" says in words."""

from sympy import Eq, Limit, Lt, MatAdd, MatMul, MatrixSymbol, Symbol, Transpose
from sympy.matrices.expressions.dotproduct import DotProduct

from chr_notes.printed.sensors import (
    A_M,
    B_C,
    B_M,
    BETA,
    BETA_A,
    CENTRE,
    D_S,
    F_LESS_G,
    FIELD,
    B,
)
from chr_notes.printed.statement import Approximately, InOrder, Printed, as_printed, words
from chr_notes.symbols import m

# Names for what the words speak of: the deflection for each unit of acceleration, at a frequency
# and under an acceleration that stays; the frequency; the forces besides gravity; the acceleration
# of the body; a figure; what the two corrections of the magnetometer come to in one; its
# calibration at two temperatures; its shape.
RESPONSE, RESPONSE_HELD = (
    Symbol(rf"\frac{{\text{{deflection}}}}{{\text{{acceleration}}}}\left({at}\right)", real=True)
    for at in (r"\omega", r"\text{constant acceleration}")
)
FREQUENCY = Symbol("omega", nonnegative=True)
NORMAL = MatrixSymbol(r"\mathbf{N}", 3, 1)
EXTERNAL = MatrixSymbol(r"\mathbf{F}_{\text{external}}", 3, 1)
ACTUAL = MatrixSymbol(r"\mathbf{a}_{\text{actual}}", 3, 1)
FALLING = Symbol(r"\left\lVert\mathbf{a}_{\text{free fall}}\right\rVert", positive=True)
LEVEL_FIGURE = words("figure of a sensor level on a table")
COMBINED = MatrixSymbol("A", 3, 3)
OFFSET = MatrixSymbol(r"\mathbf{c}", 3, 1)
FEWER, ALL_TERMS = (
    Symbol(rf"\text{{terms {how}}}", integer=True) for how in ("combined", "as printed")
)
SHAPE = MatrixSymbol(r"\text{shape of the ellipsoid}", 3, 3)
COLD_AND_WARM = tuple(
    tuple(MatrixSymbol(rf"{{{letter}_b}}\left({at}\right)", 3, columns) for at in ("T_1", "T_2"))
    for letter, columns in ((r"\beta", 1), ("S", 3), ("M", 3))
)

with as_printed():
    FROM_CENTRE = MatAdd(B, MatMul(-1, CENTRE))
    ADDITIONS = (
        Printed(
            "sensors.2.f",
            "claim",
            "section 2, paragraph 2",
            "Below the natural frequency, far enough below it, the deflection is proportional to "
            "acceleration.",
            Eq(Limit(RESPONSE, FREQUENCY, 0), RESPONSE_HELD),
        ),
        Printed(
            "sensors.2.g",
            "claim",
            "section 2, paragraph 4",
            "An accelerometer never measures gravity, it measures normal forces, and other "
            "external ones.",
            Eq(A_M, MatMul(MatAdd(NORMAL, EXTERNAL), 1 / m)),
        ),
        Printed(
            "sensors.2.h",
            "claim",
            "section 2, paragraph 9",
            "The quantity that is extracted is called the actual acceleration.",
            Eq(ACTUAL, MatMul(F_LESS_G, 1 / m)),
        ),
        Printed(
            "sensors.2.i",
            "claim",
            "section 2, paragraph 5",
            "The figure that is named as the illustration of a level sensor.",
            Eq(LEVEL_FIGURE, words("Figure 1")),
        ),
        Printed(
            "sensors.2.j",
            "claim",
            "section 2, paragraph 9",
            "The bias of the model, which has no index, is that of the correction, which has one.",
            Eq(BETA_A, BETA),
        ),
        Printed(
            "sensors.2.k",
            "claim",
            "section 2, paragraph 3",
            "In free fall the body accelerates by 9.8 m/s².",
            Approximately(FALLING, "9.8"),
        ),
        Printed(
            "sensors.4.e",
            "claim",
            "section 4, paragraph 10",
            "Terms of the magnetometer's correction can be combined into fewer.",
            InOrder(
                Eq(B_C, MatAdd(MatMul(COMBINED, B_M), MatMul(-1, OFFSET))),
                Lt(FEWER, ALL_TERMS),
            ),
        ),
        Printed(
            "sensors.4.f",
            "claim",
            "section 4, paragraph 10",
            "Bias, scale factor and alignment remain constant.",
            InOrder(*(Eq(cold, warm) for cold, warm in COLD_AND_WARM)),
        ),
        Printed(
            "sensors.4.g",
            "claim",
            "section 4, paragraph 7",
            "A correction matrix makes the ellipsoid look like a sphere again.",
            Eq(
                DotProduct(MatMul(D_S, FROM_CENTRE), MatMul(D_S, FROM_CENTRE)),
                DotProduct(FIELD, FIELD),
            ),
        ),
        Printed(
            "sensors.4.h",
            "claim",
            "section 4, paragraph 7",
            "The shape of the ellipsoid is caused by soft iron.",
            Eq(SHAPE, MatMul(Transpose(D_S), D_S)),
        ),
    )
