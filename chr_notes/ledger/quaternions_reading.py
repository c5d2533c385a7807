"""How the quaternion note is read: what its symbols mean, in each of its two readings.

The note contradicts itself. Its section 3 takes vectors from the inertial to the body frame by
`q v q⁻¹`; the Euler angles of its section 4 are right only if the same product leads from the
body to the inertial frame. Everything is judged in the second reading, which is the sensors' own,
and the statements that differ are tried in the first one as well.
"""

from sympy import (
    Abs,
    Basic,
    Eq,
    I,
    ImmutableMatrix,
    Integer,
    MatrixSymbol,
    Rational,
    asin,
    atan,
    atan2,
    cos,
    expand,
    fraction,
    pi,
    sin,
    symbols,
)

from chr_notes.derivations import hamilton
from chr_notes.derivations import quaternions as derived
from chr_notes.ledger.case import Reading
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.reading import Meaning, Notation, Read, defined, reading
from chr_notes.printed import quaternions as printed
from chr_notes.printed import quaternions_claims as claims
from chr_notes.printed.hamilton import Conjugate, Product, Pure, Reciprocal
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import (
    AXIS,
    FIRST,
    QUATERNION,
    SECOND,
    VECTOR,
    alpha,
    b,
    c,
    d,
    phi,
    psi,
    theta,
)


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


def _both_parts(angle: atan) -> Basic:
    """Read the arctangent of a quotient as section 4 says: by atan2 of its two parts."""
    return atan2(*fraction(angle.args[0]))


NOTATION: Notation = {
    Product: _product,
    Reciprocal: lambda quaternion: hamilton.inverse(quaternion.args[0]),
    Conjugate: lambda quaternion: hamilton.conjugate(quaternion.args[0]),
    Pure: lambda vector: hamilton.pure(vector.args[0].doit()),
    Rotation: _matrix,
    atan: _both_parts,
}

ANGLES = derived.euler_from_matrix(derived.matrix_from_quaternion())
NORM = hamilton.norm_squared(derived.ATTITUDE)
UNIT = Condition(Eq(NORM, 1))

# What steps speak of: any vector.
ANY_VECTOR = MatrixSymbol(r"\mathbf{v}", 3, 1)

_NUMBERS: dict[Basic, Meaning] = {
    printed.REALS: Integer(1),
    printed.IMAGINARY: Integer(1),
    printed.COMPLEX: Integer(len((1, I))),
    printed.QUATERNIONS: Integer(len(hamilton.BASIS)),
    printed.NO_RATE: derived.pitches_without_rates,
}
_NAMES: dict[Basic, Meaning] = {
    **defined("quaternions.2.1"),
    printed.Q_1: ImmutableMatrix(FIRST),
    printed.Q_2: ImmutableMatrix(SECOND),
    **dict.fromkeys((printed.V_I, ANY_VECTOR), ImmutableMatrix(VECTOR)),
}
# What depends on the direction in which the quaternion leads.
_ATTITUDE: dict[Basic, Basic] = {
    printed.V_B: ImmutableMatrix(derived.rotate_to_body() / NORM),
    printed.V_B_AS_QUATERNION: hamilton.pure(derived.rotate_to_body() / NORM),
    phi: ANGLES[0],
    theta: asin(derived.pitch_sine(derived.matrix_from_quaternion())),
    psi: ANGLES[2],
}
PRESUMED = (
    # Its square then stands for 1 wherever it stands.
    Presumed(UNIT, "of norm one", "quaternions.2.1", ("quaternions.3.3", "quaternions.3.b")),
    Presumed(Condition(Eq(Abs(theta), pi / 2)), "At a pitch of ±90°", "quaternions.4.b"),
)
READ = reading({**_NUMBERS, **_NAMES, **_ATTITUDE}, NOTATION, PRESUMED)
# Where the note names atan2 itself, an arctangent would be one of the quotient alone.
READ_AT_ITS_WORD = Read({}, {kind: how for kind, how in NOTATION.items() if kind is not atan}, READ)

# What the other reading says of q is what this one says of its conjugate.
_AS_IN_3 = {
    name: value.subs({b: -b, c: -c, d: -d}, simultaneous=True) for name, value in _ATTITUDE.items()
}
# Some attitude with no angle zero.
SOMEWHERE = dict(zip(QUATERNION, (Rational(n, 9) for n in (6, 4, 2, 5)), strict=True))
_SOME_POINT = {
    **SOMEWHERE,
    **dict(zip(VECTOR, (1, 2, 3), strict=True)),
}
READINGS = (
    Reading(
        Eq(Pure(printed.V_I), Product(printed.Q, Pure(printed.V_B), Reciprocal(printed.Q))),
        READ,
        _SOME_POINT,
    ),
    Reading(
        Eq(Pure(printed.V_B), Product(printed.Q, Pure(printed.V_I), Reciprocal(printed.Q))),
        reading({**_NUMBERS, **_NAMES, **_AS_IN_3}, {**NOTATION, Rotation: _matrix_as_in_3}),
        _SOME_POINT,
    ),
)

X, Z = ImmutableMatrix([1, 0, 0]), ImmutableMatrix([0, 0, 1])
# A vector along x, turned about z; any vector, turned about any unit axis.
X_TURNED = MatrixSymbol(r"\mathbf{x}_{\text{turned about } z}", 3, 1)
_TILT, _HEADING = symbols("tau eta", real=True)
UNIT_AXIS = ImmutableMatrix([sin(_TILT) * cos(_HEADING), sin(_TILT) * sin(_HEADING), cos(_TILT)])
READ_AXIS = READ.also(
    {
        **dict(
            zip(
                QUATERNION,
                derived.from_axis_angle(ImmutableMatrix(AXIS), printed.TURN),
                strict=True,
            )
        ),
        X_TURNED: derived.turned(Z, printed.TURN, X),
        claims.TURNED: derived.turned(UNIT_AXIS, printed.TURN, ImmutableMatrix(VECTOR)),
    }
)
READ_ROTATION = READ.also(
    {
        **dict(zip(QUATERNION, derived.from_axis_angle(UNIT_AXIS, alpha), strict=True)),
        claims.TURNED: derived.turned(UNIT_AXIS, alpha, ImmutableMatrix(VECTOR)),
    }
)
READ_ORDERS = READ.also(
    {
        claims.ROLL_321: derived.euler_from_matrix(derived.matrix_from_quaternion())[0],
        claims.ROLL_123: derived.roll_turned_first(derived.matrix_from_quaternion()),
    }
)
READ_AT_LOCK = READ.also(dict(zip(QUATERNION, derived.from_euler(), strict=True)))
