"""Which files an entry is written in, for messages that say where to mend it."""

import re
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
TABLE = re.compile(r"(\w+\.t1)\..+")  # the cells of a table are written in one place


@cache
def files_of(name: str) -> tuple[str, ...]:
    """Find the file that prints a statement, and the one with what is brought for it, if any is.

    Parameters
    ----------
    name
        The id of an entry.

    Returns
    -------
    tuple of str
        Paths from the root of the project.
    """
    cell = TABLE.fullmatch(name)
    written = rf'"{re.escape(cell[1])}\.\{{' if cell else rf'"{re.escape(name)}"'
    calls = (("printed", r"Printed\(\s*"), ("ledger", r"(?:Case\(\s*|statement = )"))
    return tuple(
        f"{PACKAGE.name}/{folder}/{file.name}"
        for folder, call in calls
        for file in sorted((PACKAGE / folder).glob("*.py"))
        if re.search(rf"{call}f?{written}", file.read_text(encoding="utf-8"))
    )


def see(*names: str) -> str:
    """Say in which files entries are to be mended."""
    files = dict.fromkeys(file for name in names for file in files_of(name))
    return f"see {' and '.join(files)}" if files else "no file prints it"


def see_case(name: str) -> str:
    """Say the same of one entry, and where a case of it goes if none is found."""
    folders = {Path(file).parent.name for file in files_of(name)}
    gathered = f"; cases are gathered in chr_notes/ledger/{name.partition('.')[0]}.py"
    return see(name) + (gathered if folders == {"printed"} else "")
