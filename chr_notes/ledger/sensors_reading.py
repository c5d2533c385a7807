"""How the note on sensors is read: what its symbols mean.

The note gives the accelerometer's reading two meanings, one after the other: the specific force,
and what the sensor puts out in its own unit. The second is read by the printed model, so that a
misprint there shows wherever the reading is used; the gyro and the magnetometer are read by the
same model, for section 4 says that theirs are essentially equivalent.
"""

from sympy import (
    And,
    Basic,
    Eq,
    ImmutableMatrix,
    Integer,
    Lt,
    MatAdd,
    MatMul,
    MatrixSymbol,
    Rational,
    diag,
    simplify,
    sqrt,
    symbols,
)

from chr_notes.derivations import calibration as derived
from chr_notes.derivations import sensors as physics
from chr_notes.derivations.estimation import tilt, weight
from chr_notes.derivations.euler import rotation
from chr_notes.ledger.case import NOTHING
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.reading import Meaning, defined, elements, reading
from chr_notes.ledger.shared_steps import HOLDING, PROOF_MASS
from chr_notes.printed import BY_ID
from chr_notes.printed import sensors as printed
from chr_notes.printed import sensors_claims as claims
from chr_notes.printed.statement import words
from chr_notes.symbols import ACCELEROMETER, BODY_RATES, g, m, phi, theta

# All forces on the sensor. Those that hold it against gravity balance that one, says section 2.
FORCE = ImmutableMatrix(symbols("F_x F_y F_z", real=True))
FIELD = ImmutableMatrix(symbols("B_N B_E B_D", real=True))
STANDARD_GRAVITY = Rational("9.80665")  # m/s²
TEMPERATURES = symbols("T_1 T_2", real=True)
SLOPES = symbols(r"\beta' S'", real=True)  # of bias and sensitivity, per kelvin

_NO_FORCE = Condition(Eq(FORCE, NOTHING, evaluate=False))
_FLAT = Condition(And(Eq(phi, 0), Eq(theta, 0)))
_STRAIGHT_DOWN = Condition(
    And(Eq(ACCELEROMETER[0], 0), Eq(ACCELEROMETER[1], 0), Lt(ACCELEROMETER[2], 0))
)
PRESUMED = (
    Presumed(_NO_FORCE, "external forces are trivial", "sensors.2.2"),
    Presumed(_NO_FORCE, "Without acceleration", "sensors.2.a"),
    Presumed(Condition(Eq(FORCE, weight(), evaluate=False)), "In free fall", "sensors.2.b"),
    Presumed(_NO_FORCE, "on a table", "sensors.2.c"),
    Presumed(_FLAT, "Flat", "sensors.2.c"),
    Presumed(_STRAIGHT_DOWN, "gravity points straight down", "sensors.2.d"),
    Presumed(
        Condition(Eq(printed.BETA_A, printed.BETA, evaluate=False)),
        "is that of the correction",
        "sensors.2.j",
        ("sensors.2.5", "sensors.2.e"),
    ),
)


def _model(misalignment: Basic, sensitivity: Basic, bias: Basic, actual: Basic) -> Basic:
    """Give the accelerometer's printed model to another sensor."""
    return (
        BY_ID["sensors.2.3"]
        .statement.rhs.xreplace(
            {
                printed.M_A: misalignment,
                printed.S_A: sensitivity,
                printed.BETA: bias,
                printed.F_LESS_G: MatMul(m, actual),
            }
        )
        .doit()
    )


def _gyro() -> Basic:
    """Model the gyro: what acceleration makes of it adds to what its axes read."""
    return MatAdd(
        _model(printed.M_G, printed.S_G, printed.BETA_G, ImmutableMatrix(BODY_RATES)),
        MatMul(printed.M_G, printed.C_GA, printed.A_MC),
    )


def _count(*terms: ImmutableMatrix) -> Integer:
    return Integer(len(set().union(*(term.free_symbols for term in terms))))


_MEANING: dict[Basic, Meaning] = {
    printed.F: FORCE,
    printed.F_G: weight,
    printed.S_A: derived.sensitivity_matrix(printed.SENSITIVITIES),
    **elements((printed.ROLL, printed.PITCH), tilt),
    **defined("sensors.3.1"),
    printed.P_M: _gyro,
    printed.B_M: lambda: _model(printed.M_B, printed.S_B, printed.BETA_B, printed.B),
    **defined("sensors.4.2"),
    printed.INVERSE_SENSITIVITY: printed.S_B.I,
    claims.NORMAL: lambda: -weight(),
    claims.EXTERNAL: FORCE,
    claims.ACTUAL: ImmutableMatrix(FORCE / m),
    claims.FALLING: lambda: simplify(sqrt(weight().dot(weight())) / m).subs(g, STANDARD_GRAVITY),
    claims.LEVEL_FIGURE: words("the figure below it, which has no number"),
    claims.RESPONSE: physics.deflection,
    claims.RESPONSE_HELD: physics.deflection_held,
    claims.COMBINED: MatMul(printed.D_S, printed.S_B.I, printed.M_B.I),
    claims.OFFSET: MatAdd(printed.BETA_H, MatMul(-1, printed.D_S, printed.S_B.I, printed.BETA_B)),
    claims.FEWER: _count(derived.MISALIGNMENT, ImmutableMatrix(derived.BIAS)),
    claims.ALL_TERMS: _count(
        derived.MISALIGNMENT,
        derived.sensitivity_matrix(),
        ImmutableMatrix(derived.BIAS),
        derived.SOFT_IRON,
        ImmutableMatrix(derived.HARD_IRON),
    ),
}
READ = reading(_MEANING, presumed=PRESUMED)

# The reading as the specific force; as the sensor puts it out; and the correction besides: the
# term that is wanted, and what is printed.
READ_FORCE = READ.also(
    {
        printed.A_M: lambda: physics.specific_force(FORCE, weight(), m),
        HOLDING: lambda: PROOF_MASS * physics.specific_force(FORCE, weight(), m),
    }
)
READ_OUTPUT = READ.also(defined("sensors.2.3"))
READ_WANTED = READ_OUTPUT.also({printed.A_MC: lambda: physics.specific_force(FORCE, weight(), m)})
READ_SOLVED = READ_OUTPUT.also(defined("sensors.2.5"))
# What must be added to the output for that.
READ_ADDED = READ_OUTPUT.also(
    {
        printed.BETA_A: lambda: READ_OUTPUT(
            MatAdd(
                MatMul(1 / m, printed.S_A, printed.F_LESS_G),
                MatMul(-1, printed.M_A.I, printed.A_M),
            )
        )
    }
)

# The magnetometer: any field at it; turned in one field, without iron; and with iron, as the
# correction takes it out.
READ_FIELD = READ.also({printed.B: ImmutableMatrix(symbols("b_x b_y b_z", real=True))})
READ_TURNED = READ.also({printed.B: lambda: rotation("I", "B") * FIELD, printed.FIELD: FIELD})
READ_DISTORTED = READ.also(
    {
        printed.B: lambda: MatAdd(
            MatMul(printed.D_S.I, ImmutableMatrix(rotation("I", "B") * FIELD)), printed.CENTRE
        ),
        printed.FIELD: FIELD,
    }
)


def _without_soft_iron(expression: ImmutableMatrix) -> ImmutableMatrix:
    return ImmutableMatrix(
        expression.xreplace(dict(zip(derived.REALIGNMENT, ImmutableMatrix.eye(3), strict=True)))
    )


def _without_hard_iron() -> ImmutableMatrix:
    return ImmutableMatrix(derived.readings_mean().xreplace(dict.fromkeys(derived.HARD_IRON, 0)))


# Soft iron alone; hard iron alone; both.
READ_IRON = READ.also(
    {
        printed.SOFTENED: MatMul(printed.D_S.I, printed.FIELD),
        printed.MEAN: lambda: _without_soft_iron(derived.readings_mean()),
        printed.CENTRE: derived.readings_centre,
        printed.BIAS_BY_IRON: lambda: derived.readings_mean() - _without_hard_iron(),
        printed.D_S.I: derived.REALIGNMENT,
        printed.BETA_H: ImmutableMatrix(derived.HARD_IRON),
    }
)
READ_SHAPE = READ.also({printed.D_S: derived.SOFT_IRON, claims.SHAPE: derived.ellipsoid_shape})


def _at_temperatures() -> dict[Basic, Meaning]:
    """Let bias and sensitivity change in proportion to temperature, and the alignment not."""
    alignment = MatrixSymbol("M_b", 3, 3)
    found: dict[Basic, Meaning] = {}
    for index, temperature in enumerate(TEMPERATURES):
        warm = [start + SLOPES[0] * temperature for start in derived.BIAS]
        scale = [start + SLOPES[1] * temperature for start in derived.SENSITIVITY]
        values = (ImmutableMatrix(warm), ImmutableMatrix(diag(*scale)), alignment)
        found |= {pair[index]: v for pair, v in zip(claims.COLD_AND_WARM, values, strict=True)}
    return found


READ_TEMPERATURES = READ.also(_at_temperatures())
