"""Types of fields, in the reference by the names that one calls them by."""

import re
from typing import Final

__all__ = ["shorten"]

_ARRAY: Final = re.compile(r"numpy\.ndarray\[tuple\[Any, \.\.\.\], numpy\.dtype\[numpy\.\w+\]\]")
_MODULE: Final = re.compile(r"\b(?:[a-z_]\w*\.)+(?=[A-Za-z])")


def shorten(lines: list[str]) -> None:
    """Shorten types that Sphinx took from annotations, in the lines of a docstring.

    Examples
    --------
    >>> lines = [":type accel: numpy.ndarray[tuple[Any, ...], numpy.dtype[numpy.float64]] | None",
    ...          ":type rests: tuple[chr_notes.sensors.recording.Stretch, ...]"]
    >>> shorten(lines)
    >>> lines
    [':type accel: ndarray | None', ':type rests: tuple[Stretch, ...]']
    """
    for place, line in enumerate(lines):
        if line.startswith(":type "):
            short = _MODULE.sub("", _ARRAY.sub("ndarray", line))
            lines[place] = short.replace("mappingproxy", "Mapping")
