"""What "Using Accelerometers to Estimate Position and Velocity" prints, its Table 1 apart."""

from sympy import Eq, ImmutableMatrix, MatAdd, MatMul, MatrixSymbol, Ne, ZeroMatrix

from chr_notes.printed.statement import Approximately, InOrder, Printed, Rotation, as_printed
from chr_notes.printed.table_1 import CELLS, error
from chr_notes.symbols import T, g

A_M = MatrixSymbol(r"\mathbf{a}_m", 3, 1)
A_B = MatrixSymbol(r"\mathbf{a}_B", 3, 1)
A_I = MatrixSymbol(r"\mathbf{a}_I", 3, 1)
IN_GRAVITIES = MatrixSymbol(r"\tilde{\mathbf{a}}_m", 3, 1)
V_I = MatrixSymbol(r"\mathbf{v}_I", 3, 1)
R_I = MatrixSymbol(r"\mathbf{r}_I", 3, 1)
INTEGRAL = MatrixSymbol(r"\int \mathbf{a}_I", 3, 1)
DOUBLE_INTEGRAL = MatrixSymbol(r"\iint \mathbf{a}_I", 3, 1)
A_K = MatrixSymbol(r"\mathbf{a}_I[k]", 3, 1)
V_K, V_NEXT = (MatrixSymbol(rf"\mathbf{{v}}_I[{k}]", 3, 1) for k in ("k", "k+1"))
R_K, R_NEXT = (MatrixSymbol(rf"\mathbf{{r}}_I[{k}]", 3, 1) for k in ("k", "k+1"))

# Names for what the words speak of: the acceleration that the note's step gives, the error of the
# accelerometer itself, and what a body at rest seems to accelerate by.
ESTIMATED = MatrixSymbol(r"\hat{\mathbf{a}}_I", 3, 1)
OWN_ERROR = MatrixSymbol(r"\boldsymbol{\varepsilon}", 3, 1)
RESIDUE = MatrixSymbol(r"\hat{\mathbf{a}}_{I,\text{rest}}", 3, 1)

GRAVITY = ImmutableMatrix([0, 0, g])
ONE_GRAVITY = ImmutableMatrix([0, 0, 1])
R_IB, R_BI = Rotation("I", "B"), Rotation("B", "I")

with as_printed():
    PRINTED = (
        Printed(
            "dead_reckoning.2.1",
            "equation",
            "section 2, paragraph 1",
            "The reading: the body's acceleration less gravity, in the body frame.",
            Eq(A_M, MatAdd(A_B, MatMul(-1, R_IB, GRAVITY))),
        ),
        Printed(
            "dead_reckoning.2.2",
            "equation",
            "section 2, paragraph 2",
            "The body's acceleration from the reading, in the body frame.",
            Eq(A_B, MatAdd(A_M, MatMul(R_IB, GRAVITY))),
        ),
        Printed(
            "dead_reckoning.2.3",
            "equation",
            "section 2, paragraph 3",
            "The body's acceleration from the reading, in the inertial frame.",
            Eq(A_I, MatAdd(MatMul(R_BI, A_M), GRAVITY)),
        ),
        Printed(
            "dead_reckoning.2.a",
            "claim",
            "section 2, paragraph 4",
            "With a reading in gravities, g is 1 and the acceleration in gravities, or the "
            "reading is multiplied by g first.",
            InOrder(
                Eq(MatMul(1 / g, A_I), MatAdd(MatMul(R_BI, IN_GRAVITIES), ONE_GRAVITY)),
                Eq(A_I, MatAdd(MatMul(R_BI, g, IN_GRAVITIES), GRAVITY)),
            ),
        ),
        Printed(
            "dead_reckoning.3.1",
            "equation",
            "section 3, paragraph 1",
            "Velocity as an integral of the acceleration.",
            Eq(V_I, INTEGRAL),
        ),
        Printed(
            "dead_reckoning.3.2",
            "equation",
            "section 3, paragraph 1",
            "Position as a double integral of the acceleration.",
            Eq(R_I, DOUBLE_INTEGRAL),
        ),
        Printed(
            "dead_reckoning.3.3",
            "equation",
            "section 3, paragraph 2",
            "Velocity by a step of one sample period.",
            Eq(V_NEXT, MatAdd(V_K, MatMul(T, A_K))),
        ),
        Printed(
            "dead_reckoning.3.4",
            "equation",
            "section 3, paragraph 2",
            "Position by a step of one sample period.",
            Eq(R_NEXT, MatAdd(R_K, MatMul(T, V_K))),
        ),
        Printed(
            "dead_reckoning.4.f",
            "claim",
            "section 4, paragraph 3",
            "With a perfect orientation the step adds no error to the accelerometer's own.",
            Eq(MatAdd(ESTIMATED, -A_I), MatMul(R_BI, OWN_ERROR)),
        ),
        Printed(
            "dead_reckoning.4.g",
            "claim",
            "section 4, paragraph 4",
            "With an error of orientation a body at rest in general seems to accelerate.",
            Ne(RESIDUE, ZeroMatrix(3, 1)),
        ),
        *(
            Printed(
                f"dead_reckoning.t1.{cell.degrees}.{cell.column}",
                "table cell",
                "section 4, Table 1",
                f"Table 1, {cell.degrees}° of angle error: error of {cell.means}.",
                Approximately(cell.quantity, cell.number),
            )
            for cell in CELLS
        ),
        Printed(
            "dead_reckoning.4.a",
            "claim",
            "section 4, paragraph 6",
            "One degree: after 10 s the velocity is off by 1.7 m/s.",
            Approximately(error("velocity_10s", "1.0"), "1.7"),
        ),
        Printed(
            "dead_reckoning.4.b",
            "claim",
            "section 4, paragraph 6",
            "One degree: after 10 s the position is off by 17.1 m.",
            Approximately(error("position_10s", "1.0"), "17.1"),
        ),
        Printed(
            "dead_reckoning.4.c",
            "claim",
            "section 4, paragraph 6",
            "One degree: after a minute the position is off by almost a kilometre, that is by one "
            "when rounded to whole kilometres.",
            Approximately(error("position_1min", "1.0"), "1 e 3"),
        ),
        Printed(
            "dead_reckoning.4.d",
            "claim",
            "section 4, paragraph 6",
            "One degree: after ten minutes the position is off by 62 km.",
            Approximately(error("position_10min", "1.0"), "62 e 3"),
        ),
        Printed(
            "dead_reckoning.4.e",
            "claim",
            "section 4, paragraph 7",
            "Two degrees: after 10 s the position is off by 34.2 m and the velocity by 3.4 m/s.",
            InOrder(
                Approximately(error("position_10s", "2.0"), "34.2"),
                Approximately(error("velocity_10s", "2.0"), "3.4"),
            ),
        ),
    )
