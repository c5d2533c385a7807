"""The theme's scripts and fonts are gone, and what they drew is there."""

import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect
from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace

from chr_notes.book import SOURCES
from chr_notes.book.theme import offered

Visit = Callable[..., Page]


def test_no_figure_is_numbered_for_which_each_build_would_load_all_pages(tmp_path: Path) -> None:
    names = ["sphinx.ext.autodoc", "chr_notes.book.theme", "sphinx_jupyterbook_latex"]
    with docutils_namespace():
        app = Sphinx(
            str(tmp_path), None, str(tmp_path / "html"), str(tmp_path / "read"), "html",
            confoverrides={"extensions": names}, status=None, warningiserror=True,
        )  # fmt: skip
    assert app.config["numfig"] is False


@pytest.mark.full
def test_what_builds_pages_loads_no_sympy() -> None:
    told = (
        "import sys, chr_notes.book.formulas, chr_notes.book.theme; print('sympy' in sys.modules)"
    )
    run = [sys.executable, "-c", told]
    assert subprocess.run(run, check=True, capture_output=True, text=True).stdout == "False\n"


def test_nothing_of_the_icon_package_is_left(book: Path) -> None:
    assert [path for path in book.rglob("*") if "fontawesome" in path.name] == []
    for page in book.rglob("*.html"):
        assert "fontawesome" not in page.read_text(encoding="utf-8")
    styles = (book / "_static" / "styles" / "pydata-sphinx-theme.css").read_text(encoding="utf-8")
    assert "Font Awesome" not in re.sub(r"/\*.*?\*/", "", styles, flags=re.DOTALL)
    assert len(styles) > 90_000  # and of the rules only those for what is nowhere


def test_each_icon_of_the_pages_is_drawn(book: Path) -> None:
    drawn = set(re.findall(r"\.(fa-[\w-]+)", (SOURCES / "icons.css").read_text(encoding="utf-8")))
    for page in book.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        used = {name for names in re.findall(r'class="([^"]*)"', text) for name in names.split()}
        assert {name for name in used if name.startswith("fa-")} <= drawn, page.name


ICONS = """() => [...document.querySelectorAll(".fa-solid")]
  .filter((icon) => icon.checkVisibility())
  .map((icon) => {
    const { width, height } = icon.getBoundingClientRect();
    return [getComputedStyle(icon).maskImage, width, height];
  })"""


def test_icons_are_seen(visit: Visit, address: str) -> None:
    icons = visit(address + "notebooks/euler.html").evaluate(ICONS)
    assert icons
    for image, width, height in icons:
        assert image.startswith("url")
        assert width == height > 8


THEMES = """window.themes = [];
new MutationObserver(() => themes.push(document.documentElement.dataset.theme))
  .observe(document, { attributeFilter: ["data-theme"], subtree: true });"""


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_page_is_light_or_dark_from_its_first_lines(
    visit: Visit, address: str, theme: str
) -> None:
    page = visit("about:blank", color_scheme=theme)
    page.add_init_script(THEMES)
    page.goto(address + "book/bibliography.html")
    assert {*page.evaluate("themes")} == {theme}
    page.evaluate("localStorage.setItem('mode', 'light')")
    page.reload()
    assert {*page.evaluate("themes")} == {"light"}


# From the disk too, where a page may not fetch others: `visit` fails on an error on the console.
def test_the_search_finds(visit: Visit, address: str) -> None:
    page = visit(address + "notebooks/euler.html")
    page.keyboard.press("Control+K")
    page.locator("#pst-search-dialog input[type=search]").fill("aircraft")
    page.keyboard.press("Enter")
    expect(page).to_have_url(re.compile(r"search\.html\?q=aircraft"))
    expect(page.locator("#search-results ul.search li").first).to_be_visible()


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
