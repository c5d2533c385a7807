"""Formulas of the built book: none is lost, and they stand without a script."""

import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import yaml
from docutils import nodes
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token
from myst_parser.config.main import MdParserConfig
from myst_parser.parsers.mdit import create_md_parser
from playwright.sync_api import Browser, Page

from chr_notes.book import ROOT, SOURCES, formulas

Visit = Callable[..., Page]

TOC = yaml.safe_load((SOURCES / "_toc.yml").read_text(encoding="utf-8"))
CHAPTERS = [
    page["file"]
    for part in TOC["parts"]
    for chapter in part["chapters"]
    for page in (chapter, *chapter.get("sections", ()))
]
EXTENSIONS = yaml.safe_load((SOURCES / "_config.yml").read_text("utf-8"))["parse"]
MARKDOWN = create_md_parser(
    MdParserConfig(enable_extensions=set(EXTENSIONS["myst_enable_extensions"])), RendererHTML
)
CODE = {"code-block", "eval-rst", "literalinclude", "toctree"}


def tokens(text: str) -> Iterator[Token]:
    for token in MARKDOWN.parse(text):
        yield token
        yield from token.children or ()


def in_markdown(text: str, folder: Path) -> int:
    """How many formulas Markdown has, with what it includes and what directives hold."""
    count = 0
    for token in tokens(text):
        directive = re.match(r"\{([\w-]+)\}\s*(\S*)", token.info)
        if token.type in ("amsmath", "math_inline", "math_inline_double", "math_block"):
            count += 1
        elif directive and directive[1] == "include":
            path = folder / directive[2]
            count += in_markdown(path.read_text(encoding="utf-8"), path.parent)
        elif directive and directive[1] not in CODE:
            count += in_markdown(token.content, folder)
    return count


def in_source(name: str) -> int:
    """How many formulas the source of a page has."""
    page = ROOT / f"{name}.md"
    if page.exists():
        return in_markdown(page.read_text(encoding="utf-8"), page.parent)
    notebook = json.loads((ROOT / f"{name}.ipynb").read_text(encoding="utf-8"))
    count = 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "markdown":
            count += in_markdown("".join(cell["source"]), ROOT / "notebooks")
        for output in cell.get("outputs", ()):
            shown = output.get("data", {})
            if "text/html" not in shown and "image/svg+xml" not in shown:
                assert "text/latex" not in shown
                count += in_markdown("".join(shown.get("text/markdown", ())), ROOT / "notebooks")
    return count


@pytest.mark.parametrize("name", CHAPTERS)
def test_each_formula_of_the_source_is_on_the_page(book: Path, name: str) -> None:
    page = (book / f"{name}.html").read_text(encoding="utf-8")
    assert page.count("<math") == in_source(name)


def test_chapters_are_full_of_formulas() -> None:
    """Otherwise the test above has lost its point."""
    assert in_source("notebooks/euler") > 50
    assert in_source("book/ledger/euler") > 50


def test_a_formula_that_cannot_be_set_stops_the_build(tmp_path: Path) -> None:
    (tmp_path / "index.md").write_text("# Title\n\nIt is $a$.\n\nIt is\n$\\gimbal{b}$.\n", "utf-8")
    (tmp_path / "conf.py").write_text(
        'extensions = ["myst_parser", "chr_notes.book.formulas"]\n'
        'myst_enable_extensions = ["dollarmath"]\n',
        encoding="utf-8",
    )
    command = [sys.executable, "-m", "sphinx", str(tmp_path), str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert "A formula cannot be set" in done.stderr
    assert re.search(r'index\.md:5: .*Unknown command "\\gimbal"', done.stderr)
    assert "\n\\gimbal{b}" in done.stderr
    assert not (tmp_path / "out" / "index.html").exists()


def test_in_a_notebook_its_cell_is_named() -> None:
    block = nodes.math_block("", r"\gimbal{b}")
    block.source, block.line = "notebook.ipynb", 40_012
    with pytest.raises(formulas.FormulaError, match=r"notebook\.ipynb: cell 4, line 12: "):
        formulas.converted(block)


def test_formulas_stand_without_a_script(visit: Visit, browser: Browser, book: Path) -> None:
    address = (book / "notebooks" / "euler.html").as_uri()
    boxes = """() => [...document.querySelectorAll("math")].map((formula) => {
      const { width, height } = formula.getBoundingClientRect();
      return [width, height];
    })"""
    fonts = """() => [...document.fonts]
      .filter((font) => font.family.includes("STIX Two Math")).map((font) => font.status)"""
    context = browser.new_context(
        java_script_enabled=False, viewport={"width": 1280, "height": 900}
    )
    plain = context.new_page()
    plain.goto(address)
    assert plain.evaluate(fonts) == ["loaded"]
    assert plain.evaluate(boxes) == visit(address).evaluate(boxes)
    context.close()


def copied(page: Page, start: str, end: str) -> str:
    """What a reader gets who selects from one element to the other and copies."""
    page.evaluate(
        """([start, end]) => {
          const range = document.createRange();
          range.setStart(document.querySelector(start), 0);
          range.setEnd(document.querySelector(end), 1);
          getSelection().removeAllRanges();
          getSelection().addRange(range);
          addEventListener("copy", (event) => {
            window.copied = event.clipboardData.getData("text/plain");
          }, { once: true });
        }""",
        [start, end],
    )
    page.keyboard.press("Control+C")
    return str(page.evaluate("window.copied"))


def test_a_copied_formula_is_latex(visit: Visit, tmp_path: Path) -> None:
    script = (SOURCES / "copy_formulas.js").read_text(encoding="utf-8")
    formula = (
        "<math{0}><semantics><mrow><mi id={1}>{1}</mi></mrow>"
        "<annotation>\\{1}</annotation></semantics></math>"
    )
    page = tmp_path / "page.html"
    page.write_text(
        f"<!doctype html><meta charset=utf-8><title>Formulas</title><script>{script}</script>"
        f"<p id=first>One {formula.format('', 'psi')} two</p><p>and</p>"
        f"<div>{formula.format(' display=block', 'phi')}</div><p id=last>end</p>",
        encoding="utf-8",
    )
    opened = visit(page.as_uri())
    assert copied(opened, "#psi", "#psi") == r"\psi"
    assert copied(opened, "#phi", "#phi") == r"\phi"
    assert copied(opened, "#first", "#psi") == r"One $\psi$"
    whole = copied(opened, "#first", "#last")
    assert re.sub(r"\n+", "\n", whole) == "One $\\psi$ two\nand\n$$\n\\phi\n$$\nend"
    assert copied(opened, "#last", "#last") == ""  # the browser's own business
    assert opened.locator("body > div").count() == 1


def test_a_formula_of_the_book_is_copied(visit: Visit, served: str) -> None:
    page = visit(served + "notebooks/euler.html")
    formula = page.locator("div.math math").first
    latex = formula.locator("annotation").text_content()
    formula.evaluate("(element) => { element.id = 'chosen'; }")
    assert copied(page, "#chosen", "#chosen") == latex
