"""The font of the book has what all pages need, whichever of them are read anew."""

import base64
import io
import re
from pathlib import Path

import pytest
from fontTools.ttLib import TTFont
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.docutils import docutils_namespace

from chr_notes.book import formulas

LETTERS = ("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta")


def in_font(sources: Path, *, processes: int = 1) -> set[str]:
    """Build what changed, and say of which Greek letters the font has the italic."""
    built = sources / "_build"
    with docutils_namespace():
        Sphinx(
            str(sources), None, str(built), str(built / "read"), "html",
            confoverrides={"extensions": ["chr_notes.book.formulas"],
                           "exclude_patterns": ["_build"],
                           "html_math_renderer": "mathml", "html_theme": "basic"},
            status=None, warningiserror=True, parallel=processes,
        ).build()  # fmt: skip
    styles = (built / "_static" / "formulas.css").read_text(encoding="utf-8")
    (data,) = re.findall(r"base64,([^\"]+)", styles)
    has = TTFont(io.BytesIO(base64.b64decode(data))).getBestCmap()
    return {chr(code - 0x1D6FC + 0x3B1) for code in has if 0x1D6FC <= code <= 0x1D714}


def page(sources: Path, name: str, letter: str) -> None:
    (sources / f"{name}.rst").write_text(
        f":orphan:\n\n{name}\n========\n\n:math:`\\{letter}`\n", encoding="utf-8"
    )


def test_a_change_of_one_page_keeps_the_characters_of_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in LETTERS:
        page(tmp_path, name, name)
    page(tmp_path, "index", "theta")
    assert in_font(tmp_path, processes=2) == {*"αβγδϵζηθ"} - {"ϵ"}
    page(tmp_path, "alpha", "psi")
    (tmp_path / "beta.rst").unlink()
    loaded: list[str] = []
    whole = BuildEnvironment.get_doctree
    monkeypatch.setattr(
        BuildEnvironment, "get_doctree", lambda env, name: loaded.append(name) or whole(env, name)
    )
    assert in_font(tmp_path) == {*"ψγδζηθ"}
    assert {*loaded} <= {"alpha", "index"}
    # What has all that occurs is not made again.
    page(tmp_path, "gamma", "gamma^2")
    assert in_font(tmp_path) == {*"ψγδζηθ"}
    monkeypatch.setattr(formulas, "font", None)
    page(tmp_path, "gamma", "gamma_2")
    assert in_font(tmp_path) == {*"ψγδζηθ"}
