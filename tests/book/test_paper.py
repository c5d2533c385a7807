"""On paper nothing is cut off and all is light; in colours of the reader's own, states are seen."""

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
WIDEST = ("notebooks/validation", "book/ledger/validation", "book/from_derivation_to_code")
# What a demo has drawn.
DRAWN = "() => document.querySelector('.chr-stage canvas').toDataURL()"
PRINTED = """() => {
  dispatchEvent(new Event("beforeprint"));
  return document.querySelector(".chr-stage canvas").toDataURL();
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
