"""Each entry of the ledger stands in exactly one chapter."""

import re
from collections import Counter
from pathlib import Path

import nbformat
import pytest

from chr_notes.ledger.cases import CASES
from chr_notes.ledger.files import see

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
ANCHOR = re.compile(r'id="entry-([\w.]+)"')


def shown(chapter: str) -> Counter[str]:
    """Count the entries that the outputs of a chapter show."""
    notebook = nbformat.read(FOLDER / f"{chapter}.ipynb", as_version=4)
    outputs = [out for cell in notebook.cells for out in cell.get("outputs", [])]
    texts = [out.get("data", {}).get("text/markdown", "") for out in outputs]
    return Counter(name for text in texts for name in ANCHOR.findall(text))


@pytest.mark.parametrize("chapter", sorted({c.printed.document for c in CASES.values()}))
def test_each_entry_stands_once_in_the_chapter_of_its_document(chapter: str) -> None:
    own = [name for name, case in CASES.items() if case.printed.document == chapter]
    found = shown(chapter)
    for name in {*own, *found}:
        assert found[name] == own.count(name), (
            f"{name} is shown {found[name]} times in notebooks/{chapter}.ipynb; {see(name)}"
        )
