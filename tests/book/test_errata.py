"""The errata name each error once, the heaviest first, and leave none out."""

import re
from collections.abc import Callable
from dataclasses import replace

from playwright.sync_api import Page, expect

from chr_notes.book.errata import HEADINGS, by_root, errata, heaviest, summary
from chr_notes.ledger import entries
from chr_notes.ledger.harm import HARM
from chr_notes.ledger.roots import ROOTS

TEXT = "\n".join(errata(entries()))


def test_parts_and_errors_stand_in_the_order_of_their_weight() -> None:
    titles = [title for title, _ in HEADINGS.values()]
    assert re.findall(r"^## (.*)$", TEXT, re.MULTILINE)[: len(titles)] == titles
    weights = [heaviest(places) for places in by_root(entries()).values()]
    assert weights == sorted(weights, key=list(HEADINGS).index)
    for says in ROOTS.values():
        assert TEXT.count(says) == 1


def test_each_entry_that_is_not_right_stands_there_once_or_in_the_table() -> None:
    wrong = [entry for entry in entries() if entry.verdict in ("qualified", "corrected")]
    assert {entry.id for entry in wrong} == {
        entry.id for places in by_root(entries()).values() for entry in places
    }
    for entry in wrong:
        assert TEXT.count(f"**[{entry.id}](#{entry.id})**") == (entry.kind != "table cell")
        assert f"{entry.place}: {entry.says}" in TEXT or entry.kind == "table cell"


def test_printed_it_is_a_few_pages(visit: Callable[..., Page], served: str) -> None:
    page = visit(f"{served}book/errata.html", own=True)
    assert page.pdf(format="A4").count(b"/MediaBox") <= 7
    page.emulate_media(media="print")
    expect(page.locator(".erratum").first).to_be_visible()
    assert not page.locator(".erratum-remark").first.is_visible()


def test_what_misleads_comes_in_the_order_of_its_harm() -> None:
    """What turns an attitude round stands before a division by zero, which shows itself."""
    errors = by_root(entries())
    misleading = [root for root, places in errors.items() if heaviest(places) == "misleads"]
    assert misleading == [*HARM]
    assert misleading.index("quaternion-direction") == 0
    for weight in ("label", "small print"):
        counts = [len(places) for places in errors.values() if heaviest(places) == weight]
        assert counts == sorted(counts, reverse=True)


def test_an_error_weighs_as_much_as_its_worst_place() -> None:
    entry = entries()[0]
    places = [replace(entry, weight=weight) for weight in ("small print", "misleads", "label")]
    assert heaviest(places) == "misleads"
    assert heaviest(places[2:]) == "label"


def test_the_summary_counts_places_and_errors() -> None:
    errors = by_root(entries())
    numbers = [int(number) for number in re.findall(r"\*\*(\d+)\*\*", summary(entries()))]
    places, count, *weights = numbers
    assert places == sum(entry.verdict in ("qualified", "corrected") for entry in entries())
    assert count == len(errors) == sum(weights)
