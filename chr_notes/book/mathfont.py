"""The font of the formulas, cut down to the characters that occur."""

import io
import re
from collections.abc import Iterable
from html import unescape
from importlib import metadata
from typing import Final

from fontTools import subset
from fontTools.ttLib import TTFont

from chr_notes.book.mathml import ITALIC

__all__ = ["characters", "font"]

_FEATURES: Final = ("ccmp", "dtls", "kern", "mark", "mkmk", "ssty")  # letters of indices among them
_ANNOTATION: Final = re.compile(r"<annotation.*?</annotation>", re.DOTALL)
_SINGLE: Final = re.compile(r"<mi>(.)</mi>")


def characters(formulas: Iterable[str]) -> set[str]:
    """Return the characters that a browser shows for formulas in MathML."""
    shown = set()
    for formula in formulas:
        drawn = _ANNOTATION.sub("", formula)
        shown |= {ITALIC.get(letter, letter) for letter in _SINGLE.findall(drawn)}
        shown |= set(unescape(re.sub("<[^>]+>", "", _SINGLE.sub("", drawn))))
        shown |= {"√"} if "<msqrt>" in drawn or "<mroot>" in drawn else set()
    return shown


def font(wanted: Iterable[str]) -> bytes:
    """Return STIX Two Math with these characters and what they grow into, as WOFF2.

    The names of its authors and of its licence, the SIL Open Font License 1.1, stay in the file.
    """
    options = subset.Options(flavor="woff2", layout_features=list(_FEATURES), name_IDs=["*"])
    # A package of the extra "book" has the file; importing it would bring all that it does.
    files = metadata.files("ziamath") or ()
    (path,) = (file for file in files if file.name == "STIXTwoMath-Regular.ttf")
    file = io.BytesIO()
    with subset.load_font(str(path.locate()), options) as whole:
        _align_roots(whole)
        cut = subset.Subsetter(options)
        cut.populate(text="".join(wanted))
        cut.subset(whole)
        subset.save_font(whole, file, options)
    return file.getvalue()


def _align_roots(whole: TTFont) -> None:
    """Let each larger form of the root sign end where the smallest does.

    Chromium makes room for the widest form, whichever it draws, and what follows a small root
    would stand 0.4 em off. A larger form reaches out to the left instead; pages.css makes room.
    """
    name = whole.getBestCmap()[ord("√")]
    variants = whole["MATH"].table.MathVariants
    forms = variants.VertGlyphConstruction[variants.VertGlyphCoverage.glyphs.index(name)]
    larger = {each.VariantGlyph for each in forms.MathGlyphVariantRecord} - {name}
    larger |= {each.glyph for each in forms.GlyphAssembly.PartRecords}
    advance, _ = whole["hmtx"][name]
    for form in larger:
        width, bearing = whole["hmtx"][form]
        glyph = whole["glyf"][form]
        glyph.coordinates.translate((advance - width, 0))
        glyph.recalcBounds(whole["glyf"])
        whole["hmtx"][form] = (advance, bearing + advance - width)
