"""How the quaternion note is read: what its symbols mean, in each of its two readings."""

from sympy import (
    Basic,
    Eq,
    I,
    ImmutableMatrix,
    Integer,
    Rational,
    asin,
    expand,
    sqrt,
)

from chr_notes.derivations import hamilton
from chr_notes.derivations import quaternions as derived
from chr_notes.ledger.case import Condition, Reading
from chr_notes.ledger.reading import Notation, reading
from chr_notes.printed import quaternions as printed
from chr_notes.printed.hamilton import Conjugate, Product, Pure, Reciprocal
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import (
    AXIS,
    FIRST,
    QUATERNION,
    SECOND,
    VECTOR,
    a,
    b,
    c,
    d,
    phi,
    psi,
    theta,
)

BY_ID = {statement.id: statement for statement in printed.PRINTED}
CONJUGATED = {b: -b, c: -c, d: -d}


def _product(whole: Product) -> Basic:
    first, *others = whole.args
    for other in others:
        first = hamilton.multiply(first, other).applyfunc(expand)
    return first


def _matrix(symbol: Rotation) -> Basic:
    """Give the matrix of a quaternion with the direction that the symbol's frames name."""
    elements = dict(zip(QUATERNION, symbol.angles[0], strict=True))
    matrix = derived.matrix_from_any_quaternion().subs(elements, simultaneous=True)
    return matrix if symbol.frames == ("i", "b") else ImmutableMatrix(matrix.T)


def _matrix_as_in_3(symbol: Rotation) -> Basic:
    return _matrix(Rotation(*symbol.frames, hamilton.conjugate(symbol.angles[0])))


NOTATION: Notation = {
    Product: _product,
    Reciprocal: lambda quaternion: hamilton.inverse(quaternion.args[0]),
    Conjugate: lambda quaternion: hamilton.conjugate(quaternion.args[0]),
    Pure: lambda vector: hamilton.pure(vector.args[0]),
    Rotation: _matrix,
}
NOTATION_AS_IN_3: Notation = {**NOTATION, Rotation: _matrix_as_in_3}

ANGLES = derived.euler_from_matrix(derived.matrix_from_quaternion())
NORM = hamilton.norm_squared(derived.ATTITUDE)
# The attitude quaternion has norm one, says 2.1; its square then stands for 1 wherever it stands.
UNIT = Condition(Eq(NORM, 1), ({NORM: 1},))
# One vector in two frames: any components in one, and those that follow in the other.
TO_BODY = {
    printed.V_I: ImmutableMatrix(VECTOR),
    printed.V_B: ImmutableMatrix(derived.rotate_to_body() / NORM),
}
# The note equates a 3-vector with a product of quaternions: read it as one without scalar part.
AS_QUATERNION = {**TO_BODY, printed.V_B: hamilton.pure(derived.rotate_to_body() / NORM)}
TO_INERTIAL = {
    printed.V_B: ImmutableMatrix(VECTOR),
    printed.V_I: ImmutableMatrix(derived.rotate_to_inertial() / NORM),
}
MEANING = {
    printed.REALS: Integer(1),
    printed.IMAGINARY: Integer(1),
    printed.COMPLEX: Integer(len((1, I))),
    printed.QUATERNIONS: Integer(len(hamilton.BASIS)),
    printed.Q_1: ImmutableMatrix(FIRST),
    printed.Q_2: ImmutableMatrix(SECOND),
    phi: ANGLES[0],
    theta: asin(derived.pitch_sine(derived.matrix_from_quaternion())),
    psi: ANGLES[2],
}
# Names that the note gives: the elements in 2.1, the matrix in 3.3.
ELEMENTS = {printed.Q: BY_ID["quaternions.2.1"].statement.rhs}
MATRIX = {printed.R_IB: printed.MATRIX}

DERIVED = reading(MEANING, NOTATION)
READ = reading({**MEANING, **TO_BODY, **ELEMENTS}, NOTATION)
READ_AXIS = reading(
    dict(zip(QUATERNION, derived.from_axis_angle(ImmutableMatrix(AXIS), theta), strict=True))
)
READ_PRODUCT = reading({**AS_QUATERNION, **ELEMENTS}, NOTATION)
READ_BACK = reading({**TO_INERTIAL, **ELEMENTS}, NOTATION)
READ_MATRIX = reading({**TO_BODY, **ELEMENTS, **MATRIX}, NOTATION)
READ_AT_LOCK = reading(
    {
        **dict(zip(QUATERNION, derived.from_euler(), strict=True)),
        printed.NO_RATE: derived.pitches_without_rates(),
    }
)

YAW_90 = {a: sqrt(2) / 2, b: 0, c: 0, d: sqrt(2) / 2}
YAW_120 = {a: Rational(1, 2), b: 0, c: 0, d: sqrt(3) / 2}
ROLL_120 = {a: Rational(1, 2), b: sqrt(3) / 2, c: 0, d: 0}
NORTH = dict(zip(VECTOR, (1, 0, 0), strict=True))
NO_PLACE_IN_PARTICULAR = {
    **dict(zip(QUATERNION, (Rational(n, 9) for n in (6, 4, 2, 5)), strict=True)),
    **dict(zip(VECTOR, (1, 2, 3), strict=True)),
}


def readings(meaning: dict[Basic, Basic]) -> tuple[Reading, Reading]:
    """Give both readings: that of section 4, which the sensors use, and that of section 3."""
    one, other = printed.V_I, printed.V_B
    # What the other reading says of q is what this one says of its conjugate.
    as_in_3 = {
        name: value.subs(CONJUGATED, simultaneous=True)
        for name, value in meaning.items()
        if name not in (*ELEMENTS, *MATRIX)
    }
    return (
        Reading(
            Eq(Pure(one), Product(printed.Q, Pure(other), Reciprocal(printed.Q))),
            reading(meaning, NOTATION),
            NO_PLACE_IN_PARTICULAR,
        ),
        Reading(
            Eq(Pure(other), Product(printed.Q, Pure(one), Reciprocal(printed.Q))),
            reading({**meaning, **as_in_3}, NOTATION_AS_IN_3),
            NO_PLACE_IN_PARTICULAR,
        ),
    )
