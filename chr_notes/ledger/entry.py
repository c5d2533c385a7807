"""What the ledger says of one printed statement."""

from dataclasses import dataclass
from typing import Literal

Verdict = Literal["definition", "proved", "qualified", "corrected", "reported"]
Weight = Literal["misleads", "label", "small print"]


@dataclass(frozen=True)
class Witness:
    """One numeric point at which what is printed and what is right differ.

    Parameters
    ----------
    at
        Pairs of LaTeX symbol and value; angles in degrees.
    printed, right
        What the printed and the right form give there, in LaTeX.
    symbol
        Whether it is the symbol on the left that is wrong, and the formula after it is kept:
        `right` is then the value of what that symbol means, `printed` the formula's.
    """

    at: tuple[tuple[str, str], ...]
    printed: str
    right: str
    symbol: bool = False


@dataclass(frozen=True)
class Entry:
    """A row of the ledger. All formulas are LaTeX, made from the objects that were checked.

    Parameters
    ----------
    id, document, kind, says
        Which printed statement it is; `says` puts it in our words.
    verdict
        Computed, see `chr_notes.ledger.judgement`.
    root
        Which error this is one place of, see `chr_notes.ledger.roots`. Nothing where the
        statement holds as printed.
    weight
        How much that matters: `misleads` (who computes with it gets a wrong number or sign),
        `label` (a name or direction is wrong, numbers are right), `small print` (edge, rounding,
        caption).
    place
        Section and paragraph.
    printed_latex
        The statement as printed.
    derived_latex
        What the derivation gives for the thing that the statement is about.
    correction_latex
        The right form of a `corrected` statement, with boxes around what differs.
    given
        What the document or the convention presumes, within which it is judged.
    condition
        Under which a `qualified` statement holds.
    exact
        Whether it holds exactly when the condition does. If not, it holds if the condition does,
        and at some points outside as well.
    undefined
        Where a side of the statement is not defined, if it is so anywhere.
    witness
        Where a `qualified` or `corrected` statement fails.
    method
        How the verdict was reached.
    derivation
        Steps that lead to the right form: words and LaTeX.
    readings
        Where the document contradicts itself: each convention, and whether the statement holds
        under it, with the condition if there is one.
    remark
        What the reader should know besides, Markdown.
    """

    id: str
    document: str
    kind: str
    says: str
    verdict: Verdict
    root: str | None
    weight: Weight | None
    place: str
    printed_latex: str
    derived_latex: str | None
    correction_latex: str | None
    given: str | None
    condition: str | None
    exact: bool | None
    undefined: str | None
    witness: Witness | None
    method: str
    derivation: tuple[tuple[str, str], ...]
    readings: tuple[tuple[str, bool], ...]
    remark: str | None
