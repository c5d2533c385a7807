"""Messages say in which files an entry is to be mended."""

import re
from pathlib import Path

import pytest

from chr_notes.ledger.cases import CASES
from chr_notes.ledger.files import files_of, see, see_case

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("name", ["euler.5.5", "validation.g", "sensors.4.d"])
def test_the_files_of_an_entry(name: str) -> None:
    printed, brought = files_of(name)
    assert f'"{name}"' in (ROOT / printed).read_text(encoding="utf-8")
    assert f'"{name}"' in (ROOT / brought).read_text(encoding="utf-8")
    assert see(name) == see_case(name) == f"see {printed} and {brought}"


def test_where_a_case_goes_that_is_not_there() -> None:
    printed, gathered = see_case("quaternions.3.d").split("; ")
    assert printed == see("quaternions.3.d")
    (file,) = re.findall(r"^cases are gathered in (chr_notes/ledger/quaternions\.py)$", gathered)
    assert "\nCASES = " in (ROOT / file).read_text(encoding="utf-8")


def test_a_cell_is_written_with_its_table() -> None:
    cell = "dead_reckoning.t1.1.5.velocity_10s"
    assert files_of(cell) == ("chr_notes/printed/dead_reckoning.py", "chr_notes/ledger/table_1.py")


def test_each_entry_is_printed_in_one_file() -> None:
    for name in CASES:
        files = [file for file in files_of(name) if file.startswith("chr_notes/printed/")]
        assert len(files) == 1, name


def test_what_no_file_prints_is_told() -> None:
    assert see("euler.9.9") == "no file prints it"
