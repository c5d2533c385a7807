"""Our words fit the formula: a sense that is turned round is refused."""

from dataclasses import replace

import pytest

from chr_notes import ledger, printed
from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.judgement import judge
from chr_notes.ledger.words import ELSEWHERE, misfits

from .senses import TURNED, wrong_senses

ENTRIES = ledger.entries()


def refused(entry: ledger.Entry, says: str) -> bool:
    return any(misfits(entry.id, says, entry.printed_latex, entry.given or ""))


def test_all_words_of_the_ledger_fit() -> None:
    assert [entry.id for entry in ENTRIES if refused(entry, entry.says)] == []


def test_the_judgement_refuses_words_that_do_not_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    height = printed.BY_ID["euler.2.a"]
    wrong = replace(height, says=height.says.replace("negative", "positive"))
    assert wrong != height
    monkeypatch.setitem(printed.BY_ID, "euler.2.a", wrong)
    with pytest.raises(CannotJudgeError, match="“positive” is said and does not show"):
        judge(CASES["euler.2.a"])


@pytest.mark.parametrize("word", TURNED)
def test_each_word_of_sense_is_missed_somewhere(word: str) -> None:
    kind = f"{word!r} to {TURNED[word]!r}"
    assert any(
        refused(entry, wrong)
        for entry in ENTRIES
        for turned, wrong in wrong_senses(entry.says)
        if turned == kind
    )


def test_numbers_in_words_are_those_of_the_formula() -> None:
    changed = [
        refused(entry, wrong)
        for entry in ENTRIES
        for kind, wrong in wrong_senses(entry.says)
        if kind.startswith("number") and "Table" not in entry.says
    ]
    assert sum(changed) > len(changed) // 2


def test_what_stands_elsewhere_is_of_entries_that_there_are() -> None:
    assert ELSEWHERE.keys() <= {entry.id for entry in ENTRIES}
