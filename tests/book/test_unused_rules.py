"""Of a style sheet only rules go whose class is nowhere."""

from pathlib import Path

import pydata_sphinx_theme
import pytest

from chr_notes.book.unused_rules import used_words, without_unused

THEME = Path(pydata_sphinx_theme.__file__).parent / "theme/pydata_sphinx_theme/static/styles"
SHEET = (THEME / "pydata-sphinx-theme.css").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("sheet", "left"),
    [
        (".a{x:y}.b{x:y}", ".a{x:y}"),
        ("p,.b,.a .b,.a>p{x:y}", "p,.a>p{x:y}"),
        (".b{x:y}:is(.b,p){x:y}p:not(.b){x:y}", ":is(.b,p){x:y}p:not(.b){x:y}"),
        ("@media print{.b{x:y}.a{x:y}}@media all{.b{x:y}}", "@media print{.a{x:y}}"),
        ("@keyframes b{from{x:y}to{x:z}}.b{x:y}", "@keyframes b{from{x:y}to{x:z}}"),
        ('@charset "UTF-8";.b{x:"}"}.a{x:";"}', '@charset "UTF-8";.a{x:";"}'),
        (r".a\/2{x:y}.a{x:url(data:x;y,.b{})}", ".a{x:url(data:x;y,.b{})}"),
        ("/* gone *//*! who made it */.b{x:y}.a{x:y}", "/*! who made it */.a{x:y}"),
        ('[x=".b,"],.b{x:y}.bs-tooltip-top{x:y}', '[x=".b,"]{x:y}.bs-tooltip-top{x:y}'),
    ],
)
def test_what_is_left(sheet: str, left: str) -> None:
    assert without_unused(sheet, {"a"}) == left


def test_a_sheet_whose_classes_are_all_used_stays_whole() -> None:
    plain = without_unused(SHEET, used_words([SHEET]))
    assert plain.count("{") == plain.count("}") == SHEET.count("{")
    assert without_unused(plain, set()) != plain


def test_doing_it_twice_changes_nothing() -> None:
    once = without_unused(SHEET, {"navbar", "d-none"})
    assert without_unused(once, {"navbar", "d-none"}) == once
    assert ".d-none{" in once
    assert ".btn-danger{" not in once
