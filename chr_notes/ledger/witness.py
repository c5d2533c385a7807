"""The witness that something fails: its check, and its numbers, typeset."""

from collections.abc import Iterable, Mapping
from itertools import repeat

from sympy import (
    And,
    Basic,
    Eq,
    Expr,
    Float,
    MatrixBase,
    MatrixExpr,
    N,
    S,
    Set,
    Symbol,
    deg,
    log,
    sympify,
    zoo,
)

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.entry import Witness
from chr_notes.ledger.evaluation import parts, sides, work_out
from chr_notes.ledger.identities import equal, shape_of
from chr_notes.ledger.proof import excludes, fails
from chr_notes.printed.statement import Approximately
from chr_notes.symbols import Angle, AngularRate
from chr_notes.typeset import latex

GIVEN_IN_DEGREES = {Angle: r"^\circ", AngularRate: r"^\circ/\mathrm{s}"}
MANY = 3


def check_witness(case: Case) -> None:
    """Refuse a witness at which the statement does not fail, or only has no value.

    Its values are those of free quantities: another value for a name that is derived would make
    anything fail.
    """
    read, point = case.reading, case.witness
    read_otherwise = [
        name for name in point if isinstance(name, Basic) and work_out(name, read, {}) != name
    ]
    if read_otherwise:
        msg = f"{case.id}: the witness changes {read_otherwise[0]}, which is derived"
        raise CannotJudgeError(msg)
    odd = [
        name
        for name, value in point.items()
        if not (isinstance(name, Basic) and _is_exact(value, shape_of(name)))
    ]
    if odd:
        got = f"{odd[0]} at the witness, got {point[odd[0]]!r}"
        msg = f"{case.id}: expected exact numbers of the right shape for {got}"
        raise CannotJudgeError(msg)
    if any(excludes(given, point) for given in case.given):
        msg = f"{case.id}: the witness {point} lies outside what is given"
        raise CannotJudgeError(msg)
    if point and not point.keys() & _quantities(case, parts(case.printed.statement)):
        msg = f"{case.id}: the witness {point} has nothing that the statement depends on"
        raise CannotJudgeError(msg)
    failing = _failing(case)
    if not failing:
        msg = f"{case.id}: the witness {point} does not show that it fails as printed"
        raise CannotJudgeError(msg)
    missing = sorted(_quantities(case, failing) - point.keys(), key=str)
    if missing:
        msg = f"{case.id}: expected a value for {missing[0]} at the witness, got none"
        raise CannotJudgeError(msg)
    if all(
        _has_no_value(part, case, point) and not _has_no_value(part, case, {}) for part in failing
    ):
        msg = f"{case.id}: at the witness {point} it has no value; choose one where it is wrong"
        raise CannotJudgeError(msg)


def _failing(case: Case) -> list[Basic]:
    """List the parts of a statement that are false at its witness."""
    try:
        return [p for p in parts(case.printed.statement) if fails(p, case.reading, case.witness)]
    except ValueError as error:
        msg = f"{case.id}: at the witness {case.witness} it has no value: {error}"
        raise CannotJudgeError(msg) from error


def _quantities(case: Case, among: Iterable[Basic]) -> set[Basic]:
    """List the free quantities of parts of the statement, of the condition, and of what is given.

    Things that are named in words have no value.
    """
    own = () if case.condition is None else (case.condition,)
    names = set().union(*(each.holds.free_symbols for each in (*case.given, *own)))
    for part in among:
        for side in part.args[:1] if isinstance(part, Approximately) else part.args:
            names |= case.reading(side).free_symbols
    return {name for name in names if not str(name).startswith(r"\text{")}


def _is_exact(value: object, shape: tuple[Basic, ...]) -> bool:
    """Whether a value is a number without rounding, or a matrix of such of the right shape."""
    if isinstance(value, MatrixBase):
        return value.shape == shape and all(_is_exact(each, ()) for each in value)
    if isinstance(value, bool) or not isinstance(value, int | Expr) or shape:
        return False
    number = sympify(value)
    return bool(number.is_number and number.is_finite and not number.has(Float))


def _has_no_value(part: Basic, case: Case, point: Mapping[Basic, Basic]) -> bool:
    return any(side.has(S.NaN, zoo) for side in _sides(part, case, point))


def _sides(part: Basic, case: Case, point: Mapping[Basic, Basic]) -> tuple[Basic, ...]:
    return () if isinstance(part, Approximately) else sides(part, case.reading, point)


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
            at,
            f"{place} = {number(printed[where])}",
            f"{place} = {number(right[where])}",
            symbol=_is_of_a_symbol(case, failing),
        )
    if isinstance(right, Set):
        shown = (latex(Eq(failing.lhs, each, evaluate=False)) for each in (printed, right))
        return Witness(at, next(shown), next(shown))
    of = failing.rhs if isinstance(failing.rhs, Angle) else failing.lhs
    return Witness(at, number(printed, of), number(right, of))


def _is_of_a_symbol(case: Case, failing: Eq) -> bool:
    """Whether the correction changes the left side of what fails, and keeps the right side."""
    if case.right is None:
        return False
    mended = dict(zip(parts(case.printed.statement), parts(case.right), strict=True))[failing]
    return isinstance(mended, Eq) and mended.lhs != failing.lhs and mended.rhs == failing.rhs


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
