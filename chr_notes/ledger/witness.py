"""The numbers of a witness, typeset: what the printed and what the right form give there."""

from collections.abc import Mapping
from itertools import repeat

from sympy import (
    And,
    Basic,
    Eq,
    MatrixBase,
    MatrixExpr,
    N,
    S,
    Set,
    Symbol,
    deg,
    log,
    sympify,
)

from chr_notes.ledger.case import Case
from chr_notes.ledger.entry import Witness
from chr_notes.ledger.evaluation import parts, sides
from chr_notes.ledger.identities import equal
from chr_notes.ledger.proof import fails
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import Angle, AngularRate
from chr_notes.typeset import latex

GIVEN_IN_DEGREES = {Angle: r"^\circ", AngularRate: r"^\circ/\mathrm{s}"}
MANY = 3


def witness(case: Case) -> Witness:
    """Put the numbers of the witness beside each other, where printed and right differ most."""
    point = case.witness
    at = _point(point)
    failing = next(
        part for part in parts(case.printed.statement) if fails(part, case.reading, point)
    )
    right, printed = sides(failing, case.reading, point)
    if isinstance(failing, Approximately):
        # Two digits more than printed, so that the difference shows, or those of the correction.
        given = [part.unit for part in parts(case.right) if isinstance(part, Approximately)]
        digits = max(2 - round(log(failing.unit, 10)), *(-round(log(unit, 10)) for unit in given))
        return Witness(at, failing.number, f"{round(float(right), digits):.{max(digits, 0)}f}")
    if not isinstance(failing, Eq):
        values = zip((failing.lhs, failing.rhs), (right, printed), strict=True)
        found = [Eq(side, value, evaluate=False) for side, value in values if side.free_symbols]
        return Witness(at, latex(failing), latex(And(*found, evaluate=False)))
    if isinstance(right, MatrixBase) and right.cols == 1:
        names = _names(case, failing)
        return Witness(at, _column(printed, names), _column(right, names))
    if isinstance(right, MatrixBase):
        where = max(
            (index for index in range(len(right)) if not equal(right[index], printed[index])),
            key=lambda index: abs(N(right[index] - printed[index])),
        )
        row, column = divmod(where, right.cols)
        place = rf"(\ldots)_{{{row + 1}{column + 1}}}"
        return Witness(
            at, f"{place} = {number(printed[where])}", f"{place} = {number(right[where])}"
        )
    if isinstance(right, Set):
        shown = [latex(Eq(failing.lhs, each, evaluate=False)) for each in (printed, right)]
        return Witness(at, *shown)
    of = failing.rhs if isinstance(failing.rhs, Angle) else failing.lhs
    return Witness(at, number(printed, of), number(right, of))


def _names(case: Case, relation: Eq) -> Basic:
    """Find names for the elements of a column: one of the sides, or what it is read as."""
    for side in (relation.lhs, relation.rhs, *map(case.reading, relation.args)):
        if isinstance(side, MatrixBase) and all(isinstance(each, Symbol) for each in side):
            return side
    return S.One


def _point(point: Mapping[Basic, Basic]) -> tuple[tuple[str, str], ...]:
    """Typeset a point; many zeros are put together."""
    zeros = [symbol for symbol, value in point.items() if value == 0]
    together = len(zeros) > MANY
    at = tuple(
        (latex(symbol), number(sympify(value), symbol))
        for symbol, value in point.items()
        if not (together and value == 0)
    )
    return (*at, (r"\text{all others}", "0")) if together else at


def _column(values: MatrixBase, of: Basic = S.One) -> str:
    """Typeset a column of numbers in a line, those of angles and rates in degrees."""
    names = of if isinstance(of, MatrixBase) else repeat(S.One, len(values))
    numbers = (number(*pair) for pair in zip(values, names, strict=True))
    return r"\left(" + r",\ ".join(numbers) + r"\right)"


def number(value: Basic, of: Basic = S.One) -> str:
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
