"""Where the fields of a text stand."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Places = NDArray[np.int64]

BESIDE = b" \t\"'"
"""What may stand around a number in its field."""

_WHITE, _QUOTE = (np.isin(np.arange(256), [*letters]) for letters in (BESIDE[:2], BESIDE[2:]))


@dataclass(frozen=True)
class Fields:
    """Where fields stand in a text."""

    all: NDArray[np.uint8]
    starts: Places
    ends: Places

    def of(self, columns: list[int]) -> "Fields":
        """Take columns of what has rows of fields; row after row."""
        starts, ends = (each[:, columns].ravel() for each in (self.starts, self.ends))
        return Fields(self.all, starts, ends)

    def bare(self) -> "Fields":
        """Leave out the white space around each, and quotes that open and close it."""
        starts, ends = _trimmed(self.all, self.starts, self.ends)
        first, last = self.all[starts], self.all[ends - 1]
        quoted = _QUOTE[first] & (first == last) & (ends - starts > 1)
        if quoted.any():
            starts, ends = _trimmed(self.all, starts + quoted, ends - quoted)
        return Fields(self.all, starts, ends)

    def text(self, place: int) -> str:
        """Give one."""
        part = self.all[self.starts[place] : self.ends[place]]
        return part.tobytes().decode(errors="replace")


def _trimmed(text: NDArray[np.uint8], starts: Places, ends: Places) -> tuple[Places, Places]:
    """Leave out white space."""
    while (white := _WHITE[text[starts]] & (starts < ends)).any():
        starts = starts + white
    while (white := _WHITE[text[ends - 1]] & (starts < ends)).any():
        ends = ends - white
    return starts, ends
