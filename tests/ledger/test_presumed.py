"""What is given is what the document says; nothing else makes a wrong line right."""

from dataclasses import replace

import pytest
from sympy import (
    Abs,
    And,
    Eq,
    Ge,
    Identity,
    ImmutableMatrix,
    Integer,
    Le,
    Ne,
    Rational,
    ZeroMatrix,
)
from sympy.logic.boolalg import Boolean

from chr_notes.derivations.calibration import HARD_IRON
from chr_notes.ledger.case import CannotJudgeError, complete
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.checks import check_conditions, check_definition
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.estimation_reading import FORCE
from chr_notes.ledger.generality import check_condition, check_given, check_reading
from chr_notes.ledger.judgement import judge
from chr_notes.ledger.reading import Read, defined
from chr_notes.ledger.sensors_reading import READ, TEMPERATURES
from chr_notes.printed import BY_ID, DOCUMENTS, estimation, sensors, validation
from chr_notes.symbols import QUATERNION, a, b, c, d, phi, psi, q, r, theta

from .planting import planted

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
        check_condition(replace(CASES[name], edits=(), condition=Condition(holds)))


def test_bounds_leave_something_between_them() -> None:
    pinched = And(*(part for n in QUATERNION[1:] for part in (Ge(n, 0), Le(n, 0))))
    with pytest.raises(CannotJudgeError, match=r"quaternions.3.1: no rule for the condition"):
        replace(CASES["quaternions.3.1"], condition=Condition(pinched)).check()
    never = And(Ge(b, 2), Le(b * b, 1))
    with pytest.raises(CannotJudgeError, match="no point was found"):
        check_conditions(replace(CASES["quaternions.3.1"], condition=Condition(never)))


@pytest.mark.parametrize(
    ("name", "holds"),
    [
        ("estimation.4.3", Eq(estimation.L, 0)),
        ("estimation.4.3", Eq(2 * estimation.L - 2, 0)),
        ("estimation.4.3", Eq(estimation.PITCH_ACCEL, estimation.PITCH_PLUS)),
        ("validation.11", Eq(validation.ALPHA, 1)),
        ("sensors.2.5", Eq(sensors.BETA_A, ZeroMatrix(3, 1))),
        ("sensors.4.3", Eq(sensors.M_A, Identity(3))),
        ("sensors.4.c", Eq(ImmutableMatrix(HARD_IRON), ImmutableMatrix.zeros(3, 1))),
        ("estimation.2.1", Eq(ImmutableMatrix(FORCE), ImmutableMatrix([0, 0, 9]))),
    ],
)
def test_where_a_term_vanishes_is_no_condition(name: str, holds: Boolean) -> None:
    case = replace(CASES[name], edits=(), condition=Condition(holds))
    with pytest.raises(CannotJudgeError, match="on what the document leaves out, got"):
        check_condition(case)


def test_a_lost_gain_is_no_matter_of_a_gain_of_nothing() -> None:
    lost = Eq(estimation.PITCH, estimation.PITCH_PLUS)
    gain = Condition(Eq(estimation.L, 0))
    brought = {"condition": gain, "root": "seam", "weight": "small print"}
    point = {estimation.PITCH_PLUS: 1, estimation.PITCH_ACCEL: 2, estimation.L: Rational(1, 2)}
    with planted("estimation.4.3", lost) as cases:
        case = replace(cases["estimation.4.3"], steps=(), witness=point, **brought)
        with pytest.raises(CannotJudgeError, match="the document writes L, for any value"):
            judge(case)


def test_what_the_document_presumes_elsewhere_may_be_a_condition() -> None:
    check_condition(CASES["quaternions.3.a"])
    case = replace(CASES["quaternions.3.a"], condition=Condition(Eq(a, 2)))
    with pytest.raises(CannotJudgeError, match=r"is one attitude"):
        check_condition(case)


@pytest.mark.parametrize("name", ["estimation.4.3", "sensors.4.c", "quaternions.4.2"])
def test_an_equation_is_not_read_at_one_value(name: str) -> None:
    case = CASES[name]
    free = {"estimation.4.3": estimation.L, "sensors.4.c": HARD_IRON[0], "quaternions.4.2": a}[name]
    check_reading(case)
    with pytest.raises(CannotJudgeError, match="for any value, read as"):
        check_reading(replace(case, read=case.reading.also({free: Integer(0)})))


SINGLE = [
    (name, given)
    for name, case in CASES.items()
    for given in case.given
    if all(isinstance(relation, Ne) for relation in given.relations)
]


@pytest.mark.parametrize(("name", "given"), SINGLE)
def test_single_values_are_left_out_by_the_words_of_the_statement_alone(
    name: str, given: Condition
) -> None:
    case = CASES[name]
    unsaid = Read(case.reading.meaning, case.reading.notation)
    with pytest.raises(CannotJudgeError, match="does not say that it presumes"):
        check_given(replace(case, given=(given,), read=unsaid))
    said = Presumed(given, "The gyros", "euler.7.b", (name,))
    if name == said.says:
        said = Presumed(given, "one of tilt", "dead_reckoning.4.i", (name,))
    elsewhere = Read(case.reading.meaning, case.reading.notation, presumed=(said,))
    with pytest.raises(CannotJudgeError, match="its own words do not say"):
        check_given(replace(case, given=(given,), read=elsewhere))


def test_an_exception_of_single_values_makes_no_verdict_of_its_own() -> None:
    """In all documents alike such values are left out by words."""
    conditions = {
        name: case.condition for name, case in CASES.items() if case.condition is not None
    }
    assert [
        name
        for name, condition in conditions.items()
        if all(isinstance(relation, Ne) for relation in condition.relations)
    ] == []


def test_an_equation_that_is_wrong_is_no_definition_of_what_it_is_made_of() -> None:
    case = replace(CASES["sensors.4.1"], read=READ, definition=True, steps=())
    with pytest.raises(CannotJudgeError, match="gives no new name"):
        check_definition(case)
    document = DOCUMENTS["sensors"]
    by_it = replace(CASES["sensors.4.2"], read=READ.also(defined("sensors.4.1")))
    with pytest.raises(CannotJudgeError, match="no statement is read by it"):
        complete(document, READ, (case, by_it))
