"""Each entry has what its verdict needs; the ledger has what the documents print."""

import csv
from pathlib import Path

import pytest

from chr_notes import ledger
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.files import see
from chr_notes.ledger.roots import ROOTS

INVENTORY = Path(__file__).parent / "inventory.tsv"
ROWS = "tests/ledger/inventory.tsv"
ENTRIES = {entry.id: entry for entry in ledger.entries()}
FAILING = [name for name in CASES if ENTRIES[name].verdict in ("qualified", "corrected")]


def test_the_rows_of_the_inventory_are_the_entries() -> None:
    with INVENTORY.open(encoding="utf-8") as rows:
        kinds = {row["id"]: row["kind"] for row in csv.DictReader(rows, delimiter="\t")}
    found = {name: case.printed.kind for name, case in CASES.items()}
    for name in found.keys() ^ kinds.keys():
        assert name in kinds, f"{name} has no row in {ROWS}; {see(name)}"
        assert name in found, f"{name} stands in {ROWS} and in no document of chr_notes/printed"
    for name, kind in found.items():
        assert kind == kinds[name], f"{name}: {ROWS} says {kinds[name]}; {see(name)}"


@pytest.mark.parametrize("name", CASES)
def test_entry(name: str) -> None:
    entry = ENTRIES[name]
    failing = name in FAILING
    assert entry.printed_latex
    assert entry.place
    assert (entry.condition is not None) == (entry.verdict == "qualified")
    assert (entry.exact is not None) == (entry.verdict == "qualified")
    assert (entry.correction_latex is not None) == (entry.verdict == "corrected")
    assert (entry.witness is not None) == failing
    assert (entry.root is not None) == (entry.weight is not None) == failing
    if entry.correction_latex is not None:
        assert r"\boxed" in entry.correction_latex
    if entry.verdict in ("proved", "corrected") and entry.kind == "equation":
        assert entry.derivation


@pytest.mark.parametrize("name", FAILING)
def test_witness_shows_the_difference(name: str) -> None:
    # That it fails there, and where it lies, is a part of the judgement.
    witness = ENTRIES[name].witness
    assert witness is not None
    assert witness.printed != witness.right


def test_each_root_shows_somewhere() -> None:
    assert ROOTS.keys() == {entry.root for entry in ENTRIES.values() if entry.root is not None}
