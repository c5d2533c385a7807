"""Entries of the ledger, and steps of other derivations, as a page shows them."""

from dataclasses import dataclass

from chr_notes.derivations.told import Told
from chr_notes.ledger import entry as judged
from chr_notes.ledger.card import card, chip, is_small, steps, together
from chr_notes.ledger.entry import Entry
from chr_notes.ledger.harm import HARM
from chr_notes.typeset import latex


@dataclass(frozen=True)
class Card:
    """An entry that a notebook cell can show. Markdown serves JupyterLab and the book alike.

    Attributes
    ----------
    entry
        What is shown.
    derived
        Whether the steps of its derivation stand before it, instead of folded in.
    folded
        Whether it is a line that a click opens, whatever its weight.
    """

    entry: Entry
    derived: bool = False
    folded: bool = False

    def __repr__(self) -> str:
        """Give id and verdict, where no Markdown can be shown."""
        return f"{self.entry.id}: {self.entry.verdict}"

    def markdown(self) -> str:
        """Return the card, for a page that is made from data."""
        return "\n".join(card(self.entry))

    def _repr_markdown_(self) -> str:
        if not self.derived:
            small = self.folded or is_small(self.entry)
            return "\n".join(chip(self.entry)) if small else self.markdown()
        lines = (*steps(self.entry.derivation), *card(self.entry, derived=True))
        return "\n".join(lines)


def show(name: str, *, derived: bool = False, folded: bool = False) -> Card:
    """Show one entry of the ledger with its verdict; small print on a line that a click opens.

    Parameters
    ----------
    name
        Its id, for example `"euler.5.5"`.
    derived
        Whether to go through its derivation first, step by step on the page. Else it is folded in.
    folded
        Whether to fold it to a line, where it says once more what stands on another card.

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
    return Card(entry, derived=derived, folded=folded)


@dataclass(frozen=True)
class Cards:
    """Several entries that one notebook cell can show."""

    cards: tuple[Card, ...]

    def __repr__(self) -> str:
        """Give ids and verdicts, where no Markdown can be shown."""
        return "\n".join(map(repr, self.cards))

    def _repr_markdown_(self) -> str:
        return "\n".join(each._repr_markdown_() for each in self.cards)


@dataclass(frozen=True)
class Places:
    """The places of one error, which a notebook cell shows on one card."""

    entries: tuple[Entry, ...]
    derived: bool = False

    def __repr__(self) -> str:
        """Give ids and verdicts, where no Markdown can be shown."""
        return "\n".join(f"{each.id}: {each.verdict}" for each in self.entries)

    def _repr_markdown_(self) -> str:
        return "\n".join(together(self.entries, derived=self.derived))


def show_together(*names: str, derived: bool = False) -> Places:
    """Show several places of one error that misleads on one card.

    Parameters
    ----------
    *names
        Their ids.
    derived
        As for `show`.

    Raises
    ------
    KeyError
        If no document prints anything under an id.
    ValueError
        If they are not places of one error, or none of them misleads.
    """
    places = tuple(map(judged, names))
    if len({each.root for each in places}) != 1 or places[0].root not in HARM:
        msg = f"expected places of one error that misleads, got {[each.root for each in places]}"
        raise ValueError(msg)
    return Places(places, derived=derived)


def show_additions(document: str) -> Cards:
    """Show what a document says besides what its chapter treats: all its `printed.ADDITIONS`.

    Parameters
    ----------
    document
        Its topic, for example `"euler"`.
    """
    from chr_notes.printed import ADDITIONS  # noqa: PLC0415 (cards of known ids need no SymPy)

    return Cards(tuple(show(printed.id) for printed in ADDITIONS[document]))


@dataclass(frozen=True)
class Steps:
    """A derivation that a notebook cell can show."""

    derivation: tuple[tuple[str, str], ...]
    folded: str = ""

    def __repr__(self) -> str:
        """Give the words, where no Markdown can be shown."""
        return "\n".join(words for words, _ in self.derivation)

    def _repr_markdown_(self) -> str:
        lines = "\n".join(steps(self.derivation))
        if not self.folded:
            return lines
        return f"<details>\n<summary>{self.folded}</summary>\n\n{lines}\n</details>\n"


def show_steps(told: Told, *, folded: str = "") -> Steps:
    """Go through a derivation step by step, typeset from the statements that a test compares.

    Parameters
    ----------
    told
        One of those in `chr_notes.derivations.told`.
    folded
        What stands on the line that opens them, where the text gets on without; else they are open.
    """
    return Steps(tuple((step.says, latex(step.statement)) for step in told.steps), folded)
