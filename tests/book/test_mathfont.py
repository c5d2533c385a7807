"""The font of the book has what its formulas need, and what lets them grow."""

import base64
import io
import re
from pathlib import Path

import pytest
from fontTools.ttLib import TTFont

from chr_notes.book.mathfont import characters, font
from chr_notes.book.mathml import mathml

INVISIBLE = set("\u2061\u2063\ufe00 \xa0\n")


def opened(data: bytes) -> TTFont:
    return TTFont(io.BytesIO(data))


def test_a_letter_alone_is_italic() -> None:
    assert characters([mathml(r"h + \psi", display=False)]) - INVISIBLE == set("\u210e+\U0001d713")
    assert characters([mathml(r"\sin 2", display=False)]) - INVISIBLE == set("sin2")


def test_a_root_needs_its_sign() -> None:
    assert characters([mathml(r"\sqrt{2}", display=False)]) - INVISIBLE == set("√2")
    assert characters([mathml(r"\sqrt[3]{2}", display=False)]) - INVISIBLE == set("√23")


def test_the_font_has_the_characters_and_their_larger_forms() -> None:
    cut = opened(font("(\U0001d713"))
    assert {chr(code) for code in cut.getBestCmap()} == {"(", ")", "\U0001d713"}  # and its mirror
    assert "MATH" in cut
    assert len(cut.getGlyphOrder()) > 10  # brackets of several sizes and the pieces of larger ones


def test_the_font_names_its_authors_and_licence() -> None:
    names = opened(font("x"))["name"]
    assert "STIX Fonts Project Authors" in names.getDebugName(0)
    assert "SIL Open Font License, Version 1.1" in names.getDebugName(13)


@pytest.fixture(scope="module")
def of_book(book: Path) -> TTFont:
    """The font in the built book."""
    styles = (book / "_static" / "formulas.css").read_text(encoding="utf-8")
    (data,) = re.findall(r"base64,([^\"]+)", styles)
    return opened(base64.b64decode(data))


def test_the_book_has_each_character_that_occurs(book: Path, of_book: TTFont) -> None:
    pages = (path.read_text(encoding="utf-8") for path in book.rglob("*.html"))
    formulas = [each for page in pages for each in re.findall("<math.*?</math>", page, re.DOTALL)]
    assert len(formulas) > 1000
    assert characters(formulas) - INVISIBLE <= {chr(code) for code in of_book.getBestCmap()}


def test_each_form_of_the_root_ends_alike() -> None:
    cut = opened(font("√"))
    variants = cut["MATH"].table.MathVariants
    (forms,) = variants.VertGlyphConstruction
    smallest, *larger = [each.VariantGlyph for each in forms.MathGlyphVariantRecord]
    larger += [each.glyph for each in forms.GlyphAssembly.PartRecords]
    assert len(larger) == 6
    assert {cut["hmtx"][form][0] for form in larger} == {cut["hmtx"][smallest][0]}
    for form in larger:
        assert cut["glyf"][form].xMin == cut["hmtx"][form][1]
    # The bar above what stands under a root joins each sign there.
    whole = {each.VariantGlyph for each in forms.MathGlyphVariantRecord}
    assert {cut["glyf"][form].xMax for form in whole} == {cut["glyf"][smallest].xMax}
