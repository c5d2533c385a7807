"""The pages of the book that come from data, as MyST Markdown."""

from collections import Counter
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, get_args

from chr_notes.book import (
    cases_page,
    code_pages,
    frames_picture,
    ledger_pages,
    sequence_page,
    speed_page,
)
from chr_notes.book.errata import errata, summary
from chr_notes.book.notation import notation
from chr_notes.conventions import CONVENTIONS
from chr_notes.demos import ConverterDemo, DetectiveDemo, GimbalLockDemo
from chr_notes.ledger import Entry, Verdict, entries
from chr_notes.ledger.card import badge

__all__ = ["generated"]

MEANINGS: Final[Mapping[Verdict, str]] = MappingProxyType(
    {
        "definition": "introduces a name; there is nothing to prove",
        "proved": "derived independently, with the same result",
        "qualified": "holds only under a condition that the document leaves out",
        "corrected": "wrong as printed; the right form stands beside it",
        "reported": "a fact about a product, which mathematics cannot check",
    }
)


def generated() -> dict[str, str]:
    """Return the text of each generated page or part of a page by its file name."""
    ledger = entries()
    pages = {
        "conventions.md": conventions(),
        "notation.md": notation(),
        "errata.md": "\n".join(errata(ledger)),
        "verdicts.md": verdicts(ledger),
        "gimbal_lock.md": GimbalLockDemo(yaw=30.0, pitch=60.0, roll=20.0).to_html() + "\n",
        "converter.md": ConverterDemo().to_html() + "\n",
        "detective.md": DetectiveDemo().to_html() + "\n",
    }
    pages |= ledger_pages.generated(ledger)
    for part in (code_pages, speed_page, frames_picture, sequence_page, cases_page):
        pages |= part.generated()
    return pages


def conventions() -> str:
    """Return the conventions, a section each."""
    return "\n".join(f"## {each.title}\n\n{each.statement}\n" for each in CONVENTIONS)


def verdicts(ledger: tuple[Entry, ...]) -> str:
    """Return how many entries have each verdict, what it means, and how many errors that is."""
    counts = Counter(entry.verdict for entry in ledger)
    items = "\n".join(
        f"<li><b>{counts[verdict]}</b> {badge(verdict)} <span>{MEANINGS[verdict]}</span></li>"
        for verdict in get_args(Verdict)
    )
    return f'<ul class="verdict-counts">\n{items}\n</ul>\n\n{summary(ledger)}'
