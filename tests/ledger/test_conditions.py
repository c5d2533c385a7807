"""What the judgement refuses of conditions, and of what is given."""

import pytest
from sympy import (
    Abs,
    And,
    Eq,
    Ge,
    Gt,
    Le,
    Lt,
    Ne,
    Xor,
    pi,
    sin,
)

from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.reading import Read, reading
from chr_notes.symbols import theta

from .tried import FALSE, NAME, OTHER, READ, ROOTED, Bring, Say, x, y, z


def test_an_equality_is_not_proved_as_an_inequality(say: Say) -> None:
    for less in (Ge, Le):
        with pytest.raises(CannotJudgeError, match="says less than is so"):
            say(less(y, x * x, evaluate=False))
    within: Bring = {"condition": Condition(Gt(z, 0)), "witness": {z: -1}}
    with pytest.raises(CannotJudgeError, match="says less than is so"):
        say(Le(Abs(z), z, evaluate=False), **within, **ROOTED)
    assert say(Ge(y + x**2, x**2), read=reading({y: x**2})).verdict == "proved"


def test_an_exact_condition_is_told_from_a_sufficient_one(say: Say) -> None:
    biased = reading({y: x**2 + z})
    at_rest: Bring = {"condition": Condition(Eq(z, 0)), "witness": {x: 2, z: 1}, "read": biased}
    exact = say(Eq(y, x**2), **at_rest, **ROOTED)
    assert (exact.verdict, exact.exact) == ("qualified", True)
    positive = Eq(Abs(z), z, evaluate=False)
    only_if = say(positive, condition=Condition(Gt(z, 1)), witness={z: -1}, **ROOTED)
    assert (only_if.verdict, only_if.exact) == ("qualified", False)
    assert "holds as well" in only_if.method


def test_single_values_of_several_are_no_condition(say: Say) -> None:
    twice: Bring = {"condition": Condition(Eq(z, 0)), "witness": {x: 2, z: 3}}
    with pytest.raises(CannotJudgeError, match="single values"):
        say(Eq(y, x), read=reading({y: x + z * (z - 1)}), **twice, **ROOTED)
    with pytest.raises(CannotJudgeError, match="the document writes x, for any value"):
        say(FALSE, condition=Condition(Eq(x, 0)), witness={x: 2}, **ROOTED)
    some = reading({y: sin(theta)})
    level: Bring = {"condition": Condition(Eq(theta, 0)), "witness": {theta: 1}, "read": some}
    with pytest.raises(CannotJudgeError, match="is one attitude"):
        say(Eq(y, -sin(theta)), **level, **ROOTED)


def test_what_is_given_is_said_by_the_document(say: Say) -> None:
    true = Eq(Abs(z), z, evaluate=False)
    positive, unequal = Condition(Gt(z, 0)), Condition(Ne(x, 1))
    assert say(true, given=(positive,)).verdict == "proved"
    with pytest.raises(CannotJudgeError, match="does not say that it presumes z > 0"):
        say(true, unsaid=(positive,))
    for said in ("No such words", ""):
        read = Read(READ.meaning, READ.notation, presumed=(Presumed(positive, said, "tried.1.1"),))
        with pytest.raises(CannotJudgeError, match="does not say"):
            say(true, read=read)
    # Single values are left out by words as well.
    quotient = Eq(y * (x - 1) / (x - 1), x**2, evaluate=False)
    needed = Step("So.", Ne(x - 1, 0, evaluate=False))
    assert say(quotient, given=(unequal,), steps=(needed,)).verdict == "proved"
    with pytest.raises(CannotJudgeError, match="does not say that it presumes"):
        say(quotient, unsaid=(unequal,), steps=(needed,))


def test_an_attitude_is_fixed_by_the_words_of_the_statement_alone(say: Say) -> None:
    wrong, level = Eq(y, -sin(theta), evaluate=False), Condition(Eq(theta, 0))
    for where, says in (("tried.1.1", None), ("tried.1.2", "own words do not say")):
        presumed = Presumed(level, "A statement", where, ("tried.1.1",))
        read = Read({y: sin(theta)}, READ.notation, presumed=(presumed,))
        if says is None:
            assert say(wrong, Eq(y, y + 0), read=read).verdict == "proved"
        else:
            with pytest.raises(CannotJudgeError, match=says):
                say(wrong, Eq(y, y + 0), read=read)


def test_the_condition_shown_is_the_one_that_is_proved(say: Say) -> None:
    for holds in (Lt(abs(theta), 3 * pi / 4), And(), And(Eq(x, 1), Lt(x, 3), evaluate=False)):
        with pytest.raises(CannotJudgeError, match=r"x.1: (no rule for|expected a relation)"):
            Case("x.1", condition=Condition(holds)).check()
    with pytest.raises(CannotJudgeError, match="not proved under the condition"):
        say(FALSE, condition=Condition(Lt(x, 1)), witness={x: 2}, **ROOTED)


def test_a_condition_that_cannot_be_met_is_refused(say: Say) -> None:
    with pytest.raises(CannotJudgeError, match=r"x.1: .* can be met"):
        Case("x.1", given=(Condition(Eq(Abs(z), -1, evaluate=False)),)).check()
    never = Condition(And(Gt(theta, 1), Lt(theta, x)))
    for given in ((never, Condition(Lt(x, 0))), (Condition(Eq(sin(x), 2)),)):
        with pytest.raises(CannotJudgeError, match="no point was found that meets"):
            say(Eq(y, x * x), given=given)


def test_a_condition_has_a_quantity_on_its_left() -> None:
    for holds in (Lt(1, theta, evaluate=False), Eq(1, x, evaluate=False), Xor(x > 1, z > 1)):
        with pytest.raises(CannotJudgeError, match=r"x.1: .*quantity on the left"):
            Case("x.1", condition=Condition(holds)).check()


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("condition", "x > 0", "expected Condition or None as condition, got 'x > 0'"),
        ("condition", -NAME, "expected Condition or None as condition, got -name"),
        ("condition", Condition(-NAME), "expected relations with a quantity on the left, got"),
        ("condition", Condition("x > 0"), "expected a relation or several as condition, got x > 0"),
        ("given", Condition(Gt(x, 0)), "expected tuple as given, got Condition"),
        ("witness", None, "expected Mapping as witness, got None"),
        ("edits", (x,), "expected Edit as one of edits, got x"),
        ("steps", (Eq(y, x**2),), r"expected Step as one of steps, got Eq\(y, x\*\*2\)"),
        ("steps", (Step("So.", "y = x"),), "expected a relation as step, got 'y = x'"),
        ("steps", (Step("So.", Eq(1, 1)),), "expected a relation as step, got True"),
        ("readings", (READ,), "expected Reading as one of readings, got <"),
    ],
)
def test_what_is_not_of_its_kind_is_told_with_the_entry(
    name: str, value: object, says: str
) -> None:
    with pytest.raises(
        CannotJudgeError, match=rf"euler\.2\.a: {says}.*; see chr_notes/printed/euler"
    ):
        Case("euler.2.a", **{name: value}).check()  # type: ignore[arg-type]


def test_what_cannot_be_worked_out_is_told_with_the_entry(say: Say) -> None:
    text = reading({y: lambda: "x"})  # type: ignore[dict-item,return-value]
    with pytest.raises(CannotJudgeError, match=r"tried.1.1: expected mathematics .*, got: "):
        say(Eq(y, x, evaluate=False), read=text)


def test_a_condition_that_says_the_statement_is_refused(say: Say) -> None:
    meaning = reading({y: x**2, OTHER: z})
    for statement, holds in (
        (Eq(y, z), Eq(z, x**2)),
        (Eq(y, z), Eq(y, z)),
        (Eq(y, z), Eq(OTHER, y)),
        (Eq(y, 2 * z), Eq(y - OTHER, z)),
    ):
        with pytest.raises(CannotJudgeError, match="says what the statement says"):
            say(statement, read=meaning, condition=Condition(holds), witness={x: 2, z: 1}, **ROOTED)
    unequal = Condition(Ne(y, OTHER))
    with pytest.raises(CannotJudgeError, match="says what the statement says"):
        say(Ne(x**2, z), read=meaning, given=(unequal,))


def test_what_is_given_or_a_condition_says_no_more_than_is_needed(say: Say) -> None:
    with pytest.raises(CannotJudgeError, match="holds with less than"):
        say(Eq(y, x * x), given=(Condition(Gt(z, 0)),))
    more = Condition(And(Eq(x, 1), Gt(z, 0)))
    with pytest.raises(CannotJudgeError, match="holds with less than"):
        say(FALSE, condition=more, witness={x: 2, z: -1}, **ROOTED)
    needed = Step("So.", Eq(Abs(z) * y, z * x**2))
    assert say(Eq(y, x * x), given=(Condition(Gt(z, 0)),), steps=(needed,)).verdict == "proved"
