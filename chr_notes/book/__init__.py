"""The book: write the pages that come from data, then let Jupyter Book make HTML of it all."""

import errno
import hashlib
import importlib.util
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import webbrowser
from importlib import metadata
from pathlib import Path

from chr_notes.book import pdf, sources

__all__ = ["build", "write_generated"]

ROOT = sources.CLONE
SOURCES = ROOT / "book"

_NEEDED = ("jupyter_book", "anywidget", "math_core", "fontTools", "brotli", "ziamath")
_INSTALL = 'python -m pip install "chr-notes[book]", or -e ".[book]" in a clone'
_MAKERS = ("jupyter-book", "matplotlib", "myst-nb", "sphinx", "sphinx-book-theme", "sympy")
_STAMP = "made_by"
_PDF = "chr-notes.pdf"
_COPIED_ANEW = ("mystnb.*.css",)  # it would be said that ours, which is thinned out, differs
_ROOM = 5_000_000
"""Bytes free below which a page or picture may have found no room."""


def build(
    *,
    folder: Path = Path("chr-notes-book"),
    output: Path | None = None,
    open_browser: bool = False,
    as_pdf: bool = False,
) -> Path:
    """Build the book and say where it is.

    In a clone of the project it is the clone's. Elsewhere a folder gets the sources that an
    installed package brings, and its notebooks are run there first. The book is built aside and put
    in place when it is whole, so that one from before stays if anything goes wrong. Of one that the
    same program built, only the pages change whose sources did.

    Parameters
    ----------
    folder
        What gets the sources where there is no clone.
    output
        Folder that gets a ``_build/html``, ``book`` beside the notebooks if it is None.
    open_browser
        Whether to show the first page in the reader's browser.
    as_pdf
        Whether to print it too, beside its ``html``.

    Returns
    -------
    pathlib.Path
        The first page.

    Raises
    ------
    RuntimeError
        If the sources of the book or a package of the extra ``book`` are missing, if a notebook
        does not run, if Jupyter Book finds anything wrong, warnings included, or if there is no
        Chromium to print with.
    OSError
        If a file cannot be written.
    """
    _require()
    if as_pdf:
        pdf.browser()  # without one it is said before the book is built
    root = sources.find(folder)
    made_by = _made_by(root / "book")
    if not _is_from(root / "book" / "_generated", made_by):
        _say("Writing the pages that come from data …")
        write_generated(root / "book", made_by)
    output = output or root / "book"
    output.mkdir(parents=True, exist_ok=True)
    built = output / "_build"
    with tempfile.TemporaryDirectory(dir=output, prefix=".build-") as beside:
        aside = Path(beside) / "_build"
        whole = not _is_from(built, made_by)
        if not whole:
            shutil.copytree(built, aside, ignore=shutil.ignore_patterns(_PDF, *_COPIED_ANEW))
        _say("Building the pages …" if whole else "Building the pages that changed …")
        _run_sphinx(root, aside, whole=whole)
        _write(aside / _STAMP, made_by)
        before = Path(beside) / "before"
        try:
            if built.exists():
                built.rename(before)
            aside.rename(built)
        finally:
            if before.exists() and not built.exists():
                before.rename(built)  # stopped in between
    first = built / "html" / "index.html"
    _say(f"The book is in {first}")
    if as_pdf:
        _say("Printing it, which takes minutes …")
        pdf.print_pdf(pdf.joined(first.parent, pdf.parts_of(first.parent)), built / _PDF)
        _say(f"As one PDF it is in {built / _PDF}")
    if open_browser:
        webbrowser.open(first.as_uri())
    return first


def _require() -> None:
    missing = [name for name in _NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        msg = f"the book needs {', '.join(missing)}; run: {_INSTALL}"
        raise RuntimeError(msg)


def _made_by(book: Path) -> str:
    """Stamp of what makes pages of their sources; where it differs, no page stays as it is."""
    package = Path(__file__).resolve().parents[1]
    files = [path for path in package.rglob("*") if path.is_file() and path.suffix != ".pyc"]
    files += [path for path in book.iterdir() if path.suffix in (".yml", ".css", ".js", ".json")]
    digest = hashlib.sha256()
    for path in sorted(files):
        digest.update(path.name.encode() + path.read_bytes())
    digest.update(" ".join(f"{name} {metadata.version(name)}" for name in _MAKERS).encode())
    return digest.hexdigest()


def _is_from(built: Path, made_by: str) -> bool:
    stamp = built / _STAMP
    return stamp.is_file() and stamp.read_text(encoding="utf-8") == made_by


def write_generated(book: Path, made_by: str) -> None:
    """Write what of the sources is made: pages from data, style sheets and scripts.

    Parameters
    ----------
    book
        The folder of the sources, which gets one called ``_generated``.
    made_by
        Stamp of what makes them.
    """
    # Imported here, so that a missing package is reported in our words and not as an ImportError.
    from chr_notes import lesson  # noqa: PLC0415
    from chr_notes.book import pages, search  # noqa: PLC0415
    from chr_notes.demos.base import page_script, styles  # noqa: PLC0415
    from chr_notes.ledger import entries  # noqa: PLC0415

    generated = book / "_generated"
    (generated / _STAMP).unlink(missing_ok=True)  # until all are written they are from nothing
    static = generated / "static"
    shutil.rmtree(static, ignore_errors=True)  # each script in it would go into every page
    for name, text in pages.generated().items():
        _write(generated / name, text)
    names = ("pages.css", "icons.css", "print.css")
    sheets = [(book / name).read_text(encoding="utf-8") for name in names]
    _write(static / "pages.css", "".join([styles(), lesson.styles(), *sheets]))
    _write(static / "lesson.js", lesson.script())
    for script in sorted(book.glob("*.js")):
        shutil.copy2(script, static)
    first = (book / "search_first.js").read_text(encoding="utf-8")
    _write(static / "search_first.js", search.found_first(entries()) + first)
    _write(static / "pages.js", page_script())
    _write(static / "converter_page.js", page_script("converter"))
    _write(generated / _STAMP, made_by)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    # What is as it was keeps its time, by which Sphinx sees what changed.
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def _run_sphinx(root: Path, aside: Path, *, whole: bool) -> None:
    command = [sys.executable, "-m", "chr_notes.book.run_sphinx", str(aside.resolve())]
    command += ["--all"] if whole else []
    # In a group of its own, so that who presses Ctrl-C stops us, and we end it without its words.
    done = subprocess.run(command, cwd=root, check=False, process_group=0)  # noqa: S603 - a fixed command
    if done.returncode != 0:
        if done.returncode == -getattr(signal, "SIGPIPE", 0):
            raise BrokenPipeError
        if shutil.disk_usage(aside.parent).free < _ROOM:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(aside.parent.parent))
        msg = "Jupyter Book found errors or warnings, in its output above; no page was changed"
        raise RuntimeError(msg)


def _say(text: str) -> None:
    sys.stdout.write(text + "\n")
    sys.stdout.flush()
