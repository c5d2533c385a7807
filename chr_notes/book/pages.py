"""The pages of the book that come from data, as MyST Markdown."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Final, get_args

from chr_notes.book import code_pages, speed_page
from chr_notes.book.notation import notation
from chr_notes.conventions import CONVENTIONS
from chr_notes.demos import GimbalLockDemo
from chr_notes.ledger import Entry, Verdict, entries
from chr_notes.ledger.show import badge, display, show
from chr_notes.ledger.table import show_table

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
        "errata.md": "\n".join(_errata(ledger)),
        "verdicts.md": verdicts(ledger),
        "gimbal_lock.md": GimbalLockDemo(yaw=30.0, pitch=75.0, roll=20.0).to_html() + "\n",
    }
    for document in DOCUMENTS:
        rows = (_row(entry) for entry in ledger if entry.document == document)
        pages[f"ledger/{document}.md"] = "\n".join(line for row in rows for line in row)
    return pages | code_pages.generated() | speed_page.generated()


def conventions() -> str:
    """Return the conventions, a section each."""
    return "\n".join(f"## {each.title}\n\n{each.statement}\n" for each in CONVENTIONS)


def verdicts(ledger: Iterable[Entry]) -> str:
    """Return how many entries have each verdict, and what it means, as an HTML list."""
    counts = Counter(entry.verdict for entry in ledger)
    items = "\n".join(
        f"<li><b>{counts[verdict]}</b> {badge(verdict)} <span>{MEANINGS[verdict]}</span></li>"
        for verdict in get_args(Verdict)
    )
    return f'<ul class="verdict-counts">\n{items}\n</ul>\n'


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
    shown = entry.printed_latex + (entry.correction_latex or "")
    if entry.derived_latex is None:
        yield "The statement was decided as a proposition; there is no formula to compare.\n"
    elif entry.derived_latex in shown:
        yield "The derivation gives the right-hand side that stands above.\n"
    else:
        yield f"What the derivation gives:\n\n{display(entry.derived_latex)}"
    yield "::::\n:::::\n"


def _errata(ledger: Iterable[Entry]) -> Iterator[str]:
    """Yield what one would write into the margins: the wrong form, the right one, why."""
    document = None
    for entry in ledger:
        if entry.verdict not in ("corrected", "qualified") or entry.kind == "table cell":
            continue
        if entry.document != document:
            document = entry.document
            yield f"## {DOCUMENTS[document]}\n"
        yield f"### {entry.id}\n"
        yield f"{badge(entry.verdict)} {entry.says}\n"
        yield display(entry.printed_latex)
        if entry.correction_latex is not None:
            yield f"should read\n\n{display(entry.correction_latex)}"
        if entry.condition is not None:
            holds = "holds exactly when" if entry.exact else "holds if"
            yield f"{holds}\n\n{display(entry.condition)}"
        if entry.remark is not None:
            yield f"{entry.remark}\n"
        yield f"[The entry with its witness and derivation](#{entry.id})\n"
    yield "## Table 1 of the dead-reckoning note\n"
    yield "Wrong numbers are struck out, with the right ones beside them.\n"
    yield show_table().markdown
