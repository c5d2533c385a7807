"""What the judgement refuses: nothing that is brought can lie."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from sympy import (
    Abs,
    And,
    Basic,
    Eq,
    Ge,
    Gt,
    Identity,
    ImmutableMatrix,
    Integer,
    Le,
    Limit,
    Lt,
    MatMul,
    MatrixSymbol,
    Ne,
    Symbol,
    Xor,
    cos,
    pi,
    sin,
    symbols,
)

from chr_notes import printed
from chr_notes.derivations.steps import Step
from chr_notes.ledger.case import CannotJudgeError, Case, Reading, complete
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.entry import Entry
from chr_notes.ledger.judgement import judge
from chr_notes.ledger.reading import Defined, Read, reading
from chr_notes.printed import Printed
from chr_notes.printed.statement import InOrder, words
from chr_notes.symbols import theta

x, y, z = symbols("x y z", real=True)
K = Symbol("k", positive=True)
NAME, OTHER = Symbol("name", real=True), Symbol("other", real=True)
# y stands for x squared, phi for the angle of a point on a circle.
READ = reading({y: x**2})
Bring = dict[str, object]
Say = Callable[..., Entry]


@pytest.fixture
def say(monkeypatch: pytest.MonkeyPatch) -> Say:
    """Let a document print statements, and judge the first of them, or the one asked for."""

    def judged(
        *statements: Basic,
        of: int = 1,
        read: Read = READ,
        given: tuple[Condition, ...] = (),
        unsaid: tuple[Condition, ...] = (),
        **brought: object,
    ) -> Entry:
        document = tuple(
            Printed(f"tried.1.{n}", "equation", "nowhere", "A statement.", statement)
            for n, statement in enumerate(statements, 1)
        )
        monkeypatch.setitem(printed.DOCUMENTS, "tried", document)
        for each in document:
            monkeypatch.setitem(printed.BY_ID, each.id, each)
        if given:
            said = tuple(Presumed(each, "A statement", f"tried.1.{of}") for each in given)
            read = Read(read.meaning, read.notation, presumed=said)
        case = Case(f"tried.1.{of}", given=unsaid, **brought)  # type: ignore[arg-type]
        return judge(complete(document, read, (case,))[of - 1])

    return judged


ROOTED: Bring = {"root": "inverse-is-conjugate", "weight": "misleads"}
FALSE = Eq(y, x, evaluate=False)


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
        with pytest.raises(ValueError, match=r"no rule for|expected a relation"):
            Condition(holds)
    with pytest.raises(CannotJudgeError, match="not proved under the condition"):
        say(FALSE, condition=Condition(Lt(x, 1)), witness={x: 2}, **ROOTED)


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
    right = say(FALSE, edits=(Edit(x, x**2),), witness={x: 2}, **ROOTED)
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


def test_a_condition_that_cannot_be_met_is_refused(say: Say) -> None:
    with pytest.raises(ValueError, match="can be met"):
        Condition(Eq(Abs(z), -1, evaluate=False))
    never = Condition(And(Gt(theta, 1), Lt(theta, x)))
    for given in ((never, Condition(Lt(x, 0))), (Condition(Eq(sin(x), 2)),)):
        with pytest.raises(CannotJudgeError, match="no point was found that meets"):
            say(Eq(y, x * x), given=given)


def test_a_condition_has_a_quantity_on_its_left() -> None:
    for holds in (Lt(1, theta, evaluate=False), Eq(1, x, evaluate=False), Xor(x > 1, z > 1)):
        with pytest.raises(ValueError, match="quantity on the left"):
            Condition(holds)


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
    needed = Step("So.", Eq(Abs(z), z))
    assert say(Eq(y, x * x), given=(Condition(Gt(z, 0)),), steps=(needed,)).verdict == "proved"


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


BY_NAME = READ.also({NAME: Defined("tried.1.1")})
USED = Eq(NAME, x)


def test_a_definition_introduces_a_name(say: Say) -> None:
    definition = say(Eq(NAME, x), USED, read=BY_NAME, definition=True)
    assert definition.verdict == "definition"
    assert say(Eq(NAME, x), USED, read=BY_NAME, of=2).verdict == "proved"


def test_a_name_without_a_meaning_is_no_definition_by_itself(say: Say) -> None:
    with pytest.raises(CannotJudgeError, match="a name without a meaning"):
        say(Eq(NAME, x))
    with pytest.raises(CannotJudgeError, match="a name without a meaning"):
        say(Eq(NAME, x), USED, read=BY_NAME)


def test_a_definition_is_read_by_another_statement(say: Say) -> None:
    for others in ((), (Eq(OTHER, x),)):
        with pytest.raises(CannotJudgeError, match="no statement is read by it"):
            say(Eq(NAME, x), *others, read=BY_NAME, definition=True)
    with pytest.raises(CannotJudgeError, match="no statement is read by it"):
        say(Eq(NAME, x), USED, definition=True)


def test_a_definition_brings_nothing_else(say: Say) -> None:
    more: Bring = {"edits": (Edit(x, x**2),), "witness": {x: 2}, **ROOTED}
    with pytest.raises(CannotJudgeError, match="gives no new name"):
        say(Eq(NAME, x), USED, read=BY_NAME, definition=True, **more)
    with pytest.raises(CannotJudgeError, match="no statement is read by it"):
        say(Eq(y, x * x), Eq(y, x**2), definition=True)


def test_a_name_with_a_meaning_is_not_defined_once_more(say: Say) -> None:
    again = (Eq(NAME, x), Eq(NAME, 2 * x), Eq(2 * NAME, 4 * x))
    second: Bring = {"of": 2, "read": reading({NAME: Defined("tried.1.2")}), "definition": True}
    with pytest.raises(CannotJudgeError, match="gives no new name"):
        say(*again, **second)
    assert say(*again, **second, replaces="tried.1.1").verdict == "definition"
    for other in ("tried.1.2", "tried.1.3", "tried.1.9", "euler.5.5"):
        with pytest.raises(CannotJudgeError, match="expected to replace an earlier meaning"):
            say(*again, **second, replaces=other)
    with pytest.raises(CannotJudgeError, match="expected to replace an earlier meaning"):
        say(Eq(OTHER, x), *again[1:], **second, replaces="tried.1.1")
    with pytest.raises(CannotJudgeError, match="expected to replace an earlier meaning"):
        say(Eq(y, x * x), Eq(y, x**2), of=2, replaces="tried.1.1")
    with pytest.raises(CannotJudgeError, match="not proved as printed"):
        say(Eq(NAME, x), read=reading({NAME: x**2}))
    assert say(Eq(NAME, x), read=reading({NAME: x})).verdict == "proved"
    with pytest.raises(CannotJudgeError, match="not proved as printed"):
        say(Eq(NAME, NAME + x, evaluate=False))


def test_a_name_that_is_defined_by_itself_is_refused(say: Say) -> None:
    own = reading({NAME: Defined("tried.1.1")})
    with pytest.raises(ValueError, match=r"defined by itself, in tried\.1\.1"):
        say(Eq(NAME, OTHER + NAME, evaluate=False), Eq(NAME, OTHER), of=2, read=own)


def test_a_reported_fact_is_written_down_twice(say: Say) -> None:
    fact = Eq(words("weight of the product"), 7, evaluate=False)
    assert say(fact, reported=fact).verdict == "reported"
    with pytest.raises(CannotJudgeError, match="expected in print"):
        say(fact, reported=Eq(words("weight of the product"), 8, evaluate=False))
    with pytest.raises(CannotJudgeError, match="is derived"):
        say(Eq(y, 7), reported=Eq(y, 7))
    weight = words("weight of the product")
    for mathematics in (Eq(z, 7), Eq(2, 3, evaluate=False), Eq(weight, z), Eq(2 * weight, 7)):
        with pytest.raises(CannotJudgeError, match="has mathematics to check"):
            say(mathematics, reported=mathematics)


def test_root_and_weight_go_with_what_does_not_hold(say: Say) -> None:
    settled: Bring = {"edits": (Edit(x, x**2),), "witness": {x: 2}}
    with pytest.raises(CannotJudgeError, match="expected a root and weight"):
        say(FALSE, **settled)
    with pytest.raises(CannotJudgeError, match="as root"):
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


def test_of_several_readings_one_must_make_it_true(say: Say) -> None:
    square, cube = Eq(y, x**2), Eq(y, x**3)
    readings = (Reading(square, READ, {x: 2}), Reading(cube, reading({y: x**3}), {x: 2}))
    found = (("y = x^{2}", True), ("y = x^{3}", False))
    assert say(Eq(y, x * x), readings=readings).readings == found
    swapped = (replace(readings[0], convention=cube), replace(readings[1], convention=square))
    with pytest.raises(CannotJudgeError, match="under its own reading alone"):
        say(Eq(y, x * x), readings=swapped)
    wrong: Bring = {"edits": (Edit(x, x**2),), "witness": {x: 2}, **ROOTED}
    with pytest.raises(CannotJudgeError, match="under none of its readings"):
        say(FALSE, readings=readings, **wrong)
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
    assert replace(Case("tried.1.1"), read=READ).reading is READ
