"""Numbers keep their units, formulas their comma; what is no text stays as it is."""

import re
from pathlib import Path

import pytest

from chr_notes.book.spacing import spaced

AS_IT_IS = (
    "<code>-1 m</code>",
    "<pre>x = -1 m</pre>",
    "<math><mn>-1 m</mn></math>",
    '<img alt="-1 m">',
    "<head><title>-1 m</title></head>",
    '<img alt="of chr_notes.euler">',
    "<p>3-2-1, 10-12, a -b, words - more, 5 more, 5 mm²</p>",
)


@pytest.mark.parametrize("html", AS_IT_IS)
def test_what_is_no_number_with_a_unit_stays(html: str) -> None:
    assert spaced(html) == html


def test_text_between_tags_is_set() -> None:
    html = "<p>From -180° to (-2, 1 <b>-0.5 µT</b>), 100 Hz, 1 - L, 20° - b, (c) - d.</p>"
    told = "<p>From −180° to (−2, 1 <b>−0.5\u00a0µT</b>), 100\u00a0Hz, 1 − L, 20° − b, (c) − d.</p>"
    assert spaced(html) == told
    assert spaced(told) == told


def test_no_line_begins_with_the_comma_after_a_formula() -> None:
    formula = '<span class="math"><math><mi>L</mi></math></span>'
    told = f'<p>At <span class="whole">{formula},</span> then {formula} and (b).</p>'
    assert spaced(f"<p>At {formula}, then {formula} and (b).</p>") == told
    assert spaced(told) == told


def test_a_size_is_not_broken_after_its_first_bar() -> None:
    told = "<p>Of |\u2060ω| and |\u2060q|.</p>"
    assert spaced("<p>Of |ω| and |q|.</p>") == spaced(told) == told


def test_chapters_are_set(book: Path) -> None:
    for page in (book / "notebooks").glob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert spaced(text) == text
        assert re.search(r"\d\u00a0(?:s|m/s²|°/s)", text), page.name
