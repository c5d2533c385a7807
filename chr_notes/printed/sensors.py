"""What "Sensors for Orientation Estimation" prints."""

from sympy import (
    Eq,
    ImmutableMatrix,
    MatAdd,
    MatMul,
    MatrixSymbol,
    ZeroMatrix,
    diag,
    symbols,
)
from sympy.matrices.expressions.dotproduct import DotProduct

from chr_notes.printed.statement import InOrder, Nearly, Printed, Rotation, as_printed
from chr_notes.symbols import BODY_RATES, Angle, g, m, phi, psi, theta

A_M = MatrixSymbol(r"\mathbf{a}_m", 3, 1)
A_MC = MatrixSymbol(r"\mathbf{a}_{m,c}", 3, 1)
F = MatrixSymbol(r"\mathbf{F}", 3, 1)
F_G = MatrixSymbol(r"\mathbf{F}_g", 3, 1)
F_LESS_G = MatAdd(F, -F_G)
P = MatrixSymbol(r"\mathbf{p}", 3, 1)
P_M = MatrixSymbol(r"\mathbf{p}_m", 3, 1)
B = MatrixSymbol(r"\mathbf{b}", 3, 1)
B_M = MatrixSymbol(r"\mathbf{b}_m", 3, 1)
B_C = MatrixSymbol(r"\mathbf{b}_c", 3, 1)

# Misalignment, sensitivity and bias of the three sensors; the accelerometer's model has its bias
# without an index, the correction that follows has it with one.
M_A, M_G, M_B = (MatrixSymbol(f"M_{sensor}", 3, 3) for sensor in "agb")
S_A, S_G, S_B = (MatrixSymbol(rf"{{S_{sensor}}}\left(T\right)", 3, 3) for sensor in "agb")
BETA_A, BETA_G, BETA_B = (
    MatrixSymbol(rf"{{\beta_{sensor}}}\left(T\right)", 3, 1) for sensor in "agb"
)
BETA = MatrixSymbol(r"\beta\left(T\right)", 3, 1)
C_GA = MatrixSymbol(r"C_{g,a}", 3, 3)
D_S = MatrixSymbol("D_s", 3, 3)
BETA_H = MatrixSymbol(r"\beta_h", 3, 1)
SENSITIVITIES = symbols(r"S_{a\,x} S_{a\,y} S_{a\,z}", real=True)

# Names for what the words speak of.
UPWARDS = ImmutableMatrix([0, 0, -g])
ROLL, PITCH = (Angle(rf"\{name}_{{\text{{gravity straight down}}}}") for name in ("phi", "theta"))
FIELD = MatrixSymbol(r"\mathbf{B}_I", 3, 1)
SOFTENED = MatrixSymbol(r"\mathbf{b}_{\text{soft}}", 3, 1)
MEAN = MatrixSymbol(r"\overline{\mathbf{b}}_{\text{hard}}", 3, 1)
BIAS_BY_IRON = MatrixSymbol(r"\mathbf{b}_{\text{bias by hard iron}}", 3, 1)
CENTRE = MatrixSymbol(r"\mathbf{b}_{\text{centre}}", 3, 1)
INVERSE_SENSITIVITY = MatrixSymbol(r"\text{inverse of the magnetometer sensitivity}", 3, 3)

with as_printed():
    PRINTED = (
        Printed(
            "sensors.2.1",
            "equation",
            "section 2, paragraph 1",
            "What an accelerometer reads: all forces on the body less that of gravity.",
            Eq(A_M, MatMul(1 / m, F_LESS_G)),
        ),
        Printed(
            "sensors.2.2",
            "equation",
            "section 2, paragraph 5",
            "The reading when external forces are trivial beside the normal forces.",
            Nearly(A_M, MatMul(-1, F_G, 1 / m)),
        ),
        Printed(
            "sensors.2.3",
            "equation",
            "section 2, paragraph 7",
            "The complete model of the reading: sensitivity, bias, misalignment.",
            Eq(A_M, MatMul(M_A, MatAdd(MatMul(1 / m, S_A, F_LESS_G), -BETA))),
        ),
        Printed(
            "sensors.2.4",
            "equation",
            "section 2, paragraph 7",
            "The sensitivity matrix is diagonal.",
            Eq(S_A, ImmutableMatrix(diag(*SENSITIVITIES))),
        ),
        Printed(
            "sensors.2.5",
            "equation",
            "section 2, paragraph 9",
            "The corrected accelerometer measurement.",
            Eq(A_MC, MatMul(S_A.I, MatAdd(MatMul(M_A.I, A_M), BETA_A))),
        ),
        Printed(
            "sensors.2.a",
            "claim",
            "section 2, paragraph 3",
            "Without acceleration gravity looks like an acceleration upwards by one g.",
            Eq(MatMul(Rotation("B", "I", phi, theta, psi), A_M), UPWARDS),
        ),
        Printed(
            "sensors.2.b",
            "claim",
            "section 2, paragraph 3",
            "In free fall nothing is measured.",
            Eq(A_M, ZeroMatrix(3, 1)),
        ),
        Printed(
            "sensors.2.c",
            "claim",
            "section 2, paragraph 5",
            "Flat on a table: x and y are zero, z is minus one g.",
            Eq(A_M, UPWARDS),
        ),
        Printed(
            "sensors.2.d",
            "claim",
            "section 2, paragraph 5",
            "Where gravity points straight down, pitch and roll are zero.",
            InOrder(Eq(ROLL, 0), Eq(PITCH, 0)),
        ),
        Printed(
            "sensors.2.e",
            "claim",
            "section 2, paragraph 9",
            "The corrected measurement is the model solved for the specific force.",
            Eq(A_MC, MatMul(F_LESS_G, 1 / m)),
        ),
        Printed(
            "sensors.3.1",
            "equation",
            "section 3, paragraph 1",
            "The vector of body rates.",
            Eq(P, ImmutableMatrix(BODY_RATES)),
        ),
        Printed(
            "sensors.3.2",
            "equation",
            "section 3, paragraph 1",
            "Actual body rates from measured ones, with the coupling to acceleration.",
            Eq(P, MatMul(S_G.I, MatAdd(MatMul(M_G.I, P_M), BETA_G, -MatMul(C_GA, A_MC)))),
        ),
        Printed(
            "sensors.4.1",
            "equation",
            "section 4, paragraph 2",
            "The field from the magnetometer's measurement.",
            Eq(B, MatMul(S_B.I, MatAdd(MatMul(M_B.I, B_M), BETA_B))),
        ),
        Printed(
            "sensors.4.2",
            "equation",
            "section 4, paragraph 8",
            "The field without soft and hard iron.",
            Eq(B_C, MatAdd(MatMul(D_S, B), -BETA_H)),
        ),
        Printed(
            "sensors.4.3",
            "equation",
            "section 4, paragraph 9",
            "Both corrections of the magnetometer in one.",
            Eq(
                B_C,
                MatAdd(MatMul(D_S, S_A.I, MatAdd(MatMul(M_A.I, A_M), BETA_A)), -BETA_H),
            ),
        ),
        Printed(
            "sensors.4.a",
            "claim",
            "section 4, paragraph 6",
            "Without distortion the outputs lie on a sphere about zero.",
            Eq(DotProduct(B, B), DotProduct(FIELD, FIELD)),
        ),
        Printed(
            "sensors.4.b",
            "claim",
            "section 4, paragraph 6",
            "Soft iron makes the sphere an ellipsoid; hard iron shifts the mean of the outputs.",
            InOrder(
                Eq(DotProduct(D_S * SOFTENED, D_S * SOFTENED), DotProduct(FIELD, FIELD)),
                Eq(MEAN, BETA_H),
            ),
        ),
        Printed(
            "sensors.4.c",
            "claim",
            "section 4, paragraph 7",
            "The centre of the fitted ellipsoid is the bias that hard iron causes.",
            Eq(CENTRE, BIAS_BY_IRON),
        ),
        Printed(
            "sensors.4.d",
            "claim",
            "section 4, paragraph 3",
            "The symbol for the inverse of the magnetometer's sensitivity matrix.",
            Eq(INVERSE_SENSITIVITY, S_A.I),
        ),
    )
