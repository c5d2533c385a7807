"""What the ledger says of one printed statement."""

from dataclasses import dataclass
from typing import Literal

Verdict = Literal["definition", "proved", "qualified", "corrected", "reported"]


@dataclass(frozen=True)
class Witness:
    """One numeric point at which what is printed and what is right differ.

    Parameters
    ----------
    at
        Pairs of LaTeX symbol and value; angles in degrees.
    printed, right
        What the printed and the right form give there, in LaTeX.
    """

    at: tuple[tuple[str, str], ...]
    printed: str
    right: str


@dataclass(frozen=True)
class Entry:
    """A row of the ledger. All formulas are LaTeX, made from the objects that were checked.

    Parameters
    ----------
    id, document, kind, place, says
        Which printed statement it is and where it stands; `says` puts it in our words.
    verdict
        Computed, see `chr_notes.ledger.judgement`.
    printed_latex
        The statement as printed.
    derived_latex
        What the derivation gives for the thing that the statement is about.
    correction_latex
        The right form of a `corrected` statement.
    given
        What the document or the convention presumes, within which it is judged.
    condition
        Under which a `qualified` statement holds.
    witness
        Where a `qualified` or `corrected` statement fails.
    readings
        Where the document contradicts itself: each convention, and whether the statement holds
        under it, with the condition if there is one.
    method
        How the verdict was reached.
    remark
        What the reader should know besides, Markdown.
    derivation
        Steps that lead to the right form: words and LaTeX.
    """

    id: str
    document: str
    kind: str
    place: str
    says: str
    verdict: Verdict
    printed_latex: str
    derived_latex: str | None
    correction_latex: str | None
    given: str | None
    condition: str | None
    witness: Witness | None
    readings: tuple[tuple[str, bool], ...]
    method: str
    remark: str | None
    derivation: tuple[tuple[str, str], ...]
