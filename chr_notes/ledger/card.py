"""An entry of the ledger as Markdown: as a card, or as a line that opens."""

import html
from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Final

from chr_notes.ledger.difference import boxed_alike, unboxed
from chr_notes.ledger.entry import Entry, Verdict, Witness
from chr_notes.ledger.harm import HARM
from chr_notes.ledger.roots import ROOTS

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
MISLEADS: Final = '<span class="entry-misleads"><span aria-hidden="true">⚠</span> misleads</span> '
LONG: Final = 150
"""From this many characters of LaTeX on, statements that are joined stand on a line each."""


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
    if len(unboxed(latex)) >= LONG and any(joint in latex for joint in JOINTS):
        for joint, head in JOINTS.items():
            latex = latex.replace(joint, rf" \\[0.6em] &{head}")
        latex = rf"\begin{{aligned}}&{latex}\end{{aligned}}"
    return f"$$\n{latex}\n$$\n"


def is_small(entry: Entry) -> bool:
    """Tell whether a reader may pass it by: small print, and words that hold as they are."""
    agreed = entry.kind == "claim" and entry.verdict in ("proved", "definition")
    return entry.weight == "small print" or agreed


def computed(entry: Entry) -> str | None:
    """Return an equation with the function that it is read with, where it is printed with another.

    An arctangent of a quotient that holds as atan2 of its two parts.
    """
    derived = entry.derived_latex or ""
    if entry.verdict != "proved" or "atan2" not in derived or "atan2" in entry.printed_latex:
        return None
    return entry.printed_latex.partition(EQUALS)[0] + EQUALS + derived


def chip(
    entry: Entry, *, opened: bool = False, derived: bool = False, alone: bool = True
) -> Iterator[str]:
    """Show an entry on a line that a click opens."""
    state = " open" if opened else ""
    yield f'<details class="entry chip" id="entry-{entry.id}"{state}>\n<summary>'
    yield f'<span class="entry-id">{entry.id}</span> {badge(entry.verdict)} '
    # As Markdown sets it where the words stand in full.
    words = html.escape(entry.says.replace("'", "\u2019"), quote=False)
    words = "" if "$" in words or "`" in words else words
    yield f'<span class="chip-says">{words}</span></summary>\n<div class="entry-body">\n'
    yield f'<p class="entry-term">{_where(entry)}</p>\n'
    yield from _body(entry, derived=derived, alone=alone)
    yield "</div>\n</details>\n"


def card(entry: Entry, *, derived: bool = False) -> Iterator[str]:
    """Show an entry in full; what misleads says so, and what it does on a device."""
    # Blank lines end an HTML block, so that what stands between is read as Markdown.
    misleads = entry.weight == "misleads"
    kind = "entry misleads" if misleads else "entry"
    yield f'<div class="{kind}" id="entry-{entry.id}">\n<div class="entry-head"><p>'
    yield f'<span class="entry-id">{entry.id}</span> <strong>{badge(entry.verdict)}</strong> '
    yield f'{MISLEADS if misleads else ""}<span class="entry-kind">{_where(entry)}</span>'
    yield '</p></div>\n<div class="entry-body">\n'
    yield from _body(entry, derived=derived)
    if misleads:
        yield from _harm(entry.root)
    yield "</div>\n</div>\n"


def together(entries: Sequence[Entry], *, derived: bool = False) -> Iterator[str]:
    """Show the places of one error on one card, the first of them opened."""
    root = entries[0].root or ""
    if derived:
        yield from steps(dict.fromkeys(step for each in entries for step in each.derivation))
    yield '<div class="entry misleads">\n<div class="entry-head"><p>'
    yield f"<strong>One error, {len(entries)} places</strong> {MISLEADS}"
    yield '</p></div>\n<div class="entry-body">\n'
    yield f"{ROOTS[root]}\n"
    yield from _harm(root)
    alone = len({entry.readings for entry in entries}) > 1
    if not alone:
        yield from _readings(entries[0])
    for place, entry in enumerate(entries):
        yield from chip(entry, opened=place == 0, derived=derived, alone=alone)
    yield "</div>\n</div>\n"


def _harm(root: str | None) -> Iterator[str]:
    yield f'<p class="entry-term">On a device</p>\n\n{HARM[root or ""]}\n'


def _body(entry: Entry, *, derived: bool = False, alone: bool = True) -> Iterator[str]:
    yield f"{entry.says}\n"
    yield from _as_printed(entry)
    if entry.given is not None:
        yield from _formula("Given", entry.given)
    if entry.condition is not None:
        yield from _formula("Holds exactly when" if entry.exact else "Holds if", entry.condition)
        if entry.weight == "misleads" and entry.kind == "equation":
            yield from _formula("Right in any case", entry.derivation[-1][1], "right")
    if entry.undefined is not None:
        yield from _formula("Not defined where", entry.undefined)
    if entry.witness is not None:
        yield _witness(entry, entry.witness)
    if alone:
        yield from _readings(entry)
    if entry.remark is not None:
        yield f"{entry.remark}\n"
    if entry.derivation and not derived:
        yield "<details>\n<summary>Derivation</summary>\n"
        for words, latex in entry.derivation:
            yield f"{words}\n"
            yield display(_once(latex))
        yield "</details>\n"


def _as_printed(entry: Entry) -> Iterator[str]:
    # Words have no formula to print: what stands here is how they are read.
    read = computed(entry)
    term = "Read as" if entry.kind == "claim" else "As printed" if entry.witness or read else ""
    printed = boxed_alike(entry.printed_latex, entry.correction_latex or entry.printed_latex)
    term += "; what is wrong is in a box" if term and printed != entry.printed_latex else ""
    yield from _formula(term, printed, "wrong" if entry.correction_latex else "")
    if read is not None:
        yield from _formula("Proved as it is read", read, "right")
    if entry.correction_latex is not None:
        boxed = r"\boxed" in entry.correction_latex
        term = "Right; what differs is in a box" if boxed else "Right"
        yield from _formula(term, entry.correction_latex, "right")


def _where(entry: Entry) -> str:
    """Say what it is and where it stands; a numbered equation says both at once."""
    return entry.place if entry.place.startswith(entry.kind) else f"{entry.kind}, {entry.place}"


def _readings(entry: Entry) -> Iterator[str]:
    # What holds by all of them needs no word of it.
    if all(holds for _, holds in entry.readings):
        return
    (ours, holds), *others = entry.readings
    found = [f"By this book's reading, ${ours}$, it is {_fits(holds)}"]
    found += [f"by ${convention}$ {_fits(holds)}" for convention, holds in others]
    yield f"{'; '.join(found)}.\n"


def _fits(holds: bool) -> str:  # noqa: FBT001 (one of two words)
    return "right" if holds else "wrong"


def _formula(term: str, latex: str, kind: str = "") -> Iterator[str]:
    if kind:
        yield f'<div class="entry-{kind}">\n'
    if term:
        yield f'<p class="entry-term">{term}</p>\n'
    yield display(latex)
    if kind:
        yield "</div>\n"


def _once(latex: str) -> str:
    """Of an equation that has come to the same on both sides, leave one side."""
    half = (len(latex) - len(EQUALS)) // 2
    return latex[:half] if latex[:half] + EQUALS + latex[:half] == latex else latex


def _witness(entry: Entry, witness: Witness) -> str:
    point = ", ".join(f"${symbol} = {value}$" for symbol, value in witness.at)
    at = f" at {point}" if point else ""
    if witness.symbol:
        found = (
            f"the printed symbol means ${witness.right}$, the formula after it gives "
            f"${witness.printed}$"
        )
    else:
        # Of words nothing is printed but the words.
        wrong = "so read" if entry.kind == "claim" else "printed"
        found = f"{wrong} ${witness.printed}$, right ${witness.right}$"
    return f"Witness{at}: {found}.\n"
