"""The pages of the book that come from data, as MyST Markdown."""

from collections import Counter
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final, get_args

from chr_notes.book import cases_page, code_pages, frames_picture, sequence_page, speed_page
from chr_notes.book.errata import errata, summary
from chr_notes.book.notation import notation
from chr_notes.conventions import CONVENTIONS
from chr_notes.demos import ConverterDemo, DetectiveDemo, GimbalLockDemo
from chr_notes.ledger import Entry, Verdict, entries
from chr_notes.ledger.show import badge, display, show

__all__ = ["generated"]

DOCUMENTS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "euler": "Understanding Euler Angles",
        "quaternions": "Understanding Quaternions",
        "sensors": "Sensors for Orientation Estimation",
        "estimation": "Fundamentals of Attitude Estimation",
        "dead_reckoning": "Using Accelerometers to Estimate Position and Velocity",
        "validation": "Real-time Validation of Euler Angles",
    }
)
"""Title of each document by its topic."""

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
        "ledger.md": "\n".join(_overview(ledger)),
        "errata.md": "\n".join(errata(ledger)),
        "verdicts.md": verdicts(ledger),
        "gimbal_lock.md": GimbalLockDemo(yaw=30.0, pitch=60.0, roll=20.0).to_html() + "\n",
        "converter.md": ConverterDemo().to_html() + "\n",
        "detective.md": DetectiveDemo().to_html() + "\n",
    }
    for document in DOCUMENTS:
        rows = (_row(entry) for entry in ledger if entry.document == document)
        pages[f"ledger/{document}.md"] = "\n".join(line for row in rows for line in row)
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


def _overview(ledger: tuple[Entry, ...]) -> Iterator[str]:
    """Yield a table for each document: id with verdict, and what the entry says."""
    for document, title in DOCUMENTS.items():
        yield f"## {title}\n"
        yield f"[These entries in full](ledger/{document}.md)\n"
        yield ":::{div} ledger-overview\n| entry | what it says |\n|---|---|"
        for entry in ledger:
            if entry.document == document:
                head = f'<span id="{entry.id}"></span>[{entry.id}](#{entry.id})'
                yield f"| {head} {badge(entry.verdict)} | {entry.says} |"
        yield ":::\n"


def _row(entry: Entry) -> Iterator[str]:
    # The label is for links within the book; the span keeps the id itself as an anchor.
    yield f"({entry.id})="
    yield ":::::{div} ledger-row"
    yield f'<span id="{entry.id}"></span>\n'
    yield show(entry.id).markdown()
    yield f"::::{{dropdown}} {entry.method[0].upper()}{entry.method[1:]}."
    yield _derived(entry)
    yield "::::\n:::::\n"


def _derived(entry: Entry) -> str:
    """Say what the derivation has in place of what stands on the card."""
    derived = entry.derived_latex
    if derived is None and entry.kind == "claim":
        return "The statement was decided as a proposition; there is no formula to compare.\n"
    if derived is None:
        return "It was decided on the equation itself; the derivation has no other form of it.\n"
    ends = (f"= {derived}", f"= \\boxed{{{derived}}}")
    if any(latex.endswith(ends) for latex in (entry.printed_latex, entry.correction_latex or "")):
        return "The derivation gives the right-hand side that stands above.\n"
    return f"What the derivation gives:\n\n{display(derived)}"
