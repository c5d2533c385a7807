"""What the theme leaves unsaid to whoever hears a page, mended in the built HTML."""

import re
from typing import Final

__all__ = ["mended"]

# A name that differs from the words on the button: who speaks commands says what is to be read.
_OTHER_NAMES: Final = (
    re.compile(r'(<button class="btn search-button-field[^>]*?) aria-label="Search"'),
    re.compile(r'(<summary)(?: aria-label="Toggle hidden content")'),
)
# Beside the link to a chapter with parts stands a button of which only the sign is there.
_PARTS: Final = re.compile(r"(<a [^>]*>([^<]*)</a><details[^>]*><summary)(>)")
_SIDEBAR: Final = '<div id="pst-primary-sidebar" class="bd-sidebar-primary bd-sidebar"'
_NAMED: Final = f'{_SIDEBAR} role="region" aria-label="All pages">'
# Links to a page's demos stand beside the one to its text, outside of every region.
_SKIPS: Final = '<div id="pst-skip-link" class="skip-link d-print-none"'
_SKIPS_NAMED: Final = f'{_SKIPS} role="navigation" aria-label="Skip">'


def mended(page: str) -> str:
    """Give each part of a page the name that its words are; what is mended already stays.

    Parameters
    ----------
    page
        The HTML that the theme made.

    Returns
    -------
    str
        The same with names of buttons, of the sidebar and what opens in it, and of the first links.
    """
    for pattern in _OTHER_NAMES:
        page = pattern.sub(r"\1", page)
    page = _PARTS.sub(r'\1 aria-label="Pages of \2"\3', page)
    return page.replace(f"{_SIDEBAR}>", _NAMED).replace(f"{_SKIPS}>", _SKIPS_NAMED)
