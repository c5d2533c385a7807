"""The note on sensors, section 4: magnetometers and iron, before the judgement."""

from sympy import Eq, ImmutableMatrix, MatAdd, MatMul, Rational

from chr_notes.derivations.calibration import BIAS, SENSITIVITY
from chr_notes.derivations.steps import Step, equation
from chr_notes.ledger.case import NOTHING, Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.sensors_reading import (
    FORCE,
    READ_DISTORTED,
    READ_FIELD,
    READ_IRON,
    READ_OUTPUT,
    READ_SHAPE,
    READ_TEMPERATURES,
    READ_TURNED,
    SLOPES,
    TEMPERATURES,
)
from chr_notes.printed import sensors as printed
from chr_notes.printed import sensors_claims as claims
from chr_notes.printed.statement import InOrder
from chr_notes.symbols import g, m, phi, theta

BIASES, SCALES, _ = claims.COLD_AND_WARM
EYE = ImmutableMatrix.eye(3)
ALIGNED = MatMul(printed.M_B.I, printed.B_M)
FIELD_FROM_READING = MatMul(printed.S_B.I, MatAdd(ALIGNED, printed.BETA_B))

SETTLED = (
    Case(
        "sensors.4.1",
        READ_FIELD,
        steps=(
            Step(
                "The note begins with a model like that of the accelerometer:",
                equation(
                    printed.B_M,
                    MatMul(
                        printed.M_B,
                        MatAdd(MatMul(printed.S_B, printed.B), MatMul(-1, printed.BETA_B)),
                    ),
                ),
            ),
            Step(
                "Undo the misalignment and add the bias. What is left is scaled; undo that.",
                equation(MatAdd(ALIGNED, printed.BETA_B), MatMul(printed.S_B, printed.B)),
            ),
        ),
    ),
    Case("sensors.4.2", definition=True),
    Case(
        "sensors.4.3",
        READ_OUTPUT,
        edits=(
            Edit(printed.S_A.I, printed.S_B.I),
            Edit(printed.M_A.I, printed.M_B.I),
            Edit(printed.A_M, printed.B_M),
            Edit(printed.BETA_A, printed.BETA_B),
        ),
        witness={
            **dict.fromkeys((*FORCE, phi, theta), 0),
            **dict.fromkeys((*printed.SENSITIVITIES, m), 1),
            g: Rational(98, 10),
            printed.B: ImmutableMatrix([20, 0, 40]),
            **dict.fromkeys((printed.M_A, printed.D_S), EYE),
            **dict.fromkeys((printed.BETA, printed.BETA_A, printed.BETA_H), NOTHING),
        },
        root="accelerometer-for-magnetometer",
        weight="misleads",
        steps=(
            Step(
                "Put the magnetometer's own correction in place of the field.",
                equation(printed.B, FIELD_FROM_READING),
            ),
            Step(
                "Then take soft and hard iron out of it.",
                equation(
                    printed.B_C,
                    MatAdd(MatMul(printed.D_S, printed.B), MatMul(-1, printed.BETA_H)),
                ),
            ),
        ),
        remark="The line has the accelerometer's reading, sensitivity, misalignment and bias where "
        "the magnetometer's belong. As printed it calibrates gravity: level and at rest, in a "
        "field of 20 µT to the nose and 40 µT down, it gives 9.8 m/s² upwards.",
    ),
    Case("sensors.4.a", READ_TURNED),
    Case("sensors.4.b", READ_IRON),
    Case(
        "sensors.4.c",
        READ_IRON,
        steps=(
            Step(
                "A field and the opposite field give readings on either side of the centre. The "
                "correction takes its bias away after the soft iron, so in the readings that bias "
                "appears taken back through the matrix.",
                equation(printed.CENTRE, MatMul(printed.D_S.I, printed.BETA_H)),
            ),
        ),
        remark="The bias in the readings is not that of the formula that follows, which is taken "
        "away after the soft-iron matrix has acted: the centre is that one, taken back through the "
        "matrix.",
    ),
    Case(
        "sensors.4.d",
        edits=(Edit(printed.S_A.I, printed.S_B.I),),
        witness={**dict.fromkeys(printed.SENSITIVITIES, 4), printed.S_B: 2 * EYE},
        root="accelerometer-for-magnetometer",
        weight="label",
        told_in="sensors.4.1",
        steps=(
            Step(
                "Of the magnetometer's reading, misalignment and bias taken out, the field is left "
                "as its own axes scale it.",
                equation(MatAdd(ALIGNED, printed.BETA_B), MatMul(printed.S_B, printed.B)),
            ),
            Step(
                "So it is the inverse of that scaling which gives the field.",
                equation(printed.B, FIELD_FROM_READING),
            ),
        ),
        remark="The index is the accelerometer's; the formula just before has the right one, see "
        "sensors.4.1.",
    ),
    Case(
        "sensors.4.e",
        steps=(
            Step(
                "Put the correction for the field into that for iron, and multiply out: a matrix "
                "times the reading, less a vector.",
                equation(
                    printed.B_C,
                    MatAdd(
                        MatMul(printed.D_S, printed.S_B.I, printed.M_B.I, printed.B_M),
                        MatMul(printed.D_S, printed.S_B.I, printed.BETA_B),
                        MatMul(-1, printed.BETA_H),
                    ),
                ),
            ),
        ),
        remark="Twelve numbers in place of 27.",
    ),
    Case(
        "sensors.4.f",
        READ_TEMPERATURES,
        condition=Condition(Eq(*TEMPERATURES)),
        witness={
            TEMPERATURES[0]: 10,
            TEMPERATURES[1]: 40,
            **dict.fromkeys((*BIAS, *SENSITIVITY), 1),
            **dict.fromkeys(SLOPES, 1),
        },
        root="constant-but-for-temperature",
        weight="small print",
        told_in="sensors.2.3",
        steps=(
            Step(
                "Let bias and sensitivity change evenly with temperature. Between two temperatures "
                "they change by these amounts, each axis alike.",
                InOrder(
                    equation(
                        MatAdd(BIASES[1], -BIASES[0]),
                        SLOPES[0]
                        * (TEMPERATURES[1] - TEMPERATURES[0])
                        * ImmutableMatrix([1, 1, 1]),
                    ),
                    equation(
                        MatAdd(SCALES[1], -SCALES[0]),
                        SLOPES[1] * (TEMPERATURES[1] - TEMPERATURES[0]) * EYE,
                    ),
                ),
            ),
        ),
        remark="Wherever the sensor is mounted, the sentence means. With temperature two of the "
        "three change: the section's first paragraph says so, and so do the symbols from "
        "sensors.2.3 on.",
    ),
    Case(
        "sensors.4.g",
        READ_DISTORTED,
        remark="Only up to a rotation, though: any turn of the sphere is the same sphere, so the "
        "shape alone does not say which of its points belongs to which reading.",
    ),
    Case(
        "sensors.4.h",
        READ_SHAPE,
        remark="Of the matrix the shape has this product only, which is the same for the matrix "
        "turned by any rotation.",
    ),
)
