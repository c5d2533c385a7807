"""Each entry is judged, by its id; the ledger can tell right from wrong."""

import csv
from pathlib import Path

import pytest

from chr_notes import ledger
from chr_notes.ledger.case import Case
from chr_notes.ledger.judgement import introduces_name
from chr_notes.ledger.proof import excludes, fails, proves

from .equivalents import EQUIVALENT
from .misprints import misprints

CASES = ledger.CASES
FAILING = {
    name: case
    for name, case in CASES.items()
    if case.condition is not None or case.correction is not None
}
PROVED = {
    name: case for name, case in CASES.items() if name not in FAILING and not introduces_name(case)
}
STEPS = [(name, step) for name, case in CASES.items() for step in case.steps]


def test_ids_are_those_of_the_inventory() -> None:
    with Path(__file__).with_name("inventory.tsv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    printed = {row["id"]: row["kind"] for row in rows}
    assert len(printed) == len(rows), "an id stands twice"
    assert {name: case.printed.kind for name, case in CASES.items()} == printed


@pytest.mark.parametrize("name", CASES)
def test_entry(name: str) -> None:
    entry = ledger.entry(name)
    failing = entry.verdict in ("qualified", "corrected")
    assert entry.id == name
    assert entry.printed_latex
    assert (entry.condition is not None) == (entry.verdict == "qualified")
    assert (entry.correction_latex is not None) == (entry.verdict == "corrected")
    assert (entry.witness is not None) == failing
    assert (name in FAILING) == failing
    assert (name in PROVED) == (entry.verdict == "proved")


@pytest.mark.parametrize(("name", "case"), FAILING.items(), ids=FAILING)
def test_witness_shows_the_difference(name: str, case: Case) -> None:
    assert fails(case.printed.statement, case.read, case.witness)
    if case.correction is not None:
        assert not fails(case.correction, case.read, case.witness)
    if case.condition is not None:
        assert excludes(case.condition, case.witness)
    for given in case.given:
        assert not excludes(given, case.witness)
    witness = ledger.entry(name).witness
    assert witness is not None
    assert witness.printed != witness.right


@pytest.mark.parametrize(
    ("name", "step"), STEPS, ids=[f"{n}-{i}" for i, (n, _) in enumerate(STEPS)]
)
def test_each_step_of_a_derivation_holds(name: str, step: ledger.Step) -> None:
    case = CASES[name]
    under = (*case.given, *((case.condition,) if case.condition else ()))
    # What leads to a condition holds without it, what follows from it under it.
    assert any(
        proves(step.statement, case.read, *conditions) for conditions in ((), case.given, under)
    )


@pytest.mark.slow
@pytest.mark.parametrize(("name", "case"), PROVED.items(), ids=PROVED)
def test_misprints_change_the_verdict(name: str, case: Case) -> None:
    for misprint, wrong in misprints(case.printed.statement):
        equivalent = (name, misprint) in EQUIVALENT
        assert proves(wrong, case.read, *case.given) == equivalent, f"{name}, {misprint}: {wrong}"
