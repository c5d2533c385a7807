"""Do the steps of a derivation lead to the formula? Each is linked to what comes after it.

A step that is true and has nothing to do with the formula proves nothing. So the last step has a
term in common with the formula, and each other step one with the formula or with a later step.
"""

import re
from collections.abc import Iterator

from sympy import (
    And,
    Basic,
    Dummy,
    Expr,
    Function,
    MatrixBase,
    MatrixSymbol,
    Symbol,
    cos,
    preorder_traversal,
    sin,
)
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.core.symbol import Str

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.edits import in_order
from chr_notes.ledger.evaluation import parts
from chr_notes.ledger.proof import proves
from chr_notes.ledger.reading import Read
from chr_notes.printed.statement import Approximately, Rotation
from chr_notes.symbols import EULER, T, g, m
from chr_notes.typeset import latex

# They stand in nearly every formula: alone they link nothing.
EVERYDAY = frozenset(latex(name) for name in (*EULER, g, m, T))
IN_WORDS = r"\text{"
DOT = re.compile(r"\\dot\{((?:[^{}]|\{[^{}]*\})*)\}")
AS_IT_IS = Read({}, {})


def check_steps(case: Case) -> None:
    """Refuse steps that do not lead to the formula, and an equation without any.

    Raises
    ------
    CannotJudgeError
        Then.
    """
    if not case.steps:
        if _is_to_be_derived(case):
            msg = f"{case.id}: expected a step at least that leads to the formula, got none"
            raise CannotJudgeError(msg)
        return
    linked = goal(case)
    last = len(case.steps)
    if any(term.startswith(IN_WORDS) for term in linked if isinstance(term, str)):
        # What a name in words stands for, no formula shows.
        linked |= terms(case.steps[-1].statement, case)
    for place in range(last, 0, -1):
        statement = case.steps[place - 1].statement
        found = terms(statement, case)
        common = found & linked
        if _holds_by_itself(statement, case):
            common = {term for term in common if not isinstance(term, str)}
        if not common:
            after = "" if place == last else " or with a later step"
            msg = (
                f"{case.id}: step {place} has no name or expression in common with the formula"
                f"{after}, it leads nowhere: {latex(statement)}"
            )
            raise CannotJudgeError(msg)
        linked |= found


def goal(case: Case) -> set[object]:
    """List the terms of what the steps lead to: the right form, and the condition if there is one.

    The printed form counts as well: a step may tell where it goes wrong.
    """
    found = terms(case.printed.statement, case)
    if case.right is not None:
        found |= terms(case.right, case)
    if case.condition is not None:
        found |= terms(case.condition.holds, case)
    return found


def terms(statement: Basic, case: Case) -> set[object]:
    """List by what a statement is linked to others: names, and expressions of several names.

    Names are taken as they are typeset, without arguments, index in time, or dot. A vector or
    matrix that is written out is an expression, and so are a function of more than a bare name and
    a number of a table.
    """
    found: set[object] = set()
    for part in parts(in_order(statement)):
        if isinstance(part, Approximately):
            found.add(("number", part.number))
        for node in preorder_traversal(part):
            if isinstance(node, Relational | And | Approximately):
                continue
            if isinstance(node, Str):
                continue
            if _is_name(node) or node in case.reading:
                found |= set(_bases(node)) - EVERYDAY
            elif isinstance(node, MatrixBase):
                found.add(node)
            elif isinstance(node, Expr):
                short = node.as_coeff_Mul()[1]
                if len({base for each in _names(short) for base in _bases(each)}) > 1 or (
                    isinstance(short, Function) and not all(map(_is_name, short.args))
                ):
                    found.add(short)
    return found


def _is_to_be_derived(case: Case) -> bool:
    """Whether there is an equation to derive: one that is printed, or one that is put right."""
    if case.definition or case.reported is not None:
        return False
    return case.printed.kind == "equation" or bool(case.edits)


def _holds_by_itself(statement: Basic, case: Case) -> bool:
    """Whether a statement holds whatever its names stand for."""
    read = {node: Dummy() for node in statement.atoms(sin, cos) if node in case.reading}
    try:
        return proves(statement.xreplace(read), AS_IT_IS)
    except (TypeError, ValueError):
        return False  # notation that has to be read


def _is_name(node: Basic) -> bool:
    return isinstance(node, Symbol | MatrixSymbol | Rotation | AppliedUndef)


def _names(expression: Basic) -> set[Basic]:
    return expression.atoms(Symbol, MatrixSymbol, Rotation, AppliedUndef)


def _bases(name: Basic) -> Iterator[str]:
    r"""Yield a name as it is typeset, without arguments; of `\dot{x}` x as well."""
    base = re.split(r"\\left[(\[]|[(\[]", latex(name))[0].strip()
    yield base
    if DOT.search(base):
        yield DOT.sub(r"\1", base)
