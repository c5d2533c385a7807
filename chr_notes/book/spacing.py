"""The text of built pages: where a line may end and where not, and a minus that is no hyphen."""

import re
from typing import Final

__all__ = ["spaced"]

# What is not text stays as it is: code, signatures, formulas and tags.
_PART: Final = re.compile(
    r"<(head|script|style|pre|code|dt|math|svg)\b.*?</\1>|<[^>]*>|(?P<text>[^<]+)", re.DOTALL
)
_UNITS: Final = "°/s|°/h|°C|m/s²|m/s|µT|Hz|rad/s|rad|km|cm|mm|m|ms|µs|ns|s|min|h|kg|g|%"
_BEFORE_UNIT: Final = re.compile(rf"(?<=\d) (?=(?:{_UNITS})(?![\w/]))")
# -1 or a - b
_HYPHEN: Final = re.compile(r"(?<![^\s(\[])-(?=\d|pi\b)|(?:(?<=\b\w )|(?<=[°)] ))-(?= )")
_THEN_POINT: Final = re.compile(
    r'(?<!<span class="whole">)(<span class="math[^"]*"><math>(?:(?!</math>).)*</math></span>)'
    r"([,.:;?!)]+)",
    re.DOTALL,
)
_SIZE: Final = re.compile(r"\|(\w)\|")  # |q|, where a line would end after the first bar
_DOTTED: Final = re.compile(r"(?<=[ >(])chr_notes(?:\.\w+)+\.?(?=[^<>]*<)")  # and not in a tag
_LONG: Final = re.compile(r'(?<=<span class="pre">)\w{10,}')
_PARTS: Final = re.compile(r"(?<=_)(?=[^_])|(?<=[a-z])(?=[A-Z])")
_OPENED: Final = '<span class="sig-paren">(</span>'
_NO_BREAK: Final = "\N{NO-BREAK SPACE}"
_MINUS: Final = "\N{MINUS SIGN}"
_JOINED: Final = "|\N{WORD JOINER}\\1|"


def spaced(page: str) -> str:
    r"""Keep numbers with units, formulas with their comma, |q| whole; no hyphen is a minus.

    Names with dots may go on in another line after each dot, long ones after each underscore and
    before capitals, and signatures after their bracket.

    Parameters
    ----------
    page
        HTML.

    Examples
    --------
    >>> spaced("<p>It reads -9.8 m/s² in <code>f(-9.8 m)</code>.</p>")
    '<p>It reads −9.8\xa0m/s² in <code>f(-9.8 m)</code>.</p>'
    >>> spaced("<code>chr_notes.estimation.gains</code>")
    '<code>chr_notes.<wbr>estimation.<wbr>gains</code>'
    >>> spaced('<span class="pre">matrix_from_euler</span>')
    '<span class="pre">matrix_<wbr>from_<wbr>euler</span>'
    """
    page = _DOTTED.sub(lambda name: name[0].replace(".", ".<wbr>"), _PART.sub(_set, page))
    page = _LONG.sub(lambda name: _PARTS.sub("<wbr>", name[0]), page)
    page = page.replace(_OPENED, f"{_OPENED}<wbr>")
    return _THEN_POINT.sub(r'<span class="whole">\1\2</span>', page)


def _set(part: re.Match[str]) -> str:
    text = part["text"]
    if text is None:
        return part[0]
    return _SIZE.sub(_JOINED, _HYPHEN.sub(_MINUS, _BEFORE_UNIT.sub(_NO_BREAK, text)))
