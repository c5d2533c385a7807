"""The substitutions of each rule reach all that its condition allows."""

from collections.abc import Mapping

import pytest
from sympy import (
    Abs,
    And,
    Basic,
    Eq,
    Expr,
    Gt,
    ImmutableMatrix,
    Le,
    Lt,
    N,
    Ne,
    Or,
    Rational,
    cos,
    pi,
    sin,
    solve,
    sqrt,
    symbols,
    sympify,
)
from sympy.logic.boolalg import Boolean

from chr_notes.ledger import ranges
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.identities import OnSphere
from chr_notes.ledger.proof import proves
from chr_notes.ledger.reading import Read
from chr_notes.ledger.rules import RULES, substitutions
from chr_notes.symbols import Angle, phi, theta

x, y, LESS, MORE = symbols("x y L_1 L_2", real=True)
END = Angle("end", real=True)
TENTH = Rational(1, 10)
VECTOR = ImmutableMatrix([x, y])

# For each rule of the table conditions, and points within each of them.
WITHIN: dict[str, list[tuple[Boolean, list[Mapping[Basic, Expr]]]]] = {
    "sphere": [
        (Eq(x**2 + y**2, 1), [{x: Rational(3, 5), y: Rational(-4, 5)}, {x: 0, y: 1}]),
    ],
    "equality": [
        (Eq(x, y + 1), [{x: 2, y: 1}]),
        (Eq(VECTOR, ImmutableMatrix([1, 2])), [{x: 1, y: 2}]),
    ],
    "size": [(Eq(Abs(theta), pi / 2), [{theta: pi / 2}, {theta: -pi / 2}])],
    "short of a right angle": [
        (ranges.acute(phi, theta).holds, [{phi: 1, theta: -1}, {phi: -TENTH, theta: 0}])
    ],
    "up to a right angle": [
        (ranges.up_to_right_angle(theta).holds, [{theta: v} for v in (-pi / 2, -1, 0, pi / 2)])
    ],
    "chain": [
        (
            ranges.proper_fractions(LESS, MORE).holds,
            [{LESS: TENTH, MORE: 9 * TENTH}, {LESS: TENTH / 100, MORE: TENTH / 50}],
        )
    ],
    "fraction": [
        (ranges.from_0_to_1(LESS).holds, [{LESS: v} for v in (0, TENTH, 9 * TENTH, 1)]),
        (ranges.above_0_to_1(LESS).holds, [{LESS: v} for v in (TENTH, 9 * TENTH, 1)]),
    ],
    "between": [
        (ranges.short_turn(phi, END).holds, [{phi: 0, END: v} for v in (-pi, -3, 0, 3)]),
        (And(Gt(x, 1), Le(x, 3)), [{x: v} for v in (1 + TENTH, 2, 3)]),
    ],
    "one-sided": [
        (Gt(x, 2), [{x: 2 + TENTH}, {x: 9}]),
        (Le(x - y, 2), [{x: 2, y: 0}, {x: -5, y: 9}]),
        (Lt(x, y), [{x: -2, y: 0}]),
    ],
    "cosine not one": [(Ne(cos(x), 1), [{x: 1}, {x: pi}])],
    "not zero": [(Ne(x, 0), [{x: 1}, {x: -3}]), (Ne(sin(x), 0), [{x: 1}, {x: -1}])],
    "unequal": [(Ne(x, y), [{x: 1, y: 2}])],
}
POINTS = [(holds, point) for rows in WITHIN.values() for holds, points in rows for point in points]


def reaches(holds: Boolean, point: Mapping[Basic, Expr]) -> bool:
    """Whether some case of a condition's substitutions takes the values of a point."""
    return any(_solvable(by, point) for by in substitutions(holds))


def _solvable(by: Mapping[Basic, Expr], point: Mapping[Basic, Expr]) -> bool:
    new = {name: OnSphere(name.name, ("x", "y")) for name in (x, y)}
    spheres = {new[name]: value for name, value in point.items() if name in new}
    equations = [
        sympify(value).subs(spheres).subs(point) - sympify(old).subs(point)
        for old, value in by.items()
    ]
    free = sorted(set().union(*(equation.free_symbols for equation in equations)), key=str)
    if not free:
        return all(equation == 0 for equation in equations)
    return any(
        all(abs(N(equation.subs(solution))) < 1e-12 for equation in equations)
        for solution in solve(equations, free, dict=True)
    )


def test_every_rule_is_tried_here() -> None:
    assert WITHIN.keys() == RULES.keys()


@pytest.mark.parametrize(("holds", "point"), POINTS)
def test_what_lies_within_is_reached(holds: Boolean, point: Mapping[Basic, Expr]) -> None:
    assert reaches(holds, point)


@pytest.mark.parametrize("name", RULES)
def test_each_rule_is_the_one_that_applies(name: str) -> None:
    for holds, _ in WITHIN[name]:
        relations = holds.args if isinstance(holds, And) else (holds,)
        group = relations if name in ("chain", "fraction", "between") else relations[:1]
        first = next(rule for rule, gives in RULES.items() if gives(group) is not None)
        assert first == name


@pytest.mark.parametrize(
    ("holds", "point"),
    [
        (ranges.acute(phi, theta).holds, {phi: pi / 2, theta: 0}),
        (ranges.acute(phi, theta).holds, {phi: 0, theta: 2}),
        (ranges.short_turn(phi, END).holds, {phi: 0, END: pi}),
        (ranges.short_turn(phi, END).holds, {phi: 0, END: -4}),
        (ranges.proper_fractions(LESS, MORE).holds, {LESS: TENTH, MORE: TENTH}),
        (ranges.above_0_to_1(LESS).holds, {LESS: 0}),
        (ranges.from_0_to_1(LESS).holds, {LESS: 1 + TENTH}),
        (Gt(x, 2), {x: 2}),
    ],
)
def test_what_lies_beyond_is_not(holds: Boolean, point: Mapping[Basic, Expr]) -> None:
    assert not reaches(holds, point)


def test_one_of_several_conditions_is_enough() -> None:
    either = substitutions(Or(Eq(x, 1), Gt(x, 3), evaluate=False))
    assert len(either) == 2
    assert {x: 1} in either


def test_a_condition_without_a_rule_is_refused() -> None:
    with pytest.raises(ValueError, match="no rule for the condition"):
        substitutions(Lt(Abs(phi), 3 * pi / 4))
    with pytest.raises(ValueError, match="no rule"):
        substitutions(And(Gt(x, 0), Ne(x, 1), evaluate=False))


def test_squares_that_add_up_to_one_are_used_in_every_form() -> None:
    unit = Condition(Eq(x**2 + y**2, 1))
    same = Read({}, {})
    assert proves(Eq(x**4 + 2 * x**2 * y**2 + y**4, 1), same, unit)
    assert proves(Eq(x**3 + x * y**2, x), same, unit)
    assert not proves(Eq(x**4 + y**4, 1), same, unit)
    assert not proves(Eq(y, sqrt(1 - x**2)), same, unit)
