"""Corrections: the printed statement with named parts replaced, and the rest kept."""

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import (
    Add,
    And,
    Basic,
    Float,
    Function,
    MatrixBase,
    MatrixSymbol,
    Mul,
    Pow,
    Rational,
    Symbol,
)
from sympy.core.relational import Relational
from sympy.core.symbol import Str
from sympy.logic.boolalg import Boolean

from chr_notes.printed.statement import Approximately
from chr_notes.typeset import latex

# These put their arguments in order or work them out, unless told not to.
_AUTOMATIC = (Add, Mul, Pow, Function, Relational)


@dataclass(frozen=True)
class Edit:
    """One part of a printed statement, and what should stand there.

    Parameters
    ----------
    part
        What is expected in print. Write it out, do not take it from the printed statement: so a
        change of the print is seen. For a number of `Approximately` it is a string.
    by
        What should stand there.
    times
        How often the part is printed; it is replaced everywhere.
    """

    part: Basic | str
    by: Basic | str
    times: int = 1


def in_order(expression: Basic) -> Basic:
    """Let SymPy put in order what stands as printed; a decimal is the fraction that it says."""
    if isinstance(expression, Float):
        return Rational(str(expression))
    if not expression.args:
        return expression
    parts = [in_order(part) for part in expression.args]
    as_it_is = {"evaluate": False} if isinstance(expression, Relational) else {}
    return expression.func(*parts, **as_it_is)


def rebuilt(node: Basic, parts: list[Basic]) -> Basic:
    """Make a node anew from other parts, as unevaluated as the node itself."""
    if tuple(parts) == node.args:
        return node
    if isinstance(node, _AUTOMATIC):
        return node.func(*parts, evaluate=False)
    return node.func(*parts)


def put_in_place(expression: Basic, by: Mapping[Basic, Basic], found: dict[Basic, int]) -> Basic:
    """Replace parts, the outermost first, and count in `found` how often each one is met."""
    key = in_order(expression)
    if key in by:
        found[key] = found.get(key, 0) + 1
        return by[key]
    if isinstance(expression, MatrixBase):
        return expression.applyfunc(lambda element: put_in_place(element, by, found))
    parts = [put_in_place(part, by, found) for part in expression.args]
    return rebuilt(expression, parts)


def edited(statement: Boolean, edits: tuple[Edit, ...]) -> Boolean:
    """Correct a statement.

    Raises
    ------
    ValueError
        If a part is not printed as often as expected, or if it is a whole statement.
    """
    by = {_key(edit.part): _basic(edit.by) for edit in edits}
    return _applied(statement, edits, by)


def marked(statement: Boolean, edits: tuple[Edit, ...]) -> str:
    r"""Typeset the corrected statement, with a `\boxed` around what was put in."""
    by = {_key(edit.part): _box(_basic(edit.by)) for edit in edits}
    text = latex(_applied(statement, edits, by), as_written=True)
    for number in (edit.by for edit in edits if isinstance(edit.by, str)):
        plain = Approximately(Symbol("x"), number).number
        text = text.replace(rf"\approx {plain}", rf"\approx \boxed{{{plain}}}")
    return text


def _applied(statement: Boolean, edits: tuple[Edit, ...], by: Mapping[Basic, Basic]) -> Boolean:
    found: dict[Basic, int] = {}
    relations = statement.args if isinstance(statement, And) else (statement,)
    for edit in edits:
        if any(_key(edit.part) == in_order(relation) for relation in relations):
            msg = f"the part to replace is a whole statement: {edit.part}"
            raise ValueError(msg)

    right = put_in_place(statement, by, found)
    for edit in edits:
        times = found.get(_key(edit.part), 0)
        if times != edit.times:
            msg = f"expected in print {edit.times} times, found {times} times: {edit.part}"
            raise ValueError(msg)
    return right


def _basic(part: Basic | str) -> Basic:
    return Str(part) if isinstance(part, str) else part


def _key(part: Basic | str) -> Basic:
    return in_order(_basic(part))


def _box(by: Basic) -> Basic:
    """Give a symbol that is typeset as a box around a part."""
    if isinstance(by, Str):
        return by
    name = rf"\boxed{{{latex(by, as_written=True)}}}"
    return MatrixSymbol(name, *by.shape) if getattr(by, "is_Matrix", False) else Symbol(name)
