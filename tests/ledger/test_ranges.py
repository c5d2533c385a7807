"""The substitutions of a range reach all of it, and nothing beyond."""

from collections.abc import Mapping

import pytest
from sympy import Basic, Expr, N, Rational, Symbol, pi, solve, sympify
from sympy.logic.boolalg import BooleanTrue

from chr_notes.ledger import ranges
from chr_notes.ledger.case import Condition
from chr_notes.symbols import Angle, phi, theta

LESS, MORE = Symbol("L_1", real=True), Symbol("L_2", real=True)
END = Angle("end", real=True)
TENTH = Rational(1, 10)

RANGES = {
    "acute": (ranges.acute(phi, theta), [{phi: 1, theta: -1}, {phi: -TENTH, theta: 0}]),
    "right angle": (
        ranges.up_to_right_angle(theta),
        [{theta: v} for v in (-pi / 2, -1, 0, pi / 2)],
    ),
    "short turn": (ranges.short_turn(phi, END), [{phi: 0, END: v} for v in (-pi, -3, 0, 3)]),
    "fractions": (
        ranges.proper_fractions(LESS, MORE),
        [{LESS: TENTH, MORE: 9 * TENTH}, {LESS: TENTH / 100, MORE: TENTH / 50}],
    ),
    "0 to 1": (ranges.from_0_to_1(LESS), [{LESS: v} for v in (0, TENTH, 9 * TENTH, 1)]),
    "above 0 to 1": (ranges.above_0_to_1(LESS), [{LESS: v} for v in (TENTH, 9 * TENTH, 1)]),
}
BEYOND = {
    "acute": [{phi: pi / 2, theta: 0}, {phi: 0, theta: 2}],
    "right angle": [{theta: 2}, {theta: -pi}],
    "short turn": [{phi: 0, END: pi}, {phi: 0, END: -4}, {phi: 0, END: 4}],
    "fractions": [{LESS: 0, MORE: TENTH}, {LESS: TENTH, MORE: TENTH}, {LESS: TENTH, MORE: 1}],
    "0 to 1": [{LESS: -TENTH}, {LESS: 1 + TENTH}],
    "above 0 to 1": [{LESS: 0}, {LESS: 1 + TENTH}],
}
INSIDE = [(name, point) for name, (_, points) in RANGES.items() for point in points]
OUTSIDE = [(name, point) for name, points in BEYOND.items() for point in points]


def reaches(condition: Condition, point: Mapping[Basic, Expr]) -> bool:
    """Whether some substitution gives the point for some values of its own symbols."""
    return any(_solvable(by, point) for by in condition.by)


def _solvable(by: Mapping[Basic, Expr], point: Mapping[Basic, Expr]) -> bool:
    equations = [sympify(new).subs(point) - point[old] for old, new in by.items()]
    free = sorted(set().union(*(equation.free_symbols for equation in equations)), key=str)
    if not free:
        return all(equation == 0 for equation in equations)
    return any(
        all(abs(N(equation.subs(solution))) < 1e-12 for equation in equations)
        for solution in solve(equations, free, dict=True)
    )


@pytest.mark.parametrize(("name", "point"), INSIDE)
def test_what_lies_in_a_range_is_reached(name: str, point: Mapping[Basic, Expr]) -> None:
    condition = RANGES[name][0]
    assert isinstance(condition.holds.subs(point), BooleanTrue)
    assert reaches(condition, point)


@pytest.mark.parametrize(("name", "point"), OUTSIDE)
def test_what_lies_beyond_is_not(name: str, point: Mapping[Basic, Expr]) -> None:
    condition = RANGES[name][0]
    assert not isinstance(condition.holds.subs(point), BooleanTrue)
    assert not reaches(condition, point)
