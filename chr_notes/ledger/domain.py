"""Where a printed statement is not defined: its divisors are zero there."""

from sympy import And, Basic, Eq, Or, Pow, atan, atan2, cos, sec, simplify, tan

from chr_notes.ledger.case import Case
from chr_notes.ledger.evaluation import evaluate, parts
from chr_notes.ledger.identities import is_zero, reduced
from chr_notes.printed.statement import Approximately
from chr_notes.typeset import latex


def undefined_where(case: Case) -> str | None:
    """Typeset where a side of a statement divides by zero, or has an angle of no direction."""
    found = []
    for part in parts(case.printed.statement):
        if not isinstance(part, Approximately):
            zeros = _zeros(_with_both_parts(part, case))
            found += [zero for zero in zeros if zero not in found and _occurs(case, zero)]
    return latex(Or(*found, evaluate=False)) if found else None


def _with_both_parts(relation: Basic, case: Case) -> Basic:
    """Read the arctangent of a quotient as the document does: by both parts, if it says so."""
    read = case.reading.notation.get(atan)
    return relation if read is None else relation.replace(atan, lambda x: read(atan(x)))


def _zeros(relation: Basic) -> list[Basic]:
    """List where divisors vanish, of matrices element by element, and both sides of an atan2."""
    divisors = [
        power.base
        for power in sorted(relation.atoms(Pow), key=str)
        if power.exp.is_negative and not power.base.is_number
    ]
    divisors += [cos(call.args[0]) for call in sorted(relation.atoms(tan, sec), key=str)]
    zeros = [Eq(divisor, 0, evaluate=False) for divisor in dict.fromkeys(divisors)]
    both = [
        And(*(Eq(part, 0, evaluate=False) for part in call.args), evaluate=False)
        for call in sorted(relation.atoms(atan2), key=str)
    ]
    return [*zeros, *both]


def _occurs(case: Case, zero: Basic) -> bool:
    """Whether something may vanish: no divisor that is known never to be zero."""
    values = [evaluate(part.lhs, case.reading, {}) for part in parts(zero)]
    whole = values[0] if len(values) == 1 else sum(value**2 for value in values)
    shortened = reduced(whole)
    whole = simplify(whole) if shortened is None else shortened
    return not (whole.is_nonzero or is_zero(whole**2 - 1))
