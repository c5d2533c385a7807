"""Figures that notebooks hold within themselves, as files beside the built pages.

A page's text is then in the reader's hands before its figures, which are a quarter smaller as well.
"""

import base64
import hashlib
import re
from collections.abc import Mapping
from typing import Final

__all__ = ["taken_out"]

_FIGURE: Final = re.compile(r'src="data:image/svg\+xml;base64,([^"]+)"')
_SIZE: Final = re.compile(rb'<svg\b[^>]*?\bviewBox="[-\d.]+ [-\d.]+ ([\d.]+) ([\d.]+)"')
_PIXELS: Final = 4 / 3  # to a point


def taken_out(page: str, folder: str) -> tuple[str, Mapping[str, bytes]]:
    """Put an address in place of each figure, and its size, so that nothing moves when it comes.

    Parameters
    ----------
    page
        HTML with figures in it.
    folder
        Where the files will be, as the page names it.

    Returns
    -------
    tuple of str and mapping
        The page, and each file's content by its name.

    Raises
    ------
    ValueError
        If a figure says nothing of its size.
    """
    files: dict[str, bytes] = {}

    def address(found: re.Match[str]) -> str:
        figure = base64.b64decode(found[1])
        size = _SIZE.search(figure)
        if size is None:
            msg = f"expected a figure with a viewBox, got {figure[:80]!r}"
            raise ValueError(msg)
        name = f"{hashlib.sha256(figure).hexdigest()[:16]}.svg"
        files[name] = figure
        width, height = (round(float(each) * _PIXELS) for each in size.groups())
        return f'src="{folder}/{name}" width="{width}" height="{height}"'

    return _FIGURE.sub(address, page), files
