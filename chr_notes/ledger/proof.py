"""Does a statement hold? Symbolic proof, and numeric failure at a point."""

from collections.abc import Mapping

from sympy import (
    And,
    Basic,
    Dummy,
    Eq,
    MatrixBase,
    Ne,
    Rational,
    S,
    Set,
    cancel,
    cos,
    simplify,
    sin,
    tan,
    together,
)
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFalse, BooleanTrue
from sympy.matrices.expressions.matexpr import MatrixExpr

from chr_notes.ledger.case import Condition, Read

CLEARLY_NOT_ZERO = 1e-15  # against values computed with 30 digits


def parts(statement: Basic) -> tuple[Basic, ...]:
    """Split a conjunction into its relations."""
    return statement.args if isinstance(statement, And) else (statement,)


def evaluate(expression: Basic, read: Read, by: Mapping[Basic, Basic]) -> Basic:
    """Put the derived quantities in place of the document's symbols and work the result out."""
    # A condition may speak of the document's symbols or of the derived ones: before and after.
    meaning = read(expression.subs(by)).subs(by).doit()
    return meaning.as_explicit() if isinstance(meaning, MatrixExpr) else meaning


def sides(relation: Basic, read: Read, by: Mapping[Basic, Basic]) -> tuple[Basic, Basic]:
    """Evaluate the left and the right side of a relation, each on its own."""
    left, right = (evaluate(side, read, by) for side in (relation.lhs, relation.rhs))
    return left, right


def difference(left: Basic, right: Basic) -> tuple[Basic, ...]:
    """Take left minus right, element by element, not yet simplified."""
    if isinstance(left, MatrixBase) != isinstance(right, MatrixBase):
        msg = f"expected two matrices or two scalars, got {left} and {right}"
        raise TypeError(msg)
    return tuple(left - right) if isinstance(left, MatrixBase) else (left - right,)


def is_zero(expression: Basic) -> bool:
    """Whether an expression vanishes for all values of its symbols.

    A value clearly off zero settles that it does not. Otherwise it is made rational: sine and
    cosine of each angle are put through the tangent of its half, which loses nothing, and the
    fraction is cancelled. What is not rational then is left to SymPy's `simplify`.
    """
    if expression.is_Number or not expression.free_symbols:
        return bool(simplify(expression) == 0)
    names = sorted(expression.free_symbols, key=str)
    point = {name: Rational(2 * index + 3, 7 * index + 11) for index, name in enumerate(names)}
    value = expression.subs(point).evalf(30, chop=False)
    if value.is_Float and abs(value) > CLEARLY_NOT_ZERO:
        return False
    halves = {
        angle: Dummy(f"t_{index}", real=True)
        for index, angle in enumerate(sorted(expression.atoms(sin, cos, tan), key=str))
        for angle in angle.args
    }
    rational = expression.replace(tan, lambda x: sin(x) / cos(x))
    rational = rational.replace(sin, lambda x: 2 * halves[x] / (1 + halves[x] ** 2))
    rational = rational.replace(cos, lambda x: (1 - halves[x] ** 2) / (1 + halves[x] ** 2))
    return bool(cancel(together(rational)) == 0 or simplify(expression) == 0)


def equal(left: Basic, right: Basic) -> bool:
    """Whether two objects are the same: sets and names as such, formulas by their difference."""
    if left == right:
        return True
    if isinstance(left, Set) or isinstance(right, Set):
        return bool(left == right)
    if left in (S.Infinity, S.NegativeInfinity) or right in (S.Infinity, S.NegativeInfinity):
        return False
    return all(is_zero(element) for element in difference(left, right))


def proves(statement: Basic, read: Read, condition: Condition | None = None) -> bool:
    """Whether a statement holds for all values of its symbols, or for all that a condition allows.

    Parameters
    ----------
    statement
        Relation or conjunction of relations in a document's notation.
    read
        The meaning of that notation.
    condition
        Restricts the values.
    """
    cases = condition.by if condition else ({},)
    return all(_holds(part, read, by, condition) for part in parts(statement) for by in cases)


def _holds(
    relation: Basic, read: Read, by: Mapping[Basic, Basic], condition: Condition | None
) -> bool:
    if isinstance(relation, Eq):
        return equal(*sides(relation, read, by))
    if isinstance(relation, Ne):
        return _never_equal(relation, read, condition)
    return isinstance(simplify(evaluate(relation, read, by)), BooleanTrue)


def _never_equal(relation: Ne, read: Read, condition: Condition | None) -> bool:
    """Whether some component of the difference is one that is, or is presumed to be, not zero."""
    components = difference(*sides(relation, read, {}))
    if any(component.is_nonzero for component in components):
        return True
    if condition is None or not isinstance(condition.holds, Ne):
        return False
    excluded = condition.holds.lhs - condition.holds.rhs
    return any(is_zero(component - sign * excluded) for component in components for sign in (1, -1))


def fails(statement: Basic, read: Read, point: Mapping[Basic, Basic]) -> bool:
    """Whether a statement is false at a point."""
    return any(_fails(part, read, point) for part in parts(statement))


def _fails(relation: Basic, read: Read, point: Mapping[Basic, Basic]) -> bool:
    if isinstance(relation, Eq | Ne):
        same = equal(*sides(relation, read, point))
        return same if isinstance(relation, Ne) else not same
    if isinstance(relation, Relational):
        return isinstance(simplify(evaluate(relation, read, point)), BooleanFalse)
    msg = f"expected a relation, got {relation!r}"
    raise TypeError(msg)
