"""What is given is what the document says; nothing else makes a wrong line right."""

from dataclasses import replace

import pytest
from sympy import Abs, And, Eq, Ge, Le
from sympy.logic.boolalg import Boolean

from chr_notes.ledger.case import CannotJudgeError, complete
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.checks import check_conditions, check_definition
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.generality import check_given
from chr_notes.ledger.reading import defined
from chr_notes.ledger.sensors_reading import READ, TEMPERATURES
from chr_notes.printed import BY_ID, DOCUMENTS
from chr_notes.symbols import QUATERNION, b, c, d, phi, psi, q, r, theta

PRESUMED = {row: None for case in CASES.values() for row in case.reading.presumed}


@pytest.mark.parametrize("row", PRESUMED, ids=lambda row: f"{row.says}, {row.words}")
def test_what_is_presumed_is_said_in_the_document_that_presumes_it(row: Presumed) -> None:
    assert row.is_said
    for name in row.presuming:
        assert BY_ID[name].document == BY_ID[row.says].document
        assert row.holds in CASES[name].given


@pytest.mark.parametrize(
    ("name", "holds"),
    [
        ("quaternions.3.1", And(Eq(b, 0), Eq(c, 0), Eq(d, 0))),
        ("quaternions.3.1", And(Ge(b, 0), Le(b, 0), Ge(c, 0), Le(c, 0), Ge(d, 0), Le(d, 0))),
        ("validation.1", And(Eq(phi, 0), Eq(theta, 0), Eq(psi, 0))),
        ("euler.7.a", And(Eq(phi, 0), Eq(theta, 0))),
        ("validation.4", Eq(theta, 0)),
        ("estimation.2.6", Le(Abs(phi), 0)),
        ("sensors.4.f", Eq(*TEMPERATURES)),
    ],
)
def test_what_makes_a_wrong_line_right_is_not_given(name: str, holds: Boolean) -> None:
    with pytest.raises((CannotJudgeError, ValueError), match=r"does not say|no rule"):
        check_given(replace(CASES[name], given=(Condition(holds),)))


@pytest.mark.parametrize(
    ("name", "holds"),
    [
        ("validation.4", Eq(theta, 0)),
        ("validation.1", And(Eq(phi, 0), Eq(theta, 0), Eq(psi, 0))),
        ("quaternions.3.1", And(Eq(b, 0), Eq(c, 0), Eq(d, 0))),
        ("euler.7.a", Eq(theta, phi)),
        ("euler.7.a", And(Eq(q, 0), Eq(r, 0))),
    ],
)
def test_one_attitude_is_no_condition(name: str, holds: Boolean) -> None:
    with pytest.raises(CannotJudgeError, match="is one attitude"):
        check_given(replace(CASES[name], edits=(), condition=Condition(holds)))


def test_bounds_leave_something_between_them() -> None:
    pinched = And(*(part for n in QUATERNION[1:] for part in (Ge(n, 0), Le(n, 0))))
    with pytest.raises(CannotJudgeError, match="no point was found"):
        check_conditions(replace(CASES["quaternions.3.1"], condition=Condition(pinched)))


def test_an_equation_that_is_wrong_is_no_definition_of_what_it_is_made_of() -> None:
    case = replace(CASES["sensors.4.1"], read=READ, definition=True, steps=())
    with pytest.raises(CannotJudgeError, match="gives no new name"):
        check_definition(case)
    document = DOCUMENTS["sensors"]
    by_it = replace(CASES["sensors.4.2"], read=READ.also(defined("sensors.4.1")))
    with pytest.raises(CannotJudgeError, match="no statement is read by it"):
        complete(document, READ, (case, by_it))
