"""On paper nothing is cut off and all is light; in colours of the reader's own, states are seen."""

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page

Visit = Callable[..., Page]
SHEET = 718  # pixels between a browser's own margins on A4
CUT_OFF = """() => {
  const right = document.querySelector(".bd-article").getBoundingClientRect().right;
  const over = (each) => Math.max(
    each.getBoundingClientRect().right - right, each.scrollWidth - each.clientWidth);
  return [...document.querySelectorAll(".bd-article :is(div.math, pre, table)")]
    .filter((each) => each.checkVisibility() && over(each) > 1)
    .map((each) => each.textContent.slice(0, 60));
}"""
# Formulas below 8 points that would fit their place at 8.
SMALL = """() => [...document.querySelectorAll(".bd-article div.math > math")].filter((each) => {
  if (parseFloat(getComputedStyle(each).fontSize) > 10.66 || !each.checkVisibility()) return false;
  each.style = "font-size: 10.67px; min-width: 0";
  const { width } = each.getBoundingClientRect();
  each.style = "";
  return width <= each.parentElement.clientWidth;
}).map((each) => each.textContent)"""
ENLARGED = """() => [...document.querySelectorAll("img.chr-figure")]
  .filter((each) => each.checkVisibility() && each.height > each.naturalHeight + 30)
  .map((each) => each.alt)"""
# How many derivations there are on cards, and are seen; how many solutions, and of how many a line.
FOLDED = """() => {
  const folded = (where) => [...document.querySelectorAll(`${where} > details:not(.chip)`)];
  const seen = (all) => all.filter((each) => each.checkVisibility()).length;
  const derivations = folded(".entry:not(.chip) > .entry-body");
  const solutions = folded(".chr-exercise");
  return [[derivations.length, seen(derivations.map((each) => each.lastElementChild))],
    [solutions.length, seen(solutions)]];
}"""
# In columns as high as a sheet: what stands at the foot of one and belongs to what is on the next.
PARTED = """() => {
  const article = document.querySelector(".bd-article");
  article.style =
    "width: 718px; height: 1047px; columns: 686px; column-gap: 32px; column-fill: auto";
  const { left } = article.getBoundingClientRect();
  const sheets = (each) =>
    [...each.getClientRects()].map((rect) => Math.floor((rect.left - left) / 718));
  const pairs = [...article.querySelectorAll(
    ":is(p, div.math) + div.math, .cell_input + .cell_output, p + :is(div.cell, .erratum), " +
    ":is(h2, h3, dt, summary, .entry-head, .entry-term, .rubric) + *, " +
    "p + dl, li:first-child + li, li + li:last-child")]
    .map((each) => [each.previousElementSibling, each]);
  const parted = pairs.filter((pair) => {
    const [before, after] = pair.map(sheets);
    return before.at(-1) < after[0];
  });
  const several = Math.max(...pairs.flatMap(([, each]) => sheets(each))) > 1;
  article.style = "";
  return [several, parted.map(([each]) => each.textContent.slice(-60))];
}"""
# What can be done on a screen alone.
DONE = re.compile(
    r"\b(click|drag the|button|slider|unfold|folded|choose (below|other)|type or|cop(y|ied))",
    re.IGNORECASE,
)
WIDEST = ("notebooks/validation", "book/ledger/validation", "book/from_derivation_to_code")
# What a demo has drawn.
DRAWN = "() => document.querySelector('.chr-stage canvas').toDataURL()"
PRINTED = """() => {
  dispatchEvent(new Event("beforeprint"));
  return document.querySelector(".chr-stage canvas").toDataURL();
}"""
# How high a picture is that was drawn 3 to 2, and the place that is kept for a long demo.
STRETCHED = """() => {
  const canvas = document.querySelector(".chr-stage canvas");
  [canvas.width, canvas.height] = [600, 400];
  const { width, height } = canvas.getBoundingClientRect();
  const demo = canvas.closest("[data-demo]");
  demo.dataset.demo = "converter";
  return [height / width, getComputedStyle(demo).minHeight];
}"""
THEME = "() => document.documentElement.dataset.theme"


@pytest.mark.parametrize(
    "name", [WIDEST[0], *(pytest.param(name, marks=pytest.mark.full) for name in WIDEST[1:])]
)
def test_nothing_is_cut_off_at_the_edge_of_a_sheet(visit: Visit, served: str, name: str) -> None:
    page = visit(f"{served}{name}.html", own=True, width=SHEET)
    assert page.evaluate(CUT_OFF) != []  # on the screen it can be scrolled
    page.emulate_media(media="print")
    assert page.evaluate(CUT_OFF) == []
    assert page.evaluate(SMALL) == []
    assert page.evaluate(ENLARGED) == []
    assert page.evaluate(PARTED) == [True, []]
    if name == WIDEST[0]:
        (derivations, open_ones), (solutions, shown) = page.evaluate(FOLDED)
        assert 0 < derivations == open_ones
        assert 0 == shown < solutions


@pytest.mark.full
@pytest.mark.parametrize("name", ["book/api", "book/sequences", "book/errata", "notebooks/euler"])
def test_what_belongs_together_is_on_one_sheet(visit: Visit, served: str, name: str) -> None:
    page = visit(f"{served}{name}.html", own=True, width=SHEET)
    page.emulate_media(media="print")
    assert page.evaluate(PARTED) == [True, []]


@pytest.mark.parametrize(
    "name",
    ["book/how_to_read", "book/converter", pytest.param("book/ledger", marks=pytest.mark.full)],
)
def test_nothing_is_asked_that_paper_cannot_do(visit: Visit, served: str, name: str) -> None:
    page = visit(f"{served}{name}.html", own=True, width=SHEET)
    article = page.locator(".bd-article")
    assert DONE.search(article.inner_text())
    page.emulate_media(media="print")
    assert not DONE.search(article.inner_text())


def test_a_dark_page_and_its_demos_are_light_on_paper(visit: Visit, served: str) -> None:
    page = visit(f"{served}book/index.html", own=True, color_scheme="dark")
    dark = page.evaluate(DRAWN)
    assert page.evaluate(THEME) == "dark"
    light = page.evaluate(PRINTED)
    assert page.evaluate(THEME) == "light"
    page.evaluate("() => dispatchEvent(new Event('afterprint'))")
    assert page.evaluate(THEME) == "dark"
    expected = visit(f"{served}book/index.html", own=True, color_scheme="light").evaluate(DRAWN)
    assert light == expected != dark
    page.emulate_media(media="print")
    assert page.evaluate(STRETCHED) == [pytest.approx(2 / 3, abs=0.01), "0px"]


def test_with_the_readers_own_colours_icons_and_states_are_seen(visit: Visit, served: str) -> None:
    page = visit(f"{served}notebooks/euler.html", own=True, forced_colors="active")
    ground = page.evaluate("() => getComputedStyle(document.body).backgroundColor")

    def grounds(selector: str) -> set[str]:
        found = page.locator(selector).evaluate_all(
            "(all) => all.map((each) => getComputedStyle(each).backgroundColor)"
        )
        assert found, selector
        return set(found)

    assert ground not in grounds(".fa-solid")
    pressed = grounds(".chr-stops [aria-pressed='true']")
    assert not pressed & grounds(".chr-stops [aria-pressed='false']")
