"""The note on sensors before the judgement."""

from collections.abc import Callable

from sympy import Basic, Eq, Identity, ImmutableMatrix, MatAdd, MatMul, Symbol, diag, symbols

from chr_notes.derivations import calibration as derived
from chr_notes.derivations.estimation import accelerometer_at_rest, tilt, weight
from chr_notes.derivations.euler import rotation
from chr_notes.derivations.sensors import specific_force
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import NOTHING, Case, Condition, complete
from chr_notes.ledger.reading import elements, reading
from chr_notes.printed import sensors as printed
from chr_notes.symbols import ACCELEROMETER, VECTOR, g, m, phi, theta

FORCE = ImmutableMatrix(symbols("F_x F_y F_z", real=True))
NORMAL = ImmutableMatrix(symbols("N_x N_y N_z", real=True))
FIELD = ImmutableMatrix(symbols("B_N B_E B_D", real=True))
RAW = {
    sensor: ImmutableMatrix(symbols(f"{sensor}_x {sensor}_y {sensor}_z", real=True))
    for sensor in ("a", "p", "b")
}


def own(sensor: str, expression: ImmutableMatrix) -> ImmutableMatrix:
    """Give the parameters of the model, which are those of any sensor, an index of their own."""
    shared = (*derived.REALIGNMENT, *derived.SENSITIVITY, *derived.BIAS)
    names = {name: Symbol(f"{name}^{sensor}", **name.assumptions0) for name in shared}
    return ImmutableMatrix(expression.xreplace(names))


def corrected(sensor: str, raw: ImmutableMatrix) -> ImmutableMatrix:
    """Solve the model of a sensor for what is there when `raw` is measured."""
    offset = derived.coupled() if sensor == "p" else NOTHING
    solution = derived.corrected(offset).xreplace(dict(zip(VECTOR, raw, strict=True)))
    return own(sensor, solution)


def _parameters(sensor: str, *names: Basic) -> dict[Basic, Basic | Callable[[], Basic]]:
    """Name the inverse misalignment, the sensitivity and the bias as printed for a sensor."""
    inverse, sensitivity, bias = names
    return {
        inverse: own(sensor, derived.REALIGNMENT),
        sensitivity: own(sensor, ImmutableMatrix(diag(*derived.SENSITIVITY))),
        bias: own(sensor, ImmutableMatrix(derived.BIAS)),
    }


def _field_without_iron() -> ImmutableMatrix:
    field = corrected("b", RAW["b"])
    return ImmutableMatrix(derived.without_iron().xreplace(dict(zip(VECTOR, field, strict=True))))


def _without_soft_iron(expression: ImmutableMatrix) -> ImmutableMatrix:
    return ImmutableMatrix(
        expression.xreplace(dict(zip(derived.REALIGNMENT, Identity(3).as_explicit(), strict=True)))
    )


def _without_hard_iron() -> ImmutableMatrix:
    return ImmutableMatrix(derived.readings_mean().xreplace(dict.fromkeys(derived.HARD_IRON, 0)))


# Any forces; no external ones; no net force; free fall; level on a table.
READ_FORCES = reading(
    {
        printed.A_M: lambda: specific_force(FORCE, weight(), m),
        printed.F: FORCE,
        printed.F_G: weight,
    }
)
READ_SUPPORTED = reading(
    {
        printed.A_M: lambda: specific_force(NORMAL + weight(), weight(), m),
        printed.F: lambda: ImmutableMatrix(NORMAL + weight()),
        printed.F_G: weight,
    }
)
READ_STILL = reading({printed.A_M: lambda: specific_force(NOTHING, weight(), m)})
READ_FALLING = reading({printed.A_M: lambda: specific_force(weight(), weight(), m)})
READ_LEVEL = reading(
    {
        printed.A_M: lambda: ImmutableMatrix(accelerometer_at_rest().subs({phi: 0, theta: 0})),
        **elements(
            (printed.ROLL, printed.PITCH),
            lambda: tilt().subs(dict(zip(ACCELEROMETER, (0, 0, -g), strict=True))),
        ),
    }
)
READ_NAMES = reading({})
READ_CORRECTED = reading(
    {
        printed.A_MC: lambda: corrected("a", RAW["a"]),
        printed.A_M: RAW["a"],
        **_parameters("a", printed.M_A.I, printed.S_A, printed.BETA_A),
    }
)
READ_SOLVED = reading(
    {
        # The correction, with the model in place of the measurement; both as matrices.
        printed.A_MC: MatMul(
            printed.S_A.I,
            MatAdd(
                MatMul(
                    printed.M_A.I,
                    printed.M_A,
                    MatAdd(MatMul(printed.S_A, printed.F - printed.F_G) / m, -printed.BETA_A),
                ),
                printed.BETA_A,
            ),
        ),
    }
)
READ_GYRO = reading(
    {
        printed.P: lambda: corrected("p", RAW["p"]),
        printed.P_M: RAW["p"],
        printed.C_GA: derived.COUPLING,
        printed.A_MC: ImmutableMatrix(ACCELEROMETER),
        **_parameters("p", printed.M_G.I, printed.S_G, printed.BETA_G),
    }
)
READ_FIELD = reading(
    {
        printed.B: lambda: corrected("b", RAW["b"]),
        printed.B_C: _field_without_iron,
        printed.B_M: RAW["b"],
        printed.A_M: RAW["a"],
        printed.D_S: derived.SOFT_IRON,
        printed.BETA_H: ImmutableMatrix(derived.HARD_IRON),
        printed.INVERSE_SENSITIVITY: own("b", ImmutableMatrix(diag(*derived.SENSITIVITY)).inv()),
        **_parameters("a", printed.M_A.I, printed.S_A, printed.BETA_A),
        **_parameters("b", printed.M_B.I, printed.S_B, printed.BETA_B),
    }
)
READ_TURNED = reading({printed.B: lambda: rotation("I", "B") * FIELD, printed.FIELD: FIELD})
# Soft iron alone; hard iron alone; both.
READ_IRON = reading(
    {
        printed.SOFTENED: MatMul(printed.D_S.I, printed.FIELD),
        printed.MEAN: lambda: _without_soft_iron(derived.readings_mean()),
        printed.CENTRE: derived.readings_centre,
        printed.BIAS_BY_IRON: lambda: derived.readings_mean() - _without_hard_iron(),
        printed.D_S.I: derived.REALIGNMENT,
        printed.BETA_H: ImmutableMatrix(derived.HARD_IRON),
    }
)

_STILL_PARAMETERS = {
    **dict(zip(own("a", derived.REALIGNMENT), Identity(3).as_explicit(), strict=True)),
    **dict(zip(own("b", derived.REALIGNMENT), Identity(3).as_explicit(), strict=True)),
    **dict(zip(derived.SOFT_IRON, Identity(3).as_explicit(), strict=True)),
    **dict.fromkeys(
        (
            *own("a", ImmutableMatrix(derived.BIAS)),
            *own("b", ImmutableMatrix(derived.BIAS)),
            *derived.HARD_IRON,
        ),
        0,
    ),
    **dict.fromkeys(
        (
            *own("a", ImmutableMatrix(derived.SENSITIVITY)),
            *own("b", ImmutableMatrix(derived.SENSITIVITY)),
        ),
        1,
    ),
}

SETTLED = (
    Case(
        "sensors.2.2",
        READ_SUPPORTED,
        condition=Condition(
            Eq(NORMAL, -weight(), evaluate=False),
        ),
        witness={
            **dict(zip(NORMAL, (0, 0, -11), strict=True)),
            phi: 0,
            theta: 0,
            m: 1,
            g: 10,
        },
        steps=(
            Step(
                "Let no force act but the normal force and gravity. Then the accelerometer reads "
                "the normal force, per unit of mass.",
                Eq(
                    ImmutableMatrix(specific_force(NORMAL + weight(), weight(), m)),
                    ImmutableMatrix(NORMAL / m),
                    evaluate=False,
                ),
            ),
            Step(
                "That equals minus gravity only where the normal force balances gravity: where "
                "the body does not accelerate.",
                Eq(
                    ImmutableMatrix(specific_force(NOTHING, weight(), m)),
                    ImmutableMatrix(-weight() / m),
                    evaluate=False,
                ),
            ),
        ),
        remark="It takes more than small external forces: the normal force itself can accelerate "
        "the body. In a lift that starts upwards by 1 m/s² nothing acts but the floor and gravity, "
        "and the reading is larger than one g.",
    ),
    Case(
        "sensors.2.3",
        READ_NAMES,
        replaces="sensors.2.1",
        remark="From here on the symbol of the reading stands for what the sensor puts out, in "
        "its own unit. The bias has no index here, and the index a in the correction.",
    ),
    *(Case(name, READ_NAMES) for name in ("sensors.2.4", "sensors.3.1", "sensors.4.2")),
    Case(
        "sensors.2.5",
        READ_CORRECTED,
        remark="The bias is added, not taken away, because the model takes it away.",
    ),
    Case("sensors.2.a", READ_STILL),
    Case("sensors.2.b", READ_FALLING),
    Case("sensors.2.c", READ_LEVEL),
    Case("sensors.2.d", READ_LEVEL),
    Case("sensors.2.e", READ_SOLVED),
    Case(
        "sensors.3.2",
        READ_GYRO,
        remark="The note prints no model of the gyro that this would solve. It solves the one of "
        "the accelerometer, with the coupling added to what the axes read.",
    ),
    Case("sensors.4.1", READ_FIELD),
    Case(
        "sensors.4.3",
        READ_FIELD,
        correction=Eq(
            printed.B_C,
            MatAdd(
                MatMul(
                    printed.D_S,
                    printed.S_B.I,
                    MatAdd(MatMul(printed.M_B.I, printed.B_M), printed.BETA_B),
                ),
                -printed.BETA_H,
            ),
        ),
        witness={
            **_STILL_PARAMETERS,
            **dict(zip(RAW["a"], (0, 0, -10), strict=True)),
            **dict(zip(RAW["b"], (20, 0, 40), strict=True)),
        },
        steps=(
            Step(
                "Put the magnetometer's own correction in place of the field.",
                Eq(
                    printed.B,
                    MatMul(
                        printed.S_B.I,
                        MatAdd(MatMul(printed.M_B.I, printed.B_M), printed.BETA_B),
                    ),
                ),
            ),
            Step(
                "Then take soft and hard iron out of it.",
                Eq(printed.B_C, MatAdd(MatMul(printed.D_S, printed.B), -printed.BETA_H)),
            ),
        ),
        remark="The line has the accelerometer's reading, sensitivity, misalignment and bias where "
        "the magnetometer's belong. As printed it calibrates gravity.",
    ),
    Case("sensors.4.a", READ_TURNED),
    Case(
        "sensors.4.b",
        READ_IRON,
    ),
    Case(
        "sensors.4.c",
        READ_IRON,
        steps=(
            Step(
                "A field and the opposite field give readings on either side of the centre. The "
                "hard iron is taken away after the soft iron, so it reaches the readings through "
                "the inverse of the soft-iron matrix.",
                Eq(
                    derived.readings_centre(),
                    derived.REALIGNMENT * ImmutableMatrix(derived.HARD_IRON),
                    evaluate=False,
                ),
            ),
            Step(
                "Turned by any rotation, the corrected field has the same length. So the shape of "
                "the ellipsoid gives the soft-iron matrix only up to a rotation.",
                Eq(MatMul(rotation("I", "B").T, rotation("I", "B")), Identity(3)),
            ),
        ),
        remark="The bias in the readings is not the β_h of the formula that follows: that one is "
        "taken away after the soft-iron matrix has acted, so the centre is β_h taken back through "
        "the matrix. And the shape "
        "leaves a rotation open: which sphere point belongs to which reading cannot be seen in "
        "the ellipsoid.",
    ),
    Case(
        "sensors.4.d",
        READ_FIELD,
        correction=Eq(printed.INVERSE_SENSITIVITY, printed.S_B.I),
        witness={
            **dict.fromkeys(own("a", ImmutableMatrix(derived.SENSITIVITY)), 4),
            **dict.fromkeys(own("b", ImmutableMatrix(derived.SENSITIVITY)), 2),
        },
        remark="The index is the accelerometer's; the formula just before has the right one.",
    ),
)

CASES = complete(printed.PRINTED, READ_FORCES, SETTLED)
