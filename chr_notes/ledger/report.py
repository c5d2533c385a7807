"""The ledger on the command line: a table for people, JSON for programs."""

import dataclasses
import json
import sys
from collections import Counter
from collections.abc import Iterable, Iterator

from chr_notes.ledger import CASES, Entry, entry

_BAR = 30


def run(document: str | None = None, verdict: str | None = None, *, as_json: bool = False) -> int:
    """Judge entries, with a bar on standard error, and print them on standard output.

    Parameters
    ----------
    document
        Only the entries of this document, by its topic, such as `"euler"`.
    verdict
        Only the entries with this verdict.
    as_json
        Print a list of objects instead of a table.

    Returns
    -------
    int
        Exit code: 2 if there is no such document, else 0.
    """
    documents = sorted({case.printed.document for case in CASES.values()})
    if document is not None and document not in documents:
        sys.stderr.write(f"expected one of {', '.join(documents)}, got {document!r}\n")
        return 2
    names = [name for name, case in CASES.items() if document in (None, case.printed.document)]
    judged = [each for each in _with_bar(names) if verdict in (None, each.verdict)]
    sys.stdout.write(as_text(judged) if not as_json else as_list(judged))
    return 0


def as_list(entries: Iterable[Entry]) -> str:
    """Write entries as a JSON list; each field is a string, an object, a list or null."""
    rows = [dataclasses.asdict(each) for each in entries]
    return json.dumps(rows, indent=1, ensure_ascii=False) + "\n"


def as_text(entries: Iterable[Entry]) -> str:
    """Write entries as a table, with the counts of the verdicts below."""
    rows = list(entries)
    width = max((len(row.id) for row in rows), default=0)
    lines = [f"{row.id:{width}}  {row.verdict:10}  {row.says}" for row in rows]
    counts = Counter(row.verdict for row in rows)
    total = ", ".join(f"{number} {verdict}" for verdict, number in counts.most_common())
    return "\n".join([*lines, "", f"{len(rows)} entries: {total}" if rows else "no entries"]) + "\n"


def _with_bar(names: list[str]) -> Iterator[Entry]:
    """Judge one by one and say how far it is; a file gets no bar, only the result."""
    shown = sys.stderr.isatty()
    for done, name in enumerate(names, 1):
        yield entry(name)
        if shown:
            full = _BAR * done // len(names)
            bar = "#" * full + "." * (_BAR - full)
            sys.stderr.write(f"\r[{bar}] {done}/{len(names)} {name:45}")
    if shown:
        sys.stderr.write("\r" + " " * (_BAR + 60) + "\r")
