"""What is boxed in a correction, boxed in the print as well."""

import re

_BOX = r"\boxed{"


def boxed_alike(printed: str, correction: str) -> str:
    r"""Box in a printed formula what the boxes of its correction take the place of.

    Parameters
    ----------
    printed
        LaTeX of a statement as printed.
    correction
        The same statement with other parts in some places, each in a box.

    Returns
    -------
    str
        The printed LaTeX without boxes, if it does not have what the correction leaves unboxed.

    Examples
    --------
    >>> boxed_alike("x = a + b", r"x = a \boxed{- c}")
    'x = a \\boxed{+ b}'
    """
    kept = _outside(correction)
    found = re.fullmatch("(.*?)".join(map(re.escape, kept)), printed, re.DOTALL)
    if len(kept) == 1 or found is None or not all(map(_is_whole, found.groups())):
        return printed
    parts = zip(found.groups(), kept[1:], strict=True)
    return kept[0] + "".join(f"{_BOX}{part}}}{after}" for part, after in parts)


def unboxed(latex: str) -> str:
    """Take the boxes off, and leave what is in them."""
    start = latex.find(_BOX)
    if start < 0:
        return latex
    end = _end(latex, start)
    return unboxed(latex[:start] + latex[start + len(_BOX) : end] + latex[end + 1 :])


def _outside(latex: str) -> list[str]:
    start = latex.find(_BOX)
    if start < 0:
        return [latex]
    return [latex[:start], *_outside(latex[_end(latex, start) + 1 :])]


def _end(latex: str, start: int) -> int:
    """Find the brace that closes the box that begins there."""
    depth = 0
    for place in range(start + len(_BOX) - 1, len(latex)):
        depth += {"{": 1, "}": -1}.get(latex[place], 0)
        if depth == 0:
            return place
    msg = f"expected a box that ends: {latex}"
    raise ValueError(msg)


def _is_whole(part: str) -> bool:
    counts = part.count("{") - part.count("}"), part.count(r"\left") - part.count(r"\right")
    return bool(part.strip()) and counts == (0, 0)
