"""The style and the script of lessons, for the book's pages and for a notebook."""

import json
from dataclasses import dataclass
from pathlib import Path

from chr_notes import palette
from chr_notes._texts import read
from chr_notes.lesson.words import UNITS, WORDS

__all__ = ["Beginning", "begin", "script", "styles"]

_SOURCES = Path(__file__).resolve().parent


def styles() -> str:
    """Return the style sheet of cards, guesses and exercises, on the palette's variables."""
    return read(_SOURCES / "lesson.css")


def script() -> str:
    """Return the script of answer boxes, with the tables that Python has, too."""
    tables = json.dumps({"UNITS": dict(UNITS), "WORDS": dict(WORDS)}, ensure_ascii=False)
    sources = (read(_SOURCES / name) for name in ("arrow.js", "lesson.js"))
    return "\n".join([f"const TABLES = {tables};", *sources])


@dataclass(frozen=True)
class Beginning:
    """What a notebook needs once, so that it looks and answers as the book does."""

    def __repr__(self) -> str:
        """Say what it is for, where no HTML can be shown."""
        return "Style of cards and answer boxes."

    def _repr_html_(self) -> str:
        return f"<style>{palette.css()}{styles()}</style><script>{{{script()}}}</script>"


def begin() -> Beginning:
    """Style a notebook's cards and bring its answer boxes to life; the book has both by itself."""
    return Beginning()
