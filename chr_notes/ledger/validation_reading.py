"""What the paper on validating Euler angles means by its symbols."""

from collections.abc import Mapping

from sympy import (
    Abs,
    Basic,
    Eq,
    Expr,
    ImmutableMatrix,
    MatMul,
    MatrixSymbol,
    Rational,
    Symbol,
    cos,
    expand,
    pi,
    simplify,
    sin,
    symbols,
)

from chr_notes.derivations import estimation
from chr_notes.derivations import validation as derived
from chr_notes.derivations.euler import X, Y, Z, body_rates, euler_rates, rotation
from chr_notes.ledger.case import Reading
from chr_notes.ledger.reading import Meaning, elements, reading
from chr_notes.printed import validation as printed
from chr_notes.symbols import (
    BODY_RATES,
    EULER_RATES,
    MAGNETOMETER,
    AngularRate,
    T,
    g,
    phi,
    psi,
    theta,
)

VECTOR = ImmutableMatrix(symbols("v_x v_y v_z", real=True))
# What a faultless magnetometer far from iron would not see, in the inertial frame; the gyro's bias
# while at rest; the altitude.
DISTURBANCE = ImmutableMatrix(symbols("d_x d_y d_z", real=True))
BIAS = AngularRate("b", real=True)
ALTITUDE = Symbol("h", positive=True)
# The matrix of the labels, with yaw and without; E after an error about the field's own direction.
WITHOUT_YAW = MatrixSymbol(r"R_{i}^{b}(\phi, \theta, 0)", 3, 3)
E_ALONG_FIELD = Symbol(r"E_{\text{tilt about the field's horizontal part}}", real=True)
WEAKENING = Symbol(r"\lVert\mathbf{M}(1\,\mathrm{km})\rVert / \lVert\mathbf{M}(0)\rVert")


def gravity() -> ImmutableMatrix:
    """Take gravity to the body frame."""
    return ImmutableMatrix(rotation("I", "B") * (g * Z))


def in_print(formula: Basic) -> Basic:
    """Write a derived formula with the paper's symbols for the magnetic field."""
    names = (*printed.FIELD_B, *printed.FIELD_I)
    return formula.subs(
        dict(zip((*MAGNETOMETER, *derived.REFERENCE), names, strict=True)), simultaneous=True
    )


def yaw_in_print(formula: Expr) -> Expr:
    """Write a formula for yaw with the paper's symbols, from the reading in the body frame."""
    return in_print(derived.from_reading(formula))


def disturbed_factor() -> Expr:
    """Take E at the exact attitude, in a field that something disturbs."""
    field = ImmutableMatrix(symbols("f_x f_y f_z"))
    reading_of_it = rotation("I", "B") * field
    gap = expand(
        in_print(derived.downward_gap()).subs(
            dict(zip(printed.FIELD_B, reading_of_it, strict=True))
        )
    )
    seen = {part: simplify(gap.coeff(part)) for part in field}
    present = dict(zip(field, printed.M_I + DISTURBANCE, strict=True))
    return Abs(printed.M_ZI + sum(seen[part] * present[part] for part in field))


def factor_in_print() -> Expr:
    """Take E of a normalised reading, at the angles of the filter."""
    at = {phi: printed.ROLL_COMP, theta: printed.PITCH_COMP}
    return Abs(in_print(derived.downward_gap()).subs(at))


def filter_in_print(step: Expr) -> Expr:
    """Write a step of the observer with the paper's gain and period."""
    return step.subs({estimation.L: printed.ALPHA, T: printed.DT})


def settling() -> Expr:
    """Follow the filter at rest: the accelerometer exact, the gyro not quite."""
    error = filter_in_print(estimation.error_after().subs(estimation.bias, BIAS))
    return printed.ROLL_ACCEL + error


def factor_along_field() -> Expr:
    """Take E after a turn about the horizontal part of the field, with x in its direction."""
    axis = dict(zip(derived.ERROR_AXIS, (1, 0, 0), strict=True))
    return in_print(derived.factor_after_error().subs(axis)).subs(printed.M_YI, 0)


HIGH = {derived.radius: derived.radius + ALTITUDE}
ROLL_STEP = printed.ROLL_BEFORE + printed.ROLL_RATE * printed.DT
PITCH_STEP = printed.PITCH_BEFORE + printed.PITCH_RATE * printed.DT

_MEANING: dict[Basic, Meaning] = {
    printed.R_IB: rotation("I", "B"),
    printed.R_BI: rotation("B", "I"),
    printed.R_Z: rotation("v1", "I"),
    printed.R_Y: rotation("v2", "v1"),
    printed.R_X: rotation("B", "v2"),
    printed.R_Z_IN_8: rotation("v1", "I"),
    printed.R_Y_IN_8: rotation("v2", "v1"),
    # The axes of the three turns, in the inertial frame.
    printed.YAW_AXIS: Z,
    printed.PITCH_AXIS: lambda: ImmutableMatrix(rotation("v1", "I") * Y),
    printed.ROLL_AXIS: lambda: ImmutableMatrix(rotation("v2", "I") * X),
    WITHOUT_YAW: lambda: rotation("I", "B").subs(psi, 0),
    printed.V_I: VECTOR,
    printed.V_B: lambda: ImmutableMatrix(rotation("I", "B") * VECTOR),
    **elements(printed.GRAVITY, gravity),
    printed.ROLL_ACCEL: phi,
    printed.PITCH_ACCEL: theta,
    printed.YAW_ACCEL: psi,
    **elements(BODY_RATES, body_rates),
    printed.YAW: psi,
}
READ = reading(_MEANING)
READ_RATES = reading(elements(EULER_RATES, euler_rates))
READ_FILTER = reading(
    {
        printed.ROLL: lambda: filter_in_print(
            estimation.update_on_circle(ROLL_STEP, printed.ROLL_ACCEL)
        ),
        printed.PITCH: lambda: filter_in_print(estimation.update(PITCH_STEP, printed.PITCH_ACCEL)),
        printed.SETTLING: settling,
    }
)
_FIELD_MEANING: dict[Basic, Meaning] = {
    printed.R_IB: rotation("I", "B"),
    printed.R_BI: rotation("B", "I"),
    **elements(printed.FIELD_B, lambda: ImmutableMatrix(rotation("I", "B") * printed.M_I)),
    printed.E: disturbed_factor,
    E_ALONG_FIELD: factor_along_field,
    printed.GROWTH: lambda: in_print(derived.sensitivity()),
}
READ_FIELD = reading(_FIELD_MEANING)
READ_YAW = reading(
    {
        sin(psi): lambda: yaw_in_print(derived.sine_and_cosine_of_yaw()[0]),
        cos(psi): lambda: yaw_in_print(derived.sine_and_cosine_of_yaw()[1]),
        printed.A: lambda: yaw_in_print(derived.determinant()),
        printed.E: factor_in_print,
    }
)
READ_EARTH = reading(
    {
        **elements(printed.FIELD_I, derived.field_with_x_south),
        printed.GROUND_MAGNITUDE: derived.dipole_magnitude,
        printed.HIGH_MAGNITUDE: lambda: derived.dipole_magnitude().subs(HIGH),
        printed.GROUND_DIRECTION: derived.dipole_direction,
        printed.HIGH_DIRECTION: lambda: derived.dipole_direction().subs(HIGH),
        WEAKENING: lambda: simplify(
            derived.dipole_magnitude().subs(derived.radius, 6372) / derived.dipole_magnitude()
        ).subs(derived.radius, 6371),
    }
)


# The paper contradicts itself: what R_i^b takes to what, by its label and by equation 1.
_AS_IN_EQUATION_1 = {
    printed.R_IB: rotation("B", "I"),
    printed.R_BI: rotation("I", "B"),
}
SOME_ATTITUDE = {phi: pi / 6, theta: pi / 9, psi: pi / 3}
SOME_FIELD = dict(zip(printed.FIELD_I, (Rational(4, 10), 0, Rational(9, 10)), strict=True))
SOME_POINT = {**SOME_ATTITUDE, **SOME_FIELD, g: Rational(98, 10), **dict.fromkeys(EULER_RATES, 1)}


def both_readings(meaning: Mapping[Basic, Meaning]) -> tuple[Reading, Reading]:
    """Give the reading by the label, which the ledger uses, and the one by equation 1."""
    by_label = Eq(printed.V_B, MatMul(printed.R_IB, printed.V_I))
    as_in_1 = Eq(printed.V_I, MatMul(printed.R_IB, printed.V_B))
    return (
        Reading(by_label, reading(meaning), SOME_POINT),
        Reading(as_in_1, reading({**meaning, **_AS_IN_EQUATION_1}), SOME_POINT),
    )


READINGS = both_readings(_MEANING)
FIELD_READINGS = both_readings(_FIELD_MEANING)
