"""Style rules for what is on no page, taken out of the theme's sheets."""

import re
from collections.abc import Collection, Iterator
from typing import Final

__all__ = ["used_words", "without_unused"]

_WORD: Final = re.compile(r"[A-Za-z_][\w-]*")
_COMMENT: Final = re.compile(r"/\*(?!!).*?\*/", re.DOTALL)
_CLASS: Final = re.compile(r"\.(-?[A-Za-z_](?:[\w-]|\\.)*)")
# What a rule says of alternatives and of absence is not looked into.
_WITHIN: Final = re.compile(r":(?:not|is|where|has)\((?:[^()]|\([^()]*\))*\)|\[[^\]]*\]")
_GROUPS: Final = ("@media", "@supports")
_BUILT_UP: Final = "bs-"  # of these Bootstrap's script puts the names together


def used_words(texts: Collection[str]) -> frozenset[str]:
    """Collect all that could be the name of a class in pages and scripts.

    Parameters
    ----------
    texts
        HTML and JavaScript.
    """
    return frozenset().union(*map(_WORD.findall, texts))


def without_unused(sheet: str, used: Collection[str]) -> str:
    """Leave out each selector with a class that no page has and no script names.

    Parameters
    ----------
    sheet
        CSS, minified or not.
    used
        Names of classes.

    Returns
    -------
    str
        The sheet with the other rules, in their order.

    Examples
    --------
    >>> without_unused(".a,.b .c{color:red}@media print{.b{color:red}}p{margin:0}", {"a", "c"})
    '.a{color:red}p{margin:0}'
    """
    return "".join(_kept(_COMMENT.sub("", sheet), used))


def _kept(sheet: str, used: Collection[str]) -> Iterator[str]:
    for head, body in _rules(sheet):
        name = head.strip()
        if body is None:
            yield head
        elif name.startswith(_GROUPS):
            inner = "".join(_kept(body, used))
            if inner.strip():
                yield f"{head}{{{inner}}}"
        elif name.startswith("@"):
            yield f"{head}{{{body}}}"
        else:
            # A licence stands before the first selector and stays.
            licence, _, selectors = head.rpartition("*/")
            chosen = [each for each in _parts(selectors) if _is_used(each, used)]
            if chosen:
                yield f"{licence}{'*/' if licence else ''}{','.join(chosen)}{{{body}}}"
            elif licence:
                yield f"{licence}*/"


def _rules(sheet: str) -> Iterator[tuple[str, str | None]]:
    """Yield what stands before each block, and the block; nothing for a statement without one."""
    start = depth = opened = 0
    for place, sign in _signs(sheet):
        if sign == "{":
            depth += 1
            opened = place if depth == 1 else opened
        elif sign == "}":
            depth -= 1
            if depth == 0:
                yield sheet[start:opened], sheet[opened + 1 : place]
                start = place + 1
        elif depth == 0:
            yield sheet[start : place + 1], None
            start = place + 1


def _signs(sheet: str) -> Iterator[tuple[int, str]]:
    """Yield braces and semicolons that stand in no text, address or comment."""
    pattern = r"""/\*.*?\*/|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|url\([^)"']*\)|\\.|([{};])"""
    for found in re.finditer(pattern, sheet, re.DOTALL):
        if found[1]:
            yield found.start(), found[1]


def _parts(selectors: str) -> list[str]:
    """Split a list of selectors at the commas outside of brackets."""
    return re.findall(
        r"(?:\[[^\]]*\]|\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)|\\.|[^,])+", selectors
    )


def _is_used(selector: str, used: Collection[str]) -> bool:
    names = [name.replace("\\", "") for name in _CLASS.findall(_WITHIN.sub("", selector))]
    return all(name in used or name.startswith(_BUILT_UP) for name in names)
