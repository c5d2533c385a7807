"""A card says all that the entry has, and breaks long formulas where a reader would."""

import re

import pytest

from chr_notes.ledger import entries
from chr_notes.ledger.show import AND, LONG, display, show, show_additions
from chr_notes.printed import ADDITIONS


def test_short_formulas_stay_as_they_are() -> None:
    assert display("a = b") == "$$\na = b\n$$\n"
    assert display(f"a{AND}b") == f"$$\na{AND}b\n$$\n"


def test_long_statements_stand_on_a_line_each() -> None:
    first, second = "x" * LONG, "y" * LONG
    shown = display(f"{first}{AND}{second}")
    assert first in shown
    assert second in shown
    assert AND not in shown
    assert shown.count(r"\\") == 1


def test_statements_are_taken_apart_between_brackets_not_within() -> None:
    for entry in entries():
        for part in entry.printed_latex.split(AND):
            assert part.count("{") == part.count("}"), entry.id
            assert part.count(r"\left") == part.count(r"\right"), entry.id


def test_a_card_has_formula_verdict_condition_and_witness() -> None:
    for entry in entries():
        text = show(entry.id).markdown()
        assert f"{entry.verdict}</span>" in text
        for formula in (entry.printed_latex, entry.correction_latex, entry.condition):
            assert formula is None or display(formula) in text
        assert ("Witness" in text) == (entry.witness is not None)


def test_no_step_of_a_derivation_is_shown_as_a_mere_truth() -> None:
    for entry in entries():
        text = show(entry.id).markdown()
        assert r"\text{True}" not in text, entry.id
        for formula in re.findall(r"\$\$\n(.*)\n\$\$", text):
            left, _, right = formula.partition(" = ")
            assert left != right, entry.id


def test_all_additions_of_a_document_are_shown_in_their_order() -> None:
    for document, additions in ADDITIONS.items():
        shown = [card.entry.id for card in show_additions(document).cards]
        assert shown == [printed.id for printed in additions]


def test_a_derivation_is_gone_through_once() -> None:
    shown = show("euler.7.2", derived=True)._repr_markdown_()
    assert shown.index("chr-steps") < shown.index('id="entry-euler.7.2"')
    assert shown.count("Each Euler rate is a turn about one known axis") == 1
    assert "<summary>Derivation</summary>" not in shown
    with pytest.raises(ValueError, match=r"euler\.2\.a has none"):
        show("euler.2.a", derived=True)
