"""Where the fields of a text stand."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Letters = NDArray[np.uint8]
Places = NDArray[np.int64]

BESIDE = b" \t\"'"
"""What may stand around a number in its field."""

# In lines of words: what divides them, and what only a line alone can tell.
_WORDS_END = np.isin(np.arange(256), [*b" \t\n"])
_SPECIAL = np.isin(np.arange(256), [*b" \t\n!", *range(35, 127)], invert=True)
_WHITE, _QUOTE = (np.isin(np.arange(256), [*letters]) for letters in (BESIDE[:2], BESIDE[2:]))


@dataclass(frozen=True)
class Fields:
    """Where fields stand in a text."""

    all: Letters
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


def _trimmed(text: Letters, starts: Places, ends: Places) -> tuple[Places, Places]:
    """Leave out white space."""
    while (white := _WHITE[text[starts]] & (starts < ends)).any():
        starts = starts + white
    while (white := _WHITE[text[ends - 1]] & (starts < ends)).any():
        ends = ends - white
    return starts, ends


def lines_of_words(text: Letters, rows: int, fields: int) -> Fields | None:
    """Divide lines at white space, however much of it, or give None if not all have as many words.

    Parameters
    ----------
    text
        Ends with a line feed.
    rows, fields
        How many lines it has, and words each of them should have.
    """
    if _SPECIAL[text].any():  # quotes, or white space of another script
        return None
    between = _WORDS_END[text]
    edges = np.flatnonzero(between[1:] != between[:-1]) + 1
    starts, ends = edges[bool(between[0]) ^ 1 :: 2], edges[bool(between[0]) :: 2]
    if not between[0]:
        starts = np.concatenate([[0], starts])
    if len(ends) != rows * fields or len(starts) != len(ends):
        return None
    starts, ends = starts.reshape(rows, fields), ends.reshape(rows, fields)
    feeds = np.flatnonzero(text == ord("\n"))
    if (ends[:, -1] > feeds).any() or (starts[1:, 0] < feeds[:-1]).any():
        return None
    return Fields(text, starts, ends)
