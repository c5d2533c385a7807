"""What the proofs accept, and what they must not."""

import pytest
from sympy import (
    Abs,
    Basic,
    Eq,
    Expr,
    FiniteSet,
    Function,
    Gt,
    Identity,
    ImmutableMatrix,
    Integer,
    Inverse,
    Limit,
    Lt,
    MatMul,
    MatrixSymbol,
    Ne,
    Or,
    Symbol,
    ZeroMatrix,
    asin,
    atan,
    atan2,
    cos,
    floor,
    nan,
    oo,
    pi,
    sin,
    symbols,
    tan,
)

from chr_notes.ledger.condition import Condition
from chr_notes.ledger.identities import equal, is_positive, is_zero, same_angle, settle
from chr_notes.ledger.proof import excludes, fails, proves
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import phi, psi, theta
from chr_notes.typeset import latex

s, d = symbols("s d", positive=True)
x = Symbol("x", real=True)


def same(expression: Basic) -> Basic:
    return expression


def test_zero_is_told_from_small() -> None:
    assert is_zero(sin(x) ** 2 + cos(x) ** 2 - 1)
    assert is_zero(Abs(sin(2 * x) - 2 * sin(x) * cos(x)))
    assert not is_zero(sin(x) ** 2 + cos(x) ** 2 - 1 + s / 10**12)
    assert not is_zero(sin(pi / 7) - sin(pi / 7 + pi / 10**12))


def test_magnitudes_are_equal_whatever_the_sign_inside() -> None:
    assert equal(Abs(x - s), Abs(s - x))
    assert not equal(Abs(x - s), Abs(x + s))


@pytest.mark.parametrize("undefined", [nan, tan(pi / 2)])
def test_what_is_undefined_equals_nothing(undefined: Basic) -> None:
    assert not equal(undefined, undefined + x)
    assert not equal(nan, nan)


def test_division_by_zero_is_seen() -> None:
    nothing = sin(pi / 7) ** 2 + cos(pi / 7) ** 2 - 1
    assert settle(x / (1 + s)) == x / (1 + s)
    assert settle(1 / nothing) is nan
    assert fails(Eq(x + 1, (x**2 - 1) / (x - 1), evaluate=False), same, {x: 1})


def test_angles_are_equal_up_to_whole_turns() -> None:
    assert same_angle(atan2(sin(psi), cos(psi)), psi)
    assert same_angle(phi, phi + 2 * pi)
    assert not same_angle(phi, phi + pi)
    assert not same_angle(atan2(cos(psi), sin(psi)), psi)
    assert not same_angle(asin(sin(theta)), theta)
    assert not same_angle(atan(tan(phi)), phi)
    assert proves(Eq(psi, atan2(s * sin(psi), s * cos(psi))), same)
    assert fails(Eq(phi, atan(tan(phi)), evaluate=False), same, {phi: 5 * pi / 6})


def test_only_angles_are_equal_up_to_whole_turns() -> None:
    assert not proves(Eq(x, x + 2 * pi, evaluate=False), same)


def test_a_range_puts_the_angle_on_its_branch() -> None:
    statement = Eq(phi, atan(sin(phi) / cos(phi)), evaluate=False)
    assert not proves(statement, same)
    assert proves(statement, same, Condition(Lt(Abs(phi), pi / 2)))


def test_inequalities_need_all_terms_of_one_sign() -> None:
    assert is_positive(1 / s - 1 / (s + d))
    assert is_positive(-1 / (-s - d))
    assert not is_positive(s - d)
    assert not is_positive(x**2 - 2 * x + s)
    assert proves(Gt(1 / s, 1 / (s + d)), same)
    assert not proves(Lt(1 / s, 1 / (s + d)), same)


def test_a_floor_is_worked_out_between_two_integers() -> None:
    part = s / (1 + s)
    assert settle(floor(part)) == 0
    assert settle(floor(3 + part)) == 3
    assert settle(floor(-part)) == floor(-s / (s + 1))  # it may come arbitrarily close to -1
    assert settle(floor(2 * part)) == floor(2 * s / (s + 1))


def test_what_a_condition_excludes_is_not_zero() -> None:
    condition = Condition(Ne(cos(x), 1))
    assert proves(Ne(s * (1 - cos(x)), 0), same, condition)
    assert not proves(Ne(s * (1 - cos(x)), 0), same)
    assert not proves(Ne(x * (1 - cos(x)), 0), same, condition)


def test_each_way_to_meet_a_condition_must_do() -> None:
    either = Condition(Or(Ne(x, 1), Ne(sin(x), s), evaluate=False))
    pair = ImmutableMatrix([x, sin(x)])
    assert proves(Ne(pair, ImmutableMatrix([1, s])), same, either)
    assert proves(Ne(ImmutableMatrix([1, s]), pair), same, either)
    assert not proves(Ne(pair, ImmutableMatrix([1, d])), same, either)
    assert not proves(Ne(pair, ImmutableMatrix([1, s])), same)


def test_sets_differ_by_an_element() -> None:
    one, other = FiniteSet(0, pi), FiniteSet(pi / 2)
    assert proves(Ne(one, other), same)
    assert proves(Ne(FiniteSet(0, pi / 2), other), same)
    assert not proves(Ne(one, FiniteSet(pi, 0), evaluate=False), same)
    assert not proves(Ne(FiniteSet(x), FiniteSet(0)), same), "x may be 0"


def test_conditions_hold_together() -> None:
    first, second = Condition(Eq(x, 1)), Condition(Eq(s, 2))
    assert proves(Eq(x * s, 2), same, first, second)
    assert not proves(Eq(x * s, 2), same, first)


def test_a_zero_in_place_of_something_tells_nothing() -> None:
    assert not proves(Approximately(Integer(49), "0 e 3"), same)
    assert proves(Approximately(Integer(0), "0"), same)


@pytest.mark.parametrize(
    ("printed", "right"),
    [("0.017", "0.01749"), ("17", "17.5"), ("220 e 3", "219500"), ("1.1 e 6", "1.149e6")],
)
def test_a_number_holds_within_half_its_last_digit(printed: str, right: str) -> None:
    quantity = Symbol("r")
    statement = Approximately(quantity, printed)
    value = Approximately(quantity, right).rhs
    off = statement.unit / 2 + statement.unit / 1000
    for sign in (1, -1):
        wrong = {quantity: statement.rhs + sign * off}
        assert not proves(statement.subs(wrong), same)
        assert fails(statement, same, wrong)
    assert proves(statement.subs({quantity: value}), same)
    assert not fails(statement, same, {quantity: value})


def test_a_number_is_typeset_as_printed() -> None:
    assert latex(Approximately(Symbol("r"), "220 e 3")) == r"r \approx 220 \times 10^{3}"
    assert latex(Approximately(Symbol("r"), "2.0")) == r"r \approx 2.0"


@pytest.mark.parametrize(
    "identity",
    [
        sin(x) - 2 * sin(x / 2) * cos(x / 2),
        cos(3 * x) - 4 * cos(x) ** 3 + 3 * cos(x),
        sin(x - s) - sin(x) * cos(s) + cos(x) * sin(s),
        tan(2 * x) * (1 - tan(x) ** 2) - 2 * tan(x),
        cos(x + pi / 5) - cos(x) * cos(pi / 5) + sin(x) * sin(pi / 5),
        cos(-x / 3 + 2 * s) ** 2 + sin(x / 3 - 2 * s) ** 2 - 1,
    ],
)
def test_sums_and_parts_of_angles_are_related(identity: Expr) -> None:
    assert is_zero(identity)
    assert not is_zero(identity + sin(x) / 10**12)


def test_elements_of_a_matrix_count_once_the_matrix_as_a_whole_is_used() -> None:
    whole, vector = MatrixSymbol("M", 3, 3), MatrixSymbol("v", 3, 1)
    back = MatMul(Inverse(whole), whole, vector)
    assert proves(Eq(back, vector), same)
    assert not proves(Eq(MatMul(whole, whole, vector), vector), same)
    assert proves(Eq(MatMul(whole, vector + back), MatMul(2, whole, vector)), same)
    assert fails(Eq(MatMul(whole, vector), vector), same, {whole: 2 * Identity(3)})


def test_a_point_lies_outside_a_condition() -> None:
    vector, number = MatrixSymbol("v", 2, 1), Symbol("n", real=True)
    either = Condition(Or(Eq(vector, ZeroMatrix(2, 1)), Gt(number, 3)))
    assert excludes(either, {vector: ImmutableMatrix([0, 1]), number: 3})
    assert not excludes(either, {vector: ImmutableMatrix([0, 1]), number: 4})
    assert not excludes(either, {vector: ImmutableMatrix([0, 0]), number: 3})
    assert not excludes(either, {vector: ImmutableMatrix([0, 1])}), "the number is open"


def test_a_limit_that_is_not_worked_out_proves_nothing() -> None:
    unknown = Function("f")
    assert not proves(Eq(Limit(unknown(x) ** unknown(x), x, oo), 0), same)
