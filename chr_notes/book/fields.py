"""Fields in the reference: types by the names that one calls them by, and each sentence once."""

import re
from typing import Final

from docutils import nodes

__all__ = ["join", "shorten"]

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


def join(document: nodes.document) -> None:
    """Set names of which one sentence tells on one line, as they stand in the docstring.

    Sphinx gives each of them a line, with the sentence once more.
    """
    for body in document.findall(nodes.field_body):
        told = ""
        names = nodes.paragraph()
        for item in list(body.findall(nodes.list_item)):
            paragraph = item[0]
            name, *tail = paragraph.children
            told, before = "".join(each.astext() for each in tail), told
            if not told or told != before:
                names = paragraph
                continue
            names.insert(len(names) - len(tail), [nodes.Text(", "), name])
            item.parent.remove(item)
