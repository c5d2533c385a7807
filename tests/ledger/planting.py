"""A ledger in which one statement is misprinted."""

import importlib
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path

from sympy import Basic

from chr_notes import ledger, printed
from chr_notes.ledger.case import Case
from chr_notes.ledger.cases import CASES

LEDGER = Path(ledger.__file__).parent


@contextmanager
def planted(name: str, wrong: Basic) -> Iterator[Mapping[str, Case]]:
    """Print something else under an id, and give the cases that the document then brings."""
    before = printed.BY_ID[name]
    document = before.document
    statements = printed.DOCUMENTS[document]
    misprinted = replace(before, statement=wrong)
    topic = f"chr_notes.ledger.{document}"
    modules = {key: sys.modules[key] for key in sys.modules if key.startswith(topic)}
    printed.BY_ID[name] = misprinted
    printed.DOCUMENTS[document] = tuple(
        misprinted if each.id == name else each for each in statements
    )
    try:
        if name not in _looked_up(document):
            # Only its own case sees what is printed.
            yield CASES
            return
        for key in modules:
            del sys.modules[key]
        cases = importlib.import_module(topic).CASES
        yield {case.id: case for case in cases}
    finally:
        printed.BY_ID[name] = before
        printed.DOCUMENTS[document] = statements
        sys.modules.update(modules)


@cache
def _looked_up(document: str) -> frozenset[str]:
    """Find the ids that the ledger's modules on a document name elsewhere than for their case."""
    ids = rf'"({document}\.[\w.]+)"'
    sources = (file.read_text(encoding="utf-8") for file in LEDGER.glob("*.py"))
    return frozenset(
        name
        for source in sources
        for name in re.findall(ids, re.sub(rf"Case\(\s*{ids}", "", source))
    )
