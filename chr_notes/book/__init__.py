"""The book: write the pages that come from data, then let Jupyter Book make HTML of it all."""

import importlib.metadata
import importlib.util
import shutil
import subprocess
import sys
import webbrowser
from pathlib import Path

__all__ = ["build"]

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "book"
GENERATED = SOURCES / "_generated"

_JUPYTER_BOOK = "from jupyter_book.cli.main import main; main()"
_NEEDED = ("jupyter_book", "anywidget", "math_core", "fontTools", "brotli", "ziamath")


def build(*, open_browser: bool = False, output: Path = SOURCES) -> Path:
    """Build the book and say where it is.

    Parameters
    ----------
    open_browser
        Whether to show the first page in the reader's browser.
    output
        Folder that gets a ``_build/html``.

    Returns
    -------
    pathlib.Path
        The first page.

    Raises
    ------
    RuntimeError
        If the sources of the book or a package of the extra ``book`` are missing, or if Jupyter
        Book finds anything wrong, warnings included.
    """
    _require()
    _say("Judging every statement and writing the pages that come from data …")
    _write_generated()
    _say("Building the pages …")
    _run_jupyter_book(output)
    first = output / "_build" / "html" / "index.html"
    _say(f"The book is in {first}")
    if open_browser:
        webbrowser.open(first.as_uri())
    return first


def _require() -> None:
    if not (SOURCES / "_config.yml").is_file():
        msg = (
            f"expected the sources of the book in {SOURCES}, found none: they are not part of an "
            'installed package; clone the project and run python -m pip install -e ".[book]" there'
        )
        raise RuntimeError(msg)
    missing = [name for name in _NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        msg = f'the book needs {", ".join(missing)}; run: python -m pip install -e ".[book]"'
        raise RuntimeError(msg)


def _write_generated() -> None:
    # Imported here, so that a missing package is reported in our words and not as an ImportError.
    from chr_notes.book import pages  # noqa: PLC0415
    from chr_notes.demos.base import BUILT, styles  # noqa: PLC0415

    static = GENERATED / "static"
    shutil.rmtree(static, ignore_errors=True)  # each script in it would go into every page
    for name, text in pages.generated().items():
        _write(GENERATED / name, text)
    sheets = [(SOURCES / name).read_text(encoding="utf-8") for name in ("pages.css", "icons.css")]
    _write(static / "pages.css", "".join([styles(), *sheets]))
    shutil.copy2(SOURCES / "copy_formulas.js", static)
    _write(static / "pages.js", (BUILT / "pages.js").read_text(encoding="utf-8"))


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def _run_jupyter_book(output: Path) -> None:
    # All pages each time: what is unchanged would be left as it is, styles and warnings included.
    command = [
        sys.executable, "-c", _JUPYTER_BOOK, "build", ".",
        "--config", str(SOURCES / "_config.yml"), "--toc", str(SOURCES / "_toc.yml"),
        "--path-output", str(output), "--all", "-W", "-n", "--keep-going",
    ]  # fmt: skip
    done = subprocess.run(command, cwd=ROOT, check=False)  # noqa: S603 - a fixed command
    if done.returncode != 0:
        msg = "Jupyter Book found errors or warnings; they are in its output above"
        raise RuntimeError(msg)


def _say(text: str) -> None:
    sys.stdout.write(text + "\n")
    sys.stdout.flush()
