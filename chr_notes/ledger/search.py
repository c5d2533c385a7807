"""Is a condition exact? A search outside it for points at which the statement holds as well."""

from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import product
from random import Random

from sympy import (
    Abs,
    And,
    Basic,
    Eq,
    Expr,
    Ge,
    Gt,
    Le,
    Lt,
    MatrixBase,
    MatrixSymbol,
    N,
    Ne,
    Or,
    Rational,
    Symbol,
    pi,
    solve,
    sympify,
)
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean, BooleanFalse, BooleanTrue

from chr_notes.ledger.case import Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.evaluation import parts
from chr_notes.ledger.proof import fails
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import Angle

Point = Mapping[Basic, Basic]

POINTS = 6  # for each way of not meeting the condition
TRIES = 400
SPECIAL = 0.3  # of the angles drawn are right ones, or none; of the numbers, 0 or 1
RIGHT_ANGLES = (0, pi / 2, -pi / 2, pi)


def is_exact(case: Case, condition: Condition) -> bool:
    """Whether a statement fails at all points that are found outside its condition.

    The points come from random numbers that are the same each time. Where the condition excludes
    single values only, these are solved for.
    """
    return not any(_holds(case, point) for point in outside(case, condition))


def outside(case: Case, condition: Condition) -> Iterator[Point]:
    """Yield points within what is given and outside the condition."""
    names = _names(case, condition)
    random = Random(case.id)  # noqa: S311 (the same points each time, no secret)
    given = And(*(each.holds for each in case.given), evaluate=False)
    for inside, beyond in product(_alternatives(given), _alternatives(_negated(condition.holds))):
        yield from _points((*inside, *beyond), names, random)


def is_met_somewhere(case: Case) -> bool:
    """Whether a point is found that meets the condition of a case and what is given, inside."""
    conditions = (*case.given, *((case.condition,) if case.condition is not None else ()))
    names = sorted(set().union(*(each.holds.free_symbols for each in conditions)), key=str)
    random = Random(case.id)  # noqa: S311 (the same points each time, no secret)
    wanted = And(*(each.holds for each in conditions), evaluate=False)
    plain = [name for name in names if isinstance(name, Symbol)]
    ways = (tuple(map(_strictly, way)) for way in _alternatives(wanted))
    return any(True for way in ways for _ in _points(way, plain, random))


def _strictly(relation: Relational) -> Relational:
    """Leave out the ends: bounds that leave nothing between them say that two things are equal."""
    kind = {Ge: Gt, Le: Lt}.get(type(relation))
    return relation if kind is None else kind(*relation.args, evaluate=False)


def _holds(case: Case, point: Point) -> bool:
    return not fails(case.printed.statement, case.reading, point)


def _names(case: Case, condition: Condition) -> list[Symbol]:
    found = condition.holds.free_symbols.union(*(each.holds.free_symbols for each in case.given))
    for part in parts(case.printed.statement):
        found |= case.reading(part.lhs).free_symbols
        if not isinstance(part, Approximately):
            found |= case.reading(part.rhs).free_symbols
    return sorted((name for name in found if isinstance(name, Symbol)), key=str)


def _negated(statement: Boolean) -> Boolean:
    """Turn a condition round, the relations between matrices element by element."""
    if isinstance(statement, And | Or):
        other = Or if isinstance(statement, And) else And
        return other(*map(_negated, statement.args), evaluate=False)
    if isinstance(statement.lhs, MatrixBase):
        pairs = zip(statement.lhs, statement.rhs, strict=True)
        return Or(*(Ne(*pair, evaluate=False) for pair in pairs), evaluate=False)
    return statement.negated


def _alternatives(statement: Boolean) -> Iterator[tuple[Relational, ...]]:
    """Yield each way to meet a condition, as relations that hold together."""
    if isinstance(statement, Or):
        for part in statement.args:
            yield from _alternatives(part)
    elif isinstance(statement, And):
        for choice in product(*map(_alternatives, statement.args)):
            yield tuple(relation for relations in choice for relation in relations)
    elif isinstance(statement, BooleanTrue):
        yield ()
    elif isinstance(statement, Eq) and isinstance(statement.lhs, MatrixBase):
        pairs = zip(statement.lhs, statement.rhs, strict=True)
        yield tuple(Eq(*pair, evaluate=False) for pair in pairs)
    elif isinstance(statement, Eq) and isinstance(statement.lhs, MatrixSymbol):
        yield ()  # a name for a whole matrix can be met by any
    elif isinstance(statement, Eq) and isinstance(statement.lhs, Abs):
        for sign in (1, -1):
            yield (Eq(statement.lhs.args[0], sign * statement.rhs, evaluate=False),)
    else:
        yield (statement,)


def _points(
    relations: tuple[Relational, ...], names: list[Symbol], random: Random
) -> Iterator[Point]:
    """Yield points at which relations hold: equations are solved, the rest is tried."""
    equations = [relation for relation in relations if isinstance(relation, Eq)]
    others = [relation for relation in relations if not isinstance(relation, Eq)]
    solved_for = set().union(*(equation.free_symbols for equation in equations))
    early = [relation for relation in others if not relation.free_symbols & solved_for]
    found = 0
    for _ in range(TRIES):
        point = {name: _value(name, random) for name in names}
        if (
            all(_true(relation, point) for relation in early)
            and all(_solve(equation, point, random) for equation in equations)
            and all(_true(relation, point) for relation in others)
        ):
            yield point
            found += 1
        if found == POINTS:
            return


def _value(name: Symbol, random: Random) -> Expr:
    """Draw a value that a symbol may have; special ones are more frequent than they are."""
    if isinstance(name, Angle):
        if random.random() < SPECIAL:
            return sympify(random.choice(RIGHT_ANGLES))
        return Rational(random.randint(-31, 31), 10)
    if name.is_integer:
        return Rational(random.randint(1, 6))
    if name.is_nonnegative:
        return Rational(random.randint(1, 30), 10)
    if random.random() < SPECIAL:
        return sympify(random.choice((0, 1)))
    size = random.choice((10, 30))
    return Rational(random.randint(-size, size), 10)


def _solve(equation: Eq, point: dict[Basic, Basic], random: Random) -> bool:
    """Change one symbol of a point such that an equation holds there."""
    difference = equation.lhs - equation.rhs
    names = sorted(difference.free_symbols, key=str)
    random.shuffle(names)
    for name in names:
        others = {other: value for other, value in point.items() if other != name}
        roots = [root for root in _roots(difference.subs(others), name) if root.is_real]
        if roots:
            point[name] = roots[random.randrange(len(roots))]
            return True
    return False


@lru_cache(maxsize=64)
def _roots(left_over: Expr, name: Symbol) -> tuple[Expr, ...]:
    """Find where an expression vanishes; a straight line needs no search."""
    slope = left_over.diff(name)
    if slope.is_Rational and slope != 0:
        return (-left_over.subs(name, 0) / slope,)
    return tuple(solve(left_over, name))


def _true(relation: Relational, point: Point) -> bool:
    there = relation.subs(point)
    if not isinstance(there, BooleanTrue | BooleanFalse):
        there = there.func(*(N(side) for side in there.args))
    return isinstance(there, BooleanTrue)
