"""The built pages, without what they load and do not need, and mended: a Sphinx extension."""

import re
import shutil
from pathlib import Path
from typing import Any, Final

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.util.osutil import relative_uri

from chr_notes.book.access import mended
from chr_notes.book.entry_links import from_cards, from_docstring
from chr_notes.book.fields import join, shorten
from chr_notes.book.figures import taken_out
from chr_notes.book.spacing import spaced
from chr_notes.book.unused_rules import used_words, without_unused

__all__ = ["offered", "setup"]

_ICONS: Final = ("fontawesome",)  # they are in book/icons.css
_SEARCH: Final = (
    "searchtools",
    "language_data",
    "searchindex",
    "search_first",
)  # for the page of the search
_DEMOS: Final = ("pages",)  # for pages that have one
_CONVERTER: Final = ("converter_page",)  # for the page that has it, and no other demo
_FILTER: Final = ("ledger_filter",)  # for the table of all entries
_LESSONS: Final = ("lesson",)  # for pages with answer boxes, and with code to show or hide

_ICON_RULES: Final = re.compile(
    r"(?<=[}/])(?:(?:\.fa[-\w.:]*(?:>[\w.]+)?,?)+\{[^{}]*\}|:host,:root\{--fa-[^{}]*\})"
    r"|@font-face\{[^{}]*Font Awesome[^{}]*\}"
)
# The theme's script finds out light or dark when the page is there, and then all of it is styled
# again; the lines at its top can say so.
_LATE_THEME: Final = 'localStorage.getItem("theme") || "auto"'
_THEME: Final = (
    '["light", "dark"].find((each) => each === localStorage.getItem("mode")) || '
    '(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")'
)
_SHEETS: Final = ("styles/pydata-sphinx-theme.css", "sphinx-design.min.css", "mystnb.*.css")
_UNUSED: Final = (
    "_static/scripts/fontawesome.js",
    "_static/scripts/fontawesome.js.LICENSE.txt",
    "_static/vendor/fontawesome",
)
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


def _without_scripts(page: str, names: list[str]) -> str:
    choice = "|".join(names)
    return re.sub(rf'\s*<script[^>]* src="(?:[^"]*/)?(?:{choice})\.js[^"]*"></script>', "", page)


def _lighten(app: Sphinx, error: Exception | None) -> None:
    if error is not None:
        return
    built = Path(app.outdir)
    for page in built.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        unused = [*_ICONS]
        unused += [] if page == built / "search.html" else _SEARCH
        converts = 'data-demo="converter"' in text
        unused += [] if "data-demo" in text and not converts else _DEMOS
        unused += [] if converts else _CONVERTER
        unused += [] if "chr-lesson" in text or "cell_input" in text else _LESSONS
        unused += [] if "data-verdict" in text else _FILTER
        if page.parent.name == "notebooks":
            notebook = page.with_suffix(".ipynb")
            shutil.copyfile(Path(app.srcdir) / "notebooks" / notebook.name, notebook)
            text = offered(from_cards(text), notebook.name)
        own = page.relative_to(built).as_posix()
        text, figures = taken_out(text, relative_uri(own, "_images"))
        for name, figure in figures.items():
            (built / "_images").mkdir(exist_ok=True)
            (built / "_images" / name).write_bytes(figure)
        text = _without_scripts(text, unused).replace(_LATE_THEME, _THEME)
        page.write_text(spaced(mended(text)), encoding="utf-8")
    styles = built / "_static" / "styles" / "pydata-sphinx-theme.css"
    text = styles.read_text(encoding="utf-8")
    styles.write_text(_ICON_RULES.sub("", text), encoding="utf-8")
    _thin_out_rules(built)
    for name in _UNUSED:
        path = built / name
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)
    for source_map in built.rglob("*.map"):
        source_map.unlink()


def _thin_out_rules(built: Path) -> None:
    static = built / "_static"
    read = [*built.rglob("*.html"), *static.rglob("*.js")]
    used = used_words([path.read_text(encoding="utf-8") for path in read])
    for pattern in _SHEETS:
        for sheet in static.glob(pattern):
            text = without_unused(sheet.read_text(encoding="utf-8"), used)
            sheet.write_text(text, encoding="utf-8")


def _link(
    _app: Sphinx, _what: str, _name: str, _obj: object, _options: object, lines: list[str]
) -> None:
    from_docstring(lines)
    shorten(lines)


def _join(_app: Sphinx, document: nodes.document) -> None:
    join(document)


def _skip_field(
    _app: Sphinx, _what: str, _name: str, member: object, _skip: object, _options: object
) -> bool | None:
    """Leave out the fields of named tuples, which stand among the class's parameters."""
    return True if str(member.__doc__).startswith("Alias for field number") else None


def _leave_place_unsaid(app: Sphinx) -> None:
    app.builder.epilog = ""  # it is built aside


def _number_no_figures(_app: Sphinx, config: Config) -> None:
    """Undo what comes with Jupyter Book: for numbers, which none has, all pages would be loaded."""
    config["numfig"] = False


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.connect("config-inited", _number_no_figures, priority=900)
    app.connect("builder-inited", _leave_place_unsaid)
    app.connect("build-finished", _lighten)
    app.connect("autodoc-process-docstring", _link)
    app.connect("doctree-read", _join)
    app.connect("autodoc-skip-member", _skip_field)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
