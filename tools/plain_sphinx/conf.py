"""The book's configuration for Sphinx itself, from that for Jupyter Book: `nox -s newest`."""

from pathlib import Path

import yaml

_BOOK = Path(__file__).resolve().parents[2] / "book"
_CONFIG = yaml.safe_load((_BOOK / "_config.yml").read_text(encoding="utf-8"))
_SPHINX = _CONFIG["sphinx"]["config"]

# What Jupyter Book adds of its own.
project = html_title = _CONFIG["title"]
author = _CONFIG["author"]
html_theme = "sphinx_book_theme"
external_toc_path = "book/_toc.yml"
external_toc_exclude_missing = _CONFIG["only_build_toc_files"]
exclude_patterns = _CONFIG["exclude_patterns"]
nb_execution_mode = _CONFIG["execute"]["execute_notebooks"]
myst_enable_extensions = _CONFIG["parse"]["myst_enable_extensions"]

globals().update(_SPHINX)
extensions = [name for name in _SPHINX["extensions"] if name != "jupyter_book"]
html_static_path = [str(_BOOK.parent / path) for path in _SPHINX["html_static_path"]]
bibtex_bibfiles = [str(_BOOK.parent / path) for path in _SPHINX["bibtex_bibfiles"]]
