"""Ties of functions and entries, part two: sensors, filters, heading."""

from collections.abc import Iterator, Mapping

from sympy import (
    Basic,
    Eq,
    ImmutableMatrix,
    Symbol,
    atan,
    cos,
    diag,
    expand_func,
    eye,
    floor,
    pi,
    sin,
    sqrt,
)
from sympy.codegen.cfunctions import hypot
from sympy.logic.boolalg import Boolean

from chr_notes.codegen.targets import TARGETS
from chr_notes.derivations import calibration, validation
from chr_notes.derivations.estimation import L
from chr_notes.printed import BY_ID
from chr_notes.printed import estimation as printed_angles
from chr_notes.printed import sensors as printed
from chr_notes.printed import validation as paper
from chr_notes.symbols import (
    ACCELEROMETER,
    EULER,
    EULER_RATES,
    MAGNETOMETER,
    VECTOR,
    T,
    g,
    m,
    phi,
    psi,
    theta,
)

from .ties import Formula, States, Tie

GIVEN = ImmutableMatrix(VECTOR)
# Roll and pitch that an accelerometer sees, by the formula of the function for them.
TILT = (
    next(target for target in TARGETS if target.name == "tilt_from_accelerometer")
    .formula()
    .inlined(3, 0)
)
SENSITIVITY = ImmutableMatrix(diag(*calibration.SENSITIVITY))
BIAS = ImmutableMatrix(calibration.BIAS)
READING = ImmutableMatrix(ACCELEROMETER)
# Functions that correct take the inverse of the misalignment.
MISALIGNED = calibration.REALIGNMENT.adjugate() / calibration.REALIGNMENT.det()
ALIGNED = dict(zip(calibration.MISALIGNMENT, MISALIGNED, strict=True))
ACCELEROMETERS = {
    printed.M_A: calibration.MISALIGNMENT,
    printed.M_A.I: calibration.REALIGNMENT,
    printed.S_A: SENSITIVITY,
    printed.BETA: BIAS,
    printed.BETA_A: BIAS,
    printed.F: m * GIVEN,
    printed.F_G: ImmutableMatrix.zeros(3, 1),
}
GYROS = {
    printed.M_G.I: calibration.REALIGNMENT,
    printed.S_G: SENSITIVITY,
    printed.BETA_G: BIAS,
    printed.C_GA: calibration.COUPLING,
    printed.A_MC: READING,
}
MAGNETOMETERS = {
    printed.M_B.I: calibration.REALIGNMENT,
    printed.S_B: SENSITIVITY,
    printed.BETA_B: BIAS,
}
IRON = {printed.D_S: calibration.SOFT_IRON, printed.BETA_H: ImmutableMatrix(calibration.HARD_IRON)}


def put(expression: Basic, names: Mapping[Basic, Basic]) -> Basic:
    """Put the arguments of a function in place of the names of a document."""
    return expression.xreplace(dict(names)).doit()


def by(names: Mapping[Basic, Basic]) -> States:
    """What the function returns is the right side, written in the function's arguments."""

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        yield Eq(formula, put(entry.rhs, names), evaluate=False)

    return states


def undoes(name: Basic, names: Mapping[Basic, Basic]) -> States:
    """With what the function returns in place of a name, the right side is what was given."""

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        found = put(entry.rhs, {**names, name: ImmutableMatrix(formula).xreplace(ALIGNED)})
        yield Eq(found, GIVEN, evaluate=False)

    return states


def _sensitivity_alone(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """Aligned and without bias, each axis is multiplied by its sensitivity."""
    names = dict(zip(printed.SENSITIVITIES, calibration.SENSITIVITY, strict=True))
    aligned = dict(zip(calibration.MISALIGNMENT, eye(3), strict=True))
    plain = ImmutableMatrix(formula).xreplace(aligned | dict.fromkeys(BIAS, 0 * m))
    yield Eq(plain, put(entry.rhs, names) * GIVEN, evaluate=False)


def _solves_the_model(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """Given what the printed model reads, the function returns the specific force."""
    read = put(BY_ID["sensors.2.3"].statement.rhs, ACCELEROMETERS).xreplace(ALIGNED)
    found = ImmutableMatrix(formula).xreplace(dict(zip(VECTOR, read, strict=True)))
    yield Eq(found, put(entry.rhs, ACCELEROMETERS), evaluate=False)


def _level(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    yield Eq(ImmutableMatrix(formula.subs({phi: 0, theta: 0})), entry.rhs, evaluate=False)


LENGTH = sqrt(READING.dot(READING))
AT_REST = {
    **dict(
        zip((printed_angles.A_MX, printed_angles.A_MY, printed_angles.A_MZ), READING, strict=True)
    ),
    g: LENGTH,
    # The paper writes components of gravity, of which a reading at rest is the opposite.
    **dict(zip((paper.G_XB, paper.G_YB, paper.G_ZB), -READING, strict=True)),
}


def _pitch_at_rest(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """Sine and cosine of the angle, the length of the reading being g."""
    angle = put(entry.rhs, AT_REST)
    sine, cosine = formula[1].args
    yield Eq(sine, LENGTH * sin(angle), evaluate=False)
    assert isinstance(cosine, hypot), "a root, which is not negative"
    squared = expand_func(cosine) ** 2
    yield Eq(squared, LENGTH**2 * (1 - sin(angle) ** 2), evaluate=False)


def _roll_at_rest(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """The arctangent of the quotient, where the second part is positive."""
    across, down = formula[0].args
    assert down == -ACCELEROMETER[2]
    yield Eq(atan(across / down), put(entry.rhs, AT_REST), evaluate=False)


def _rates(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    yield Eq(ImmutableMatrix((formula - ImmutableMatrix(EULER)) / T), entry.rhs, evaluate=False)


PRINTED_RATES = dict(zip(EULER_RATES, BY_ID["estimation.3.1"].statement.rhs, strict=True))
ESTIMATES = {printed_angles.ROLL: phi, printed_angles.PITCH: theta}


def predicts(place: int) -> States:
    """Without the accelerometer the angle goes on by the printed rate."""

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        angle = formula[place].subs(L, 0)
        yield Eq(angle, put(entry.rhs, ESTIMATES | PRINTED_RATES), evaluate=False)

    return states


def updates(place: int, predicted: Basic, seen: Basic) -> States:
    """The update is the printed one, with what is seen so many whole turns off."""

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        turns = Symbol("turns", integer=True)
        angle = formula[place].replace(floor, lambda _: turns)
        names = {predicted: angle.subs(L, 0), seen: TILT[place] - 2 * pi * turns}
        yield Eq(angle, put(entry.rhs, names), evaluate=False)

    return states


BODY_FIELD = dict(
    zip(
        (paper.M_XB, paper.M_YB, paper.M_ZB),
        MAGNETOMETER,
        strict=True,
    )
)
INERTIAL_FIELD = dict(
    zip(
        (paper.M_XI, paper.M_YI, paper.M_ZI),
        validation.REFERENCE,
        strict=True,
    )
)
NORTH, EAST, DOWN = validation.REFERENCE


def _field_turned(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """Turned by the yaw returned, the level field points where the reference does."""
    *_, written_out = (part.rhs for part in entry.args)
    sine, cosine = formula.args  # or a positive multiple of them
    turned = put(written_out, BODY_FIELD).xreplace({sin(psi): sine, cos(psi): cosine})
    north, east, _ = turned
    yield Eq(north * EAST, east * NORTH, evaluate=False)
    yield Eq(north * NORTH + east * EAST, sine**2 + cosine**2, evaluate=False)


def _by_13_and_14(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """Its two parts are a multiple of the printed sine and cosine."""
    names = BODY_FIELD | INERTIAL_FIELD
    printed_yaw = put(
        entry.rhs,
        {
            sin(psi): BY_ID["validation.14"].statement.rhs,
            cos(psi): BY_ID["validation.13"].statement.rhs,
        },
    )
    sine, cosine = (put(part, names) for part in printed_yaw.args)
    across, along = formula.args
    yield Eq(across * cosine, along * sine, evaluate=False)


def _factor(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    length = sqrt(sum(part**2 for part in MAGNETOMETER))
    names = {name: part / length for name, part in BODY_FIELD.items()} | {
        paper.M_ZI: DOWN,
        paper.ROLL_COMP: phi,
        paper.PITCH_COMP: theta,
    }
    yield Eq(formula, put(entry.rhs, names), evaluate=False)


SENSORS: dict[tuple[str, str], Tie] = {
    ("accelerometer_at_rest", "sensors.2.c"): Tie(_level),
    ("sensor_measures", "sensors.2.3"): Tie(by(ACCELEROMETERS)),
    ("sensor_measures", "sensors.2.4"): Tie(_sensitivity_alone),
    ("sensor_corrected", "sensors.2.5"): Tie(by({**ACCELEROMETERS, printed.A_M: GIVEN})),
    ("sensor_corrected", "sensors.2.e"): Tie(_solves_the_model),
    ("sensor_corrected", "sensors.4.1"): Tie(by({**MAGNETOMETERS, printed.B_M: GIVEN})),
    ("gyro_measures", "sensors.3.2"): Tie(undoes(printed.P_M, GYROS)),
    ("gyro_corrected", "sensors.3.2"): Tie(by({**GYROS, printed.P_M: GIVEN})),
    ("iron_removed", "sensors.4.2"): Tie(by({**IRON, printed.B: GIVEN})),
    ("iron_added", "sensors.4.2"): Tie(undoes(printed.B, {**IRON, printed.D_S: MISALIGNED})),
    ("tilt_from_accelerometer", "estimation.2.5"): Tie(_pitch_at_rest, (3, 0)),
    ("tilt_from_accelerometer", "estimation.2.6"): Tie(_roll_at_rest, (3, 0)),
    ("tilt_from_accelerometer", "validation.3"): Tie(_roll_at_rest, (3, 0)),
    ("tilt_from_accelerometer", "validation.4"): Tie(_pitch_at_rest, (3, 0)),
    ("gyro_step", "estimation.3.1"): Tie(_rates, (0,)),
    ("gyro_step", "estimation.3.2"): Tie(predicts(0), (0,)),
    ("gyro_step", "estimation.3.3"): Tie(predicts(1), (0,)),
    ("euler_observer_step", "estimation.4.1"): Tie(predicts(1), (0, 3, 0, 0)),
    ("euler_observer_step", "estimation.4.2"): Tie(predicts(0), (0, 3, 0, 0)),
    ("euler_observer_step", "estimation.4.3"): Tie(
        updates(1, printed_angles.PITCH_PLUS, printed_angles.PITCH_ACCEL), (0, 3, 0, 0)
    ),
    ("euler_observer_step", "estimation.4.4"): Tie(
        updates(0, printed_angles.ROLL_PLUS, printed_angles.ROLL_ACCEL), (0, 3, 0, 0)
    ),
    ("heading_from_magnetometer", "validation.12"): Tie(_field_turned, (0,)),
    ("heading_from_magnetometer", "validation.16"): Tie(_by_13_and_14, (0,)),
    ("validation_factor", "validation.17"): Tie(_factor, (0, 0)),
}
