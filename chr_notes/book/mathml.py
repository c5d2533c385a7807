"""LaTeX to MathML, as browsers set it well."""

import functools
import re
import unicodedata
from itertools import pairwise
from typing import Final
from xml.etree.ElementTree import Element, fromstring, tostring

from math_core import LatexError, LatexToMathML

__all__ = ["ITALIC", "mathml"]

_CONVERTER: Final = LatexToMathML(annotation=True, fancy_error=False, macros={"substack": "#1"})

_ROW_DISTANCE: Final = re.compile(r"(\\\\)\[[\d.]+em\]")  # the style sheet sets it
_ENVIRONMENT: Final = re.compile(r"\\begin\{(\w+\*?)\}((?!\\begin\{).)*?\\end\{\1\}", re.DOTALL)
# What the converter would leave out without a word.
_REFUSED: Final = (
    (re.compile(r"\\\\"), "a line break outside of an environment"),
    (re.compile(r"\n\s*\n"), "an empty line"),
)

_THIN: Final = "0.1667em"
_APPLY: Final = "\u2061"  # the invisible operator between a function and its argument
_OPENING: Final = frozenset("([{|‖⌊")
_FENCES: Final = _OPENING | frozenset(")]}⌋")
_SIGNS: Final = frozenset("−+±")
_LOW_LINE: Final = "\u0332"  # what the converter writes for a bar above
_OVERLINE: Final = "\u203e"
_FLAT: Final = frozenset(
    ("mi", "mn", "mo", "mover", "mpadded", "mrow", "mspace", "msub", "msubsup", "msup", "mtext")
)

ITALIC: Final = {
    chr(int(unicodedata.decomposition(chr(code)).split()[1], 16)): chr(code)
    for first, last in ((0x1D434, 0x1D454), (0x1D456, 0x1D467), (0x1D6E2, 0x1D71B))
    for code in range(first, last + 1)
} | {"h": "\u210e"}
"""The character in which a browser shows a variable of one letter."""


@functools.cache
def mathml(latex: str, *, display: bool) -> str:
    r"""Convert a formula.

    Parameters
    ----------
    latex
        The formula without delimiters.
    display
        Whether it stands on a line of its own.

    Returns
    -------
    str
        A ``math`` element, with the LaTeX as its annotation.

    Raises
    ------
    ValueError
        If the formula has a command or an environment that is not known, or is not complete.

    Examples
    --------
    >>> mathml("q", display=False)[:29]
    '<math><semantics><mi>q</mi><a'
    """
    latex = _ROW_DISTANCE.sub(r"\1", latex.strip())
    outside, found = latex, 1
    while found:
        outside, found = _ENVIRONMENT.subn("", outside)
    for pattern, what in _REFUSED:
        if pattern.search(outside):
            msg = f"expected a formula that can be set, found {what}"
            raise ValueError(msg)
    try:
        converted = _CONVERTER.convert_with_local_state(latex, displaystyle=display)
    except LatexError as error:
        raise ValueError(str(error)) from error
    math = fromstring(converted.replace("&ApplyFunction;", _APPLY))  # noqa: S314 - our own
    for element in math.iter():
        _space_words(element)
        _place_accents(element)
        _draw_box(element)
    for element in math.iter():
        _space_functions(list(element))
        _bind_signs(list(element))
        _keep_fences_small(list(element))
    return tostring(math, encoding="unicode", short_empty_elements=False)


def _space_words(element: Element) -> None:
    """Make words an identifier: browsers drop the spaces of an operator between texts."""
    text = element.text or ""
    if element.tag == "mtext" and text.strip():
        element.tag = "mi"
        if len(text) == 1:
            element.set("mathvariant", "normal")


def _place_accents(element: Element) -> None:
    """Write an accent's letter as it is shown: Chromium measures the one that is written.

    A bar is one that is above: a combining one would hang half a letter to the left.
    """
    if element.tag != "mover":
        return
    if element[1].text == _LOW_LINE:
        element[1].text = _OVERLINE
    if element[0].tag == "mi" and not element[0].attrib:
        element[0].text = ITALIC.get(element[0].text or "", element[0].text)


def _draw_box(element: Element) -> None:
    """Leave the box to the style sheet: Chromium draws none of its own."""
    if element.tag == "menclose" and element.get("notation") == "box":
        element.tag, element.attrib = "mrow", {"class": "boxed"}


def _space_functions(row: list[Element]) -> None:
    """Set the thin spaces beside a function's name that TeX has and the converter leaves out.

    These are the one before an argument in braces and, in a matrix, the one after a sign.
    """
    for place, argument in enumerate(row[1:], start=1):
        name = row[place - 1]
        word = _function_in_cell(name)
        if name.text == _APPLY and not _opens(argument):
            name.set("lspace", _THIN)
        elif word is not None:
            if not _opens(argument):
                word.set("rspace", _THIN)
            if place == 2 and row[0].text in _SIGNS:  # noqa: PLR2004 - sign, name, argument
                word.set("lspace", _THIN)


def _bind_signs(row: list[Element]) -> None:
    """Set the sign of a number close to it where a space stands between the sign and a comma."""
    written = [each for each in row if each.tag not in ("mspace", "mtext")]
    for before, sign in pairwise(written):
        if sign.text in _SIGNS and before.text == ",":
            sign.attrib |= {"lspace": "0", "rspace": "0"}


def _keep_fences_small(row: list[Element]) -> None:
    """Keep brackets around a line of letters at its size: Chromium takes larger ones."""
    fences = [end for end in (row[:1] + row[-1:]) if end.tag == "mo" and end.text in _FENCES]
    if fences and all(each.tag in _FLAT for part in row for each in part.iter()):
        for fence in fences:
            fence.set("stretchy", "false")


def _function_in_cell(element: Element) -> Element | None:
    """Find the name of a function, which in a matrix is an operator, perhaps with a power."""
    while element.tag in ("msup", "msub", "munder"):
        element = element[0]
    return element if element.tag == "mo" and (element.text or "").isalpha() else None


def _opens(element: Element) -> bool:
    """Tell whether an argument begins with a bracket."""
    while element.tag == "mrow" and len(element):
        element = element[0]
    return element.tag == "mo" and element.text in _OPENING
