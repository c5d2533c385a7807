"""The pages of the ledger: a table of all entries to look through, and each document's in full."""

import inspect
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final

import chr_notes
from chr_notes.book.entry_links import ledger_ids
from chr_notes.ledger import Entry
from chr_notes.ledger.card import badge, display
from chr_notes.ledger.show import show
from chr_notes.ledger.table import show_table

__all__ = ["DOCUMENTS", "citation", "functions", "generated"]

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

_CELL: Final = "table cell"


def generated(ledger: tuple[Entry, ...]) -> dict[str, str]:
    """Return the text of each part of the pages by its file name.

    Parameters
    ----------
    ledger
        All entries.
    """
    parts = {"ledger.md": "\n".join(_overview(ledger))}
    used = functions()
    for document in DOCUMENTS:
        own = [entry for entry in ledger if entry.document == document]
        rows = [line for entry in own if entry.kind != _CELL for line in _row(entry, used)]
        cells = [entry for entry in own if entry.kind == _CELL]
        rows += _cells(cells) if cells else []
        parts[f"ledger/{document}.md"] = "\n".join(rows)
    return parts


def functions() -> dict[str, list[str]]:
    """Find the public functions that name each entry in their docstrings, with their modules."""
    found: dict[str, list[str]] = {}
    for name in chr_notes.__all__:
        value = getattr(chr_notes, name)
        for entry in ledger_ids(inspect.getdoc(value) or "") if callable(value) else ():
            found.setdefault(entry, []).append(f"{value.__module__}.{name}")
    return found


def _overview(ledger: tuple[Entry, ...]) -> Iterator[str]:
    """Yield a table for each document: id with verdict, and what the entry says."""
    for document, title in DOCUMENTS.items():
        yield f"## {title}\n"
        yield f"[These entries in full](ledger/{document}.md)\n"
        yield ":::{div} ledger-overview\n| entry | what it says |\n|---|---|"
        for entry in ledger:
            if entry.document == document:
                yield f"| {_head(entry)} {badge(entry.verdict)} | {entry.says} |"
        yield ":::\n"


def _head(entry: Entry) -> str:
    """Give the id as a link, with what the filter of the page goes by."""
    known = f'id="{entry.id}" data-verdict="{entry.verdict}" data-kind="{entry.kind}"'
    known += f' data-document="{entry.document}" data-weight="{entry.weight or "right"}"'
    return f"<span {known}></span>[{entry.id}](#{entry.id})"


def _row(entry: Entry, used: Mapping[str, list[str]]) -> Iterator[str]:
    # The label is for links within the book; the span keeps the id itself as an anchor.
    yield f"({entry.id})="
    yield ":::::{div} ledger-row"
    yield f'<span id="{entry.id}"></span>\n'
    yield show(entry.id).markdown()
    yield f"::::{{dropdown}} {_method(entry)}"
    yield _derived(entry)
    yield "::::\n"
    yield "\n".join(_links(entry, used.get(entry.id, [])))
    yield ":::::\n"


def _method(entry: Entry) -> str:
    return f"{entry.method[0].upper()}{entry.method[1:]}."


def _links(entry: Entry, used: list[str]) -> Iterator[str]:
    """Yield where else the entry is, how to try its verdict, and how to cite it."""
    yield "::::{div} entry-links"
    chapter = f"../../notebooks/{entry.document}.html#entry-{entry.id}"
    yield f'<a href="#{entry.id}">Permalink</a> <a href="{chapter}">in its chapter</a>'
    for name in used:
        yield f"{{py:obj}}`{name.rpartition('.')[2]}() <{name}>`"
    yield "\n<details><summary>Check and cite</summary>\n"
    yield f"Print it misprinted: `python -m pytest tests/ledger -k {entry.id} --full`.\n"
    yield f"Cite it: {citation(entry)}\n"
    yield "</details>\n::::"


def citation(entry: Entry) -> str:
    """Say how to cite an entry: who, what, in which version."""
    title = DOCUMENTS[entry.document]
    return (
        f"the chr_notes contributors, “{entry.id}: {entry.verdict}” ({title}, {entry.place}), "
        f"in: CH Robotics notes, derived, chr_notes {chr_notes.__version__}, 2026."
    )


def _cells(cells: list[Entry]) -> Iterator[str]:
    """Yield the cells of a table as one, each with its id, and how they were judged."""
    yield "## The table\n"
    yield "".join(f"({cell.id})=\n" for cell in cells)
    yield ":::::{div} ledger-cells"
    table = show_table().markdown
    for cell in cells:
        table = table.replace(f'id="entry-{cell.id}"', f'id="{cell.id}"')
    yield f"{table}\n\n:::::\n"
    for method in dict.fromkeys(map(_method, cells)):
        alike = [cell for cell in cells if _method(cell) == method]
        yield f"**{len(alike)} cells {badge(alike[0].verdict)}** {method}\n"
    derivation, remark = next((c.derivation, c.remark) for c in cells if c.derivation)
    yield f"{remark}\n"
    # The last step is in the numbers of one cell.
    for words, latex in derivation[:-1]:
        yield f"{words}\n\n{display(latex)}"


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
