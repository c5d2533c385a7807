"""Sphinx as Jupyter Book runs it, for a process of its own."""

import gc
import signal
import sys
from pathlib import Path

__all__ = ["run"]


def run(aside: Path, *, whole: bool) -> int:
    """Build the pages from the sources in the present folder.

    Jupyter Book's own command would print where the pages are, and they are aside.

    Parameters
    ----------
    aside
        Folder that gets the ``html``.
    whole
        Whether all pages are built, not only those that changed.

    Returns
    -------
    int
        An exit code: 0 without errors and warnings.
    """
    # Here, for a book is also built without Jupyter Book.
    from jupyter_book.sphinx import build_sphinx  # noqa: PLC0415
    from sphinx.util.console import color_terminal, nocolor  # noqa: PLC0415

    if not color_terminal():  # what Sphinx's own command asks, and Jupyter Book does not
        nocolor()
    result = build_sphinx(
        Path.cwd(),
        aside / "html",
        path_config="book/_config.yml",
        noconfig=True,
        confoverrides={
            "external_toc_path": "book/_toc.yml",
            "latex_individualpages": False,
            "nitpicky": True,
        },
        warningiserror=True,
        keep_going=True,
        freshenv=whole,
    )
    return result if isinstance(result, int) else 1


if __name__ == "__main__":
    # Nearly all that it makes stays to its end: to look for garbage takes a sixth of its time.
    gc.disable()
    if hasattr(signal, "SIGPIPE"):  # where nobody reads it ends without a word
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    sys.exit(run(Path(sys.argv[1]), whole="--all" in sys.argv[2:]))
