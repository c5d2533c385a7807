"""One entry of the ledger as a page shows it: formula, verdict, and what the verdict needs."""

import html
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from chr_notes.ledger import entry as judged
from chr_notes.ledger.entry import Entry, Verdict

MARKS: Final[Mapping[Verdict, str]] = MappingProxyType(
    {"definition": "≔", "proved": "✓", "qualified": "◐", "corrected": "✎", "reported": "❞"}
)
"""A sign beside each verdict's name, so that colour is not the only cue."""

AND: Final = r" \quad\text{and}\quad "
JOINTS: Final[Mapping[str, str]] = MappingProxyType(
    {AND: r"\text{and}\quad ", r" \quad\Rightarrow\quad ": r"\Rightarrow\quad ", " {}= ": "= "}
)
"""What joins statements on one line, and what heads the second where each has its own."""
EQUALS: Final = " = "
LONG: Final = 150
"""From this many characters of LaTeX on, statements that are joined stand on a line each."""


@dataclass(frozen=True)
class Card:
    """An entry that a notebook cell can show. Markdown serves JupyterLab and the book alike.

    Attributes
    ----------
    entry
        What is shown.
    derived
        Whether the steps of its derivation stand before it, instead of folded in.
    """

    entry: Entry
    derived: bool = False

    def __repr__(self) -> str:
        """Give id and verdict, where no Markdown can be shown."""
        return f"{self.entry.id}: {self.entry.verdict}"

    def markdown(self) -> str:
        """Return the card, for a page that is made from data."""
        return "\n".join(_card(self.entry))

    def _repr_markdown_(self) -> str:
        if not self.derived:
            return "\n".join(_chip(self.entry)) if _is_small(self.entry) else self.markdown()
        lines = (*steps(self.entry.derivation), *_card(self.entry, derived=True))
        return "\n".join(lines)


def show(name: str, *, derived: bool = False) -> Card:
    """Show one entry of the ledger with its verdict; small print on a line that a click opens.

    Parameters
    ----------
    name
        Its id, for example `"euler.5.5"`.
    derived
        Whether to go through its derivation first, step by step on the page. Else it is folded in.

    Raises
    ------
    KeyError
        If no document prints anything under that id.
    ValueError
        If there is no derivation to go through.
    """
    entry = judged(name)
    if derived and not entry.derivation:
        msg = f"expected an entry with a derivation, {name} has none"
        raise ValueError(msg)
    return Card(entry, derived=derived)


@dataclass(frozen=True)
class Cards:
    """Several entries that one notebook cell can show."""

    cards: tuple[Card, ...]

    def __repr__(self) -> str:
        """Give ids and verdicts, where no Markdown can be shown."""
        return "\n".join(map(repr, self.cards))

    def _repr_markdown_(self) -> str:
        return "\n".join(card._repr_markdown_() for card in self.cards)


def show_additions(document: str) -> Cards:
    """Show what a document says besides what its chapter treats: all its `printed.ADDITIONS`.

    Parameters
    ----------
    document
        Its topic, for example `"euler"`.
    """
    from chr_notes.printed import ADDITIONS  # noqa: PLC0415 (cards of known ids need no SymPy)

    return Cards(tuple(show(printed.id) for printed in ADDITIONS[document]))


def steps(derivation: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Go through a derivation, one numbered step after the other: words, and LaTeX."""
    yield '<div class="chr-steps" role="group" aria-label="Derivation">\n'
    for number, (words, latex) in enumerate(derivation, 1):
        yield f'<span class="chr-step">{number}</span> {words}\n'
        yield display(_once(latex))
    yield "</div>\n"


def badge(verdict: Verdict) -> str:
    """Return a verdict as HTML: colour, sign and word."""
    mark = f'<span aria-hidden="true">{MARKS[verdict]}</span>'
    return f'<span class="verdict verdict-{verdict}">{mark} {verdict}</span>'


def display(latex: str) -> str:
    """Return a formula on lines of its own, as Markdown."""
    if len(latex) >= LONG and any(joint in latex for joint in JOINTS):
        for joint, head in JOINTS.items():
            latex = latex.replace(joint, rf" \\[0.6em] &{head}")
        latex = rf"\begin{{aligned}}&{latex}\end{{aligned}}"
    return f"$$\n{latex}\n$$\n"


def _is_small(entry: Entry) -> bool:
    """Tell whether a reader may pass it by: small print, and words that hold as they are."""
    agreed = entry.kind == "claim" and entry.verdict in ("proved", "definition")
    return entry.weight == "small print" or agreed


def _chip(entry: Entry) -> Iterator[str]:
    yield f'<details class="entry chip" id="entry-{entry.id}">\n<summary>'
    yield f'<span class="entry-id">{entry.id}</span> {badge(entry.verdict)} '
    words = "" if "$" in entry.says or "`" in entry.says else html.escape(entry.says, quote=False)
    yield f'<span class="chip-says">{words}</span></summary>\n<div class="entry-body">\n'
    yield f'<p class="entry-term">{_where(entry)}</p>\n'
    yield from _body(entry)
    yield "</div>\n</details>\n"


def _card(entry: Entry, *, derived: bool = False) -> Iterator[str]:
    # Blank lines end an HTML block, so that what stands between is read as Markdown.
    yield f'<div class="entry" id="entry-{entry.id}">\n<div class="entry-head"><p>'
    yield f'<span class="entry-id">{entry.id}</span> <strong>{badge(entry.verdict)}</strong> '
    yield f'<span class="entry-kind">{_where(entry)}</span>'
    yield '</p></div>\n<div class="entry-body">\n'
    yield from _body(entry, derived=derived)
    yield "</div>\n</div>\n"


def _body(entry: Entry, *, derived: bool = False) -> Iterator[str]:
    yield f"{entry.says}\n"
    # Words have no formula to print: what stands here is how they are read.
    term = "Read as" if entry.kind == "claim" else "As printed" if entry.witness else ""
    yield from _formula(term, entry.printed_latex)
    if entry.given is not None:
        yield from _formula("Given", entry.given)
    if entry.correction_latex is not None:
        boxed = r"\boxed" in entry.correction_latex
        term = "Right; what differs is in a box" if boxed else "Right"
        yield from _formula(term, entry.correction_latex)
    if entry.condition is not None:
        yield from _formula("Holds exactly when" if entry.exact else "Holds if", entry.condition)
    if entry.undefined is not None:
        yield from _formula("Not defined where", entry.undefined)
    if entry.witness is not None:
        yield from _witness(entry)
    yield from _readings(entry)
    if entry.remark is not None:
        yield f"{entry.remark}\n"
    if entry.derivation and not derived:
        yield "<details>\n<summary>Derivation</summary>\n"
        for words, latex in entry.derivation:
            yield f"{words}\n"
            yield display(_once(latex))
        yield "</details>\n"


def _where(entry: Entry) -> str:
    """Say what it is and where it stands; a numbered equation says both at once."""
    return entry.place if entry.place.startswith(entry.kind) else f"{entry.kind}, {entry.place}"


def _readings(entry: Entry) -> Iterator[str]:
    if not entry.readings:
        return
    found = ", ".join(
        f"{'right' if holds else 'wrong'} if ${convention}$" for convention, holds in entry.readings
    )
    yield f"The document contradicts itself; this is {found}. The first reading counts here.\n"


def _formula(term: str, latex: str) -> Iterator[str]:
    if term:
        yield f'<p class="entry-term">{term}</p>\n'
    yield display(latex)


def _once(latex: str) -> str:
    """Of an equation that has come to the same on both sides, leave one side."""
    half = (len(latex) - len(EQUALS)) // 2
    return latex[:half] if latex[:half] + EQUALS + latex[:half] == latex else latex


def _witness(entry: Entry) -> Iterator[str]:
    witness = entry.witness
    if witness is None:
        return
    point = ", ".join(f"${symbol} = {value}$" for symbol, value in witness.at)
    at = f" at {point}" if point else ""
    yield f"Witness{at}: printed ${witness.printed}$, right ${witness.right}$.\n"
