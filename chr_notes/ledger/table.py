"""The cells of Table 1 as one table: each as printed, with its verdict and the right number."""

from collections.abc import Iterator
from dataclasses import dataclass

from chr_notes.ledger import CASES, entry
from chr_notes.ledger.show import MARKS
from chr_notes.printed.statement import Approximately
from chr_notes.printed.table_1 import CELLS

PREFIX = "dead_reckoning.t1"


@dataclass(frozen=True)
class Table:
    """A table that a notebook cell can show."""

    markdown: str

    def __repr__(self) -> str:
        """Give the Markdown source, where nothing can be typeset."""
        return self.markdown

    def _repr_markdown_(self) -> str:
        return self.markdown


def show_table() -> Table:
    """Show Table 1 of the dead-reckoning note, wrong numbers struck out beside the right ones."""
    return Table("\n".join(_lines()))


def _lines() -> Iterator[str]:
    columns = {cell.column: cell.means for cell in CELLS}
    yield "| angle | " + " | ".join(columns.values()) + " |"
    yield "|---" * (len(columns) + 1) + "|"
    for degrees in dict.fromkeys(cell.degrees for cell in CELLS):
        cells = (_cell(f"{PREFIX}.{degrees}.{column}") for column in columns)
        yield f"| {degrees}° | " + " | ".join(cells) + " |"


def _cell(name: str) -> str:
    case, verdict = CASES[name], entry(name).verdict
    anchor = f'<span id="entry-{name}"></span>'
    mark = (
        f'<span class="verdict-{verdict}" role="img" aria-label="{verdict}">{MARKS[verdict]}</span>'
    )
    printed, right = case.printed.statement, case.correction
    if not isinstance(right, Approximately):
        return f"{anchor}${printed.number}$ {mark}"
    return f"{anchor}<s>${printed.number}$</s> {mark} ${right.number}$"
