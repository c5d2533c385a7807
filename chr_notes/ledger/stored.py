"""The verdicts as they are kept in the package: read without SymPy, written after a change.

A file a document, `verdicts/euler.json` and so on: its entries, and a stamp of what they depend
on. That is every file which the document's cases import, straight or through others, and the
version of SymPy that judged.
"""

import ast
import dataclasses
import hashlib
import json
from collections.abc import Iterable
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any, Final

from chr_notes._texts import PACKAGE, is_there
from chr_notes._texts import read as read_text
from chr_notes.ledger.entry import Entry, Witness

DOCUMENTS: Final = (
    "euler",
    "quaternions",
    "sensors",
    "estimation",
    "dead_reckoning",
    "validation",
)
FOLDER = PACKAGE / "ledger" / "verdicts"
REFRESH = "python -m chr_notes ledger --write"


class StaleError(RuntimeError):
    """The stored verdicts are not those of the present sources."""


def stamp(document: str) -> str:
    """Compute the hash of all sources that the verdicts on a document depend on."""
    printed = (file.stem for file in (PACKAGE / "printed").glob(f"{document}*.py"))
    start = (
        f"chr_notes.ledger.{document}",
        "chr_notes.ledger.judgement",
        *(f"chr_notes.printed.{name}" for name in printed),
    )
    files = sorted(_sources(start), key=str)
    digest = hashlib.sha256()
    for file in files:
        # A line ends alike on every system, however it was checked out.
        text = file.read_bytes().replace(b"\r\n", b"\n")
        digest.update(file.relative_to(PACKAGE).as_posix().encode() + b"\0" + text)
    return digest.hexdigest()[:16]


def _sources(start: Iterable[str]) -> set[Path]:
    """Follow the imports. What only gathers others, an `__init__.py`, is not followed."""
    found: set[Path] = set()
    waiting = [*start]
    while waiting:
        file = PACKAGE.joinpath(*waiting.pop().split(".")[1:]).with_suffix(".py")
        if file.is_file() and file not in found:
            found.add(file)
            waiting += _imported(file)
    return found


@cache
def _imported(file: Path) -> tuple[str, ...]:
    found = []
    for node in ast.parse(file.read_bytes()).body:
        if isinstance(node, ast.ImportFrom) and str(node.module).startswith("chr_notes"):
            found += [str(node.module), *(f"{node.module}.{alias.name}" for alias in node.names)]
    return tuple(found)


def write(document: str, entries: Iterable[Entry], sources: str) -> None:
    """Store the verdicts on a document with the stamp of the sources that gave them."""
    rows = [dataclasses.asdict(entry) for entry in entries]
    content = {"sources": sources, "sympy": metadata.version("sympy"), "entries": rows}
    text = json.dumps(content, indent=1, ensure_ascii=False) + "\n"
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / f"{document}.json").write_text(text, encoding="utf-8", newline="\n")


def is_stale(document: str) -> bool:
    """Whether the verdicts on a document were not stored, or for other sources."""
    file = FOLDER / f"{document}.json"
    return not is_there(file) or _content(document)["sources"] != stamp(document)


def judged_with(document: str) -> str:
    """Return the version of SymPy with which the stored verdicts on a document were reached."""
    return str(_content(document)["sympy"])


@cache
def read(document: str) -> tuple[Entry, ...]:
    """Read the stored verdicts on a document, in the order of its statements.

    Raises
    ------
    StaleError
        If the sources have changed since.
    """
    if is_stale(document):
        msg = f"the stored verdicts on {document} are out of date; run: {REFRESH}"
        raise StaleError(msg)
    return tuple(_entry(row) for row in _content(document)["entries"])


def _content(document: str) -> dict[str, Any]:
    content: dict[str, Any] = json.loads(read_text(FOLDER / f"{document}.json"))
    return content


def _entry(row: dict[str, Any]) -> Entry:
    witness = row.pop("witness")
    derivation, readings = (
        tuple((first, second) for first, second in row.pop(name))
        for name in ("derivation", "readings")
    )
    if witness is not None:
        at = tuple((symbol, value) for symbol, value in witness["at"])
        witness = Witness(**witness | {"at": at})
    return Entry(**row, witness=witness, derivation=derivation, readings=readings)
