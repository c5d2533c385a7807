"""Our words fit the formula: a sense that is turned round is refused."""

import csv
from dataclasses import replace

import pytest

from chr_notes import ledger, printed
from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.files import see
from chr_notes.ledger.judgement import judge
from chr_notes.ledger.words import ELSEWHERE, FROM_TO, misfits

from .meant import meant
from .senses import TURNED, turned_by_a_stranger, wrong_senses
from .test_ledger import INVENTORY, ROWS

SAID = "what we say, word by word that carries sense"

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


with INVENTORY.open(encoding="utf-8") as _rows:
    TWICE = {row["id"]: row[SAID] for row in csv.DictReader(_rows, delimiter="\t")}


def seen(entry: ledger.Entry, says: str) -> bool:
    """Whether other words are refused by the formula, or by what is written down twice."""
    return refused(entry, says) or meant(says) != TWICE[entry.id]


def test_what_we_say_is_written_down_twice() -> None:
    for entry in ENTRIES:
        says, twice = meant(entry.says), TWICE[entry.id]
        assert says == twice, f"{entry.id}: {ROWS} has other words; {see(entry.id)}"
    assert len(TWICE) == len(ENTRIES), ROWS


def test_a_stranger_who_turns_words_is_seen() -> None:
    made = [(entry, wrong) for entry in ENTRIES for wrong in turned_by_a_stranger(entry.says)]
    assert len(made) > 500
    assert [(entry.id, wrong) for entry, wrong in made if not seen(entry, wrong)] == []
    # The formulas alone see some of it.
    assert sum(refused(entry, wrong) for entry, wrong in made) > len(made) // 4


def test_a_way_between_frames_is_that_of_the_formula() -> None:
    for name in ("euler.4.1", "euler.5.3", "quaternions.3.1", "quaternions.3.b", "validation.12"):
        (entry,) = (each for each in ENTRIES if each.id == name)
        source, target = FROM_TO.findall(entry.says)[0]
        wrong = entry.says.replace(source, "?").replace(target, source).replace("?", target)
        assert any("from" in misfit for misfit in misfits(name, wrong, entry.printed_latex))


def test_what_stands_elsewhere_is_of_entries_that_there_are() -> None:
    assert ELSEWHERE.keys() <= {entry.id for entry in ENTRIES}
