"""What the detective finds, told apart: one match for what says the same, and what decides."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.sequences import matrix_from_angles
from chr_notes.systems.axes import Axes
from chr_notes.systems.convention import Convention
from chr_notes.systems.converting import from_matrix, to_body
from chr_notes.systems.examples import TRIED, Examples

GENERIC = (11.0, 23.0, 37.0)
"""Angles at which what differs anywhere differs."""
_SAME = 1e-9
_APART = 1e-2
"""More than any rounding."""


@dataclass(frozen=True)
class Match:
    """Descriptions that explain the examples, and that no example tells apart.

    Parameters
    ----------
    convention
        The simplest of them. Fields that the examples say nothing of are this package's own.
    error
        Largest angle between what two programs say, radians.
    others
        The other descriptions of the same numbers.
    example
        Only if several matches are left: what programs of this convention would say of one further
        attitude. Each match says something else, so asking one's programs for it decides.
    axes
        Only if no convention with one pair of frames explains the examples: by kind, the axes of
        navigation and body in which its numbers are, those of known systems. The convention is
        that of the first kind.

    See Also
    --------
    chr_notes.systems.detective.find_conventions
    """

    convention: Convention
    error: float
    others: tuple[Convention, ...]
    example: MappingProxyType[str, Floats] | None = None
    axes: MappingProxyType[str, tuple[str, str]] | None = None


def told_apart(found: Sequence[tuple[Match, Axes]], given: Examples) -> list[Match]:
    """Make one match of those that say the same of any attitude, and add what decides.

    Parameters
    ----------
    found
        Matches with the axes of each, the simplest first.
    given
        The examples that they explain.
    """
    kept: list[tuple[Match, Axes]] = []
    known: list[Floats] = []
    for match, axes in found:
        said = _flat(match, axes, given, GENERIC)
        same = [place for place, each in enumerate(known) if np.abs(each - said).max() < _SAME]
        if same:
            first, its = kept[same[0]]
            others = (*first.others, match.convention, *match.others)
            kept[same[0]] = replace(first, others=others), its
        else:
            kept.append((match, axes))
            known.append(said)
    return _with_example(kept, given)


def _with_example(kept: Sequence[tuple[Match, Axes]], given: Examples) -> list[Match]:
    """Add the attitude that tells all matches apart, where there are several."""
    matches = [match for match, _ in kept]
    for turns in TRIED if len(matches) > 1 else ():
        flat = np.array([_flat(match, axes, given, turns) for match, axes in kept])
        apart = np.abs(flat[:, np.newaxis] - flat).max(axis=-1) + np.eye(len(flat))
        if apart.min() > _APART:
            return [
                replace(
                    match,
                    example=MappingProxyType(_said(match.convention, axes, given, turns)),
                )
                for match, axes in kept
            ]
    return matches


def _flat(match: Match, axes: Axes, given: Examples, turns: Sequence[float]) -> Floats:
    """All that programs would say of an attitude, in a row."""
    said = _said(match.convention, axes, given, turns)
    return np.concatenate([np.ravel(value) for value in said.values()])


def _said(
    convention: Convention, axes: Axes, given: Examples, turns: Sequence[float]
) -> dict[str, Floats]:
    """Say of one attitude what each program would."""
    made: dict[str, Floats] = {}
    if "angles" in given.values:
        # All matches are told the same angles; what the others make of it differs.
        made["angles"] = np.asarray(turns, dtype=float)
        own = axes.to_usual(to_body(made["angles"], convention, "angles"), "angles")
    else:
        own = matrix_from_angles(np.radians(turns), "xyz")
        own = own if given.first_is_to_body(convention) else own.T
    for kind in ("matrix", "quaternion"):
        if kind in given.values and kind not in made:
            made[kind] = from_matrix(axes.from_usual(own, kind), convention, kind)
    if "vectors" in given.values:
        before = np.array([1.0, 2.0, 3.0])
        made["vectors"] = (own if convention.vectors == "to body" else own.T) @ before
    if "accel" in given.values:
        made["accel"] = convention.accelerometer * own[:, 2]
    return made
