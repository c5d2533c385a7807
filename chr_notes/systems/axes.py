"""Programs in different axes: which pairs of frames known systems have, and how they relate."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.systems.convention import DOCUMENTED, PRESETS, Convention
from chr_notes.systems.examples import ATTITUDES, Examples

Frames = tuple[str, str]

OWN: Frames = ("ned", "frd")
KNOWN: tuple[Frames, ...] = tuple(
    dict.fromkeys((each.navigation, each.body) for each in (PRESETS | DOCUMENTED).values())
)
"""Navigation and body of each known system, each pair once, the most usual first."""


@dataclass(frozen=True)
class Axes:
    """In which axes the numbers of each kind are: all in the usual ones, but for one kind.

    Parameters
    ----------
    usual
        Navigation and body of all others.
    kind
        The one that differs, or none.
    other
        Its navigation and body.
    """

    usual: Frames = OWN
    kind: str = ""
    other: Frames = OWN

    def of(self, kind: str) -> Frames:
        """Name the axes of a kind."""
        return self.other if kind == self.kind else self.usual

    def to_usual(self, matrix: Floats, kind: str) -> Floats:
        """Bring a matrix from navigation to body, in the axes of its kind, to the usual ones."""
        if kind != self.kind:
            return matrix
        room, body = self.changes()
        return np.asarray(body @ matrix @ room.T)

    def from_usual(self, matrix: Floats, kind: str) -> Floats:
        """Write a matrix from navigation to body in the axes of a kind."""
        if kind != self.kind:
            return matrix
        room, body = self.changes()
        return np.asarray(body.T @ matrix @ room)

    def changes(self) -> tuple[Floats, Floats]:
        """Matrices from the other axes to the usual ones: of the room, and of the body."""
        one, other = (
            Convention(navigation=navigation, body=body)
            for navigation, body in (self.usual, self.other)
        )
        room = one.axes("navigation").T @ other.axes("navigation")
        return room, one.axes("body").T @ other.axes("body")


ONE = Axes()
"""All in one pair of frames."""


def other_axes(given: Examples) -> Iterator[Axes]:
    """Give all ways in which one kind may be in other axes than the rest, each relation once."""
    kinds = [kind for kind in given.values if kind in ATTITUDES]
    if len(kinds) < 2 or len(kinds) < len(given.values):  # noqa: PLR2004 (a pair)
        return
    # Of two, it is the second one that is in other axes.
    for kind in kinds[1:] if len(kinds) == 2 else kinds:  # noqa: PLR2004
        seen = set()
        for usual in KNOWN:
            for other in KNOWN:
                axes = Axes(usual, kind, other)
                relation = tuple(np.kron(*axes.changes()).ravel() + 0.0)
                if usual != other and relation not in seen:
                    seen.add(relation)
                    yield axes
