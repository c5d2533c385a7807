"""Read what a reader writes into an answer box: numbers, expressions, a unit at the end."""

import math
import re
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Final

from chr_notes.lesson.words import UNITS, WORDS

__all__ = ["AnswerError", "read"]

_DEGREE: Final = math.pi / 180
_NAMES: Final[Mapping[str, Callable[..., float]]] = MappingProxyType(
    {
        "sqrt": math.sqrt,
        "sin": math.sin,
        "cos": math.cos,
        "tan": math.tan,
        "asin": math.asin,
        "acos": math.acos,
        "atan": math.atan,
        "arcsin": math.asin,
        "arccos": math.acos,
        "arctan": math.atan,
        "atan2": math.atan2,
    }
)
_VECTOR: Final = re.compile(r"[(\[](.*)[)\]]\s*((?:[A-Za-zµ°%][^()\[\],]*)?)")
_SPACED: Final = re.compile(r"[+-]?[\d.]+(\s+[+-]?[\d.]+){2,}(?=\s*([A-Za-zµ°%].*)?$)", re.ASCII)
_NUMBER: Final = re.compile(r"(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


class AnswerError(ValueError):
    """An answer that cannot be read; the message says so to the reader."""


class _Reader:
    """Reads one expression from the left; what is left over is a unit or cannot be read."""

    def __init__(self, text: str) -> None:
        self.rest = text.strip()
        self.depth = 0

    def takes(self, sign: str) -> bool:
        if not self.rest.startswith(sign):
            return False
        self.rest = self.rest[len(sign) :].lstrip()
        return True

    def error(self) -> AnswerError:
        return AnswerError(WORDS["unread" if self.rest else "ends"].format(self.rest[:12]))

    def total(self) -> float:
        value = self.term()
        while True:
            if self.takes("+"):
                value += self.term()
            elif self.takes("-"):
                value -= self.term()
            else:
                return value

    def term(self) -> float:
        value = self.signed()
        while True:
            if self.rest.startswith("**"):
                raise self.error()
            if self.takes("*"):
                value *= self.signed()
            elif self.takes("/"):
                value /= self.signed()
            elif self.rest.startswith("(") or self.name():
                value *= self.power()
            else:
                return value

    def signed(self) -> float:
        if self.takes("-"):
            return -self.signed()
        return self.signed() if self.takes("+") else self.power()

    def power(self) -> float:
        base = self.atom()
        if self.takes("**") or self.takes("^"):
            return float(base ** self.signed())
        return base

    def name(self) -> str:
        found = re.match(r"[A-Za-z]+2?", self.rest)
        return found[0] if found and (found[0] in _NAMES or found[0] == "pi") else ""

    def atom(self) -> float:
        name = self.name()
        if name:
            self.takes(name)
            return self.degrees(math.pi if name == "pi" else _NAMES[name](*self.arguments()))
        if self.rest.startswith("("):
            (value,) = self.arguments()
            return self.degrees(value)
        found = _NUMBER.match(self.rest)
        if found is None:
            raise self.error()
        self.takes(found[0])
        return self.degrees(float(found[0]))

    def degrees(self, value: float) -> float:
        # Within brackets a sign of degrees belongs to the number, at the end it is the answer's.
        return value * _DEGREE if self.depth and (self.takes("°") or self.takes("deg")) else value

    def arguments(self) -> list[float]:
        if not self.takes("("):
            raise self.error()
        self.depth += 1
        values = [self.total()]
        while self.takes(","):
            values.append(self.total())
        self.depth -= 1
        if not self.takes(")"):
            raise self.error()
        return values


def _parts(text: str) -> list[str]:
    """Take a list apart at the commas that stand in no further brackets."""
    for signs, plain in (("−", "-"), ("×", "*"), ("·", "*"), ("π", "pi"), ("²", "^2"), ("μ", "µ")):
        text = text.replace(signs, plain)
    text = text.strip()
    vector = _VECTOR.fullmatch(text)
    if vector:
        inner = _split(_spaced(vector[1]))
        if len(inner) > 1 and all(part.count("(") == part.count(")") for part in inner):
            return [*inner[:-1], f"{inner[-1]} {vector[2]}"]
    return _split(_spaced(text))


def _spaced(text: str) -> str:
    """Put commas between three numbers or more that have none but white space between."""
    numbers = _SPACED.match(text)
    if not numbers:
        return text
    return ", ".join(numbers[0].split()) + " " + text[numbers.end() :]


def _split(text: str) -> list[str]:
    parts, depth = [""], 0
    for sign in text:
        depth += (sign in "([") - (sign in ")]")
        if sign == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += sign
    return parts


def read(text: str, unit: str = "") -> tuple[tuple[float, ...], str]:
    """Read an answer: numbers, expressions like ``3*pi/4``, a unit at the end.

    Parameters
    ----------
    text
        What the reader wrote; several numbers with commas between, or three and more with spaces.
    unit
        The unit that is expected, named in messages.

    Returns
    -------
    values : tuple of float
        The numbers as they are written.
    unit : str
        The unit written, `""` for none.

    Raises
    ------
    AnswerError
        If it cannot be read; the message is for the reader.

    Examples
    --------
    >>> read("3*pi/4 rad")
    ((2.356194490192345,), 'rad')
    >>> read("(0.5, -1/2, 0)")
    ((0.5, -0.5, 0.0), '')
    """
    if not text.strip():
        raise AnswerError(WORDS["empty"])
    values, written = [], ""
    for part in _parts(text):
        reader = _Reader(part)
        try:
            value = reader.total()
        except (ArithmeticError, ValueError, TypeError) as error:
            if isinstance(error, AnswerError):
                raise
            raise AnswerError(WORDS["no value"]) from error
        if isinstance(value, complex) or not math.isfinite(value):
            raise AnswerError(WORDS["no value"])
        values.append(value)
        if reader.rest:
            written = reader.rest.strip()
            if not re.match(r"[A-Za-zµ°%]", written):
                raise reader.error()
            if written not in UNITS:
                raise AnswerError(WORDS["unknown"].format(written, unit or "plain numbers"))
    return tuple(values), written
