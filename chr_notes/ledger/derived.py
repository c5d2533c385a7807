"""What the derivations give for the left side of a statement, as its entry shows it."""

from sympy import Abs, Basic, Dummy, Eq, Limit, MatrixBase, sympify, together

from chr_notes.ledger.case import Case
from chr_notes.ledger.edits import in_order
from chr_notes.ledger.entry import Verdict
from chr_notes.ledger.evaluation import evaluate, work_out
from chr_notes.ledger.identities import OnSphere, reduced
from chr_notes.ledger.witness import number
from chr_notes.printed.statement import Approximately
from chr_notes.typeset import latex

LONG = 400  # characters of LaTeX


def derived(case: Case, verdict: Verdict) -> str | None:
    """Typeset what the derivations give for the left side, where the statement is an equation."""
    statement = case.printed.statement
    if isinstance(statement, Approximately):
        return number(evaluate(statement.lhs, case.reading, {}))
    if not isinstance(statement, Eq) or statement.lhs.has(Limit):
        return None  # a limit may depend on the range that is given
    by = {
        old: new
        for given in case.given
        for old, new in given.by[0].items()
        if len(given.by) == 1 and not sympify(new).atoms(Dummy, OnSphere)
    }
    found = work_out(statement.lhs, case.reading, by)
    if found == statement.lhs:
        return None
    if found == in_order(statement.rhs):
        return latex(statement.rhs, as_written=True)
    text = latex(found)
    if len(text) <= LONG:
        return text
    shorter = [text, latex(_shortened(found))]
    if verdict == "proved":
        # Both sides are the same, by the proof; the shorter one is the simplified one.
        shorter.append(latex(work_out(statement.rhs, case.reading, by)))
    return min(shorter, key=len)


def _shortened(expression: Basic) -> Basic:
    """Bring each element of a matrix, or what a magnitude is of, together."""
    if isinstance(expression, MatrixBase):
        return expression.applyfunc(together)
    if isinstance(expression, Abs):
        return Abs(reduced(expression.args[0]) or expression.args[0])
    return expression
