"""Each chapter as a notebook, to be had from its page."""

from typing import Final

__all__ = ["offered"]

_END: Final = "</h1>"
_MARK: Final = '<p class="chapter-download">'


def offered(page: str, name: str) -> str:
    """Say on a chapter's built page where its notebook is and how to run it; once is enough.

    Parameters
    ----------
    page
        HTML of a chapter.
    name
        File name of the notebook, which stands beside the page.
    """
    before, article, after = page.partition('<article class="bd-article">')
    if _MARK in after or not article:
        return page
    told = (
        f'{_MARK}<a href="{name}" download>Download this chapter as a notebook</a>. To run it: '
        '<code>python -m pip install "chr-notes[notebooks]"</code>, then '
        f"<code>jupyter lab {name}</code>.</p>"
    )
    return before + article + after.replace(_END, f"{_END}\n{told}", 1)
