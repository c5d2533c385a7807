"""What the judgement refuses as a definition, and as a fact about a product."""

import pytest
from sympy import (
    Eq,
)

from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.edits import Edit
from chr_notes.ledger.reading import Defined, reading
from chr_notes.printed.statement import words

from .tried import NAME, OTHER, READ, ROOTED, Bring, Say, x, y, z

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
    with pytest.raises(CannotJudgeError, match=r"defined by itself, in tried\.1\.1"):
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
