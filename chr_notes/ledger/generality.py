"""How far a statement is judged: what may be given, and what is too little for a condition."""

from collections.abc import Iterator

from sympy import Basic, Eq, MatrixBase, Ne

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.condition import Condition
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, QUATERNION

ATTITUDE = frozenset((*EULER, *QUATERNION, *EULER_RATES, *BODY_RATES))


def check_given(case: Case) -> None:
    """Refuse what is given without the document's words, and an attitude fixed without its own.

    A general statement may leave out single values; anything else that is given is presumed by the
    document, as its reading says. The formulas are about any attitude: one is fixed only by the
    words of the statement itself, and never by a condition that the document leaves out.
    """
    for given in case.given:
        said = [
            each.says
            for each in case.reading.presumed
            if each.holds == given and case.id in each.presuming and each.is_said
        ]
        general = all(isinstance(relation, Ne) for relation in given.relations)
        if not (general or said):
            msg = f"{case.id}: the document does not say that it presumes {given.holds}"
            raise CannotJudgeError(msg)
        if _fixes_attitude(given) and case.id not in said:
            msg = f"{case.id}: its own words do not say {given.holds}"
            raise CannotJudgeError(msg)
    if case.condition is not None and _fixes_attitude(case.condition):
        msg = f"{case.id}: {case.condition.holds} is one attitude; it is no condition of a formula"
        raise CannotJudgeError(msg)


def _fixes_attitude(condition: Condition) -> bool:
    """Whether an equation binds angles, elements or rates; the norm of a quaternion is neither."""
    equations = (
        Eq(*pair, evaluate=False)
        for relation in condition.relations
        if isinstance(relation, Eq)
        for pair in _pairs(relation)
    )
    return any(
        each.free_symbols and each.free_symbols <= ATTITUDE and each.free_symbols != {*QUATERNION}
        for each in equations
    )


def _pairs(relation: Eq) -> Iterator[tuple[Basic, Basic]]:
    if isinstance(relation.lhs, MatrixBase):
        yield from zip(*relation.args, strict=True)
    else:
        yield relation.args


def check_sufficient(case: Case, condition: Condition) -> None:
    """Refuse as sufficient what is single values only: of these a wrong formula may have some."""
    for relation in condition.relations:
        if isinstance(relation, Eq) and not relation.rhs.free_symbols:
            msg = f"{case.id}: single values, {condition.holds}, of several; it is no condition"
            raise CannotJudgeError(msg)
