"""What to write into the margins: the errors by weight, each once with all its places."""

from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Final, get_args

from chr_notes.ledger import Entry, Weight
from chr_notes.ledger.card import badge, display
from chr_notes.ledger.harm import HARM
from chr_notes.ledger.roots import ROOTS
from chr_notes.ledger.table import show_table

HEADINGS: Final[Mapping[Weight, tuple[str, str]]] = MappingProxyType(
    {
        "misleads": (
            "What misleads",
            "Whoever computes with these gets a wrong number, or a wrong sign.",
        ),
        "label": (
            "Wrong names",
            "A symbol, a word or a direction is wrong; the numbers come out right.",
        ),
        "small print": (
            "Small print",
            "Edges, roundings and captions; worth a note, and seldom worth a worry.",
        ),
    }
)
"""Heading of each part, and what stands in it."""


def by_root(ledger: Iterable[Entry]) -> dict[str, list[Entry]]:
    """Collect the entries that are not right as printed by the error behind them.

    Parameters
    ----------
    ledger
        All entries.

    Returns
    -------
    dict
        From root to its places: the heaviest error first, what misleads in the order of
        `harm.HARM`, the others by their number of places, then in the order of the documents.
    """
    errors: dict[str, list[Entry]] = {root: [] for root in ROOTS}
    for entry in ledger:
        if entry.root is not None:
            errors[entry.root].append(entry)
    weights, harmful = get_args(Weight), [*HARM]
    return dict(
        sorted(
            ((root, places) for root, places in errors.items() if places),
            key=lambda error: (
                weights.index(heaviest(error[1])),
                harmful.index(error[0]) if error[0] in HARM else -len(error[1]),
            ),
        )
    )


def heaviest(places: Iterable[Entry]) -> Weight:
    """Tell the weight of an error: that of its worst place."""
    weights: tuple[Weight, ...] = get_args(Weight)
    found = {entry.weight for entry in places}
    return next(weight for weight in weights if weight in found)


def summary(ledger: Iterable[Entry]) -> str:
    """Say in how many places the documents err, and how many errors these are, by weight."""
    errors = by_root(ledger)
    count = sum(map(len, errors.values()))
    kinds: list[str] = [heaviest(places) for places in errors.values()]
    parts = [
        f"**{kinds.count(weight)}** {words}"
        for weight, words in (
            ("misleads", "mislead whoever computes with them"),
            ("label", "are wrong names that leave the numbers right"),
            ("small print", "are small print"),
        )
    ]
    return (
        f"The **{count}** entries that are qualified or corrected come from **{len(errors)}** "
        f"errors: one may show in many places. Of these errors {parts[0]}, {parts[1]}, and "
        f"{parts[2]}. [The errata](errata.md) list them in this order. Which places belong to one "
        "error, and what its weight is, we judge; that the places are alike and that the weight "
        "fits what is wrong, a program checks.\n"
    )


def errata(ledger: Iterable[Entry]) -> Iterator[str]:
    """Yield the errors, the heaviest first: what is wrong, where, and the right form of each."""
    weight = None
    for root, places in by_root(ledger).items():
        if heaviest(places) != weight:
            weight = heaviest(places)
            title, says = HEADINGS[weight]
            yield f"## {title}\n\n{says}\n"
        yield f"### {root.replace('-', ' ').capitalize()}\n"
        yield f"{ROOTS[root]}\n"
        cells = [entry for entry in places if entry.kind == "table cell"]
        for entry in places:
            if entry not in cells:
                yield from _entry(entry)
        if cells:
            yield (
                f"{len(cells)} cells of Table 1 of the dead-reckoning note are wrong by it; "
                "[the corrected table](#table-1) stands at the end of this page.\n"
            )
    yield "(table-1)=\n## Table 1 of the dead-reckoning note\n"
    yield "Wrong numbers are struck out, with the right ones beside them.\n"
    yield show_table().markdown


def _entry(entry: Entry) -> Iterator[str]:
    yield "::::{div} erratum"
    yield (f"**[{entry.id}](#{entry.id})** {badge(entry.verdict)} {entry.place}: {entry.says}\n")
    yield display(entry.printed_latex)
    if entry.correction_latex is not None:
        yield f"should read\n\n{display(entry.correction_latex)}"
    if entry.condition is not None:
        holds = "holds exactly when" if entry.exact else "holds if"
        yield f"{holds}\n\n{display(entry.condition)}"
    if entry.remark is not None:
        yield f":::{{div}} erratum-remark\n{entry.remark}\n:::\n"
    yield "::::\n"
