"""The head of a log: the names of its columns, and how its lines are divided."""

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass

from chr_notes.sensors.column_names import unit_of
from chr_notes.sensors.columns import Given, Selected, select
from chr_notes.sensors.log_numbers import NUMBER

Columns = Given | Sequence[str]

COMMENTS = ("#", "%", "//")
_DELIMITERS = (",", ";", "\t", "|", " ")
_PREAMBLE = 1000
"""Lines within which the names of the columns have to come."""


@dataclass(frozen=True)
class Head:
    """What the first lines of a log tell.

    Parameters
    ----------
    names
        Of the columns, in order.
    selected
        Which of them hold what.
    delimiter
        Between fields; a space stands for any white space.
    decimal
        Point or comma.
    fields
        How many a line of numbers has.
    line
        Of the names, counted from 1; 0 where they were given.
    start
        First line of numbers, counted from 1.
    """

    names: tuple[str, ...]
    selected: dict[str, Selected]
    delimiter: str
    decimal: str
    fields: int
    line: int
    start: int


def split(line: str, delimiter: str) -> list[str]:
    """Divide a line into its fields, which may be quoted."""
    if delimiter == " ":
        line = " ".join(line.split())
    if '"' not in line:
        return [field.strip() for field in line.split(delimiter)]
    try:
        fields = next(csv.reader([line], delimiter=delimiter, skipinitialspace=True), [])
    except csv.Error:  # a field of over 100 000 letters
        fields = [line]
    return [field.strip() for field in fields]


def is_beside(line: str) -> bool:
    """Say whether a line is empty or a comment."""
    line = line.strip()
    return not line or line.startswith(COMMENTS)


def head(lines: Sequence[str], columns: Columns | None) -> Head:
    """Find the names of the columns and the first line of numbers.

    Parameters
    ----------
    lines
        The first ones of the log.
    columns
        As of `read_log`.

    Raises
    ------
    ValueError
        If there are no names, or they tell of no sensor.
    """
    if isinstance(columns, Sequence):
        return _without_names(lines, [*columns])
    best = _names(lines, columns) or _names(lines, columns, faulty=True)
    if best is None:
        text = next((line for line in lines if line.strip()), "")
        msg = (
            "line 1, column 1: expected a line with the names of the columns, such as "
            f"'time,ax,ay,az', within the first {_PREAMBLE} lines, got {text.strip()!r:.80}; "
            "pass columns=[names] for a log without"
        )
        raise ValueError(msg)
    place, delimiter = best
    names = split(lines[place].strip().lstrip("#%/ "), delimiter)
    return _with_numbers(lines, place, names, delimiter, columns)


def _names(
    lines: Sequence[str], columns: Given | None, *, faulty: bool = False
) -> tuple[int, str] | None:
    """Find the first line of names and what divides it: one without a fault, or any."""
    for place, line in enumerate(lines[:_PREAMBLE]):
        # A comment may say "by", or "ax", and be none.
        following = _next(lines, place + 1) if is_beside(line) and line.strip() else None
        best = 0, ""
        for delimiter in _DELIMITERS:
            names = split(line.strip().lstrip("#%/ "), delimiter)
            told = _told(names, columns, faulty=faulty)
            if told > best[0] and (following is None or _fits(lines, following, delimiter, names)):
                best = told, delimiter
        if best[0]:
            return place, best[1]
    return None


def _fits(lines: Sequence[str], place: int, delimiter: str, names: list[str]) -> bool:
    """Say whether a line has as many fields as there are names, and is none of names itself."""
    fields = split(lines[place], delimiter) if place < len(lines) else []
    count = len(fields) - (len(fields) == len(names) + 1 and not fields[-1])
    return count == len(names) and not _told(fields, None, faulty=True)


def _told(names: list[str], columns: Given | None, *, faulty: bool) -> int:
    """Count the columns that a line tells of, if it is one of names."""
    if any(NUMBER.fullmatch(name) for name in names):
        return 0
    wanted = [
        name
        for each in (columns or {}).values()
        for name in (
            [each] if isinstance(each, str) else each if isinstance(each, Sequence) else []
        )
    ]
    given = {name.strip() for name in wanted if isinstance(name, str)}
    if not given <= {*names}:
        if not faulty:
            return 0
        if not given & {*names}:
            # Of which names one that is given is missing, is said of those that tell by themselves.
            return _told(names, None, faulty=True)
    try:
        selected = select(names, columns)
    except ValueError as error:
        # Names of a sensor, if with a fault: that is for later to tell.
        return 0 if not faulty or str(error).startswith("expected columns") else len(names)
    return sum(len(each.places) for each in selected.values())


def _with_numbers(
    lines: Sequence[str], place: int, names: list[str], delimiter: str, columns: Given | None
) -> Head:
    """Look at what follows the names."""
    try:
        selected = select(names, columns)
    except ValueError as error:
        msg = f"line {place + 1}, column 1: {error}"
        raise ValueError(msg) from None
    start = _next(lines, place + 1)
    fields = split(lines[start], delimiter) if start < len(lines) else []
    if _are_units(fields, selected):
        selected = {
            quantity: Selected(each.places, each.unit or unit_of(quantity, fields[each.places[0]]))
            for quantity, each in selected.items()
        }
        start = _next(lines, start + 1)
        fields = split(lines[start], delimiter) if start < len(lines) else []
    if start >= len(lines):
        msg = f"line {len(lines) + 1}, column 1: expected rows of numbers, got the end of the log"
        raise ValueError(msg)
    count = len(names)
    if len(fields) == count + 1 and not fields[-1]:
        count += 1  # lines of numbers end with a delimiter
    decimal = _decimal(lines[start : start + _PREAMBLE], delimiter)
    return Head(tuple(names), selected, delimiter, decimal, count, place + 1, start + 1)


def _without_names(lines: Sequence[str], names: list[str]) -> Head:
    """Find the first line with as many numbers as there are names."""
    selected = select(names)
    for place, line in enumerate(lines[:_PREAMBLE]):
        if is_beside(line):
            continue
        for delimiter in _DELIMITERS:
            fields = split(line, delimiter)
            count = len(names) + (len(fields) == len(names) + 1 and not fields[-1])
            decimal = _decimal(lines[place : place + _PREAMBLE], delimiter)
            of_sensors = [
                fields[column].replace(decimal, ".")
                for quantity, each in selected.items()
                for column in each.places
                if quantity != "time" and len(fields) == count
            ]
            if of_sensors and all(NUMBER.fullmatch(field) for field in of_sensors):
                return Head(tuple(names), selected, delimiter, decimal, count, 0, place + 1)
    msg = (
        f"line 1, column 1: expected a line of {len(names)} numbers, as many as columns are given, "
        f"within the first {_PREAMBLE} lines, got none"
    )
    raise ValueError(msg)


def _next(lines: Sequence[str], place: int) -> int:
    """Pass over empty lines and comments."""
    while place < len(lines) and is_beside(lines[place]):
        place += 1
    return place


def _are_units(fields: list[str], selected: dict[str, Selected]) -> bool:
    """Say whether a line is one of units."""
    if any(re.search(r"^[+-]?[.,]?\d", field) for field in fields):
        return False
    return any(
        max(each.places) < len(fields) and unit_of(quantity, fields[each.places[0]]) is not None
        for quantity, each in selected.items()
    )


def _decimal(lines: Sequence[str], delimiter: str) -> str:
    """Tell a decimal comma from a point; between commas one has to be quoted."""
    if delimiter == ",":
        points = re.compile(r"(^|,)[ \t\"]*[+-]?\d*\.\d", re.ASCII)
        lines = [] if any(map(points.search, lines)) else [line for line in lines if '"' in line]
    fields = (field for line in lines for field in split(line, delimiter) if "," in field)
    commas = re.compile(r"[+-]?\d*,\d+(e[+-]?\d+)?", re.ASCII | re.IGNORECASE)
    return "," if any(commas.fullmatch(field) for field in fields) else "."
