"""Texts that the package brings beside its Python: files in a clone, archives in a wheel.

There they take less than half of what each takes by itself.
"""

import tarfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType

PACKAGE = Path(__file__).resolve().parent
ARCHIVES = (PACKAGE / "prose.tar.bz2", PACKAGE / "code.tar.xz")


@cache
def archived() -> Mapping[str, bytes]:
    """Return what the archives have, by the path below the package; without them nothing."""
    texts = {}
    for path in filter(Path.is_file, ARCHIVES):
        with tarfile.open(path) as archive:
            # Files of a tar without folders, as setup.py writes it.
            found = {member.name: archive.extractfile(member) for member in archive}
            texts.update({name: file.read() for name, file in found.items() if file})
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


def _name(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix() if path.is_relative_to(PACKAGE) else ""
