"""Texts that the package brings beside its Python: files in a clone, an archive in a wheel.

In the archive they take a third less than each by itself.
"""

import tarfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType

PACKAGE = Path(__file__).resolve().parent
ARCHIVE = PACKAGE / "texts.tar.xz"


@cache
def archived() -> Mapping[str, bytes]:
    """Return what the archive has, by the path below the package; nothing where there is none."""
    if not ARCHIVE.is_file():
        return {}
    with tarfile.open(ARCHIVE) as archive:
        # Files of a tar without folders, as setup.py writes it.
        found = {member.name: archive.extractfile(member) for member in archive.getmembers()}
        return MappingProxyType({name: file.read() for name, file in found.items() if file})


def is_there(path: Path) -> bool:
    """Tell whether a file of the package is there, as such or in the archive."""
    return path.is_file() or _name(path) in archived()


def read(path: Path) -> str:
    """Read a file of the package.

    Raises
    ------
    FileNotFoundError
        If it is not there, and not in the archive.
    """
    content = None if path.is_file() else archived().get(_name(path))
    return path.read_text(encoding="utf-8") if content is None else content.decode("utf-8")


def _name(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix() if path.is_relative_to(PACKAGE) else ""
