"""The book as one PDF: pages joined without their scripts, whose links lead within it."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.__main__ import main
from chr_notes.book.pdf import joined, parts_of, print_pdf

HEAD = '<link rel="stylesheet" href="../_static/pages.css?v=1"><script>alert()</script>'
SIDEBAR = """<nav class="bd-links"><span class="caption-text">Notes</span>
<a class="reference internal" href="../notebooks/euler.html">Euler</a>
<a class="reference internal" href="ledger.html">Ledger</a></nav>"""
FIRST = """<section id="top"><h1>First<a class="headerlink" href="#top">#</a></h1></section>
<p><a href="../notebooks/euler.html#pole">pole</a> <a href="../notebooks/euler.html">all</a>
<a href="#top">up</a> <a href="https://example.org/">elsewhere</a>
<a href="book.ipynb">a file</a></p><code>id="kept"</code>"""
CHAPTER = """<h1>Euler</h1><h2 id="pole">Pole</h2><img src="../_images/a.svg" alt="a">
<div data-demo="tilt"><img src="data:image/svg+xml,x" alt="still"></div><script>demo()</script>
<details name="guess"><summary>yes</summary><p>No.</p></details>"""


@pytest.fixture
def pages(tmp_path: Path) -> Path:
    """Write a book of three pages."""
    articles = {"book/index": FIRST, "notebooks/euler": CHAPTER, "book/ledger": "<h1>Ledger</h1>"}
    for name, article in articles.items():
        path = tmp_path / f"{name}.html"
        path.parent.mkdir(exist_ok=True)
        text = f'{HEAD}{SIDEBAR}<article class="bd-article">{article}</article>'
        path.write_text(text, encoding="utf-8")
    return tmp_path


def test_pages_stand_in_the_order_of_the_sidebar(pages: Path) -> None:
    assert parts_of(pages) == {
        "The book": ["book/index"],
        "Notes": ["notebooks/euler", "book/ledger"],
    }


def test_links_lead_within_the_joined_page(pages: Path) -> None:
    page = joined(pages, parts_of(pages))
    links = re.findall(r'<a href="#([^"]*)"', page)
    assert set(links) <= set(re.findall(r' id="([^"]*)"', page))
    assert links[:3] == ["book-index", "notebooks-euler", "book-ledger"]  # the contents
    assert links[3:] == ["notebooks-euler-pole", "notebooks-euler", "book-index-top"]
    assert '<a href="https://example.org/">elsewhere</a>\n<a>a file</a>' in page
    assert '<code>id="kept"</code>' in page
    assert f'src="{(pages / "_images" / "a.svg").as_uri()}"' in page
    assert 'src="data:image/svg+xml,x"' in page
    assert f'href="{(pages / "_static" / "pages.css").as_uri()}"' in page
    assert "<details open><summary>" in page
    assert "script" not in page


def test_it_is_printed_with_links_and_an_outline(
    pages: Path, program: Callable[[str], str]
) -> None:
    program("chromium")
    target = pages / "book.pdf"
    print_pdf(joined(pages, parts_of(pages)), target)
    printed = target.read_bytes()
    assert printed.count(b"/MediaBox") == 4  # one has the contents
    assert b"/Outlines" in printed
    assert printed.count(b"/Subtype /Link") == 7


def test_without_a_browser_nothing_is_built(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CHR_NOTES_CHROMIUM", "no-such-browser")
    assert main(["book", "--pdf", str(tmp_path / "mine")]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert "there is no no-such-browser on the path: install one, or name" in said.err
    assert list(tmp_path.iterdir()) == []


def test_one_that_cannot_be_printed_leaves_the_one_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "book.pdf"
    target.write_text("before", encoding="utf-8")
    monkeypatch.setenv("CHR_NOTES_CHROMIUM", "false")
    with pytest.raises(RuntimeError, match="Chromium printed no PDF"):
        print_pdf("", target)
    assert [path.read_text(encoding="utf-8") for path in tmp_path.iterdir()] == ["before"]
