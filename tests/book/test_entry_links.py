"""Links from the cards of a chapter to the ledger."""

from pathlib import Path

import pytest

from chr_notes.book.entry_links import from_cards


@pytest.mark.parametrize("chapter", ["euler", "sensors"])
def test_a_page_that_stays_when_the_book_is_built_again_keeps_its_links(
    book: Path, chapter: str
) -> None:
    page = (book / "notebooks" / f"{chapter}.html").read_text(encoding="utf-8")
    assert 'class="entry-term"><a' in page
    assert from_cards(page) == page
