"""The reference of the functions is complete."""

import re
from pathlib import Path

import pytest

import chr_notes

BOOK = Path(__file__).resolve().parents[2] / "book"
PAGES = "".join(path.read_text("utf-8") for path in sorted(BOOK.glob("api*.md")))
MEMBERS = dict(re.findall(r"automodule:: (\S+)\n\s+:members:(.*)\n", PAGES))


@pytest.mark.parametrize("name", [n for n in chr_notes.__all__ if n != "STANDARD_GRAVITY"])
def test_each_public_name_is_in_the_reference(name: str) -> None:
    module = getattr(chr_notes, name).__module__
    assert module in MEMBERS
    chosen = MEMBERS[module].replace(",", " ").split()
    assert not chosen or name in chosen
