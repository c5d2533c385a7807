"""Run notebooks in place, as they are committed, and show what changed in what they print.

`python tests/notebooks/run.py` runs all of them, `… run.py NOTEBOOK ...` those that are named. It
ends with 1 if any output is another than before, and with 2 at once where one is not there, or the
verdicts that it shows have first to be reached again.
"""

import difflib
import sys
from collections.abc import Iterator
from pathlib import Path

import nbformat
from nbclient.exceptions import CellExecutionError

from chr_notes.book.sources import run
from chr_notes.ledger import StaleError

ALL = sorted((Path(__file__).resolve().parents[2] / "notebooks").glob("*.ipynb"))


def printed(path: Path) -> list[str]:
    """List what a notebook shows, cell by cell, as text."""
    return [line for cell in nbformat.read(path, as_version=4).cells for line in shown(cell)]


def shown(cell: nbformat.NotebookNode) -> Iterator[str]:
    """Yield the lines of a cell's outputs, pictures and pages by their source."""
    for output in cell.get("outputs", []):
        for kind, text in sorted(output.get("data", {output.output_type: output}).items()):
            whole = text if isinstance(text, str) else str(text.get("text", text))
            yield from (f"{kind}: {line}" for line in whole.splitlines())


def main(names: list[str]) -> int:
    """Run notebooks and write the differences on standard output."""
    changed = 0
    chosen = [Path(name).resolve() for name in names] or ALL
    for path in chosen:
        if not path.is_file():
            sys.stderr.write(f"expected a notebook, such as notebooks/{ALL[0].name}, got {path}\n")
            return 2
    for path in chosen:
        before = printed(path)
        try:
            run(path)
        except CellExecutionError as error:
            if error.ename != StaleError.__name__:
                raise
            sys.stderr.write(f"{path.name} is as before: {error.evalue}\n")
            return 2
        lines = [*difflib.unified_diff(before, printed(path), path.name, path.name, "", "", 0, "")]
        changed += bool(lines)
        sys.stdout.writelines(f"{line[:200]}\n" for line in lines)
        sys.stdout.write(f"{path.name}: {'changed' if lines else 'as before'}\n")
        sys.stdout.flush()
    return int(changed > 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
