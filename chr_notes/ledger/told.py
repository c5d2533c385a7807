"""Derivations that no document prints anything for, as a chapter shows them."""

from dataclasses import dataclass

from chr_notes.derivations.telling import Told
from chr_notes.ledger.card import steps
from chr_notes.typeset import latex

__all__ = ["Steps", "show_steps"]


@dataclass(frozen=True)
class Steps:
    """A derivation that a notebook cell can show."""

    derivation: tuple[tuple[str, str], ...]

    def __repr__(self) -> str:
        """Give the words, where no Markdown can be shown."""
        return "\n".join(words for words, _ in self.derivation)

    def _repr_markdown_(self) -> str:
        return "\n".join(steps(self.derivation))


def show_steps(told: Told) -> Steps:
    """Go through a derivation step by step, typeset from the statements that a test compares.

    Parameters
    ----------
    told
        One of those in `chr_notes.derivations.told`.
    """
    return Steps(tuple((step.says, latex(step.statement)) for step in told.steps))
