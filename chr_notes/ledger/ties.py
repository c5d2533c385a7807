"""What can be computed of roots and weights: places of one error are alike, and weights fit.

Which error a statement is a place of, and how much that matters, are judgements of ours. They are
held to what is known: all places of one root have something in common, and a weight agrees with
what is wrong.
"""

import re

from sympy import Basic, Expr, MatrixBase, N, Symbol, Transpose
from sympy.matrices.expressions.matexpr import MatrixExpr

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.corrections import is_renamed
from chr_notes.ledger.edits import Edit, in_order
from chr_notes.ledger.evaluation import evaluate, parts
from chr_notes.ledger.harm import HARM
from chr_notes.ledger.proof import fails, proves
from chr_notes.ledger.roots import KNOWN_BY
from chr_notes.printed.statement import Approximately, Rotation
from chr_notes.typeset import latex

ROUNDING = 0.01  # a number that is off by less misleads nobody
NEARLY = 0.01  # a number may be so far from a multiple of the right one, for it was rounded


def check_weight(case: Case) -> None:
    """Refuse a weight that does not fit what is wrong.

    Raises
    ------
    CannotJudgeError
        Then.
    """
    fitting = fitting_weights(case)
    if case.weight not in fitting:
        msg = f"{case.id}: expected {' or '.join(fitting)} as weight, got {case.weight}"
        raise CannotJudgeError(msg)
    lighter = case.weight != fitting[0] and fitting[0] == "misleads"
    if lighter != (case.told_in is not None):
        wants = "a statement that has it right, for it could mislead" if lighter else "None"
        msg = f"{case.id}: expected {wants} as told_in, got {case.told_in!r} with {case.weight!r}"
        raise CannotJudgeError(msg)
    if case.told_in is not None and case.told_in not in (case.remark or ""):
        msg = f"{case.id}: expected a remark that leads to {case.told_in}, got {case.remark!r}"
        raise CannotJudgeError(msg)


def fitting_weights(case: Case) -> tuple[str, ...]:
    """List the weights that fit what is wrong with a statement.

    - A number that is off by more than rounding misleads; one that is not is small print.
    - Words in place of words give no wrong number: they are a label or small print.
    - An equation that is wrong gives wrong numbers: it misleads. If only a name stands in the place
      of a name, or a matrix in the place of its transpose, it may be a label.
    - A sentence that is wrong may mislead or be small print; a label, if it is about a name.
    """
    wrong = _failing(case)
    numbers = [part for part in wrong if isinstance(part, Approximately)]
    if numbers:
        off = max(abs(_ratio(part, case) - 1) for part in numbers)
        return ("misleads",) if off > ROUNDING else ("small print",)
    if all(_is_name(side) and _is_of_words(side) for part in wrong for side in part.args):
        return "label", "small print"
    sentence = case.printed.kind == "claim"
    about_a_name = bool(case.edits) and (
        all(map(_exchanges_names, case.edits))
        or (sentence and any(_is_name(side) for part in wrong for side in part.args))
    )
    return (
        "misleads",
        *(("label",) if about_a_name else ()),
        *(("small print",) if sentence else ()),
    )


def check_place(case: Case) -> None:
    """Refuse a root of which a statement is no place.

    Raises
    ------
    CannotJudgeError
        If what is wrong has nothing that the root is known by, or no one says what that is, or
        what it does on a device where it misleads.
    """
    if case.root is None:
        return
    known_by = KNOWN_BY.get(case.root)
    found = traits(case)
    if known_by is None:
        msg = (
            f"{case.id}: expected a pattern for {case.root!r} in KNOWN_BY of "
            f"chr_notes/ledger/roots.py, which matches one of: {'; '.join(sorted(found))}"
        )
        raise CannotJudgeError(msg)
    if not any(re.fullmatch(known_by, trait) for trait in found):
        msg = (
            f"{case.id}: expected of a place of {case.root!r} what {known_by!r} matches, "
            f"got: {'; '.join(sorted(found))}"
        )
        raise CannotJudgeError(msg)
    if case.weight == "misleads" and case.root not in HARM:
        msg = f"{case.id}: expected a line for {case.root!r} in HARM of chr_notes/ledger/harm.py"
        raise CannotJudgeError(msg)


def traits(case: Case) -> frozenset[str]:
    """List by what an error may be known again in another place, in LaTeX.

    Of a wrong number that is how many times too large it is, or that it was cut off. Of all else
    the same edit, a minus put in before the same quantities, the same condition or the same bounds
    of it, a step of the derivation, and the readings of a document that contradicts itself, if the
    statement holds under one of them.
    """
    numbers = [part for part in _failing(case) if isinstance(part, Approximately)]
    if numbers:
        return frozenset(_trait_of_number(part, case) for part in numbers)
    found = {f"step {latex(in_order(step.statement))}" for step in case.steps}
    for edit in case.edits:
        part, by = in_order(edit.part), in_order(edit.by)
        found.add(f"{latex(part)} for {latex(by)}")
        if isinstance(part, Expr | MatrixBase) and in_order(-part) == by:
            of = sorted(map(latex, case.reading(part).free_symbols))
            found.add(f"minus before {', '.join(of) or 'numbers'}")
    if case.condition is not None:
        found.add(f"only if {latex(case.condition.holds)}")
        bounds = sorted((each.rhs for each in case.condition.relations), key=str)
        if len(bounds) > 1:
            found.add(f"only from {' to '.join(map(latex, bounds))}")
    under = tuple(filter(None, (*case.given, case.condition)))
    if any(proves(case.printed.statement, each.read, *under) for each in case.readings):
        found.add(f"readings of {' or '.join(latex(each.convention) for each in case.readings)}")
    return frozenset(found)


def _failing(case: Case) -> list[Basic]:
    return [
        part for part in parts(case.printed.statement) if fails(part, case.reading, case.witness)
    ]


def _ratio(part: Approximately, case: Case) -> float:
    return float(part.rhs / N(evaluate(part.lhs, case.reading, case.witness), 30))


def _trait_of_number(part: Approximately, case: Case) -> str:
    ratio = _ratio(part, case)
    short = 0 < part.rhs / ratio - part.rhs < part.unit
    if short and round(ratio) == 1:
        return "cut off"
    nearly = abs(ratio / round(ratio) - 1) < NEARLY
    return f"{round(ratio) if nearly else f'{ratio:.2f}'} times too large"


def _exchanges_names(edit: Edit) -> bool:
    """Whether a name takes the place of a name, or of its own transpose, and all else stays."""
    if isinstance(edit.part, Rotation) and isinstance(edit.by, Rotation):
        return True
    part, by = (
        side.replace(Transpose, lambda matrix: matrix) if isinstance(side, MatrixExpr) else side
        for side in (edit.part, edit.by)
    )
    return part == by or is_renamed(Edit(part, by))


def _is_name(side: Basic) -> bool:
    return isinstance(side, Symbol) or (isinstance(side, MatrixExpr) and side.is_symbol)


def _is_of_words(name: Basic) -> bool:
    return str(name).startswith(r"\text{")
