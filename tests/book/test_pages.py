"""Every page of the book in a browser without a network."""

from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from chr_notes.book import SOURCES
from chr_notes.ledger import entries

Visit = Callable[..., Page]


def pages(folder: Path) -> list[str]:
    """All pages, by their path from the top."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*.html"))


class Formulas(HTMLParser):
    """Counts the formulas that a page asks MathJax to typeset."""

    def __init__(self) -> None:
        super().__init__()
        self.count = 0

    def handle_starttag(self, _tag: str, attrs: list[tuple[str, str | None]]) -> None:
        classes = (dict(attrs).get("class") or "").split()
        self.count += "math" in classes and "notranslate" in classes


def formulas(path: Path) -> int:
    parser = Formulas()
    parser.feed(path.read_text(encoding="utf-8"))
    return parser.count


def settled(page: Page) -> Page:
    """Wait for the formulas; `visit` has waited for everything else."""
    page.wait_for_function("!window.MathJax || (MathJax.startup && MathJax.startup.promise)")
    page.evaluate("async () => { await window.MathJax?.startup.promise; }")
    return page


def test_every_page_loads_and_typesets_by_itself(visit: Visit, book: Path, address: str) -> None:
    typeset = 0
    for name in pages(book):
        page = settled(visit(address + name))
        count = formulas(book / name)
        assert page.locator("mjx-container").count() == count, name
        assert page.locator("mjx-merror").count() == 0, name
        demos = page.locator("[data-demo]").count()
        assert page.locator("[data-demo] > .chr-demo").count() == demos, name
        typeset += count
    assert typeset > 50, "hardly any formula found: the test has lost its point"


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_every_page_fits_a_telephone(visit: Visit, book: Path, theme: str) -> None:
    for name in pages(book):
        page = settled(visit((book / name).as_uri(), width=390, color_scheme=theme))
        assert page.evaluate("document.documentElement.scrollWidth") <= 390, name
        outside = page.evaluate(
            """() => [...document.querySelectorAll(".bd-article *")].filter((element) => {
              const { right, width } = element.getBoundingClientRect();
              const scrolls = element.closest("div.math, pre, .cell_output, table, mjx-container");
              return width > 0 && right > innerWidth + 1 && !scrolls;
            }).map((element) => element.outerHTML.slice(0, 80))"""
        )
        assert outside == [], name


def test_every_image_says_what_it_shows(visit: Visit, book: Path) -> None:
    for name in pages(book):
        images = visit((book / name).as_uri()).locator("img").all()
        for image in images:
            assert image.get_attribute("alt"), f"{name}: {image.get_attribute('src')}"


def test_no_formula_is_left_as_text(visit: Visit, book: Path) -> None:
    for name in pages(book):
        page = settled(visit((book / name).as_uri()))
        if page.locator(".bd-article").count() == 0:
            continue
        text = page.evaluate(
            """() => {
              const article = document.querySelector(".bd-article").cloneNode(true);
              article.querySelectorAll("pre, code, script, mjx-container").forEach((e) => e.remove());
              return article.textContent;
            }"""
        )
        assert "$" not in text, name
        assert "\\" not in text, name


def test_demo_in_the_chapter_reacts_to_the_keyboard(visit: Visit, address: str) -> None:
    page = visit(address + "notebooks/euler.html")
    demo = page.locator("[data-demo='gimbal-lock']").first
    pitch = demo.locator("input[name=pitch]")
    pitch.fill("59")
    pitch.focus()
    page.keyboard.press("ArrowRight")
    expect(demo.locator("output[name=determinant]")).to_have_text("2")


def test_first_page_leads_to_the_book(visit: Visit, address: str) -> None:
    page = visit(address + "index.html")
    expect(page).to_have_title("CH Robotics notes, derived")
    expect(page.locator("[data-demo] canvas")).to_have_count(1)


def test_reader_sees_the_numbers_without_javascript(visit: Visit, book: Path) -> None:
    page = visit((book / "book" / "index.html").as_uri(), java_script_enabled=False)
    expect(page.locator("[data-demo]")).to_contain_text("Determinant of D: 3.864.")


def test_ledger_has_an_anchor_and_a_worded_verdict_for_every_entry(
    visit: Visit, book: Path
) -> None:
    page = visit((book / "book" / "ledger.html").as_uri())
    for entry in entries():
        row = page.locator(".ledger-row").filter(has=page.locator(f'[id="{entry.id}"]'))
        expect(row).to_have_count(1)
        expect(row.locator(".verdict")).to_contain_text(entry.verdict)


def test_link_to_an_entry_goes_there(visit: Visit, book: Path) -> None:
    page = settled(visit((book / "book" / "ledger.html").as_uri() + "#euler.7.d"))
    expect(page.locator('[id="euler.7.d"]')).to_be_in_viewport()


def test_every_source_is_a_page(book: Path) -> None:
    for source in SOURCES.glob("*.md"):
        assert (book / "book" / f"{source.stem}.html").is_file(), source
