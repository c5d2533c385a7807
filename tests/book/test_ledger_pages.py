"""Entries are looked through, cited, found by their ids, and linked both ways."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

import chr_notes
from chr_notes.book import search
from chr_notes.book.entry_links import ledger_ids
from chr_notes.book.ledger_pages import citation, functions
from chr_notes.ledger import entries, entry

Visit = Callable[..., Page]
IDS = {each.id for each in entries()}


def test_functions_name_entries_that_are_there() -> None:
    assert {*functions()} <= IDS
    assert functions()["euler.5.2"] == ["chr_notes.euler.matrix_from_euler"]
    assert ledger_ids("No more than words.") == []


def test_a_citation_has_entry_verdict_place_and_version() -> None:
    told = citation(entry("euler.7.a"))
    for part in ("euler.7.a", entry("euler.7.a").verdict, entry("euler.7.a").place):
        assert part in told
    assert f"chr_notes {chr_notes.__version__}" in told


def test_each_link_leads_to_an_anchor(book: Path) -> None:
    """From entries to chapters, from chapters to entries, and from the search."""
    names: dict[Path, set[str]] = {}

    def there(page: Path, anchor: str) -> bool:
        if page not in names:
            names[page] = set(re.findall(r' id="([^"]+)"', page.read_text(encoding="utf-8")))
        return anchor in names[page]

    for document in {each.document for each in entries()}:
        own = [each for each in entries() if each.document == document]
        for folder, other in (("book/ledger", "notebooks"), ("notebooks", "book/ledger")):
            path = book / folder / f"{document}.html"
            text = path.read_text(encoding="utf-8")
            links = re.findall(rf'href="([./]*{other}/{document}\.html)#([^"]+)"', text)
            assert len(links) >= sum(each.kind != "table cell" for each in own)
            for page, anchor in links:
                assert there((path.parent / page).resolve(), anchor), (path, anchor)
    for places in search.PLACES.values():
        for place, _ in places:
            page, _, anchor = place.partition("#")
            assert there(book / page, anchor), place


def test_a_docstring_links_its_entries(book: Path) -> None:
    text = (book / "book" / "api.html").read_text(encoding="utf-8")
    for name in ("euler.5.2", "quaternions.3.3"):
        document, anchor = name.split(".")[0], name.replace(".", "-")
        assert f'href="ledger/{document}.html#{anchor}"' in text


def test_the_ledger_is_looked_through(visit: Visit, address: str) -> None:
    page = visit(address + "book/ledger.html?verdict=corrected")
    form = page.get_by_role("search", name="Entries of the ledger")
    rows = page.locator(".ledger-overview tbody tr:visible")
    wrong = [each for each in entries() if each.verdict == "corrected"]
    expect(form.locator("output")).to_have_text(f"{len(wrong)} of {len(IDS)} entries")
    expect(rows).to_have_count(len(wrong))
    form.get_by_label("Document").select_option("euler")
    form.get_by_label("Weight").select_option("misleads")
    left = [each for each in wrong if (each.document, each.weight) == ("euler", "misleads")]
    assert 0 < len(left) < len(wrong)
    expect(rows).to_have_count(len(left))
    expect(page).to_have_url(re.compile(r"\?document=euler&verdict=corrected&weight=misleads$"))
    form.get_by_label("Words").fill("nothing has these words")
    expect(rows).to_have_count(0)
    expect(form.locator("output")).to_have_text(f"0 of {len(IDS)} entries")


@pytest.mark.parametrize("asked", ["euler.5.2", "AHRS"])
def test_the_search_leads_where_it_should(visit: Visit, served: str, asked: str) -> None:
    page = visit(f"{served}search.html?q={asked}")
    own = (f"book/ledger/euler.html#{asked}", f"{asked}: {entry('euler.5.2').says}")
    place, words = search.PLACES.get(asked.lower(), (own,))[0]
    first = page.locator("#search-results, .found-first").first.locator("a").first
    expect(first).to_have_text(words)
    expect(first).to_have_attribute("href", place)
    expect(page.get_by_role("status").filter(has_text="Search finished")).to_be_visible()
    # The excerpts that the theme fetches meanwhile are there before the page is left.
    page.wait_for_load_state("networkidle")
