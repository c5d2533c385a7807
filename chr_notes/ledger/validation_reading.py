"""What the paper on validating Euler angles means by its symbols.

The paper contradicts itself in what its matrix R_i^b takes to what. It is read by its label
everywhere: the label, the sentence that explains it and equation 2 say that it takes components
from the inertial frame to the body. The statements that differ are tried by equation 1 as well.
"""

from collections.abc import Mapping
from functools import partial

from sympy import (
    Abs,
    Basic,
    Eq,
    Expr,
    FiniteSet,
    ImmutableMatrix,
    Integer,
    MatMul,
    MatrixSymbol,
    Rational,
    Set,
    Symbol,
    cos,
    expand,
    pi,
    sin,
    symbols,
)

from chr_notes.derivations import estimation
from chr_notes.derivations import validation as derived
from chr_notes.derivations.euler import X, Y, Z, body_rates, euler_rates, rotation
from chr_notes.derivations.quaternions import turned
from chr_notes.ledger.case import Reading
from chr_notes.ledger.edits import in_order
from chr_notes.ledger.identities import is_zero, reduced
from chr_notes.ledger.reading import Meaning, Read, defined, elements, reading
from chr_notes.ledger.validation_presumed import BIAS, PRESUMED, SEEN, UNDISTURBED
from chr_notes.printed import BY_ID
from chr_notes.printed import validation as printed
from chr_notes.printed import validation_claims as claims
from chr_notes.symbols import (
    BODY_RATES,
    EULER_RATES,
    MAGNETOMETER,
    T,
    g,
    phi,
    psi,
    theta,
)

VECTOR = ImmutableMatrix(symbols("v_x v_y v_z", real=True))
# The altitude.
ALTITUDE = Symbol("h", positive=True)

# What steps speak of: the matrix of the labels without yaw; any vector that has no part to the
# north, and one that has none to the east; the field in level axes, forward and right; the field
# with x to the north; the direction of a dipole's field at the ground and higher up; how fast E
# grows with an error, before its magnitude is taken and after; E after an error about the field's
# own direction.
WITHOUT_YAW = MatrixSymbol(r"R_{i}^{b}(\phi, \theta, 0)", 3, 3)
NOT_NORTH, NOT_EAST = (
    symbols(rf"{name}_{{xb}} {name}_{{yb}} {name}_{{zb}}", real=True) for name in "uw"
)
LEVEL_X, LEVEL_Y = LEVEL = symbols("M_{x} M_{y}", real=True)
FIELD_X_NORTH = MatrixSymbol(r"\mathbf{M}_{\text{x north}}", 3, 1)
GROUND_DIRECTION, HIGH_DIRECTION = (
    MatrixSymbol(rf"\frac{{\mathbf{{M}}({where})}}{{\lVert\mathbf{{M}}({where})\rVert}}", 3, 1)
    for where in ("0", "h")
)
SIGNED_GROWTH = Symbol(r"\left.\frac{\partial E_\pm}{\partial\epsilon}\right|_{\epsilon=0}")
GROWTH = Symbol(r"\left.\frac{\partial E}{\partial\epsilon}\right|_{\epsilon=0^+}", real=True)
E_ALONG_FIELD = Symbol(r"E_{\text{tilt about the field's horizontal part}}", real=True)

ROLL_STEP = printed.ROLL_BEFORE + printed.ROLL_RATE * printed.DT
PITCH_STEP = printed.PITCH_BEFORE + printed.PITCH_RATE * printed.DT
HIGH = {derived.radius: derived.radius + ALTITUDE}


def to_body(vector: ImmutableMatrix) -> ImmutableMatrix:
    """Take a vector from the inertial frame to the body."""
    return ImmutableMatrix(rotation("I", "B") * vector)


def to_body_at_zero(vector: ImmutableMatrix) -> ImmutableMatrix:
    """Take a vector to the body while all three angles are zero."""
    return to_body(vector).subs(dict.fromkeys((phi, theta, psi), 0))


def level_to_body(along: Expr, across: Expr) -> ImmutableMatrix:
    """Take a vector to the body of which the level parts, forward and right, are given."""
    return ImmutableMatrix(rotation("v1", "B") * ImmutableMatrix([along, across, VECTOR[2]]))


def in_print(formula: Basic) -> Basic:
    """Write a derived formula with the paper's symbols for the magnetic field."""
    names = (*printed.FIELD_B, *printed.FIELD_I)
    return formula.subs(
        dict(zip((*MAGNETOMETER, *derived.REFERENCE), names, strict=True)), simultaneous=True
    )


def filter_in_print(step: Expr) -> Expr:
    """Write a step of the observer with the paper's gain and period."""
    return step.subs({estimation.L: printed.ALPHA, T: printed.DT})


def roll_filter() -> Expr:
    """Take a step of the filter for roll, which goes all the way round."""
    return filter_in_print(estimation.update_on_circle(ROLL_STEP, printed.ROLL_ACCEL))


def pitch_filter() -> Expr:
    """Take a step of the filter for pitch."""
    return filter_in_print(estimation.update(PITCH_STEP, printed.PITCH_ACCEL))


def share(of: Expr, less: Expr) -> Expr:
    """By how much the filter's angle grows with one more radian of another angle."""
    step = estimation.update(estimation.predicted, estimation.measured)
    at = {of: Integer(1), less: Integer(0)}
    return filter_in_print(step.subs(at))


def magnetometer_in_filter() -> Set:
    """Find which readings of the magnetometer stand in the angles of the filter."""
    used = roll_filter().free_symbols | pitch_filter().free_symbols
    return FiniteSet(*(used & {*printed.FIELD_B}))


def settling() -> Expr:
    """Follow the filter at rest: the accelerometer exact, the gyro not quite."""
    error = filter_in_print(estimation.error_after().subs(estimation.bias, BIAS))
    return printed.ROLL_ACCEL + error


def factor_along_field() -> Expr:
    """Take E after a turn about the horizontal part of the field, with x in its direction."""
    axis = dict(zip(derived.ERROR_AXIS, (1, 0, 0), strict=True))
    return in_print(derived.factor_after_error().subs(axis)).subs(printed.M_YI, 0)


def growth_of_factor() -> Expr:
    """Let the printed E grow with a small error of attitude about an axis, from exact angles on."""
    seen = turned(ImmutableMatrix(derived.ERROR_AXIS), derived.error_angle, printed.M_I)
    estimated = {phi: printed.ROLL_COMP, theta: printed.PITCH_COMP}
    in_body = dict(zip(printed.FIELD_B, rotation("I", "B").subs(estimated) * seen, strict=True))
    factor = in_order(BY_ID["validation.17"].statement.rhs).xreplace(in_body)
    return _slope(factor.replace(Abs, _at_first))


def angles_shown() -> Integer:
    """Count the angles with whose small error the printed E grows, but at single values."""
    growth = growth_of_factor()
    axes = (rotation("B", "I") * X, rotation("v1", "I") * Y, Z)  # of roll, pitch and yaw
    slopes = [growth.subs(dict(zip(derived.ERROR_AXIS, axis, strict=True))) for axis in axes]
    return Integer(sum(not is_zero(slope) for slope in slopes))


def _at_first(difference: Expr) -> Expr:
    """Take the magnitude of what is zero at exact angles, to first order in a positive error."""
    short = reduced(difference)
    if short is None or short.subs(derived.error_angle, 0) != 0:
        return Abs(difference)
    return derived.error_angle * Abs(_slope(short))


def _slope(expression: Expr) -> Expr:
    return expand(expression.diff(derived.error_angle).subs(derived.error_angle, 0))


def in_any_components(name: str) -> Expr:
    """Take what equation 6 or 7 says the tangent of yaw is, for any components, not gravity's."""
    quotient = in_order(BY_ID[name].statement.rhs)
    return quotient.xreplace(dict(zip(printed.GRAVITY, VECTOR, strict=True)))


def field_x_north() -> ImmutableMatrix:
    """Turn the field with x to the south by half a turn about the vertical."""
    return ImmutableMatrix(rotation("I", "v1").subs(psi, pi) * derived.field_with_x_south())


def part_of_yaw(name: str) -> Expr:
    """Work out what equation 13 or 14 prints, in the field that it presumes."""
    (undisturbed,) = UNDISTURBED.by
    part = READ(in_order(BY_ID[name].statement.rhs)).xreplace(undisturbed)
    return reduced(part) or part


_MEANING: dict[Basic, Meaning] = {
    printed.R_IB: rotation("I", "B"),
    printed.R_BI: rotation("B", "I"),
    printed.R_Z: rotation("v1", "I"),
    printed.R_Y: rotation("v2", "v1"),
    printed.R_X: rotation("B", "v2"),
    printed.R_Z_IN_8: rotation("v1", "I"),
    printed.R_Y_IN_8: rotation("v2", "v1"),
    WITHOUT_YAW: lambda: rotation("I", "B").subs(psi, 0),
    # The axes of the three turns, in the inertial frame.
    printed.YAW_AXIS: Z,
    printed.PITCH_AXIS: lambda: ImmutableMatrix(rotation("v1", "I") * Y),
    printed.ROLL_AXIS: lambda: ImmutableMatrix(rotation("v2", "I") * X),
    printed.V_I: VECTOR,
    printed.V_B: partial(to_body, VECTOR),
    **elements(printed.GRAVITY, partial(to_body, g * Z)),
    claims.READING: estimation.accelerometer_at_rest,
    claims.READING_AT_YAW: estimation.accelerometer_at_rest,
    claims.READING_WITHOUT_YAW: lambda: estimation.accelerometer_at_rest().subs(psi, 0),
    claims.YAWS: derived.yaws_of_gravity,
    printed.YAW_ACCEL: psi,
    printed.YAW: psi,
    **elements(printed.FIELD_B, partial(to_body, SEEN)),
    **defined("validation.15", "validation.17"),
    claims.READING_AT_ZERO: partial(to_body_at_zero, printed.M_I),
    claims.BY_6: partial(in_any_components, "validation.6"),
    claims.BY_7: partial(in_any_components, "validation.7"),
    claims.SHOWN_BY_E: angles_shown,
    claims.GROUND_MAGNITUDE: derived.dipole_magnitude,
    claims.HIGH_MAGNITUDE: lambda: derived.dipole_magnitude().subs(HIGH),
    printed.ROLL: roll_filter,
    printed.PITCH: pitch_filter,
    printed.SETTLING: settling,
    claims.ACCELEROMETER_SHARE: partial(share, estimation.measured, estimation.predicted),
    claims.GYRO_SHARE: partial(share, estimation.predicted, estimation.measured),
    claims.MAGNETOMETER_IN_FILTER: magnetometer_in_filter,
    claims.DRIFT: lambda: estimation.gyro_error_after().subs(estimation.bias, BIAS),
}
READ = reading(_MEANING, presumed=PRESUMED)
_TILT: dict[Basic, Meaning] = {printed.ROLL_ACCEL: phi, printed.PITCH_ACCEL: theta}
READ_TILT = READ.also(_TILT)
_BODY_RATES = elements(BODY_RATES, body_rates)
READ_BODY_RATES = READ.also(_BODY_RATES)
READ_EULER_RATES = READ.also(elements(EULER_RATES, euler_rates))
READ_STEPS = READ.also(
    {
        # Level vectors of some length, seen from the nose, with the part of the other axis zero.
        **elements(NOT_NORTH, lambda: level_to_body(VECTOR[0] * sin(psi), VECTOR[0] * cos(psi))),
        **elements(NOT_EAST, lambda: level_to_body(VECTOR[0] * cos(psi), -VECTOR[0] * sin(psi))),
        **elements(LEVEL, lambda: ImmutableMatrix(rotation("I", "v1") * SEEN)),
        GROWTH: growth_of_factor,
        SIGNED_GROWTH: lambda: in_print(derived.sensitivity()),
        E_ALONG_FIELD: factor_along_field,
        GROUND_DIRECTION: derived.dipole_direction,
        HIGH_DIRECTION: lambda: derived.dipole_direction().subs(HIGH),
    }
)
READ_YAW = READ.also(
    {
        sin(psi): partial(part_of_yaw, "validation.14"),
        cos(psi): partial(part_of_yaw, "validation.13"),
    }
)
READ_SOUTH = READ.also(
    {
        **elements(printed.FIELD_I, derived.field_with_x_south),
        FIELD_X_NORTH: field_x_north,
    }
)
READ_GRAVITY = READ.also({g: Rational("9.80665")})

SOME_ATTITUDE = {phi: pi / 6, theta: pi / 9, psi: pi / 3}
SOME_UNIT_FIELD = (Rational(3, 5), Integer(0), Rational(4, 5))
SOME_FIELD = {
    **dict(zip(printed.FIELD_I, SOME_UNIT_FIELD, strict=True)),
    **dict(zip(SEEN, SOME_UNIT_FIELD, strict=True)),
}
SOME_POINT = {
    **SOME_ATTITUDE,
    **SOME_FIELD,
    g: Rational(98, 10),
    **dict.fromkeys(EULER_RATES, 1),
    **dict(zip(VECTOR, (1, 2, 3), strict=True)),
}


def both_readings(read: Read, more: Mapping[Basic, Meaning]) -> tuple[Reading, Reading]:
    """Give the reading by the label, which the ledger uses, and the one by equation 1."""
    by_label = Eq(printed.V_B, MatMul(printed.R_IB, printed.V_I))
    as_in_1 = Eq(printed.V_I, MatMul(printed.R_IB, printed.V_B))
    swapped = {printed.R_IB: rotation("B", "I"), printed.R_BI: rotation("I", "B")}
    other = reading({**_MEANING, **swapped, **more})
    return Reading(by_label, read, SOME_POINT), Reading(as_in_1, other, SOME_POINT)


READINGS = both_readings(READ, {})
RATES_READINGS = both_readings(READ_BODY_RATES, _BODY_RATES)
