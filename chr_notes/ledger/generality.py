"""How far a statement is judged: what may be given, and what is too little for a condition.

A formula is about any values of what it writes. So what is given is what the document says in
words, and a condition is about a quantity that the document leaves out, a bias or a field that
changed: where a written one has a single value, a wrong term may vanish by itself.
"""

from collections.abc import Iterator

from sympy import Basic, Eq, MatrixBase, MatrixSymbol, Ne, Symbol
from sympy.core.function import AppliedUndef
from sympy.core.relational import Equality

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.evaluation import parts
from chr_notes.printed import DOCUMENTS
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, QUATERNION

ATTITUDE = frozenset((*EULER, *QUATERNION, *EULER_RATES, *BODY_RATES))


def check_given(case: Case) -> None:
    """Refuse what is given without the document's words, and an attitude fixed without its own.

    Single values that a general statement leaves out, and an attitude, are given only by the words
    of the statement itself; all else that is given is presumed by the words of the document.
    """
    for given in case.given:
        said = [
            each.says
            for each in case.reading.presumed
            if each.holds == given and case.id in each.presuming and each.is_said
        ]
        if not said:
            msg = f"{case.id}: the document does not say that it presumes {given.holds}"
            raise CannotJudgeError(msg)
        single = all(isinstance(relation, Ne) for relation in given.relations)
        if (single or _fixes_attitude(given)) and case.id not in said:
            msg = f"{case.id}: its own words do not say {given.holds}"
            raise CannotJudgeError(msg)


def check_condition(case: Case) -> None:
    """Refuse a condition that is one attitude, or an equation of what the print itself writes.

    What the document says in words of other statements may be a condition of this one.
    """
    if case.condition is None:
        return
    if _fixes_attitude(case.condition):
        msg = f"{case.id}: {case.condition.holds} is one attitude; it is no condition of a formula"
        raise CannotJudgeError(msg)
    if any(each.holds == case.condition and each.is_said for each in case.reading.presumed):
        return
    printed = names_in(case.printed.statement)
    written = _written(case)
    for relation in case.condition.relations:
        for equation in _pairs(relation) if isinstance(relation, Eq) else ():
            names = names_in(equation)
            number = not names_in(equation.rhs) or not names_in(equation.lhs)
            if names and names <= (written if number else printed):
                msg = (
                    f"{case.id}: expected a condition on what the document leaves out, got "
                    f"{equation}; the document writes {', '.join(sorted(map(str, names)))}, "
                    "for any value"
                )
                raise CannotJudgeError(msg)


def check_reading(case: Case) -> None:
    """Refuse an equation of which the reading takes some names for single numbers.

    An inequality needs one point only, and a number is about one; an equation of numbers alone
    counts something.
    """
    added = {name for name in case.reading.added if name in _written(case)}
    for part in parts(case.printed.statement):
        if isinstance(part, Equality):
            names = {name for name in names_in(part) if isinstance(name, Symbol)}
            values = {name: case.reading(name) for name in names | added}
            fixed = [name for name, value in values.items() if value.is_number]
            if fixed and any(case.reading(side).free_symbols for side in part.args):
                msg = (
                    f"{case.id}: expected {fixed[0]} for any value, read as "
                    f"{values[fixed[0]]}: one value proves no equation"
                )
                raise CannotJudgeError(msg)


def check_sufficient(case: Case, condition: Condition) -> None:
    """Refuse as sufficient what is single values only: of these a wrong formula may have some."""
    for relation in condition.relations:
        if isinstance(relation, Eq) and not relation.rhs.free_symbols:
            msg = f"{case.id}: single values, {condition.holds}, of several; it is no condition"
            raise CannotJudgeError(msg)


def names_in(expression: Basic) -> set[Basic]:
    """List what an expression names: quantities, matrices, functions as a whole."""
    return expression.atoms(Symbol, MatrixSymbol, AppliedUndef)


def _written(case: Case) -> set[Basic]:
    """List what the document writes in any statement, and the components of what it writes."""
    names = set().union(*(names_in(p.statement) for p in DOCUMENTS[case.printed.document]))
    meanings = case.reading.meanings()
    for value in map(meanings.get, tuple(names)):
        if isinstance(value, MatrixBase) and all(e.is_Symbol or e.is_number for e in value):
            names |= value.free_symbols
    return names


def _fixes_attitude(condition: Condition) -> bool:
    """Whether an equation binds angles, elements or rates; the norm of a quaternion is neither."""
    equations = (
        pair
        for relation in condition.relations
        if isinstance(relation, Eq)
        for pair in _pairs(relation)
    )
    return any(
        each.free_symbols and each.free_symbols <= ATTITUDE and each.free_symbols != {*QUATERNION}
        for each in equations
    )


def _pairs(relation: Eq) -> Iterator[Eq]:
    """Yield an equation, that of matrices element by element."""
    if isinstance(relation.lhs, MatrixBase):
        for pair in zip(*relation.args, strict=True):
            yield Eq(*pair, evaluate=False)
    else:
        yield relation
