"""A ledger in which one statement is misprinted."""

import importlib
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace

from sympy import Basic

from chr_notes import printed
from chr_notes.ledger.case import Case


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
    for key in modules:
        del sys.modules[key]
    try:
        cases = importlib.import_module(topic).CASES
        yield {case.id: case for case in cases}
    finally:
        printed.BY_ID[name] = before
        printed.DOCUMENTS[document] = statements
        sys.modules.update(modules)
