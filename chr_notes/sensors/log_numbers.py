"""Single fields of a log: numbers, what stands for a missing one, dates and long times."""

import re
from decimal import Decimal
from functools import lru_cache

import numpy as np

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
MISSING = frozenset(["", "nan", "na", "n/a", "null", "none", "nil", "-", "<na>", "#n/a"])
"""What stands, in small letters, where a log has no number."""

DATE = re.compile(
    r"(\d{4}-\d\d-\d\d)[T ](\d\d:\d\d(?::\d\d(?:\.\d{1,9})?)?)(Z|[+-]\d\d:?\d\d)?", re.ASCII
)
_CLOCK = re.compile(r"\d{1,2}:\d\d(:\d\d([.,]\d+)?)?", re.ASCII)
_DIGITS = 15  # a double holds every number of so many

Origin = Decimal | np.datetime64


def bare(text: str) -> str:
    """Take away white space around a field, and quotes that open and close it."""
    text = text.strip()
    quoted = len(text) > 1 and text[0] == text[-1] and text[0] in "\"'"
    return text[1:-1].strip() if quoted else text


@lru_cache(maxsize=1000)  # a log has one word for what is missing, many times
def number(text: str) -> float:
    """Read a number, or NaN where it is missing.

    Raises
    ------
    ValueError
        If it is neither, or beyond what a double holds.
    """
    text = bare(text)
    if text.lower() in MISSING:
        return np.nan
    if not NUMBER.fullmatch(text):
        msg = f"expected a number, got {text!r:.40}"
        if _CLOCK.fullmatch(text):
            msg += ", a time of day: put its date before it, as in 2024-05-01 12:30:00.25"
        raise ValueError(msg)
    value = float(text)
    if not np.isfinite(value):
        msg = f"expected a number that a sensor may read, got {text!r:.40}"
        raise ValueError(msg)
    return value


def origin(text: str) -> Origin | None:
    """Read the first time of a log if it is a date, or has more digits than a double holds."""
    text = bare(text)
    if NUMBER.fullmatch(text):
        digits = sum(letter.isdigit() for letter in text.partition("e")[0])
        return Decimal(text) if digits > _DIGITS and "e" not in text.lower() else None
    return _date(text)


def since(first: Origin, text: str) -> float:
    """Count a time from the first one, in its unit or for a date in seconds.

    Raises
    ------
    ValueError
        If it is not a time as the first one is.
    """
    text = bare(text)
    if text.lower() in MISSING:
        return np.nan
    if isinstance(first, Decimal):
        passed = float(Decimal(text) - first) if NUMBER.fullmatch(text) else np.inf
    else:
        date = _date(text)
        passed = np.inf if date is None else float((date - first) / np.timedelta64(1, "ns")) * 1e-9
    if not np.isfinite(passed):
        msg = f"expected a time as the first one is, got {text!r:.40}"
        raise ValueError(msg)
    return passed


def _date(text: str) -> np.datetime64 | None:
    match = DATE.fullmatch(text)
    if not match:
        return None
    day, clock, zone = match.groups()
    try:
        date = np.datetime64(f"{day}T{clock}", "ns")
    except ValueError:  # a thirteenth month
        return None
    if zone and zone != "Z":
        minutes = 60 * int(zone[1:3]) + int(zone[-2:])
        date -= np.timedelta64(int(f"{zone[0]}{minutes}"), "m")
    return date
