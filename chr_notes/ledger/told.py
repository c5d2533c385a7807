"""Derivations that no document prints anything for, as a chapter shows them."""

from dataclasses import dataclass

from chr_notes.derivations.told import Told
from chr_notes.ledger.card import steps
from chr_notes.typeset import latex

__all__ = ["Steps", "show_steps"]


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
