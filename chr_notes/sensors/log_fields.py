"""Where the fields of a text stand."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

_WHITE = np.isin(np.arange(256), [ord(" "), ord("\t")])


@dataclass(frozen=True)
class Fields:
    """Where fields stand in a text."""

    all: NDArray[np.uint8]
    starts: NDArray[np.int64]
    ends: NDArray[np.int64]

    def of(self, columns: list[int]) -> "Fields":
        """Take columns of what has rows of fields; row after row."""
        starts, ends = (each[:, columns].ravel() for each in (self.starts, self.ends))
        return Fields(self.all, starts, ends)

    def trimmed(self) -> "Fields":
        """Leave out the white space around each."""
        starts, ends = self.starts, self.ends
        while (white := _WHITE[self.all[starts]] & (starts < ends)).any():
            starts = starts + white
        while (white := _WHITE[self.all[ends - 1]] & (starts < ends)).any():
            ends = ends - white
        return Fields(self.all, starts, ends)

    def text(self, place: int) -> str:
        """Give one."""
        part = self.all[self.starts[place] : self.ends[place]]
        return part.tobytes().decode(errors="replace")
