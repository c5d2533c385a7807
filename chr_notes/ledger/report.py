"""The ledger on the command line: a table for people, JSON for programs, and its refreshing."""

import dataclasses
import json
import sys
import textwrap
from collections import Counter
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from importlib import import_module, metadata
from multiprocessing import active_children

from chr_notes._signals import hear_nothing, held_back
from chr_notes.ledger import stored
from chr_notes.ledger.entry import Entry

NARROWEST = 20
"""Columns that words want: below them they go below, or over the edge."""


def run(
    document: str | None = None,
    verdict: str | None = None,
    *,
    as_json: bool = False,
    width: int | None = None,
) -> None:
    """Print stored entries on standard output.

    Parameters
    ----------
    document
        Only the entries of this document, by its topic, such as `"euler"`.
    verdict
        Only the entries with this verdict.
    as_json
        Print a list of objects instead of a table.
    width
        Columns of the screen, if one reads there; otherwise an entry is a line, however long.

    Raises
    ------
    StaleError
        If the stored verdicts are out of date.
    """
    rows = [
        entry
        for topic in stored.DOCUMENTS
        if document in (None, topic)
        for entry in stored.read(topic)
        if verdict in (None, entry.verdict)
    ]
    sys.stdout.write(as_list(rows) if as_json else as_text(rows, width))


def refresh(document: str | None = None) -> int:
    """Judge the documents whose stored verdicts are out of date, and store them.

    Returns
    -------
    int
        Exit code: 1 if a case cannot be judged, else 0.
    """
    topics = [t for t in stored.DOCUMENTS if document in (None, t) and stored.is_stale(t)]
    # Taken before: what is changed while it judges is judged again.
    sources = {topic: stored.stamp(topic) for topic in topics}
    if not topics:
        sys.stdout.write("nothing is out of date\n")
    failed = False
    for topic, (entries, errors) in zip(topics, _judged(topics), strict=True):
        failed = failed or bool(errors)
        sys.stderr.writelines(f"{error}\n" for error in errors)
        if not errors:
            stored.write(topic, entries, sources[topic])
            sys.stderr.write(f"{topic}: {len(entries)} entries stored\n")
    return int(failed)


def check(document: str | None = None) -> int:
    """Judge everything again and compare with what is stored.

    Returns
    -------
    int
        Exit code: 1 if anything differs, else 0.
    """
    topics = [topic for topic in stored.DOCUMENTS if document in (None, topic)]
    count = 0
    differing: list[str] = []
    for topic, (entries, errors) in zip(topics, _judged(topics), strict=True):
        differing += errors
        if stored.is_stale(topic):
            differing.append(f"{topic}: the stored verdicts are out of date; {stored.REFRESH}")
            continue
        before = {entry.id: entry for entry in stored.read(topic)}
        now = {entry.id: entry for entry in entries}
        changed = sorted(n for n in before.keys() | now.keys() if before.get(n) != now.get(n))
        count += len(entries)
        differing += [f"{name}: judged otherwise than stored" for name in changed if not errors]
        if differing and stored.judged_with(topic) != metadata.version("sympy"):
            differing.append(f"{topic}: stored with SymPy {stored.judged_with(topic)}")
    sys.stderr.writelines(f"{line}\n" for line in differing)
    if not differing:
        sys.stdout.write(f"{count} entries judged again: each as stored\n")
    return int(bool(differing))


def as_list(entries: Iterable[Entry]) -> str:
    """Write entries as a JSON list; each field is a string, an object, a list or null."""
    rows = [dataclasses.asdict(each) for each in entries]
    return json.dumps(rows, indent=1) + "\n"  # in ASCII, which every console and program reads


def as_text(entries: Iterable[Entry], width: int | None = None) -> str:
    """Write entries as a table, with the counts of verdicts and of the errors behind them below."""
    rows = list(entries)
    name = max((len(row.id) for row in rows), default=0)
    lines = [line for row in rows for line in _told(row, name, width)]
    counts = Counter(row.verdict for row in rows)
    total = ", ".join(f"{number} {verdict}" for verdict, number in counts.most_common())
    errors = Counter(row.root for row in rows if row.root is not None)
    if errors:
        total += f"; {errors.total()} places of {len(errors)} errors"
    summary = f"{len(rows)} entries: {total}" if rows else "no entries"
    lines += [""] if rows else []
    lines += [summary] if width is None else textwrap.wrap(summary, max(width, NARROWEST))
    return "\n".join(lines) + "\n"


def _told(row: Entry, name: int, width: int | None) -> list[str]:
    """Write one entry: its words beside the names, and below where too little room is beside."""
    head = f"{row.id:{name}}  {row.verdict:10}  "
    if width is None:
        return [head + row.says]
    if width < len(head) + NARROWEST:
        below = textwrap.wrap(row.says, max(width - 2, NARROWEST))
        return [f"{row.id}  {row.verdict}", *(f"  {line}" for line in below)]
    first, *others = textwrap.wrap(row.says, width - len(head))
    return [head + first, *(" " * len(head) + line for line in others)]


def _judged(topics: list[str]) -> Iterator[tuple[list[Entry], list[str]]]:
    """Judge documents side by side: for each the entries, and what cannot be judged."""
    if len(topics) < 2:  # noqa: PLR2004 (one needs no other process)
        yield from map(judged, topics)
        return
    sys.stderr.write(f"judging {', '.join(topics)}: a minute or so\n")
    with ProcessPoolExecutor(initializer=hear_nothing) as processes:
        try:
            with held_back():
                waiting = [(topic, processes.submit(judged, topic)) for topic in topics]
            for topic, each in waiting:
                found = each.result()
                sys.stderr.write(f"{topic}: judged\n")
                yield found
        except BaseException:  # a statement takes long, and nobody waits for it any more
            for process in active_children():
                process.kill()
            raise


def judged(document: str) -> tuple[list[Entry], list[str]]:
    """Judge a document: its entries, and a line for all that keeps a case from being judged."""
    # Only here the ledger wants SymPy and all that is printed and derived.
    from chr_notes.ledger.case import CannotJudgeError  # noqa: PLC0415
    from chr_notes.ledger.judgement import faults, judge  # noqa: PLC0415

    try:
        # Alone: what is wrong with another document is told there.
        cases = import_module(f"chr_notes.ledger.{document}").CASES
    except CannotJudgeError as error:  # of what was brought, parts do not go together
        return [], str(error).splitlines()
    entries: list[Entry] = []
    errors: list[str] = []
    for case in cases:
        try:
            entries.append(judge(case))
        except CannotJudgeError:
            errors += faults(case)
    return entries, errors
