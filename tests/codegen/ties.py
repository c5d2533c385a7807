"""How a generated function and an entry of the ledger say the same: a relation for each pair.

A tie is made of the function's formula, written in its arguments, and of what the entry says when
it is right: printed, or corrected. `test_entries` proves it as the entry is read.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sympy import (
    Abs,
    Basic,
    Eq,
    FiniteSet,
    ImmutableMatrix,
    Integer,
    MatrixBase,
    Pow,
    Symbol,
    sin,
)
from sympy.logic.boolalg import Boolean

from chr_notes.derivations import hamilton, quaternions
from chr_notes.ledger.quaternions_reading import NORM, UNIT_AXIS
from chr_notes.printed import quaternions as printed
from chr_notes.printed.hamilton import Conjugate, Pure
from chr_notes.symbols import (
    AXIS,
    BODY_RATES,
    EULER_RATES,
    QUATERNION,
    VECTOR,
    a,
    alpha,
    phi,
    psi,
    theta,
)

Formula = MatrixBase
States = Callable[[Formula, Basic], Iterator[Boolean]]


def right_side(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """What the function returns is the right side."""
    yield Eq(formula, entry.rhs, evaluate=False)


@dataclass(frozen=True)
class Tie:
    """How a function and an entry belong together.

    Parameters
    ----------
    states
        Relations that hold if the function computes what the entry says.
    branches
        Which branch each choice of the computation takes where the entry speaks.
    others
        Further such branches, of which the same is said.
    """

    states: States = right_side
    branches: tuple[int, ...] = ()
    others: tuple[tuple[int, ...], ...] = ()


def element(place: int) -> States:
    """One element of the result is the right side."""

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        yield Eq(formula[place], entry.rhs, evaluate=False)

    return states


def _of_roll_and_pitch_alone(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    others = formula.free_symbols - {phi, theta}
    yield Eq(FiniteSet(*others), entry.rhs, evaluate=False)


def _gives_the_rates_back(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    gyros = dict(zip(BODY_RATES, formula, strict=True))
    yield Eq(entry.rhs.xreplace(gyros), ImmutableMatrix(EULER_RATES), evaluate=False)


def _transposed(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    # The entry's matrix leads from the body to the inertial frame, the function's back.
    yield Eq(ImmutableMatrix(formula.T), entry.rhs, evaluate=False)


def _back_from_matrix(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """From the matrix of a quaternion comes a multiple of that quaternion."""
    elements = dict(zip(quaternions.MATRIX, ImmutableMatrix(entry.rhs).T, strict=True))
    found = [value.xreplace(elements) for value in formula]
    for one in range(4):
        for other in range(one):
            yield Eq(found[one] * QUATERNION[other], found[other] * QUATERNION[one], evaluate=False)


def _same_sine(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    sine, cosine = formula[1].args
    yield Eq(sine, sin(entry.rhs), evaluate=False)
    assert all(isinstance(factor, Pow) for factor in cosine.args), "roots, which are not negative"
    yield Eq(cosine**2, NORM**2 - sin(entry.rhs) ** 2, evaluate=False)


def _axis_and_angle(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    unit = dict(zip(AXIS, UNIT_AXIS, strict=True))
    turned = ImmutableMatrix(formula.xreplace(unit | {alpha: printed.TURN}))
    yield Eq(turned, entry.rhs.xreplace(unit), evaluate=False)


def _three_turns(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """The product of the entry's quaternions of yaw about z, pitch about y and roll about x."""
    turns = []
    for angle, axis in zip((psi, theta, phi), ((0, 0, 1), (0, 1, 0), (1, 0, 0)), strict=True):
        names = dict(zip(AXIS, map(Integer, axis), strict=True)) | {printed.TURN: angle}
        turns.append(ImmutableMatrix(entry.rhs.xreplace(names).doit()))
    yaw, pitch, roll = turns
    whole = hamilton.multiply(hamilton.multiply(yaw, pitch), roll)
    yield Eq(ImmutableMatrix(formula), whole, evaluate=False)


def _back_from_axis_and_angle(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """The entry makes of the axis and the angle returned the quaternion again."""
    size = Symbol("size", positive=True)
    in_units = formula.xreplace({sum(map(Abs, QUATERNION[1:])): size})
    *axis, angle = in_units.xreplace({Abs(a): a})  # the branch where it is not negative
    whole = entry.rhs.xreplace({**dict(zip(AXIS, axis, strict=True)), printed.TURN: angle})
    for one in range(4):
        for other in range(one):
            left, right = whole[one] * QUATERNION[other], whole[other] * QUATERNION[one]
            yield Eq(left, right, evaluate=False)


def in_place_of(name: Basic) -> States:
    """With the function's result in place of a name, the entry holds."""

    def states(formula: Formula, entry: Basic) -> Iterator[Boolean]:
        assert entry.has(name)
        yield entry.xreplace({name: ImmutableMatrix(formula)})

    return states


def _seen_from_the_body(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    """What the function takes to the inertial frame, the entry takes back."""
    there = entry.rhs.xreplace({Pure(printed.V_I): Pure(ImmutableMatrix(formula))})
    assert there != entry.rhs
    yield Eq(Pure(ImmutableMatrix(VECTOR)), there, evaluate=False)


def _as_quaternion(formula: Formula, entry: Basic) -> Iterator[Boolean]:
    yield Eq(Pure(ImmutableMatrix(formula)), entry.rhs, evaluate=False)


ATTITUDES: dict[tuple[str, str], Tie] = {
    ("body_rates_from_euler_rates", "euler.7.a"): Tie(_gives_the_rates_back),
    ("euler_rates_matrix", "euler.7.d"): Tie(_of_roll_and_pitch_alone),
    ("matrix_from_quaternion", "quaternions.3.3"): Tie(_transposed),
    ("quaternion_from_matrix", "quaternions.3.3"): Tie(
        _back_from_matrix, (0, 0), ((1, 0), (2, 1), (3, 1))
    ),
    ("euler_from_quaternion", "quaternions.4.1"): Tie(element(0), (0,)),
    ("euler_from_quaternion", "quaternions.4.2"): Tie(_same_sine, (0,)),
    ("euler_from_quaternion", "quaternions.4.3"): Tie(element(2), (0,)),
    ("quaternion_from_euler", "quaternions.2.2"): Tie(_three_turns, (0,)),
    ("quaternion_from_axis_angle", "quaternions.2.2"): Tie(_axis_and_angle, (0,)),
    ("axis_angle_from_quaternion", "quaternions.2.2"): Tie(_back_from_axis_and_angle, (1, 0, 1)),
    ("quaternion_conjugate", "quaternions.3.c"): Tie(in_place_of(Conjugate(printed.Q))),
    ("rotate_to_inertial", "quaternions.3.1"): Tie(_seen_from_the_body),
    ("rotate_to_body", "quaternions.3.1"): Tie(_as_quaternion),
}
