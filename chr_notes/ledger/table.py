"""The cells of Table 1 as one table: each as printed, with its verdict and the right number."""

from collections.abc import Iterator
from dataclasses import dataclass

from chr_notes.ledger import entry
from chr_notes.ledger.card import MARKS
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
    judged = entry(name)
    verdict = judged.verdict
    anchor = f'<span id="entry-{name}"></span>'
    mark = (
        f'<span class="verdict-{verdict}" role="img" aria-label="{verdict}">{MARKS[verdict]}</span>'
    )
    printed = _number(judged.printed_latex)
    if judged.correction_latex is None:
        return f"{anchor}${printed}$ {mark}"
    return f"{anchor}<s>${printed}$</s>&nbsp;{mark} ${_number(judged.correction_latex)}$"


def _number(latex: str) -> str:
    """Take the number of a cell, which stands after the sign, in a box where it is corrected."""
    number = latex.rpartition(r"\approx ")[2]
    return number.removeprefix(r"\boxed{").removesuffix("}") if "boxed" in number else number
