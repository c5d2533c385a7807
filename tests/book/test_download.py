"""Each chapter's page has its notebook beside it, and says so once."""

from pathlib import Path

from chr_notes.book import SOURCES
from chr_notes.book.download import offered


def test_each_chapter_can_be_taken_along(book: Path) -> None:
    chapters = sorted((book / "notebooks").glob("*.html"))
    assert len(chapters) > 6
    for page in chapters:
        name = f"{page.stem}.ipynb"
        assert page.read_text(encoding="utf-8").count(f'<a href="{name}" download>') == 1
        kept = (SOURCES.parent / "notebooks" / name).read_bytes()
        assert (page.parent / name).read_bytes() == kept


def test_once_is_enough() -> None:
    page = '<h1>Menu</h1><article class="bd-article"><h1>Yaw</h1></article>'
    once = offered(page, "yaw.ipynb")
    assert once.startswith('<h1>Menu</h1><article class="bd-article"><h1>Yaw</h1>\n<p class=')
    assert offered(once, "yaw.ipynb") == once
