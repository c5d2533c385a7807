"""From a case to a verdict. Nobody types a verdict: each one is reached here.

The rules, in this order:

- `reported`: the statement is a fact about a product, so no mathematics can check it, and it was
  written down twice with the same result;
- `definition`: it is brought as one; it gives a name that no derivation and no earlier statement of
  the document knows, and that it does not use itself; and another statement is read by it;
- `proved`: read with the derived quantities, it holds for all values, or for all that the
  document or the convention presumes;
- `qualified`: it holds under the condition brought with it, and fails at a witness outside it;
- `corrected`: the printed statement with the edits brought with it is proved, keeps what
  `chr_notes.ledger.corrections` asks for, and as printed it fails at a witness.

Anything else is an error that says which part was not proved and what was left over: the ledger
has no entry that was not decided.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import NamedTuple

from sympy import And
from sympy.logic.boolalg import Boolean

from chr_notes.ledger.case import CannotJudgeError, Case, Reading
from chr_notes.ledger.chain import check_steps
from chr_notes.ledger.checks import (
    check_conditions,
    check_definition,
    check_reported,
    check_root,
    check_says_something,
)
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.corrections import check_correction
from chr_notes.ledger.derived import derived
from chr_notes.ledger.domain import undefined_where
from chr_notes.ledger.edits import marked
from chr_notes.ledger.entry import Entry, Verdict
from chr_notes.ledger.evaluation import parts
from chr_notes.ledger.files import see_case
from chr_notes.ledger.generality import (
    check_condition,
    check_given,
    check_reading,
    check_sufficient,
)
from chr_notes.ledger.proof import Finding, examine, excludes, fails, proves
from chr_notes.ledger.search import is_exact
from chr_notes.ledger.step_words import check_words
from chr_notes.ledger.ties import check_place, check_weight
from chr_notes.ledger.witness import check_witness, witness
from chr_notes.ledger.words import check_says
from chr_notes.printed.statement import Approximately
from chr_notes.typeset import latex


class Judged(NamedTuple):
    """A verdict, how it was reached, and whether the condition is exact."""

    verdict: Verdict
    method: str
    exact: bool | None = None


def judge(case: Case) -> Entry:
    """Reach the verdict on one printed statement.

    Parameters
    ----------
    case
        The printed statement and what was brought with it.

    Returns
    -------
    Entry
        The row of the ledger.

    Raises
    ------
    CannotJudgeError
        If the statement is not proved and what was brought does not settle it, or if a condition
        or correction was brought although the statement is true as printed. It says in which files
        to look.
    """
    with _told(case):
        return _entry(case)


def faults(case: Case) -> list[str]:
    """Say all that keeps a case from being judged: where the judgement ends, this goes on.

    What has no verdict yet may have steps, readings and words that are wrong as well.
    """
    checks: list[Callable[[Case], object]] = [_entry, check_steps, check_words, check_says]
    checks += [partial(_step, place=place) for place in range(len(case.steps))]
    checks += [partial(_reading, each=each) for each in case.readings]
    found = []
    for check in checks:
        try:
            with _told(case):
                check(case)
        except CannotJudgeError as error:
            found.append(str(error))
    return [*dict.fromkeys(found)]


@contextmanager
def _told(case: Case) -> Iterator[None]:
    """Name the entry and its files with what is wrong with it."""
    try:
        yield
    except CannotJudgeError as error:
        msg = f"{error}; {see_case(case.id)}"
        raise CannotJudgeError(msg) from error
    except (AttributeError, IndexError, TypeError, ValueError) as error:
        where = see_case(case.id)
        msg = f"{case.id}: expected mathematics that can be worked out, got: {error}; {where}"
        raise CannotJudgeError(msg) from error


def _entry(case: Case) -> Entry:
    verdict, method, exact = _verdict(case)
    printed = case.printed
    failing = verdict in ("qualified", "corrected")
    not_derived = verdict in ("definition", "reported")
    check_root(case, failing=failing)
    if failing:
        check_weight(case)
        check_place(case)
    derivation = tuple(_step(case, place) for place in range(len(case.steps)))
    check_steps(case)
    check_words(case)
    readings = tuple(_reading(case, each) for each in case.readings)
    if readings and verdict != "corrected" and not readings[0][1]:
        msg = f"{case.id}: {verdict}, yet it does not hold under the first of its readings"
        raise CannotJudgeError(msg)
    check_says(case)
    return Entry(
        id=case.id,
        document=printed.document,
        kind=printed.kind,
        says=printed.says,
        verdict=verdict,
        root=case.root,
        weight=case.weight,
        place=printed.place,
        printed_latex=latex(printed.statement, as_written=True),
        derived_latex=None if not_derived else derived(case, verdict),
        correction_latex=_correction(case),
        given=latex(And(*(g.holds for g in case.given), evaluate=False)) if case.given else None,
        condition=latex(case.condition.holds) if case.condition is not None else None,
        exact=exact,
        undefined=undefined_where(case) if verdict == "proved" else None,
        witness=witness(case) if failing else None,
        method=method + (", by the first of the readings" if readings else ""),
        derivation=derivation,
        readings=readings,
        remark=case.remark,
    )


def _verdict(case: Case) -> Judged:
    if case.condition is not None and case.right is not None:
        msg = f"{case.id}: expected a condition or a correction, got both"
        raise CannotJudgeError(msg)
    if case.reported is not None:
        check_reported(case)
        return Judged("reported", "a fact about a product; it was written down twice and compared")
    check_definition(case)
    if case.definition:
        return Judged("definition", "the name has no meaning before; it is read by this later")
    check_says_something(case)
    check_given(case)
    check_reading(case)
    check_conditions(case)
    check_condition(case)
    if case.condition is None and case.right is None:
        findings = _prove(case, case.printed.statement, "not proved as printed", *case.given)
        return Judged("proved", f"derived independently: {_how(findings)}")
    check_witness(case)
    return _qualified(case, case.condition) if case.condition is not None else _corrected(case)


def _qualified(case: Case, condition: Condition) -> Judged:
    if not excludes(condition, case.witness):
        msg = f"{case.id}: the witness {case.witness} meets the condition {condition.holds}"
        raise CannotJudgeError(msg)
    findings = _prove(
        case, case.printed.statement, "not proved under the condition", *case.given, condition
    )
    exact = is_exact(case, condition)
    if not exact:
        check_sufficient(case, condition)
    outside = (
        "at all points that a search tries outside it, it fails"
        if exact
        else "a search outside it finds a point at which it holds as well"
    )
    return Judged("qualified", f"proved under the condition: {_how(findings)}; {outside}", exact)


def _corrected(case: Case) -> Judged:
    right = case.right
    findings = _prove(case, right, "the correction is not proved", *case.given)
    check_correction(case)
    if case.witness and right is not None and fails(right, case.reading, case.witness):
        msg = f"{case.id}: the correction fails at the witness {case.witness} too"
        raise CannotJudgeError(msg)
    shown = "as printed it fails at the witness" if case.witness else "as printed it fails"
    return Judged("corrected", f"the correction is proved: {_how(findings)}; {shown}")


def _prove(
    case: Case, statement: Boolean | None, failure: str, *conditions: Condition
) -> tuple[Finding, ...]:
    findings = []
    for finding in examine(statement, case.reading, *conditions):
        if not finding.holds:
            msg = f"{case.id}: {failure}: {finding.left_over()}"
            raise CannotJudgeError(msg)
        findings.append(finding)
    return tuple(findings)


def _how(findings: tuple[Finding, ...]) -> str:
    return "; ".join(dict.fromkeys(finding.how for finding in findings))


def _correction(case: Case) -> str | None:
    return marked(case.printed.statement, case.edits) if case.edits else None


def _step(case: Case, place: int) -> tuple[str, str]:
    """Prove a step, and typeset it."""
    step = case.steps[place]
    under = (*case.given, *((case.condition,) if case.condition is not None else ()))
    # What leads to a condition holds without it, what follows from it under it.
    if not any(
        proves(step.statement, case.reading, *conditions) for conditions in ((), case.given, under)
    ):
        _prove(case, step.statement, f"step {place + 1} is not proved", *under)
    if any(
        latex(part.lhs) == latex(part.rhs)
        for part in parts(step.statement)
        if not isinstance(part, Approximately)
    ):
        msg = f"{case.id}: step {place + 1} shows the same on both sides"
        raise CannotJudgeError(msg)
    return step.says, latex(step.statement)


def _reading(case: Case, each: Reading) -> tuple[str, bool]:
    """Say whether a statement holds under one reading of a document that contradicts itself."""
    if any(proves(each.convention, o.read) != (o is each) for o in case.readings):
        msg = f"{case.id}: expected {each.convention} under its own reading alone"
        raise CannotJudgeError(msg)
    statement = case.printed.statement
    conditions = (case.condition,) if case.condition is not None else ()
    holds = proves(statement, each.read, *case.given, *conditions)
    if not holds and not fails(statement, each.read, each.point):
        msg = f"{case.id}: neither proved nor shown to fail under {each.convention}"
        raise CannotJudgeError(msg)
    return latex(each.convention), holds
