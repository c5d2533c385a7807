"""The text of a log in blocks of whole lines, whatever its encoding and its ends of lines."""

import codecs
from collections.abc import Iterator
from contextlib import contextmanager
from os import PathLike
from pathlib import Path
from typing import Protocol, runtime_checkable

_BLOCK = 2**18
LONGEST = 2**20
"""Bytes of a line beyond which a file is taken for none of lines, and read no further."""

_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)


@runtime_checkable
class Readable(Protocol):
    """An open file, of text or of bytes."""

    def read(self, size: int, /) -> str | bytes:
        """Return the next part, empty at the end."""


@contextmanager
def opened(source: str | PathLike[str] | Readable) -> Iterator[Readable]:
    """Open a path; leave open what is."""
    if isinstance(source, Readable):
        yield source
    else:
        with Path(source).open("rb") as file:
            yield file


def blocks(file: Readable) -> Iterator[bytes]:
    """Give the text of a file in UTF-8, block by block.

    Parameters
    ----------
    file
        With or without a mark of its encoding: UTF-8, UTF-16, UTF-32, or one of a byte a letter.

    Yields
    ------
    bytes
        Whole lines, each with a line feed at its end; by itself a last line that has none.

    Raises
    ------
    ValueError
        If it is no text.
    """
    rest = b""
    for part in _encoded(file):
        text = rest + part
        cut = text.rfind(b"\n") + 1
        if cut:
            yield text[:cut]
        rest = text[cut:]
        if len(rest) > LONGEST:
            break
    if rest:
        yield rest


def _encoded(file: Readable) -> Iterator[bytes]:
    """Give parts of a file in UTF-8 with line feeds as ends of lines."""
    decoder, late = None, b""
    first = True
    while part := file.read(_BLOCK):
        if isinstance(part, str):
            part = part.removeprefix("\ufeff") if first else part
            data = part.encode(errors="replace")
        elif first:
            _refuse_other_kinds(part)
            encoding, mark = _encoding(part)
            decoder = codecs.getincrementaldecoder(encoding)("replace") if encoding else None
            data = part[mark:]
        else:
            data = part
        if decoder is not None and isinstance(part, bytes):
            data = decoder.decode(data).encode()
        if first and b"\0" in data:
            place = data.index(b"\0")
            line, start = data.count(b"\n", 0, place) + 1, data.rfind(b"\n", 0, place)
            msg = f"line {line}, column {place - start}: expected text, got a byte 0"
            raise ValueError(msg)
        first = False
        data = late + data
        late = b""
        if data.endswith(b"\r"):  # perhaps the first half of an end of a line
            data, late = data[:-1], b"\r"
        yield data.replace(b"\r\n", b"\n").replace(b"\r", b"\n") if b"\r" in data else data
    if decoder is not None:
        late += decoder.decode(b"", final=True).encode()
    if late:
        yield late.replace(b"\r", b"\n")


def _refuse_other_kinds(start: bytes) -> None:
    """Name a file that is packed or of another program, by its first bytes."""
    for magic, kind, advice in _KINDS:
        if start.startswith(magic):
            msg = f"line 1, column 1: expected text, got {kind}; pass {advice}"
            raise ValueError(msg)


def _encoding(start: bytes) -> tuple[str | None, int]:
    """Tell what a file is written in, None for bytes that may stay, and how long its mark is."""
    for mark, encoding in _MARKS:
        if start.startswith(mark):
            return None if encoding == "utf-8" else encoding, len(mark)
    even, odd = start[0:_SAMPLE:2], start[1:_SAMPLE:2]
    if len(odd) > 1 and odd.count(0) > 0.9 * len(odd) and not even.count(0):
        return "utf-16-le", 0
    if len(odd) > 1 and even.count(0) > 0.9 * len(even) and not odd.count(0):
        return "utf-16-be", 0
    try:
        codecs.getincrementaldecoder("utf-8")().decode(start)
    except UnicodeDecodeError:
        return "latin-1", 0
    return None, 0


_SAMPLE = 4096
_KINDS = (
    (b"\x1f\x8b", "a gzip file", "gzip.open(path)"),
    (b"BZh", "a bzip2 file", "bz2.open(path)"),
    (b"\xfd7zXZ", "an xz file", "lzma.open(path)"),
    (b"PK\x03\x04", "a zip or xlsx file", "the text in it, or a DataFrame of pandas.read_excel"),
    (b"PAR1", "a parquet file", "a DataFrame of pandas.read_parquet"),
    (b"\x89HDF", "an HDF5 file", "a mapping from names to arrays"),
    (b"MATLAB 5.0", "a MATLAB file", "what scipy.io.loadmat gives"),
)
