"""What a correction must be: the print made right, not some other truth in its place.

- One side of each equation that changes stays as it is printed, so the correction still speaks of
  the same thing. Only where the print divides by nothing, whatever the values, both sides may be
  multiplied by that divisor: the print then has no value anywhere, and this is what it says.
- What is put in does not bring in what the side that stays names, under this name or another:
  that would be true by the names alone. A name in the place of a name is what a wrong label needs.
- A number takes the place of a number, to the digits of the print or better.
"""

from collections.abc import Iterator

from sympy import Basic, Eq, Expr, MatrixBase, MatrixSymbol, Pow, Symbol
from sympy.core.function import AppliedUndef

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.edits import Edit, in_order
from chr_notes.ledger.evaluation import evaluate, parts, put
from chr_notes.ledger.identities import equal, is_zero
from chr_notes.printed.statement import Approximately, Rotation


def check_correction(case: Case) -> None:
    """Refuse a correction that says nothing, less than the print, or something else.

    Raises
    ------
    CannotJudgeError
        Then.
    """
    for printed, right in zip(parts(case.printed.statement), parts(case.right), strict=True):
        if printed != right:
            wrong = _wrong_with(case, printed, right)
            if wrong is not None:
                msg = f"{case.id}: the correction {wrong}: {right}"
                raise CannotJudgeError(msg)


def _wrong_with(case: Case, printed: Basic, right: Basic) -> str | None:
    if isinstance(right, Approximately):
        return _wrong_with_number(case, printed, right)
    if not isinstance(right, Eq):
        return "changes what is neither an equation nor a number"
    if _is_empty(right):
        return "says nothing"
    kept = [side for side, other in zip(printed.args, right.args, strict=True) if side == other]
    if not kept:
        return None if _is_multiplied_out(case, printed, right) else "changes both sides"
    named = {alias for name in _names(kept[0]) for alias in _aliases(name, case)}
    # Names in place of names, and no other edit.
    relabelled = all(map(is_renamed, case.edits))
    for edit in case.edits:
        for name in () if relabelled else _names(edit.by) - _names(edit.part):
            if named & {*_aliases(name, case)}:
                return f"is true by its names alone, {name} is what the other side names"
    return None


def _wrong_with_number(case: Case, printed: Approximately, right: Approximately) -> str | None:
    if right.lhs != printed.lhs:
        return "changes the quantity that the number is given for"
    if right.unit > printed.unit:
        return f"has fewer decimals than {printed.number}"
    if right.rhs == 0 and not is_zero(evaluate(right.lhs, case.reading, {})):
        return "has no digit that counts"
    return None


def _is_empty(relation: Eq) -> bool:
    """Whether an equation holds whatever its names stand for."""
    left, right = (in_order(side).doit() for side in relation.args)
    formulas = all(isinstance(side, MatrixBase | Expr) for side in (left, right))
    explicit = not any(side.has(MatrixSymbol, Rotation) for side in (left, right))
    return left == right or (formulas and explicit and equal(left, right))


def _is_multiplied_out(case: Case, printed: Eq, right: Eq) -> bool:
    """Whether both sides are multiplied by a divisor of the print that is always zero when read."""
    before, after = in_order(printed), in_order(right)
    bases = {power.base for power in before.atoms(Pow) if power.exp.is_negative}
    return any(
        is_zero(evaluate(base, case.reading, {}))
        and all(
            is_zero(new - sign * base * old)
            for old, new in zip(before.args, after.args, strict=True)
        )
        for base in bases
        for sign in (1, -1)
    )


def _names(expression: Basic | str) -> set[Basic]:
    if isinstance(expression, str):
        return set()
    return in_order(expression).atoms(Symbol, MatrixSymbol, Rotation, AppliedUndef)


def is_renamed(edit: Edit) -> bool:
    """Whether a name takes the place of a name, and all else stays."""
    before, after = _names(edit.part), _names(edit.by)
    if len(before) != 1 or len(after) != 1:
        return False
    renamed = in_order(edit.part).xreplace({before.pop(): after.pop()})
    return bool(renamed == in_order(edit.by))


def _aliases(name: Basic, case: Case) -> Iterator[Basic]:
    """Yield a name, what it is read as (of a vector each component), and what defines it."""
    yield name
    definition = case.reading.definition(name)
    if definition is not None:
        yield from _names(definition())
    meaning = evaluate(name, case.reading, {})
    for given in case.given:
        if len(given.by) == 1:
            meaning = put(meaning, given.by[0])
    vector = isinstance(meaning, MatrixBase) and meaning.cols == 1
    for each in meaning if vector else (meaning,):
        if isinstance(each, Expr) and not each.is_number:
            yield from (each, -each)
