"""Every page of the book in a browser without a network, from a server and from the disk."""

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml
from playwright.sync_api import Browser, Page, expect

from chr_notes.book import SOURCES
from chr_notes.demos import GimbalLockDemo
from chr_notes.ledger import entries

Visit = Callable[..., Page]

TOC = yaml.safe_load((SOURCES / "_toc.yml").read_text(encoding="utf-8"))
CHAPTERS = [
    page["file"]
    for part in TOC["parts"]
    for chapter in part["chapters"]
    for page in (chapter, *chapter.get("sections", ()))
]
MADE = ["genindex", "py-modindex", "search"]
PAGES = [f"{name}.html" for name in (TOC["root"], *CHAPTERS, *MADE)]

# What a page may load, in bytes before compression: by name, else without formulas or with them.
LIMITS = {"notebooks/euler.html": 1_200_000}
LIGHT, LARGEST = 700_000, 1_600_000

WEIGHT = """() => ["navigation", "resource"]
  .flatMap((type) => performance.getEntriesByType(type))
  .reduce((sum, entry) => sum + entry.decodedBodySize, 0)"""

# How far what stands in the window has moved by itself, and the longest task in ms.
UNREST = """() => Promise.all(["layout-shift", "longtask"].map((type) => new Promise((done) => {
  new PerformanceObserver((list) => done(list.getEntries())).observe({ type, buffered: true });
  setTimeout(() => done([]), 100);
}))).then(([shifts, tasks]) => [
  shifts.filter((shift) => !shift.hadRecentInput).reduce((sum, shift) => sum + shift.value, 0),
  Math.max(0, ...tasks.map((task) => task.duration)),
])"""
MOST_SHIFT = 0.05

LEFT_OVER = """() => {
  const article = document.querySelector(".bd-article")?.cloneNode(true);
  if (!article) return "";
  for (const each of article.querySelectorAll("pre, code, script, math")) each.remove();
  return article.textContent;
}"""

# No place is asked of what is in a formula or another part that scrolls: it takes long.
TOO_WIDE = """() => {
  const scrolls = ":is(.math, pre, .cell_output, table)";
  const others = `.bd-article *:not(${scrolls}, ${scrolls} *)`;
  return [...document.querySelectorAll(others)].filter((element) => {
    const { right, width } = element.getBoundingClientRect();
    return width > 0 && right > innerWidth + 1;
  }).map((element) => element.outerHTML.slice(0, 80));
}"""


OUT_OF_REACH = """() => [...document.querySelectorAll(".bd-article *")].filter((element) =>
  element.checkVisibility() && element.scrollWidth > element.clientWidth + 1
  && /auto|scroll/.test(getComputedStyle(element).overflowX)
  && element.tabIndex < 0 && !element.querySelector("a, button, input, [tabindex='0']")
).map((element) => element.outerHTML.slice(0, 80))"""


CUT = """() => [...document.querySelectorAll(
  ".bd-article div.cell_output :is(pre, div:has(> figure)):not(details *)"
)].filter((element) =>
  element.checkVisibility() && element.scrollWidth > element.clientWidth
  && getComputedStyle(element).overflowX !== "visible"
  && element.textContent.split("\\n").every((line) => line.length <= 57 || element.matches("div"))
).map((element) => element.textContent.slice(0, 80))"""


# Parts of a text that are gone through one by one when a demo beside them moves.
NOT_APART = """() => [...document.querySelectorAll(".bd-article section > :not(section)")]
  .filter((part) => getComputedStyle(part).isolation !== "isolate")
  .map((part) => part.outerHTML.slice(0, 80))"""
SLID = """() => new Promise((done) => {
  const slider = document.querySelector("[data-demo] input[type=range]");
  let frames = 0;
  const step = () => {
    slider.value = Number(slider.min) + frames % 60;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    frames += 1;
    if (frames < 60) requestAnimationFrame(step);
    else done();
  };
  requestAnimationFrame(step);
})"""
MOST_ANEW = 0.05
"""What may be painted anew in each frame of a slider that moves, of all that the page paints."""


OPENED = """() => {
  for (const line of document.querySelectorAll(".bd-article details")) line.open = true;
}"""
# In the end a page without frames, which a resized one can be for long, is looked at as it is.
# Of tables with up to five columns all are seen at once.
CUT_TABLES = """[...document.querySelectorAll("article table.table:not(:has(th:nth-child(6)))")]
  .filter((table) => table.offsetWidth > table.parentElement.clientWidth + 1)
  .map((table) => table.textContent.trim().slice(0, 60))"""
# Names in tables and titles at the foot that break within a word.
BROKEN = """() => [...document.querySelectorAll(
  ".prev-next-area a p, table .pre"
)].flatMap((each) => {
  const text = each.firstChild;
  const broken = ({ index, 0: word }) => {
    const range = document.createRange();
    range.setStart(text, index);
    range.setEnd(text, index + word.length);
    return new Set([...range.getClientRects()].map((rect) => rect.top)).size > 1;
  };
  return [...text.data.matchAll(/\\w+/g)].filter(broken).map(([word]) => word);
})"""
IDLE = """new Promise((done) => {
  requestAnimationFrame(() => requestIdleCallback(done, { timeout: 500 }));
  setTimeout(done, 5000);
})"""


def test_each_chapter_is_a_page_and_nothing_else_is(book: Path) -> None:
    built = {path.relative_to(book) for path in book.rglob("*.html")}
    built = {str(path) for path in built if path.parts[0] != "_static"}
    assert built == {*PAGES, "index.html"}


def looked_at(page: Page) -> None:
    """Fail on a formula not set, a picture without words and a dead demo."""
    left_over = page.evaluate(LEFT_OVER)
    assert "$" not in left_over, page.url
    assert "\\" not in left_over, page.url
    assert page.locator("img:not([alt]), img[alt='']").count() == 0, page.url
    demos = page.locator("[data-demo]").count()
    expect(page.locator("[data-demo] > .chr-demo")).to_have_count(demos)


# `visit` fails on any request to elsewhere, missing file or error on the console.
@pytest.mark.parametrize("name", PAGES)
def test_page_stands_by_itself(
    visit: Visit, served: str, name: str, record_property: Callable[[str, object], None]
) -> None:
    page = visit(served + name, color_scheme="light", cold=True)
    weight = page.evaluate(WEIGHT)
    plain = page.locator("math").count() == 0
    assert 300_000 < weight <= LIMITS.get(name, LIGHT if plain else LARGEST)
    looked_at(page)
    shift, longest = page.evaluate(UNREST)
    record_property(
        "measured",
        f"{name} {weight / 1000:.0f} kB, moves {shift:.3f}, longest task {longest:.0f} ms",
    )
    assert shift <= MOST_SHIFT
    chapter = name.startswith("notebooks/")
    # On the narrowest of phones a chapter does not move sideways. On phones all is unfolded.
    for width in (1280, 320, 390) if chapter else (1280, 390):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        if width == 320:
            continue
        assert page.evaluate(TOO_WIDE) == []
        assert page.evaluate(CUT_TABLES) == []
        page.evaluate(IDLE)  # the page has seen its width
        assert page.evaluate(OUT_OF_REACH) == []
        assert page.evaluate(CUT) == []
        page.evaluate(OPENED)
    assert page.evaluate(BROKEN) == []


@pytest.mark.parametrize("name", ["book/converter", "notebooks/euler"])
def test_on_a_phone_little_moves(
    visit: Visit, served: str, name: str, record_property: Callable[[str, object], None]
) -> None:
    page = visit(f"{served}{name}.html", width=390, own=True)
    demos = page.locator("[data-demo]").count()
    expect(page.locator("[data-demo] > .chr-demo")).to_have_count(demos)
    shift, _ = page.evaluate(UNREST)
    record_property("measured", f"{name} at 390 px moves {shift:.3f}")
    assert shift <= MOST_SHIFT


def test_first_page_leads_to_the_book(visit: Visit, served: str) -> None:
    page = visit(served + "index.html")
    expect(page).to_have_title(re.compile("CH Robotics notes, derived"))
    expect(page.locator("[data-demo] canvas")).to_have_count(1)


def test_demo_in_the_chapter_reacts_to_the_keyboard(visit: Visit, served: str) -> None:
    page = visit(served + "notebooks/euler.html")
    demo = page.locator("[data-demo='gimbal-lock']").first
    pitch = demo.locator("input[name=pitch]")
    pitch.fill("59")
    pitch.focus()
    page.keyboard.press("ArrowRight")
    expect(demo.locator("output[name=determinant]")).to_have_text("2")


# The next press of Tab leads to the first link of the page.
FROM_THE_TOP = """() => {
  scrollTo(0, 0);
  document.body.tabIndex = -1;
  document.body.focus();
}"""
FOCUSED = """() => {
  const each = document.activeElement;
  return each.closest(".chr-demo") ? [...document.querySelectorAll(".chr-demo")]
    .indexOf(each.closest(".chr-demo")) : -1;
}"""


def test_few_presses_of_tab_lead_to_each_demo(
    visit: Visit, book: Path, record_property: Callable[[str, object], None]
) -> None:
    """To the n-th demo of a page n + 1: past the link to the text, and those before it."""
    page = visit((book / "notebooks" / "euler.html").as_uri())
    demos = page.locator(".chr-demo").count()
    assert demos == 3
    for nth in range(demos):
        page.evaluate(FROM_THE_TOP)
        for _ in range(nth + 2):
            page.keyboard.press("Tab")
        page.keyboard.press("Enter")
        assert page.evaluate(FOCUSED) == nth
        expect(page.locator(".chr-demo").nth(nth)).to_be_in_viewport()
        page.keyboard.press("Tab")  # and to the first of what it has
        assert page.evaluate(FOCUSED) == nth
    # Without the links too: a formula is a stop only where it must be scrolled.
    page.evaluate(FROM_THE_TOP)
    presses = 0
    while page.evaluate(FOCUSED) < 0:
        presses += 1
        page.keyboard.press("Tab")
    record_property("measured", f"{presses} presses of Tab to the first demo without its link")
    assert presses <= 60


def test_reader_without_javascript_gets_the_numbers(book: Path) -> None:
    first = (book / "book" / "index.html").read_text(encoding="utf-8")
    assert GimbalLockDemo(yaw=30, pitch=60, roll=20).to_html() in first


def test_ledger_has_an_anchor_and_a_worded_verdict_for_each_entry(book: Path) -> None:
    overview = (book / "book" / "ledger.html").read_text(encoding="utf-8")
    for document in {entry.document for entry in entries()}:
        text = (book / "book" / "ledger" / f"{document}.html").read_text(encoding="utf-8")
        text, _, table = text.partition('<div class="ledger-cells')
        rows = re.split(r'<div class="ledger-row', text)[1:]
        own = [entry for entry in entries() if entry.document == document]
        expected = [entry for entry in own if entry.kind != "table cell"]
        for entry, row in zip(expected, rows, strict=True):
            verdict = rf'class="verdict verdict-{entry.verdict}">.* {entry.verdict}</span>'
            assert f'<span id="{entry.id}"></span>' in row
            assert re.search(verdict, row)
        for entry in own:
            assert f'<span id="{entry.id}" data-verdict="{entry.verdict}"' in overview
        for cell in (entry for entry in own if entry.kind == "table cell"):
            found = table.partition(f'<span id="{cell.id}"></span>')[2].partition("</td>")[0]
            assert f'aria-label="{cell.verdict}"' in found


def test_link_to_an_entry_goes_there(visit: Visit, book: Path) -> None:
    page = visit((book / "book" / "ledger.html").as_uri() + "#euler.7.d")
    expect(page.locator('[id="euler.7.d"]')).to_be_in_viewport()
    page.get_by_role("link", name="euler.7.d").click()
    expect(page).to_have_url(re.compile(r"ledger/euler\.html#euler-7-d$"))
    expect(page.locator('[id="euler.7.d"]')).to_be_in_viewport()


def test_on_a_phone_the_picture_of_a_demo_stays_below_the_bar(visit: Visit, served: str) -> None:
    page = visit(served + "notebooks/estimation.html")
    page.set_viewport_size({"width": 390, "height": 844})
    demo = page.locator("[data-demo='tilt']").first
    for name in ("lateral_acceleration", "vibration"):
        slider = demo.locator(f"input[name={name}]")
        # So far up that the picture would have gone, did it not stick.
        slider.evaluate("(each) => scrollBy(0, each.getBoundingClientRect().bottom - 560)")
        page.wait_for_function("scrollY > 0")
        picture, control = demo.locator("canvas").bounding_box(), slider.bounding_box()
        bar = page.locator(".bd-header-article").bounding_box()
        assert picture is not None
        assert control is not None
        assert bar is not None
        assert bar["y"] + bar["height"] <= picture["y"] + 1
        assert picture["y"] + picture["height"] <= control["y"]
        assert control["y"] + control["height"] <= 844


@pytest.mark.full
@pytest.mark.parametrize("width", [390, 1280])
def test_the_page_is_not_painted_again_for_a_demo(
    visit: Visit,
    browser: Browser,
    book: Path,
    width: int,
    record_property: Callable[[str, object], None],
) -> None:
    page = visit((book / "notebooks" / "euler.html").as_uri(), width=width)
    assert page.evaluate(NOT_APART) == []
    page.locator("[data-demo]").first.scroll_into_view_if_needed()
    page.evaluate(IDLE)
    browser.start_tracing(page=page, categories=["blink"])
    page.evaluate(SLID)
    events = json.loads(browser.stop_tracing())["traceEvents"]
    frames = [
        (each["args"]["num_non_cached_new_items"], each["args"]["current_display_list_size"])
        for each in events
        if each["name"] == "PaintController::commitNewDisplayItems"
        and each["args"]["current_display_list_size"] > 1_000  # an icon is painted by itself
    ]
    assert len(frames) > 20
    anew, of = max(frames)
    told = f"a slider at {width} px paints {anew} of {of} items anew"
    record_property("measured", told)
    assert anew <= MOST_ANEW * of
