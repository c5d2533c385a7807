"""Texts that the package brings beside its Python, read and written out for who asks for them.

They are files in a clone and archives in a wheel, where they take less than half of the room.
"""

import bz2
import lzma
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType

PACKAGE = Path(__file__).resolve().parent
ARCHIVES = {PACKAGE / "prose.bz2": bz2.decompress, PACKAGE / "code.xz": lzma.decompress}
"""In each, path below the package and text in turn, with a zero byte between."""


@cache
def archived() -> Mapping[str, bytes]:
    """Return what the archives have, by the path below the package; without them nothing."""
    texts: dict[str, bytes] = {}
    for path, decompress in ARCHIVES.items():
        if path.is_file():
            parts = decompress(path.read_bytes()).split(b"\0")
            texts |= zip(map(bytes.decode, parts[::2]), parts[1::2], strict=True)
    return MappingProxyType(texts)


def is_there(path: Path) -> bool:
    """Tell whether a file of the package is there, as such or in an archive."""
    return path.is_file() or _name(path) in archived()


def read(path: Path) -> str:
    """Read a file of the package.

    Raises
    ------
    FileNotFoundError
        If it is not there, and in no archive.
    """
    content = None if path.is_file() else archived().get(_name(path))
    return path.read_text(encoding="utf-8") if content is None else content.decode("utf-8")


def write(texts: Mapping[Path, str]) -> None:
    """Write all of these files: without room for one none is changed, and each is whole."""
    begun = {path: path.with_name(f".{path.name}.begun") for path in texts}
    try:
        for path, part in begun.items():
            part.write_bytes(texts[path].encode())
        for path, part in begun.items():
            part.replace(path)
    except BaseException as error:
        for part in begun.values():
            part.unlink(missing_ok=True)
        if isinstance(error, OSError):
            error.filename, error.filename2 = str(path), None
        raise


def _name(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix() if path.is_relative_to(PACKAGE) else ""
