"""The formulas of one document with their verdicts, for the end of its chapter."""

from collections.abc import Iterator

from chr_notes.ledger import entries
from chr_notes.ledger.card import badge, computed, display
from chr_notes.ledger.entry import Entry
from chr_notes.ledger.table import Table

__all__ = ["show_summary"]


def show_summary(document: str) -> Table:
    """Show all equations of a document in one table: the right form of each, and its verdict.

    What is printed with another function than it is read with stands as it is read.

    Parameters
    ----------
    document
        Its topic, for example `"euler"`.

    Raises
    ------
    ValueError
        If no document has that topic.
    """
    equations = [each for each in entries() if (each.document, each.kind) == (document, "equation")]
    if not equations:
        msg = f"expected the topic of a document, got {document!r}"
        raise ValueError(msg)
    return Table("\n".join(_lines(equations)))


def _lines(equations: list[Entry]) -> Iterator[str]:
    # Blank lines end an HTML block, so that what stands between is read as Markdown.
    yield '<table class="chr-summary">\n<tbody>'
    for entry in equations:
        link = f'<a href="#entry-{entry.id}">{entry.id}</a>'
        yield f"<tr>\n<th>{link}<br>{badge(entry.verdict)}</th>\n<td>\n"
        yield f"{entry.says}\n"
        yield display(entry.correction_latex or computed(entry) or entry.printed_latex)
        if entry.condition is not None:
            yield f"{'Exactly when' if entry.exact else 'If'}\n"
            yield display(entry.condition)
        yield "</td>\n</tr>"
    yield "</tbody>\n</table>\n"
