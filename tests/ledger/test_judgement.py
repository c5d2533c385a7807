"""What the judgement refuses: nothing that is brought can lie."""

from dataclasses import replace

import pytest
from sympy import (
    Eq,
    Identity,
    ImmutableMatrix,
    Integer,
    Limit,
    Lt,
    MatMul,
    MatrixSymbol,
    Ne,
    cos,
    sin,
)

from chr_notes import printed
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import CannotJudgeError, Case, Reading, complete
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.reading import reading
from chr_notes.printed.statement import InOrder

from .tried import FALSE, NAME, READ, ROOTED, Bring, Say, x, y, z

STEPS = (Step("So.", Eq(y * x, x**3)),)


def test_a_true_statement_is_proved(say: Say) -> None:
    assert say(Eq(y, x * x)).verdict == "proved"


def test_a_false_one_is_refused_with_what_is_left_over(say: Say) -> None:
    with pytest.raises(
        CannotJudgeError, match=r"tried.1.1: not proved as printed: .* x\*\(x - 1\)"
    ):
        say(FALSE)
    with pytest.raises(CannotJudgeError, match=r"part 2 of 2, left less right is -x \+ z"):
        say(InOrder(Eq(y, x * x), Eq(z, x)))
    with pytest.raises(CannotJudgeError, match=r"in element \(2, 1\)"):
        say(Eq(ImmutableMatrix([y, y]), ImmutableMatrix([x * x, x]), evaluate=False))


def test_what_says_nothing_is_refused(say: Say) -> None:
    with pytest.raises(CannotJudgeError, match="the same on both sides"):
        say(InOrder(Eq(y, x * x), Eq(z, z, evaluate=False)))
    with pytest.raises(CannotJudgeError, match="one thing twice"):
        say(InOrder(Eq(y, x * x), Eq(y, x**2)))
    sufficient: Bring = {"condition": Condition(Eq(x, 0)), "witness": {x: 2}, **ROOTED}
    with pytest.raises(CannotJudgeError, match="the same on both sides"):
        say(InOrder(FALSE, Eq(z, z, evaluate=False)), **sufficient)
    with pytest.raises(CannotJudgeError, match="the same on both sides"):
        say(Eq(Limit(NAME, z, 0), NAME), read=reading({NAME: x}))


def test_a_witness_must_lie_outside_and_fail(say: Say) -> None:
    biased: Bring = {"read": reading({y: x + z}), "condition": Condition(Eq(z, 0))}
    with pytest.raises(CannotJudgeError, match="does not show that it fails"):
        say(FALSE, witness={x: 1, z: 0}, **biased, **ROOTED)
    with pytest.raises(CannotJudgeError, match="meets the condition"):
        say(FALSE, condition=Condition(Lt(x, 5)), witness={x: 2}, **ROOTED)
    given = (Condition(Lt(x, 1)),)
    with pytest.raises(CannotJudgeError, match="outside what is given"):
        say(FALSE, given=given, witness={x: 2, z: 1}, **biased, **ROOTED)


def test_a_correction_keeps_what_it_does_not_correct(say: Say) -> None:
    right = say(FALSE, edits=(Edit(x, x**2),), witness={x: 2}, steps=STEPS, **ROOTED)
    assert right.verdict == "corrected"
    assert right.correction_latex == r"y = \boxed{x^{2}}"
    with pytest.raises(CannotJudgeError, match="expected in print"):
        say(Eq(y, z), edits=(Edit(x, x**2),), witness={x: 2, z: 1}, **ROOTED)
    with pytest.raises(CannotJudgeError, match="the correction is not proved"):
        say(FALSE, edits=(Edit(x, 2 * x),), witness={x: 3}, **ROOTED)


def test_a_correction_that_says_nothing_is_refused(say: Say) -> None:
    with pytest.raises(CannotJudgeError, match="says nothing"):
        say(FALSE, edits=(Edit(x, y),), witness={x: 2}, **ROOTED)
    tautology = (Edit(y, cos(z) ** 2 + sin(z) ** 2), Edit(x, Integer(1)))
    with pytest.raises(CannotJudgeError, match="says nothing"):
        say(FALSE, edits=tautology, witness={x: 2}, **ROOTED)


def test_a_correction_of_matrices_that_says_nothing_is_refused(say: Say) -> None:
    one, other = (MatrixSymbol(name, 2, 2) for name in ("A", "B"))
    wrong = Eq(one, one + other, evaluate=False)
    empty: Bring = {"edits": (Edit(one + other, MatMul(Identity(2), one, evaluate=False)),)}
    point = dict.fromkeys((one, other), ImmutableMatrix([[1, 2], [3, 4]]))
    with pytest.raises(CannotJudgeError, match="says nothing"):
        say(wrong, witness=point, **empty, **ROOTED)


def test_a_witness_at_which_the_correction_fails_too_is_refused(say: Say) -> None:
    # Both are 0/0 there, so that it does not show the printed one to be the worse.
    printed, right = Eq(y * x / x, x**2, evaluate=False), (Edit(y * x / x, x**3 / x),)
    with pytest.raises(CannotJudgeError, match=r"fails at the witness|does not show|not proved"):
        say(printed, edits=right, witness={x: 0}, **ROOTED)


def test_a_witness_shows_more_than_a_division_by_zero(say: Say) -> None:
    quotient = Eq(y * x / x, x**2, evaluate=False)
    not_zero: Bring = {"condition": Condition(Ne(x, 0)), "witness": {x: 0}}
    with pytest.raises(CannotJudgeError, match="it has no value"):
        say(
            Eq(y / (x - 1), x**2 / (x - 1)), condition=Condition(Ne(x, 1)), witness={x: 1}, **ROOTED
        )
    with pytest.raises(CannotJudgeError, match=r"it has no value|does not show"):
        say(quotient, **not_zero, **ROOTED)


def test_a_condition_and_a_correction_together_are_refused(say: Say) -> None:
    both: Bring = {"condition": Condition(Eq(x, 0)), "edits": (Edit(x, x**2),)}
    with pytest.raises(CannotJudgeError, match="got both"):
        say(FALSE, witness={x: 2}, **both, **ROOTED)


def test_root_and_weight_go_with_what_does_not_hold(say: Say) -> None:
    settled: Bring = {"edits": (Edit(x, x**2),), "witness": {x: 2}}
    with pytest.raises(CannotJudgeError, match="expected a root and weight"):
        say(FALSE, **settled)
    with pytest.raises(CannotJudgeError, match=r"as root one of .*roots\.py, .*; got 'no such"):
        say(FALSE, root="no such root", weight="label", **settled)
    with pytest.raises(CannotJudgeError, match="expected no root and weight"):
        say(Eq(y, x * x), **ROOTED)


def test_steps_are_proved_and_show_something(say: Say) -> None:
    true = Eq(y, x * x)
    assert say(true, steps=(Step("So.", Eq(y * x, x**3)),)).derivation
    with pytest.raises(CannotJudgeError, match="step 1 is not proved"):
        say(true, steps=(Step("So.", Eq(y * x, x**2)),))
    with pytest.raises(CannotJudgeError, match="step 2 shows the same on both sides"):
        say(true, steps=(Step("So.", true), Step("So.", Eq(x * x, x**2, evaluate=False))))


def test_of_several_readings_the_first_makes_it_true_or_an_edit_does(say: Say) -> None:
    square, cube = Eq(y, x**2), Eq(y, x**3)
    readings = (Reading(square, READ, {x: 2}), Reading(cube, reading({y: x**3}), {x: 2}))
    found = (("y = x^{2}", True), ("y = x^{3}", False))
    assert say(Eq(y, x * x), readings=readings).readings == found
    swapped = (replace(readings[0], convention=cube), replace(readings[1], convention=square))
    with pytest.raises(CannotJudgeError, match="under its own reading alone"):
        say(Eq(y, x * x), readings=swapped)
    # A misprint besides is wrong under each of them.
    wrong: Bring = {"edits": (Edit(x, x**2),), "witness": {x: 2}, "steps": STEPS, **ROOTED}
    misprint = say(FALSE, readings=readings, **wrong)
    assert misprint.readings == (("y = x^{2}", False), ("y = x^{3}", False))
    with pytest.raises(CannotJudgeError, match=r"1\.2: expected readings as of tried\.1\.1.*; no"):
        say(Eq(y, x * x), Eq(y, x**2), readings=readings)
    with pytest.raises(CannotJudgeError, match="under the first of its readings"):
        say(Eq(y, x * x), readings=readings[1:])


def test_a_document_has_one_reading(say: Say) -> None:
    with pytest.raises(ValueError, match="not read yet"):
        READ.also({y: x**3})
    assert say(Eq(NAME, x**3), read=READ.also({NAME: x**3})).verdict == "proved"
    document = printed.DOCUMENTS["tried"]
    with pytest.raises(CannotJudgeError, match="read otherwise than the document"):
        complete(document, READ, (Case("tried.1.1", reading({y: x**3})),))
    with pytest.raises(CannotJudgeError, match="expected one case at most"):
        complete(document, READ, (Case("tried.1.9"),))
    odd = (Case("tried.1.1", reading({y: x**3}), told_in="tried.1.7"), Case("tried.1.9"))
    with pytest.raises(CannotJudgeError, match=r"at most.*\n.*: read other.*\n.*as told_in"):
        complete(document, READ, odd)
    assert replace(Case("tried.1.1"), read=READ).reading is READ


def test_all_cases_that_are_not_made_of_what_they_should_be_are_told() -> None:
    odd: tuple[Bring, Bring] = ({"id": "euler.2.a", "edits": (x,)}, {"id": "euler.4.1", "steps": 1})
    with pytest.raises(CannotJudgeError, match=r"2\.a: expected Edit .*\neuler\.4\.1: .* as steps"):
        complete(printed.DOCUMENTS["euler"], READ, tuple(Case(**each) for each in odd))  # type: ignore[arg-type]
