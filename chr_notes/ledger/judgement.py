"""From a case to a verdict. Nobody types a verdict: each one is reached here.

The rules, in this order:

- `reported`: the statement is a fact about a product, so no mathematics can check it;
- `definition`: it introduces a name that no derivation knows and that it does not use itself;
- `proved`: read with the derived quantities, it holds for all values, or for all that the
  document or the convention presumes;
- `qualified`: it holds under the condition brought with it, and fails at a witness outside it;
- `corrected`: the correction brought with it is proved, and the printed form fails at a witness.

Anything else is an error: the ledger has no entry that was not decided.
"""

from collections.abc import Mapping

from sympy import (
    And,
    Basic,
    Eq,
    Limit,
    MatrixBase,
    MatrixExpr,
    MatrixSymbol,
    N,
    S,
    Set,
    Symbol,
    deg,
    log,
    sympify,
)
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean

from chr_notes.ledger.case import CannotJudgeError, Case, Reading
from chr_notes.ledger.entry import Entry, Verdict, Witness
from chr_notes.ledger.identities import equal
from chr_notes.ledger.proof import (
    evaluate,
    excludes,
    fails,
    ordered,
    parts,
    proves,
    sides,
    work_out,
)
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, Angle, AngularRate, g, m
from chr_notes.typeset import latex

GIVEN_IN_DEGREES = {Angle: r"^\circ", AngularRate: r"^\circ/\mathrm{s}"}
MANY = 3
DERIVED_NAMES = frozenset((*EULER, *EULER_RATES, *BODY_RATES, g, m))


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
        or correction was brought although the statement is true as printed.
    """
    verdict, method = _verdict(case)
    printed = case.printed
    failing = verdict in ("qualified", "corrected")
    return Entry(
        id=printed.id,
        document=printed.document,
        kind=printed.kind,
        place=printed.place,
        says=printed.says,
        verdict=verdict,
        printed_latex=latex(printed.statement, as_written=True),
        derived_latex=_derived(case),
        correction_latex=latex(case.correction, as_written=True)
        if case.correction is not None
        else None,
        given=latex(And(*(g.holds for g in case.given), evaluate=False)) if case.given else None,
        condition=latex(case.condition.holds) if case.condition is not None else None,
        witness=_witness(case) if failing else None,
        readings=tuple(_reading(case, each) for each in case.readings),
        method=method,
        remark=case.remark,
        derivation=tuple((step.says, latex(step.statement)) for step in case.steps),
    )


def _as_written(correction: Boolean | None) -> str | None:
    return latex(correction, as_written=True) if correction is not None else None


def _verdict(case: Case) -> tuple[Verdict, str]:
    statement, read, name = case.printed.statement, case.read, case.printed.id
    if introduces_name(case):
        return "definition", "the name stands in no derivation and not in its own definition"
    if case.condition is None and case.correction is None:
        if proves(statement, read, *case.given):
            return "proved", "derived independently; the difference simplifies to zero"
        msg = f"{name}: not proved, and neither a condition nor a correction was brought"
        raise CannotJudgeError(msg)
    if any(excludes(given, case.witness) for given in case.given):
        msg = f"{name}: the witness {case.witness} lies outside what is given"
        raise CannotJudgeError(msg)
    if not fails(statement, read, case.witness):
        msg = f"{name}: the witness {case.witness} does not show that it fails as printed"
        raise CannotJudgeError(msg)
    if case.condition is not None and case.correction is None:
        if not excludes(case.condition, case.witness):
            msg = f"{name}: the witness {case.witness} meets the condition {case.condition.holds}"
            raise CannotJudgeError(msg)
        if proves(statement, read, *case.given, case.condition):
            return "qualified", "proved under the condition; fails at the witness outside it"
    if (
        case.correction is not None
        and case.condition is None
        and proves(case.correction, read, *case.given)
    ):
        return "corrected", "the correction is proved; the printed form fails at the witness"
    msg = f"{name}: what was brought, a condition or a correction, is not proved"
    raise CannotJudgeError(msg)


def introduces_name(case: Case) -> bool:
    """Whether a statement only gives a name: one that no derivation knows, nor itself uses."""
    statement = case.printed.statement
    if not isinstance(statement, Eq):
        return False
    names = tuple(statement.lhs) if isinstance(statement.lhs, MatrixBase) else (statement.lhs,)
    return all(
        isinstance(name, Symbol | MatrixSymbol | AppliedUndef)
        and name not in DERIVED_NAMES
        and case.read(name) == name
        and not name.free_symbols & statement.rhs.free_symbols
        for name in names
    )


def _derived(case: Case) -> str | None:
    """Typeset what the derivations give for the left side, where the statement is an equation."""
    statement = case.printed.statement
    if isinstance(statement, Approximately):
        return _number(evaluate(statement.lhs, case.read, {}))
    if not isinstance(statement, Eq) or introduces_name(case):
        return None
    if statement.lhs.has(Limit):  # it may depend on the range that is given
        return None
    by = {
        old: new
        for given in case.given
        for old, new in given.by[0].items()
        if len(given.by) == 1 and sympify(new).is_number
    }
    derived = work_out(statement.lhs, case.read, by)
    if derived == ordered(statement.rhs):
        return latex(statement.rhs, as_written=True)
    return latex(derived) if derived != statement.lhs else None


def _reading(case: Case, each: Reading) -> tuple[str, bool]:
    """Say whether a statement holds under one reading of a document that contradicts itself."""
    statement = case.printed.statement
    conditions = (case.condition,) if case.condition is not None else ()
    holds = proves(statement, each.read, *case.given, *conditions)
    if not holds and not fails(statement, each.read, each.point):
        msg = f"{case.printed.id}: neither proved nor shown to fail under {each.convention}"
        raise CannotJudgeError(msg)
    return latex(each.convention), holds


def _witness(case: Case) -> Witness:
    """Put the numbers of the witness beside each other, where printed and right differ most."""
    point = case.witness
    at = _point(point)
    failing = next(part for part in parts(case.printed.statement) if fails(part, case.read, point))
    right, printed = sides(failing, case.read, point)
    if isinstance(failing, Approximately):
        # Two digits more than printed, so that the difference shows.
        digits = 2 - round(log(failing.unit, 10))
        return Witness(at, failing.number, f"{round(float(right), digits):.{max(digits, 0)}f}")
    if not isinstance(failing, Eq):
        values = zip((failing.lhs, failing.rhs), (right, printed), strict=True)
        found = [Eq(side, value, evaluate=False) for side, value in values if side.free_symbols]
        return Witness(at, latex(failing), latex(And(*found, evaluate=False)))
    if isinstance(right, MatrixBase) and right.cols == 1:
        return Witness(at, _column(printed), _column(right))
    if isinstance(right, MatrixBase):
        where = max(
            (index for index in range(len(right)) if not equal(right[index], printed[index])),
            key=lambda index: abs(N(right[index] - printed[index])),
        )
        row, column = divmod(where, right.cols)
        place = rf"(\ldots)_{{{row + 1}{column + 1}}}"
        return Witness(
            at, f"{place} = {_number(printed[where])}", f"{place} = {_number(right[where])}"
        )
    of = failing.rhs if isinstance(failing.rhs, Angle) else failing.lhs
    return Witness(at, _number(printed, of), _number(right, of))


def _point(point: Mapping[Basic, Basic]) -> tuple[tuple[str, str], ...]:
    """Typeset a point; many zeros are put together."""
    zeros = [symbol for symbol, value in point.items() if value == 0]
    together = len(zeros) > MANY
    at = tuple(
        (latex(symbol), _number(sympify(value), symbol))
        for symbol, value in point.items()
        if not (together and value == 0)
    )
    return (*at, (r"\text{all others}", "0")) if together else at


def _column(values: MatrixBase) -> str:
    """Typeset a column of numbers in a line."""
    return r"\left(" + r",\ ".join(_number(value) for value in values) + r"\right)"


def _number(value: Basic, of: Basic = S.One) -> str:
    """Typeset a number with four digits, an angle in degrees; names and sets as they are."""
    if value is S.NaN:
        return r"\text{undefined}"
    if isinstance(value, MatrixBase):
        return _column(value) if value.cols == 1 else latex(value)
    if isinstance(value, Set | MatrixExpr) or not value.is_number or not value.is_finite:
        return latex(value)
    degrees = GIVEN_IN_DEGREES.get(type(of))
    if degrees is not None:
        return f"{float(deg(value)):.6g}{degrees}"
    mantissa, _, exponent = f"{float(value):.4g}".partition("e")
    return rf"{mantissa} \times 10^{{{int(exponent)}}}" if exponent else mantissa
