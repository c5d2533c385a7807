"""Answers that are given by hand: a picture to choose, an arrow to drag.

Without scripts the pictures still stand there, each with its letter and its words, and instead of
the arrow one gives its angle.
"""

import base64
import html
import json
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from chr_notes.lesson.pictures import Drawing, outline

__all__ = ["COMPASS", "FROM_ABOVE", "FROM_ASIDE", "FROM_BEHIND", "Pictures", "Plane"]

_CORNER: Final = 90  # degrees from one name to the next


@dataclass(frozen=True)
class Plane:
    """Where an arrow is dragged: its answer is an angle in degrees.

    Attributes
    ----------
    names
        Of the directions up, to the right, down and to the left, as the plane is drawn.
    start
        The one from which the angle is counted.
    towards
        Its neighbour, to which a positive angle leads.
    outline
        What stands in the middle, as the data of an SVG path.
    within
        Largest error that still counts as right, degrees.

    Examples
    --------
    >>> COMPASS.told()
    'Point the arrow, or give its angle in degrees, counted from north towards east.'
    """

    names: tuple[str, str, str, str]
    start: str
    towards: str
    outline: str = ""
    within: float = 5.0

    def told(self) -> str:
        """Say how to answer."""
        counted = f"counted from {self.start} towards {self.towards}"
        return f"Point the arrow, or give its angle in degrees, {counted}."

    def data(self) -> Mapping[str, object]:
        """Give what the script draws it by: angles on the page run clockwise from its top."""
        start, towards = map(self.names.index, (self.start, self.towards))
        sense = 1 if (towards - start) % len(self.names) == 1 else -1
        found = {"names": self.names, "start": _CORNER * start, "sense": sense}
        return {**found, "outline": self.outline}


COMPASS: Final = Plane(("north", "east", "south", "west"), "north", "east")
"""A map."""
FROM_ABOVE: Final = Plane(
    ("ahead", "right", "back", "left"), "ahead", "right", outline([0, 1, 0], [1, 0, 0])
)
"""A vehicle from above."""
FROM_ASIDE: Final = Plane(
    ("up", "ahead", "down", "back"), "ahead", "up", outline([1, 0, 0], [0, 0, -1])
)
"""A vehicle from its right side."""
FROM_BEHIND: Final = Plane(("up", "right", "down", "left"), "right", "down")
"""A vehicle from behind, with angles counted as roll is."""


@dataclass(frozen=True)
class Pictures:
    """What is chosen among: a drawing of the right answer, and one of each mistake's.

    Attributes
    ----------
    draw
        Draws an answer.
    drawn
        The answers in the order of the pictures, where nobody tells which one is right: in
        notebooks for a class.
    """

    draw: Callable[[ArrayLike], Drawing]
    drawn: Sequence[ArrayLike] = ()

    def html(self, number: int, answers: Sequence[ArrayLike]) -> str:
        """Show the answers, each with its letter, as one line of HTML.

        Raises
        ------
        ValueError
            If two of them look or read alike.
        """
        # The last digits differ from one processor to the next.
        kept = [np.asarray(answer, dtype=float).round(4).tolist() for answer in answers]
        drawings = [self.draw(answer) for answer in kept]
        for part in ("svg", "alt"):
            if len({getattr(each, part) for each in drawings}) < len(drawings):
                msg = f"two pictures of exercise {number} have the same {part}"
                raise ValueError(msg)
        labels = "".join(
            f'<label class="chr-picture"><input type="radio" name="exercise-{number}" '
            f'value="{letter}"> {letter} {_image(drawing)}</label>'
            for letter, drawing in zip(letters(len(answers)), drawings, strict=True)
        )
        data = html.escape(json.dumps(kept, separators=(",", ":")))
        return (
            f'<div class="chr-pictures" role="radiogroup" data-lm-suppress-shortcuts="true" '
            f'aria-label="Pictures of exercise {number}" data-drawn="{data}">{labels}</div>\n'
        )


def letters(count: int) -> str:
    """Give so many letters, from A on."""
    return "".join(chr(ord("A") + each) for each in range(count))


def mixed(names: Sequence[str], question: str) -> list[int]:
    """Give an order that does not tell which one is right, the same each time."""
    return sorted(
        range(len(names)), key=lambda each: zlib.crc32(f"{names[each]}{question}".encode())
    )


def _image(drawing: Drawing) -> str:
    data = base64.b64encode(drawing.svg.encode()).decode()
    return f'<img alt="{html.escape(drawing.alt)}" src="data:image/svg+xml;base64,{data}">'
