"""Each part of a page has the name that its words are, each button has one, and axe is content."""

import itertools
import re
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from chr_notes.book.access import mended

Visit = Callable[..., Page]

SUMMARY = re.compile(r"<summary([^>]*)>(.*?)</summary>", re.DOTALL)
BUTTON = re.compile(r"<button([^>]*)>(.*?)</button>", re.DOTALL)
# A kbd is in the name as well; its own words are enough here.
TAGS = re.compile(r"<[^>]*>")

# All that is folded is open, and what scrolls has been found.
LAID_OUT = """() => {
  const folded = document.querySelectorAll("details");
  for (const each of folded) each.removeAttribute("name"); // else one of a guess's is open
  for (const each of folded) each.open = true;
  return new Promise((done) => {
    requestAnimationFrame(() => requestIdleCallback(() => setTimeout(done)));
    setTimeout(done, 5000);
  });
}"""
# Of each rule that a page breaks, where. By itself axe says nothing of the contrast of one letter,
# of a sign such as ✓, and of what lies on a gradient, as all code does; what was just
# opened is pale for a moment.
DECIDED = "* { background-image: none !important; animation: none !important }"
FOUND = """() => axe.run({
  resultTypes: ["violations"],
  preload: false,
  checks: { "color-contrast": { options: { ignoreLength: true, ignoreUnicode: false } } },
}).then((found) =>
  found.violations.flatMap(({ id, nodes }) =>
    nodes.map(({ html }) => `${id}: ${html.slice(0, 160)}`)))"""


@pytest.fixture(scope="module")
def texts(book: Path) -> dict[str, str]:
    return {
        str(path.relative_to(book)): path.read_text(encoding="utf-8")
        for folder in ("book", "notebooks")
        for path in (book / folder).rglob("*.html")
    }


def words(html: str) -> str:
    return " ".join(TAGS.sub(" ", html).split()).lower()


def test_a_name_has_the_words_that_are_seen(texts: dict[str, str]) -> None:
    for page, text in texts.items():
        for pattern in (SUMMARY, BUTTON):
            for attributes, inside in pattern.findall(text):
                label = re.search(r'aria-label="([^"]*)"', attributes)
                seen = words(inside)
                assert seen or label or " title=" in attributes, (page, attributes)
                assert label is None or seen in label.group(1).lower(), (page, label)


def test_all_that_is_seen_is_in_a_region(texts: dict[str, str]) -> None:
    for page, text in texts.items():
        (sidebar,) = re.findall(r'<div id="pst-primary-sidebar"[^>]*>', text)
        assert 'role="region" aria-label="All pages"' in sidebar, page
        (skips,) = re.findall(r'<div id="pst-skip-link"[^>]*>', text)
        assert 'role="navigation" aria-label=' in skips, page


def test_pages_have_one_first_heading_and_leave_no_level_out(texts: dict[str, str]) -> None:
    for page, text in texts.items():
        article = text.partition('<article class="bd-article">')[2]
        levels = [int(level) for level in re.findall(r"<h([1-6])\b", article)]
        assert levels.count(1) == 1, page
        assert all(b <= a + 1 for a, b in itertools.pairwise(levels)), page


def test_what_is_mended_stays() -> None:
    page = (
        '<div id="pst-primary-sidebar" class="bd-sidebar-primary bd-sidebar">'
        '<a href="x">The ledger</a><details><summary><i></i></summary></details></div>'
    )
    once = mended(page)
    assert '<summary aria-label="Pages of The ledger">' in once
    assert mended(once) == once


def test_a_pressed_button_keeps_the_focus(visit: Visit, served: str) -> None:
    page = visit(served + "notebooks/sensors.html", width=390, own=True)
    for selector in (".theme-switch-button", ".search-button__button", "button.copybtn"):
        button = page.locator(f"{selector}:visible").first
        button.focus()
        page.keyboard.press("Enter")
        if "search" in selector:
            expect(page.locator("#pst-search-dialog input")).to_be_focused()
            page.keyboard.press("Escape")
        expect(button).to_be_focused()


# How far the focused control is below the picture that stays in sight.
BELOW = """() => {
  const control = document.activeElement;
  const stage = control.closest(".chr-demo").querySelector(".chr-stage");
  return control.getBoundingClientRect().top - stage.getBoundingClientRect().bottom;
}"""


def test_no_focused_control_is_behind_the_picture(visit: Visit, served: str) -> None:
    page = visit(served + "notebooks/sensors.html", width=390)
    page.locator("[data-demo='magnetometer'] [name='link']").focus()
    for _ in range(10):
        page.keyboard.press("Shift+Tab")
        assert page.evaluate(BELOW) >= 0


MARKED = """(part) => [getComputedStyle(part).boxShadow, getComputedStyle(part).maskImage]
  .some((drawn) => drawn !== "none")"""


@pytest.mark.parametrize("kind", ["div.math", ".pst-scrollable-table-container"])
def test_what_scrolls_is_marked_where_there_is_more(visit: Visit, served: str, kind: str) -> None:
    page = visit(served + "book/errata.html", width=390, own=True)
    wide = page.locator(f"{kind}[data-more]").first
    expect(wide).to_have_attribute("data-more", "right")
    for far, more in ((5, "left right"), (10_000, "left"), (0, "right")):
        wide.evaluate("(part, far) => part.scrollTo(far, 0)", far)
        expect(wide).to_have_attribute("data-more", more)
        assert wide.evaluate(MARKED)
    page.emulate_media(media="print")
    assert not wide.evaluate(MARKED)
    page.emulate_media(media="screen")
    page.set_viewport_size({"width": 2400, "height": 800})
    expect(page.locator(f"{kind}[data-more]")).to_have_count(0)


@pytest.mark.full
@pytest.mark.parametrize("seen", list(itertools.product(("light", "dark"), (390, 1280))))
def test_axe_finds_nothing_on_any_page(
    visit: Visit,
    book: Path,
    served: str,
    seen: tuple[str, int],
    record_property: Callable[[str, object], None],
) -> None:
    axe = (files("axe_playwright_python") / "axe.min.js").read_text(encoding="utf-8")
    theme, width = seen
    page = visit("about:blank", color_scheme=theme, reduced_motion="reduce", width=width)
    pages = [path.relative_to(book) for path in book.rglob("*.html")]
    names = sorted(str(path) for path in pages if path.parts[0] != "_static")
    found = {}
    for name in names:
        page.goto(served + name)
        expect(page.locator("main")).to_be_visible()  # the first one leads to another
        expect(page.locator("[data-demo] > .chr-demo")).to_have_count(
            page.locator("[data-demo]").count()
        )
        page.evaluate(LAID_OUT)
        expect(page.locator("details:not([open])")).to_have_count(0)
        page.add_style_tag(content=DECIDED)
        page.evaluate(axe)
        nodes = page.evaluate(FOUND)
        if nodes:
            found[name] = nodes
    count = sum(map(len, found.values()))
    told = f"axe at {width} px, {theme}, on {len(names)} pages: {count} nodes"
    record_property("measured", told)
    assert found == {}
