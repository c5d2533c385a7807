"""Does a statement hold? Symbolic proof, and numeric failure at a point."""

from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import product

from sympy import (
    And,
    Basic,
    Eq,
    Expr,
    Float,
    Ge,
    Gt,
    Le,
    Limit,
    Lt,
    MatrixBase,
    N,
    Ne,
    Or,
    Pow,
    Rational,
    S,
    Subs,
    Symbol,
    cancel,
    expand,
    simplify,
    sympify,
)
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFalse, BooleanTrue
from sympy.matrices.expressions.matexpr import MatrixElement, MatrixExpr

from chr_notes.ledger.case import Condition, Read
from chr_notes.ledger.identities import difference, equal, is_positive, is_zero, same_angle, settle
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import Angle
from chr_notes.typeset import latex


def parts(statement: Basic) -> tuple[Basic, ...]:
    """Split a conjunction into its relations."""
    return statement.args if isinstance(statement, And) else (statement,)


def ordered(expression: Basic) -> Basic:
    """Let SymPy order what stands as printed; a decimal is the fraction that it says."""
    if isinstance(expression, Float):
        return Rational(str(expression))
    return expression.func(*map(ordered, expression.args)) if expression.args else expression


def put(expression: Basic, by: Mapping[Basic, Basic]) -> Basic:
    """Substitute; a point of many numbers at once, where no symbol is bound."""
    numbers = all(isinstance(old, Symbol) and sympify(new).is_number for old, new in by.items())
    if numbers and not expression.has(Limit, ExprWithLimits, Subs):
        return expression.xreplace({old: sympify(new) for old, new in by.items()})
    return expression.subs(by)


def work_out(expression: Basic, read: Read, by: Mapping[Basic, Basic]) -> Basic:
    """Put the derived quantities in place of the document's symbols, matrices as a whole."""
    # A condition may speak of the document's symbols or of the derived ones: before and after.
    meaning = put(read(put(ordered(expression), by)), by).doit()
    return expand(meaning).doit() if isinstance(meaning, MatrixExpr) else meaning


def evaluate(expression: Basic, read: Read, by: Mapping[Basic, Basic]) -> Basic:
    """Put the derived quantities in place of the document's symbols, element by element."""
    return _evaluated(expression, read, tuple(by.items()))


@lru_cache(maxsize=256)
def _evaluated(expression: Basic, read: Read, pairs: tuple[tuple[Basic, Basic], ...]) -> Basic:
    by = dict(pairs)
    divisors = (power.base for power in expression.atoms(Pow) if power.exp.is_negative)
    if not expression.is_Matrix and any(is_zero(work_out(part, read, by)) for part in divisors):
        return S.NaN
    meaning = work_out(expression, read, by)
    if isinstance(meaning, MatrixExpr):
        meaning = meaning.as_explicit()
    # What is known of a matrix as a whole is used by now; its elements are numbers like others.
    meaning = meaning.xreplace(
        {element: Symbol(latex(element), real=True) for element in meaning.atoms(MatrixElement)}
    )
    return meaning.applyfunc(settle) if isinstance(meaning, MatrixBase) else settle(meaning)


def sides(relation: Basic, read: Read, by: Mapping[Basic, Basic]) -> tuple[Basic, Basic]:
    """Evaluate the left and the right side of a relation, each on its own."""
    left, right = (evaluate(side, read, by) for side in (relation.lhs, relation.rhs))
    return left, right


def proves(statement: Basic, read: Read, *conditions: Condition) -> bool:
    """Whether a statement holds for all values of its symbols, or for all that conditions allow.

    Parameters
    ----------
    statement
        Relation or conjunction of relations in a document's notation.
    read
        The meaning of that notation.
    conditions
        Restrict the values, all of them together.
    """
    try:
        return all(
            _holds(part, read, by, conditions)
            for part in parts(statement)
            for by in _cases(conditions)
        )
    except NotImplementedError:  # a limit that SymPy cannot work out proves nothing
        return False


def _cases(conditions: tuple[Condition, ...]) -> Iterator[Mapping[Basic, Basic]]:
    """Yield each choice of one case of every condition; the later ones narrow the earlier ones."""
    seen: list[Mapping[Basic, Basic]] = []
    for choice in product(*(condition.by for condition in conditions)):
        by = {old: new for case in choice for old, new in case.items()}
        if by not in seen:
            seen.append(by)
            yield by


def _holds(
    relation: Basic, read: Read, by: Mapping[Basic, Basic], conditions: tuple[Condition, ...]
) -> bool:
    if isinstance(relation, Eq):
        return _equal(relation, read, by)
    if isinstance(relation, Ne):
        return _never_equal(relation, read, by, conditions)
    if isinstance(relation, Approximately):
        return _within_its_digits(relation, read, by)
    if isinstance(relation, Gt | Ge | Lt | Le):
        more, less = (evaluate(side, read, by) for side in (relation.gts, relation.lts))
        if is_positive(more - less):
            return True
    return isinstance(simplify(evaluate(relation, read, by)), BooleanTrue)


def _equal(relation: Eq, read: Read, by: Mapping[Basic, Basic]) -> bool:
    left, right = sides(relation, read, by)
    # An equation for an angle holds up to whole turns.
    return equal(left, right) or (isinstance(relation.lhs, Angle) and same_angle(left, right))


def _within_its_digits(relation: Approximately, read: Read, by: Mapping[Basic, Basic]) -> bool:
    off = N(evaluate(relation.lhs, read, by) - relation.rhs, 30)
    return bool(abs(off) <= relation.unit / 2)


def _never_equal(
    relation: Ne, read: Read, by: Mapping[Basic, Basic], conditions: tuple[Condition, ...]
) -> bool:
    """Whether some component of the difference is one that is, or is presumed to be, not zero."""
    components = difference(*sides(relation, read, by))
    excluded = [
        evaluate(condition.holds.lhs - condition.holds.rhs, read, by)
        for condition in conditions
        if isinstance(condition.holds, Ne)
    ]
    return any(
        component.is_nonzero
        or is_positive(component)
        or is_positive(-component)
        or any(_nonzero_multiple(component, other) for other in excluded)
        for component in components
    )


def _nonzero_multiple(component: Expr, excluded: Expr) -> bool:
    """Whether a component vanishes only where the excluded expression does."""
    factor = cancel(component / excluded)
    return bool(factor.is_nonzero and is_zero(component - factor * excluded))


def excludes(condition: Condition, point: Mapping[Basic, Basic]) -> bool:
    """Whether a point lies outside a condition."""
    alternatives = condition.holds.args if isinstance(condition.holds, Or) else (condition.holds,)
    return all(_fails_as_it_is(alternative, point) for alternative in alternatives)


def _fails_as_it_is(statement: Basic, point: Mapping[Basic, Basic]) -> bool:
    """Whether a statement in symbols that need no reading is false at a point."""
    there = statement.subs(point)
    if isinstance(there, BooleanFalse) or there.free_symbols:
        return isinstance(there, BooleanFalse)
    return fails(statement, lambda expression: expression, point)


def fails(statement: Basic, read: Read, point: Mapping[Basic, Basic]) -> bool:
    """Whether a statement is false at a point."""
    return any(_fails(part, read, point) for part in parts(statement))


def _fails(relation: Basic, read: Read, point: Mapping[Basic, Basic]) -> bool:
    if isinstance(relation, Eq):
        return not _equal(relation, read, point)
    if isinstance(relation, Ne):
        return equal(*sides(relation, read, point))
    if isinstance(relation, Approximately):
        return not _within_its_digits(relation, read, point)
    if isinstance(relation, Relational):
        return isinstance(simplify(evaluate(relation, read, point)), BooleanFalse)
    msg = f"expected a relation, got {relation!r}"
    raise TypeError(msg)
