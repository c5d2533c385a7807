"""What a printed expression comes to, with the derived quantities in place of its symbols."""

from collections.abc import Mapping
from functools import lru_cache, reduce
from operator import add, mul

from sympy import (
    And,
    Basic,
    ImmutableMatrix,
    Inverse,
    Limit,
    MatAdd,
    MatMul,
    MatrixBase,
    Pow,
    S,
    Subs,
    Symbol,
    expand,
    sympify,
)
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.matrices.expressions.matexpr import MatrixElement, MatrixExpr

from chr_notes.ledger.edits import in_order
from chr_notes.ledger.identities import is_zero, settle
from chr_notes.ledger.reading import Read
from chr_notes.typeset import latex


def parts(statement: Basic) -> tuple[Basic, ...]:
    """Split a conjunction into its relations."""
    return statement.args if isinstance(statement, And) else (statement,)


def put(expression: Basic, by: Mapping[Basic, Basic]) -> Basic:
    """Substitute; a point of many numbers at once, where no symbol is bound."""
    numbers = all(isinstance(old, Symbol) and sympify(new).is_number for old, new in by.items())
    if numbers and not expression.has(Limit, ExprWithLimits, Subs):
        return expression.xreplace({old: sympify(new) for old, new in by.items()})
    return expression.subs(by)


def work_out(expression: Basic, read: Read, by: Mapping[Basic, Basic]) -> Basic:
    """Put the derived quantities in place of the document's symbols, matrices as a whole."""
    # A condition may speak of the document's symbols or of the derived ones: before and after.
    meaning = put(read(put(in_order(expression), by)), by).doit()
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
        meaning = explicit(meaning)
    meaning = _elements_named(meaning)
    return meaning.applyfunc(settle) if isinstance(meaning, MatrixBase) else settle(meaning)


def explicit(matrix: MatrixExpr) -> MatrixBase:
    """Write out the elements, from the inside out; SymPy's `as_explicit` sums up from the outside.

    Raises
    ------
    ValueError
        If the determinant is zero where an inverse is needed.
    """
    if isinstance(matrix, MatMul | MatAdd):
        terms = [explicit(term) if term.is_Matrix else term for term in matrix.args]
        return ImmutableMatrix(reduce(mul if isinstance(matrix, MatMul) else add, terms))
    if isinstance(matrix, Inverse):
        inner = explicit(matrix.arg)
        determinant = inner.det()
        if is_zero(determinant):
            msg = f"expected a matrix with an inverse, got {inner}"
            raise ValueError(msg)
        return ImmutableMatrix(inner.adjugate() / determinant)
    return _elements_named(matrix if isinstance(matrix, MatrixBase) else matrix.as_explicit())


def _elements_named(expression: Basic) -> Basic:
    """Make numbers like others of the elements of a matrix that is used as a whole no more."""
    elements = expression.atoms(MatrixElement)
    return expression.xreplace({element: Symbol(latex(element), real=True) for element in elements})


def sides(relation: Basic, read: Read, by: Mapping[Basic, Basic]) -> tuple[Basic, Basic]:
    """Evaluate the left and the right side of a relation, each on its own."""
    left, right = (evaluate(side, read, by) for side in (relation.lhs, relation.rhs))
    return left, right
