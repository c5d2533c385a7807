"""The formulas of the book, set as MathML when it is built: a Sphinx extension.

A browser sets MathML by itself: a page needs no script for its formulas, and they stand at the
first paint where they stay.
"""

import base64
from pathlib import Path
from typing import Any, Final

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.domains.math import MathDomain
from sphinx.environment import BuildEnvironment
from sphinx.errors import SphinxError
from sphinx.util.nodes import get_node_line, get_node_source
from sphinx.writers.html5 import HTML5Translator

from chr_notes.book.mathfont import characters, font
from chr_notes.book.mathml import mathml

__all__ = ["FormulaError", "converted", "setup"]

_STYLES: Final = "formulas.css"
_DRAWN: Final = "chr_notes_drawn"  # the characters that the font has, kept with what Sphinx read


class FormulaError(SphinxError):
    """A formula that cannot be set; the message has its place and its LaTeX."""

    category = "A formula cannot be set"


def converted(node: nodes.Node) -> str:
    """Return a formula as MathML, or say where it stands."""
    latex = node.astext()
    try:
        return mathml(latex, display=isinstance(node, nodes.math_block))
    except ValueError as error:
        # MyST-NB numbers ten thousand lines for each cell.
        cell, line = divmod(get_node_line(node) or 0, 10_000)
        place = f" cell {cell}, line {line}" if cell else str(line)
        msg = f"{get_node_source(node)}:{place}: {error}\n{latex}"
        raise FormulaError(msg) from error


def _kept(env: BuildEnvironment) -> dict[str, frozenset[str]]:
    """Return the characters of each page's formulas, which are kept with what Sphinx read."""
    kept: dict[str, frozenset[str]] = vars(env).setdefault("chr_notes_characters", {})
    return kept


def _note(app: Sphinx, page: nodes.document) -> None:
    """Keep the characters of the formulas of a page that was read."""
    found = page.findall(lambda node: isinstance(node, nodes.math | nodes.math_block))
    _kept(app.env)[app.env.docname] = frozenset(characters(set(map(converted, found))))


def _forget(_app: Sphinx, env: BuildEnvironment, name: str) -> None:
    _kept(env).pop(name, None)


def _merge(_app: Sphinx, env: BuildEnvironment, names: set[str], other: BuildEnvironment) -> None:
    """Take over pages that another process read."""
    _kept(env).update((name, _kept(other)[name]) for name in names)


def _write_styles(app: Sphinx, env: BuildEnvironment) -> None:
    """Write the font of all formulas, if not there yet, before pages are written that name it."""
    occurring = frozenset().union(*_kept(env).values())
    static = Path(app.outdir) / "_static"
    if (static / _STYLES).is_file() and vars(env).get(_DRAWN) == occurring:
        return
    vars(env)[_DRAWN] = occurring
    data = base64.b64encode(font(sorted(occurring))).decode("ascii")
    static.mkdir(parents=True, exist_ok=True)
    # Within the style sheet: Firefox loads no font from a file for a page read from the disk.
    (static / _STYLES).write_text(
        "/* STIX Two Math, copyright 2001-2020 The STIX Fonts Project Authors, under the SIL Open\n"
        "   Font License 1.1 (https://scripts.sil.org/OFL), cut down to what occurs. */\n"
        '@font-face { font-family: "STIX Two Math"; '
        f'src: url("data:font/woff2;base64,{data}") format("woff2"); }}\n',
        encoding="utf-8",
    )


def _add_styles(app: Sphinx, name: str, *_: object) -> None:
    domain = app.env.get_domain("math")
    if isinstance(domain, MathDomain) and domain.has_equations(name):
        app.add_css_file(_STYLES)


def _visit_inline(translator: HTML5Translator, node: nodes.math) -> None:
    translator.body.append(translator.starttag(node, "span", "", CLASS="math"))
    translator.body.append(f"{converted(node)}</span>")
    raise nodes.SkipNode


def _visit_display(translator: HTML5Translator, node: nodes.math_block) -> None:
    translator.body.append(translator.starttag(node, "div", "", CLASS="math"))
    translator.body.append(f"{converted(node)}</div>\n")
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the renderer with Sphinx."""
    app.add_html_math_renderer("mathml", (_visit_inline, None), (_visit_display, None))
    app.connect("doctree-read", _note)
    app.connect("env-purge-doc", _forget)
    app.connect("env-merge-info", _merge)
    app.connect("env-updated", _write_styles)
    app.connect("html-page-context", _add_styles)
    return {"env_version": 1, "parallel_read_safe": True, "parallel_write_safe": True}
