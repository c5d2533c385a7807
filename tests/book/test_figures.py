"""Figures stand beside the pages, with their sizes, and nothing else of a page changes."""

import base64
from pathlib import Path

import pytest

from chr_notes.book.figures import taken_out

FIGURE = b'<svg width="30pt" viewBox="0 0 30 60.4"><path/></svg>'


def within(figure: bytes) -> str:
    return f'<img alt="a" src="data:image/svg+xml;base64,{base64.b64encode(figure).decode()}" x>'


def test_a_figure_is_a_file_of_its_size() -> None:
    page, files = taken_out(f"<p>{within(FIGURE)}{within(FIGURE)}</p>", "../_images")
    ((name, content),) = files.items()
    assert content == FIGURE
    assert (
        page
        == f'<p>{2 * f"""<img alt="a" src="../_images/{name}" width="40" height="81" x>"""}</p>'
    )
    assert taken_out(page, "../_images") == (page, {})


def test_a_figure_without_a_size_is_refused() -> None:
    with pytest.raises(ValueError, match="expected a figure with a viewBox"):
        taken_out(within(b"<svg/>"), "..")


def test_no_page_holds_a_figure(book: Path) -> None:
    pages = sorted((book / "notebooks").glob("*.html"))
    texts = [page.read_text(encoding="utf-8") for page in pages]
    assert not any("data:image/svg+xml;base64" in text for text in texts)
    assert sum(text.count('src="../_images/') for text in texts) > 20
