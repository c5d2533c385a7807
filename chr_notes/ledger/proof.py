"""Does a statement hold? Symbolic proof, how it was made, and numeric failure at a point."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import product

from sympy import (
    Abs,
    Basic,
    Eq,
    Ge,
    Gt,
    Le,
    Limit,
    Lt,
    MatrixBase,
    N,
    Ne,
    Or,
    Set,
    Symbol,
    simplify,
)
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFalse, BooleanTrue

from chr_notes.ledger.condition import Condition
from chr_notes.ledger.evaluation import evaluate, parts, put, sides
from chr_notes.ledger.identities import (
    difference,
    equal,
    is_positive,
    is_zero,
    same_angle,
    shape_of,
)
from chr_notes.ledger.reading import Read
from chr_notes.ledger.vanishing import never_equal, some_cannot_vanish
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import Angle

FEW_CHARACTERS = 200
FEW_OPERATIONS = 60  # a longer formula is simplified for minutes


@dataclass(frozen=True)
class Finding:
    """What came of one relation, in one case of the conditions.

    Parameters
    ----------
    holds
        Whether it was proved.
    how
        What was done to prove it.
    left_over
        Says, when it was not proved, what is left between the two sides.
    """

    holds: bool
    how: str
    left_over: Callable[[], str] = str


def examine(statement: Basic, read: Read, *conditions: Condition) -> Iterator[Finding]:
    """Try to prove a statement, relation by relation and case by case.

    Parameters
    ----------
    statement
        Relation or conjunction of relations in a document's notation.
    read
        The meaning of that notation.
    conditions
        Restrict the values, all of them together.
    """
    relations = parts(statement)
    for number, part in enumerate(relations, 1):
        for by in _cases(conditions):
            where = f"part {number} of {len(relations)}, " if len(relations) > 1 else ""
            try:
                finding = _examined(part, read, by, conditions)
            except NotImplementedError:
                finding = Finding(
                    holds=False, how="", left_over=lambda: "a limit that SymPy cannot work out"
                )
            yield Finding(finding.holds, finding.how, _at(where, finding.left_over))


def _at(where: str, left_over: Callable[[], str]) -> Callable[[], str]:
    return lambda: where + left_over()


@lru_cache(maxsize=1024)
def proves(statement: Basic, read: Read, *conditions: Condition) -> bool:
    """Whether a statement holds for all values of its symbols, or for all that conditions allow."""
    return all(finding.holds for finding in examine(statement, read, *conditions))


def _cases(conditions: tuple[Condition, ...]) -> Iterator[Mapping[Basic, Basic]]:
    """Yield each choice of one case of every condition; the later ones narrow the earlier ones."""
    seen: list[Mapping[Basic, Basic]] = []
    for choice in product(*(condition.by for condition in conditions)):
        by: dict[Basic, Basic] = {}
        for case in choice:
            by |= {old: put(new, by) for old, new in case.items()}
        if by not in seen:
            seen.append(by)
            yield by


def _examined(
    relation: Basic, read: Read, by: Mapping[Basic, Basic], conditions: tuple[Condition, ...]
) -> Finding:
    if isinstance(relation, Eq):
        return _equality(relation, read, by)
    if isinstance(relation, Ne):
        holds = never_equal(relation, read, by, conditions)
        return Finding(
            holds,
            "a component of the difference cannot vanish",
            lambda: f"a component that cannot vanish was not seen in {_gap(relation, read, by)}",
        )
    if isinstance(relation, Approximately):
        return Finding(
            _within_its_digits(relation, read, by),
            "the number is computed with 30 digits and lies within half a unit of the last "
            "printed digit",
            lambda: f"computed it is {N(evaluate(relation.lhs, read, by), 6)}",
        )
    if isinstance(relation, Gt | Ge | Lt | Le):
        more, less = (evaluate(side, read, by) for side in (relation.gts, relation.lts))
        if is_positive(more - less):
            how = "the larger side less the smaller is a quotient of positive sums"
            return Finding(holds=True, how=how)
        if isinstance(relation, Gt | Lt) and isinstance(more - less, Abs):
            how = "the larger side less the smaller is a magnitude that cannot vanish"
            inside = (more - less).args
            return Finding(
                some_cannot_vanish(inside, read, by, conditions), how, lambda: _short(more - less)
            )
    simplified = simplify(evaluate(relation, read, by))
    return Finding(
        isinstance(simplified, BooleanTrue),
        "the statement simplifies to a truth",
        lambda: f"it comes to {_short(simplified)}",
    )


def _equality(relation: Eq, read: Read, by: Mapping[Basic, Basic]) -> Finding:
    left, right = sides(relation, read, by)
    limit = "the limit is worked out, and " if relation.has(Limit) else ""

    def gap() -> str:
        return f"left less right is {_gap(relation, read, by)}"

    if equal(left, right):
        return Finding(holds=True, how=limit + _why_equal(left, right), left_over=gap)
    # An equation for an angle holds up to whole turns.
    holds = isinstance(relation.lhs, Angle) and same_angle(left, right)
    how = "the difference of the two angles has the sine 0 and the cosine 1"
    return Finding(holds, limit + how, gap)


def _why_equal(left: Basic, right: Basic) -> str:
    if isinstance(left, Set):
        return "both sides are found to be the same set"
    if isinstance(left, MatrixBase):
        return "the difference of each pair of elements simplifies to zero"
    if left.is_number and right.is_number:
        return "both sides are the same number"
    if isinstance(left, Symbol) and left == right:
        return "both sides name the same thing"
    return "the difference of the two sides simplifies to zero"


def _gap(relation: Relational, read: Read, by: Mapping[Basic, Basic]) -> str:
    """Say what is left between two sides: the first element of the difference that is not zero."""
    left, right = sides(relation, read, by)
    if isinstance(left, Set) or isinstance(right, Set):
        return f"{left} against {right}"
    shapes = [shape_of(side) or "a number" for side in (left, right)]
    if shapes[0] != shapes[1]:
        return f"of different shapes, {shapes[0]} and {shapes[1]}"
    for place, element in enumerate(difference(left, right)):
        if not is_zero(element):
            where = ""
            if isinstance(left, MatrixBase):
                row, column = divmod(place, left.cols)
                where = f" in element ({row + 1}, {column + 1})"
            short = element.count_ops() < FEW_OPERATIONS
            return f"{_short(simplify(element) if short else element)}{where}"
    return "0"


def _short(expression: Basic) -> str:
    text = str(expression)
    return text if len(text) <= FEW_CHARACTERS else f"{text[:FEW_CHARACTERS]} …"


def _within_its_digits(relation: Approximately, read: Read, by: Mapping[Basic, Basic]) -> bool:
    quantity = N(evaluate(relation.lhs, read, by), 30)
    tells = relation.rhs != 0 or quantity == 0  # a zero in place of something tells nothing
    return bool(tells and abs(quantity - relation.rhs) <= relation.unit / 2)


def excludes(condition: Condition, point: Mapping[Basic, Basic]) -> bool:
    """Whether a point lies outside a condition."""
    alternatives = condition.holds.args if isinstance(condition.holds, Or) else (condition.holds,)
    return all(_fails_as_it_is(alternative, point) for alternative in alternatives)


def _fails_as_it_is(statement: Basic, point: Mapping[Basic, Basic]) -> bool:
    """Whether a statement in symbols that need no reading is false at a point."""
    there = statement.subs(point)
    if isinstance(there, BooleanFalse) or there.free_symbols:
        return isinstance(there, BooleanFalse)
    return fails(statement, Read({}, {}), point)


def fails(statement: Basic, read: Read, point: Mapping[Basic, Basic]) -> bool:
    """Whether a statement is false at a point; what SymPy cannot work out is not seen to be."""
    try:
        return any(_fails(part, read, point) for part in parts(statement))
    except NotImplementedError:
        return False


def _fails(relation: Basic, read: Read, point: Mapping[Basic, Basic]) -> bool:
    if isinstance(relation, Eq):
        return not _equality(relation, read, point).holds
    if isinstance(relation, Ne):
        return equal(*sides(relation, read, point))
    if isinstance(relation, Approximately):
        return not _within_its_digits(relation, read, point)
    if isinstance(relation, Relational):
        return isinstance(simplify(evaluate(relation, read, point)), BooleanFalse)
    msg = f"expected a relation, got {relation!r}"
    raise TypeError(msg)
