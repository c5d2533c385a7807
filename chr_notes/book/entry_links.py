"""Links back to the ledger: from the cards of the chapters, and from docstrings."""

import re
from typing import Final

from chr_notes.ledger.stored import DOCUMENTS

__all__ = ["from_cards", "from_docstring", "ledger_ids"]

_ID: Final = rf"((?:{'|'.join(DOCUMENTS)})\.\w+(?:\.\w+)*)"
_NAME: Final = re.compile(rf"\b{_ID}")
_LEDGER: Final = re.compile(r"\bLedger: (.*?)(?=\n\n|\Z)", re.DOTALL)
# A card's id is the link. Where the id opens a line of small print, the words below it are.
_CARD: Final = re.compile(rf'(<div class="entry-head"><p>\s*)<span class="entry-id">{_ID}</span>')
_LINE: Final = re.compile(
    rf'(<details class="entry chip" id="entry-{_ID}"(?: open)?>'
    r'(?:(?!</details>|"entry-term").)*<p class="entry-term">)'
    r"([^<]*)(</p>)",
    re.DOTALL,
)


def from_cards(page: str) -> str:
    """Link each card of a chapter's built page to its entry; what is linked stays.

    Parameters
    ----------
    page
        HTML of a chapter.
    """

    def place(name: str) -> str:
        return f"../book/ledger/{name.split('.', maxsplit=1)[0]}.html#{name}"

    page = _CARD.sub(
        lambda found: f'{found[1]}<a class="entry-id" href="{place(found[2])}">{found[2]}</a>', page
    )
    return _LINE.sub(
        lambda found: f'{found[1]}<a href="{place(found[2])}">{found[3]}</a>{found[4]}', page
    )


def from_docstring(lines: list[str]) -> None:
    """Link the entries that a docstring names, in place, as Sphinx's autodoc wants it."""
    names = ledger_ids("\n".join(lines))
    if not names:
        return
    first = next(number for number, line in enumerate(lines) if "Ledger: " in line)
    for number in range(first, len(lines)):
        if not lines[number].strip():
            break
        lines[number] = _NAME.sub(r":ref:`\1 <\1>`", lines[number])


def ledger_ids(docstring: str) -> list[str]:
    """Read from a docstring which entries of the ledger it names.

    Parameters
    ----------
    docstring
        Of a public function; its notes may begin "Ledger:".

    Examples
    --------
    >>> ledger_ids("Ledger: euler.5.2, euler.5.3.")
    ['euler.5.2', 'euler.5.3']
    """
    found = _LEDGER.search(docstring)
    return _NAME.findall(found.group(1)) if found else []
