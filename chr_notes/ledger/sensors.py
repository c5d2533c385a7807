"""The note on sensors before the judgement: accelerometers and gyros; `sensors_field` has more."""

from sympy import ImmutableMatrix, MatAdd, MatMul, Rational

from chr_notes.derivations.sensors import frequency, natural_frequency
from chr_notes.derivations.steps import Step, equation
from chr_notes.ledger.case import Case, complete
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.sensors_field import SETTLED as FIELD
from chr_notes.ledger.sensors_reading import (
    FORCE,
    READ,
    READ_ADDED,
    READ_FORCE,
    READ_SOLVED,
    READ_WANTED,
)
from chr_notes.ledger.shared_steps import felt
from chr_notes.printed import DOCUMENTS
from chr_notes.printed import sensors as printed
from chr_notes.printed import sensors_claims as claims
from chr_notes.printed.statement import words
from chr_notes.symbols import ACCELEROMETER, g, m, phi, theta

AT_REST = {**dict.fromkeys((*FORCE, phi, theta), 0), m: 1, g: Rational(98, 10)}
REALIGNED = MatMul(printed.M_A.I, printed.A_M)
SCALED = MatMul(1 / m, printed.S_A, printed.F_LESS_G)
GYROS_ALIGNED = MatMul(printed.M_G.I, printed.P_M)

SETTLED = (
    Case(
        "sensors.2.1",
        READ_FORCE,
        steps=felt(printed.A_M, printed.F, printed.F_G),
    ),
    Case(
        "sensors.2.2",
        READ_FORCE,
        steps=(
            Step(
                "Normal forces are those that keep the sensor from accelerating: they balance "
                "gravity.",
                equation(claims.NORMAL, MatMul(-1, printed.F_G)),
            ),
            Step(
                "So what remains of all forces are other external ones. If these are nothing "
                "beside the normal forces, the reading is that of the normal forces.",
                equation(printed.A_M, MatMul(1 / m, claims.NORMAL)),
            ),
        ),
        remark="Approximately, as the note says: what external forces there are is what it is "
        "off by. A floor that pushes harder counts among them. In a lift that starts upwards by "
        "1 m/s² the reading is larger than one g by as much.",
    ),
    Case(
        "sensors.2.3",
        definition=True,
        replaces="sensors.2.1",
        remark="From here on the symbol of the reading stands for what the sensor puts out, in "
        "its own unit. T is the temperature.",
    ),
    Case(
        "sensors.2.4",
        steps=(
            Step(
                "Each axis scales the acceleration along it by its own sensitivity, and knows "
                "nothing of the others.",
                equation(
                    MatMul(printed.S_A, ImmutableMatrix(ACCELEROMETER)),
                    ImmutableMatrix(
                        [
                            factor * part
                            for factor, part in zip(
                                printed.SENSITIVITIES, ACCELEROMETER, strict=True
                            )
                        ]
                    ),
                ),
            ),
        ),
    ),
    Case(
        "sensors.2.5",
        READ_WANTED,
        steps=(
            Step(
                "Undo the misalignment, which the model has outermost.",
                equation(REALIGNED, MatAdd(SCALED, MatMul(-1, printed.BETA))),
            ),
            Step(
                "Add the bias, which the model takes away. What is left is scaled; undo that.",
                equation(MatAdd(REALIGNED, printed.BETA_A), SCALED),
            ),
        ),
    ),
    Case("sensors.2.a", READ_FORCE),
    Case(
        "sensors.2.b",
        READ_FORCE,
    ),
    Case("sensors.2.c", READ_FORCE),
    Case(
        "sensors.2.d",
        remark="Of the reading only its direction counts: nothing along x and y, and something "
        "upwards.",
    ),
    Case("sensors.2.e", READ_SOLVED),
    Case(
        "sensors.2.f",
        steps=(
            Step(
                "A mass on a spring, without friction, shaken at the frequency ω:",
                equation(claims.RESPONSE, 1 / (natural_frequency**2 - frequency**2)),
            ),
        ),
        remark="Nearly so far below the natural frequency ω₀, as the note will mean it: the "
        "deflection belongs to an acceleration that changes slowly. At a tenth of ω₀ it is 1 % too "
        "large, at half of it 33 %.",
    ),
    Case(
        "sensors.2.g",
        READ_FORCE,
        remark="The normal forces are those that keep the sensor from falling: they balance "
        "gravity.",
    ),
    Case(
        "sensors.2.h",
        edits=(Edit(printed.F_LESS_G, printed.F),),
        witness=AT_REST,
        root="specific-force-called-acceleration",
        weight="label",
        told_in="sensors.2.1",
        steps=(
            Step(
                "By Newton's second law all forces together accelerate the body, gravity among "
                "them.",
                equation(MatMul(m, claims.ACTUAL), printed.F),
            ),
        ),
        remark="What is extracted is the specific force, and the formula for it is right, as in "
        "sensors.2.1. It is "
        "the acceleration without what gravity does: at rest one g upwards.",
    ),
    Case(
        "sensors.2.i",
        edits=(Edit(words("Figure 1"), words("the figure below it, which has no number")),),
        root="figure-without-a-number",
        weight="small print",
        steps=(
            Step(
                "Figure 1 is the diagram of an accelerometer with one axis. The sensor on a table "
                "is drawn below the sentence.",
                equation(claims.LEVEL_FIGURE, words("the figure below it, which has no number")),
            ),
        ),
    ),
    Case(
        "sensors.2.j",
        READ_ADDED,
        steps=(
            Step(
                "What the correction must add is what the output, realigned, lacks. By the model "
                "that is its bias.",
                equation(MatAdd(SCALED, MatMul(-1, REALIGNED)), printed.BETA),
            ),
        ),
        remark="One vector under two symbols.",
    ),
    Case("sensors.3.1", definition=True),
    Case(
        "sensors.3.2",
        steps=(
            Step(
                "The model of the accelerometer, for the gyro: section 4 says that the models are "
                "essentially equivalent. What the axes read has a part that is due to "
                "acceleration.",
                equation(
                    printed.P_M,
                    MatMul(
                        printed.M_G,
                        MatAdd(
                            MatMul(printed.S_G, printed.P),
                            MatMul(-1, printed.BETA_G),
                            MatMul(printed.C_GA, printed.A_MC),
                        ),
                    ),
                ),
            ),
            Step(
                "Undo the misalignment, add the bias, take the coupling away. What is left is "
                "scaled; undo that.",
                equation(
                    MatAdd(
                        GYROS_ALIGNED,
                        printed.BETA_G,
                        MatMul(-1, printed.C_GA, printed.A_MC),
                    ),
                    MatMul(printed.S_G, printed.P),
                ),
            ),
        ),
        remark="The note prints no model of the gyro of its own. It solves the one of the "
        "accelerometer, with the coupling added to what the axes read.",
    ),
)

CASES = complete(DOCUMENTS["sensors"], READ, (*SETTLED, *FIELD))
