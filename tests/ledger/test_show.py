"""A card says all that the entry has, and breaks long formulas where a reader would."""

import re

import pytest

from chr_notes.derivations.told.dead_reckoning import DRIFT
from chr_notes.ledger import entries
from chr_notes.ledger import entry as judged
from chr_notes.ledger.card import AND, LONG, computed, display
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.difference import boxed_alike, unboxed
from chr_notes.ledger.harm import HARM
from chr_notes.ledger.proof import proves
from chr_notes.ledger.show import show, show_additions, show_steps, show_together
from chr_notes.ledger.summary import show_summary
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
        text = unboxed(show(entry.id).markdown())
        assert f"{entry.verdict}</span>" in text
        for formula in (entry.printed_latex, entry.correction_latex, entry.condition):
            assert formula is None or unboxed(display(formula)) in text
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


def test_what_the_text_gets_on_without_is_folded() -> None:
    assert show("sensors.2.4")._repr_markdown_().startswith('<div class="entry"')
    folded = show("sensors.2.4", folded=True)._repr_markdown_()
    assert folded.startswith('<details class="entry chip" id="entry-sensors.2.4">')
    assert show_steps(DRIFT)._repr_markdown_().startswith('<div class="chr-steps"')
    steps = show_steps(DRIFT, folded="Derivation")._repr_markdown_()
    assert steps.startswith("<details>\n<summary>Derivation</summary>\n\n<div")
    assert repr(show_steps(DRIFT, folded="Derivation")) == repr(show_steps(DRIFT))


def test_what_misleads_has_its_difference_marked_and_says_what_it_does() -> None:
    misleading = [entry for entry in entries() if entry.weight == "misleads"]
    assert {entry.root for entry in misleading} == HARM.keys()
    for entry in misleading:
        if entry.kind == "table cell":
            continue
        text = show(entry.id).markdown()
        assert HARM[entry.root] in text
        assert "⚠" in text
        if entry.correction_latex is not None:
            marked = boxed_alike(entry.printed_latex, entry.correction_latex)
            assert marked.count(r"\boxed") == entry.correction_latex.count(r"\boxed")
            assert unboxed(marked) == entry.printed_latex
            assert display(marked) in text


@pytest.mark.parametrize(
    "name", ["estimation.2.6", "estimation.4.4", "validation.3", "validation.10"]
)
def test_what_is_right_in_any_case_is_so_without_the_condition(name: str) -> None:
    case = CASES[name]
    assert show(name).markdown().count("Right in any case") == 1
    assert proves(case.steps[-1].statement, case.reading, *case.given)


def test_places_of_one_error_stand_on_one_card() -> None:
    text = show_together("validation.6", "validation.7")._repr_markdown_()
    assert text.count('<div class="entry misleads"') == 1
    assert re.findall(r'id="entry-([\w.]+)"( open)?', text) == [
        ("validation.6", " open"),
        ("validation.7", ""),
    ]
    assert text.count(HARM["no-information"]) == 1
    for names in (("validation.6", "validation.4"), ("euler.4.b",), ("euler.3.1",)):
        with pytest.raises(ValueError, match="places of one error that misleads"):
            show_together(*names)


def test_what_is_read_with_another_function_shows_it_as_read() -> None:
    other = [each.id for each in entries() if computed(each)]
    assert other == ["quaternions.4.1", "quaternions.4.3"]
    summary = show_summary("quaternions")._repr_markdown_()
    for name in other:
        text, read = show(name).markdown(), computed(judged(name))
        assert read is not None
        assert read.startswith((r"\phi = \mathrm{atan2}", r"\psi = \mathrm{atan2}"))
        assert text.index("As printed") < text.index("Proved as it is read") < text.index(read)
        assert read in summary
    assert r"\arctan" not in summary


def test_readings_are_told_where_they_differ_and_once_a_card() -> None:
    assert "reading" not in show("quaternions.3.c").markdown()
    both = show_together("quaternions.3.1", "quaternions.3.3")._repr_markdown_()
    for text, ours, other in (
        (both, "wrong", "right"),
        (show("quaternions.4.2").markdown(), "right", "wrong"),
    ):
        (first, _), (second, _) = judged("quaternions.3.1").readings
        told = f"By this book's reading, ${first}$, it is {ours}; by ${second}$ {other}.\n"
        assert text.count(told) == text.count("By this book's reading") == 1
