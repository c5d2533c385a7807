"""The columns of a log as numbers, from text or from arrays."""

import re
from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import chain
from os import PathLike, fstat

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.sensors.column_names import SENSORS
from chr_notes.sensors.columns import Selected
from chr_notes.sensors.decimals import decimals
from chr_notes.sensors.log_fields import BESIDE, Fields, Letters, lines_of_words
from chr_notes.sensors.log_header import COMMENTS, Columns, Head, head, is_beside, split
from chr_notes.sensors.log_numbers import Origin, number, origin, since
from chr_notes.sensors.log_since import since_first
from chr_notes.sensors.log_text import LONGEST, Readable, blocks, opened

_MARKS = [mark[:1].encode() for mark in COMMENTS]
_COMMENT = re.compile(rb"^\s*(#|%|//)", re.MULTILINE)
_COMMA = bytes.maketrans(b",.", b".?")  # a point between thousands is none of a number
Divide = Callable[[Letters, int, int], Fields | None]
LARGEST = 1e15
"""No sensor reads as much, in whatever unit."""


@dataclass(frozen=True)
class Table:
    """What a log holds, as it stands there.

    Parameters
    ----------
    values
        Of each quantity, shape (N, 3), or (N, 1) for time and temperature; NaN is missing. Times
        of many digits, and dates, are counted from the first one.
    selected
        The columns of each quantity, with the unit that their names tell.
    names
        Of all columns.
    place
        Says where a sample stands in the log: a line or a row.
    notes
        A sentence for each thing about the text that was found or taken for granted.
    warnings
        A sentence for each thing about the text that is not as it should be.
    """

    values: dict[str, Floats]
    selected: dict[str, Selected]
    names: tuple[str, ...]
    place: Callable[[int], str]
    notes: tuple[str, ...]
    warnings: tuple[str, ...]


def read_text(source: str | PathLike[str] | Readable, columns: Columns | None) -> Table:
    """Read a file.

    Raises
    ------
    ValueError
        If it holds anything but numbers in the columns that are read; it names line and column.
    """
    with opened(source) as file:
        stream = blocks(file)
        first = next(stream, b"")
        _check_length(first, 1)
        lines = first.decode(errors="replace").split("\n")
        if first.endswith(b"\n") or not first:
            lines.pop()
        found = head(lines, columns)
        rows = _Rows(found, _expected(file, first))
        cut = 0
        for _ in range(found.start - 1):
            cut = first.index(b"\n", cut) + 1
        for block in chain([first[cut:]], stream):
            rows.add(block)
    return rows.table()


def _check_length(block: bytes, line: int) -> None:
    """Refuse a line without end."""
    if len(block) > LONGEST and b"\n" not in block:
        msg = f"line {line}, column 1: expected lines of text, got one of over a megabyte"
        raise ValueError(msg)


def _expected(file: Readable, block: bytes) -> int:
    """Estimate how many lines a file has, from its size and its first block."""
    lines = block.count(b"\n") + 1
    try:
        size = fstat(file.fileno()).st_size  # type: ignore[attr-defined]
    except (AttributeError, OSError):
        return lines
    return int(size * lines / max(len(block), 1) * 1.01) + 16


@dataclass
class _Rows:
    """Lines of numbers, block by block."""

    head: Head
    capacity: int
    count: int = 0
    line: int = 0
    anchors: list[tuple[int, int]] = field(default_factory=list)
    values: dict[str, Floats] = field(default_factory=dict)
    origin: Origin | None = None
    readings: set[int] = field(default_factory=set)
    warnings: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.line = self.head.start
        sensors = (self.head.selected[each] for each in SENSORS if each in self.head.selected)
        self.readings = {place for each in sensors for place in each.places}
        for quantity, each in self.head.selected.items():
            self.values[quantity] = np.empty((self.capacity, len(each.places)))

    def add(self, block: bytes) -> None:
        """Read whole lines."""
        if not block:
            return
        _check_length(block, self.line)
        ended = block.endswith(b"\n")
        block = block if ended else block + b"\n"
        rows = block.count(b"\n")
        commented = any(mark in block for mark in _MARKS) and _COMMENT.search(block) is not None
        divide = lines_of_words if self.head.delimiter == " " else self._divided
        if commented or not self._regular(block, [self.line], rows, divide, ended=ended):
            kept, numbers = self._lines(block, ended=ended)
            if kept:
                self._regular(b"".join(kept), numbers, len(kept), self._divided, ended=ended)
        self.line += rows

    def _lines(self, block: bytes, *, ended: bool) -> tuple[list[bytes], list[int]]:
        """Take the lines of numbers alone, each with its number and its fields plainly divided."""
        expected, delimiter = self.head.fields, self.head.delimiter
        kept, numbers = [], []
        for place, line in enumerate(block.split(b"\n")[:-1]):
            text = line.decode(errors="replace")
            if is_beside(text):
                continue
            fields = split(text, delimiter)
            if len(fields) != expected:
                if not ended and len(fields) < expected:
                    self.warnings.append(
                        f"line {self.line + place}, the last, has {len(fields)} of {expected} "
                        "fields and no end: left out"
                    )
                    continue
                at = min(len(fields), expected) + (len(fields) > expected)
                msg = (
                    f"line {self.line + place}, column {at}: expected {expected} fields, "
                    f"got {len(fields)}: {text.strip()!r:.80}"
                )
                raise ValueError(msg)
            if self.head.decimal == delimiter:
                fields = [each.replace(".", "?").replace(delimiter, ".") for each in fields]
            for at in self.readings if delimiter != " " else ():
                if delimiter in fields[at]:  # quoted
                    self._refuse(f"line {self.line + place}", at, self._wrong(fields[at]))
            clean = delimiter.join(
                each.replace(delimiter, "_").replace("\n", "_") for each in fields
            )
            kept.append(clean.encode() + b"\n")
            numbers.append(self.line + place)
        return kept, numbers

    def _regular(
        self, block: bytes, numbers: list[int], rows: int, divide: Divide, *, ended: bool
    ) -> bool:
        """Read lines that have all as many fields; if not all have, say so and read none."""
        if self.head.decimal == "," != self.head.delimiter:
            block = block.translate(_COMMA)
        fields_of = divide(np.frombuffer(block, dtype=np.uint8), rows, self.head.fields)
        if fields_of is None:
            return False
        self._anchor(numbers, rows)
        self._grow(rows)
        self._keep(fields_of, bare=not any(letter in block for letter in BESIDE))
        self.count += rows
        if not ended:
            self.warnings.append(
                f"line {self.line} is the last and has no end: its last number may be cut"
            )
        return True

    def _divided(self, text: Letters, rows: int, fields: int) -> Fields | None:
        """Divide lines at each delimiter."""
        ends = np.flatnonzero((text == ord(self.head.delimiter)) | (text == ord("\n")))
        if len(ends) != rows * fields or (text[ends[fields - 1 :: fields]] != ord("\n")).any():
            return None
        begins = np.concatenate([[0], ends[:-1] + 1])
        return Fields(text, begins.reshape(rows, fields), ends.reshape(rows, fields))

    def _keep(self, fields: Fields, *, bare: bool) -> None:
        """Read the fields of some lines, which may have nothing but numbers in them."""
        here = slice(self.count, self.count + len(fields.ends))
        columns = [place for each in self.head.selected.values() for place in each.places]
        if "time" in self.values:
            times = fields.of(columns[:1])
            if not self.count:
                self.origin = origin(times.text(0))
            if self.origin is not None:
                times = times if bare else times.bare()
                self.values["time"][here, 0] = self._long_times(times, self.origin)
                columns = columns[1:]
        wanted = fields.of(columns)
        values = self._numbers(wanted if bare else wanted.bare(), columns)
        values = values.reshape(-1, len(columns))
        place = 0
        for quantity, kept in self.values.items():
            if quantity != "time" or self.origin is None:
                kept[here] = values[:, place : place + kept.shape[1]]
                place += kept.shape[1]

    def _numbers(self, fields: Fields, columns: Sequence[int]) -> Floats:
        values, read = decimals(fields.all, fields.starts, fields.ends)
        missing = fields.starts == fields.ends
        values[missing] = np.nan
        read |= missing
        for each in np.flatnonzero(~read).tolist():
            try:
                values[each] = number(fields.text(each))
            except ValueError:
                self._refuse_field(each, columns, self._wrong(fields.text(each)))
        for each in np.flatnonzero(np.abs(values) > LARGEST).tolist():
            if columns[each % len(columns)] in self.readings:
                self._refuse_field(each, columns, f"expected a reading, got {values[each]:g}")
        return values

    def _wrong(self, text: str) -> str:
        """Say what is wrong with a field, as it stands in the log."""
        if self.head.decimal == ",":
            text = text.replace(".", ",").replace("?", ".")
        try:
            number(text)
        except ValueError as error:
            return str(error)
        return f"expected a number with a decimal comma, got {text!r:.40}"

    def _refuse(self, line: str, column: int, reason: object) -> None:
        msg = f"{line}, column {column + 1} ({self.head.names[column]}): {reason}"
        raise ValueError(msg)

    def _refuse_field(self, each: int, columns: Sequence[int], reason: object) -> None:
        row, place = divmod(each, len(columns))
        self._refuse(self.place(self.count + row), columns[place], reason)

    def _long_times(self, times: Fields, first: Origin) -> Floats:
        """Count dates, and times of more digits than a double holds, from the first one."""
        values, read = since_first(first, times)
        for row in np.flatnonzero(~read).tolist():
            try:
                values[row] = since(first, times.text(row))
            except ValueError as error:
                self._refuse_field(row, self.head.selected["time"].places, error)
        return values

    def _anchor(self, numbers: list[int], rows: int) -> None:
        """Keep at which line which row stands."""
        for row, line in enumerate(numbers if len(numbers) == rows else numbers[:1]):
            if (
                not self.anchors
                or line - self.anchors[-1][1] != self.count + row - self.anchors[-1][0]
            ):
                self.anchors.append((self.count + row, line))

    def place(self, row: int) -> str:
        """Say at which line a row stands."""
        first, line = self.anchors[max(bisect_right(self.anchors, (row, 2**63)) - 1, 0)]
        return f"line {line + row - first}"

    def _grow(self, rows: int) -> None:
        if self.count + rows > self.capacity:
            self.capacity = max(self.count + rows, self.capacity * 5 // 4)
            for values in self.values.values():
                values.resize((self.capacity, values.shape[1]), refcheck=False)

    def table(self) -> Table:
        """Give all that was read."""
        for values in self.values.values():
            values.resize((self.count, values.shape[1]), refcheck=False)
        comma = self.head.decimal == ","
        notes = ["numbers are written with a decimal comma"] if comma else []
        if self.head.line > 1:
            notes.append(
                f"lines before line {self.head.line}, which has the names, were passed over"
            )
        return Table(
            self.values,
            self.head.selected,
            self.head.names,
            self.place,
            tuple(notes),
            tuple(self.warnings),
        )
