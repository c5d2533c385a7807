"""A document that prints what a test wants judged."""

import pytest
from sympy import (
    Basic,
)

from chr_notes import printed
from chr_notes.ledger import ties
from chr_notes.ledger.case import Case, complete
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.ledger.entry import Entry
from chr_notes.ledger.judgement import judge
from chr_notes.ledger.reading import Read
from chr_notes.ledger.roots import ROOTS
from chr_notes.printed import Printed

from .tried import READ, Say


@pytest.fixture
def say(monkeypatch: pytest.MonkeyPatch) -> Say:
    """Let a document print statements, and judge the first of them, or the one asked for."""
    # What is tried here is a place of any error, and any may mislead.
    monkeypatch.setattr(ties, "KNOWN_BY", dict.fromkeys(ties.KNOWN_BY, ".*"))
    monkeypatch.setattr(ties, "HARM", ROOTS)

    def judged(
        *statements: Basic,
        of: int = 1,
        read: Read = READ,
        given: tuple[Condition, ...] = (),
        unsaid: tuple[Condition, ...] = (),
        **brought: object,
    ) -> Entry:
        document = tuple(
            Printed(f"tried.1.{n}", "claim", "nowhere", "A statement.", statement)
            for n, statement in enumerate(statements, 1)
        )
        monkeypatch.setitem(printed.DOCUMENTS, "tried", document)
        for each in document:
            monkeypatch.setitem(printed.BY_ID, each.id, each)
        if given:
            said = tuple(Presumed(each, "A statement", f"tried.1.{of}") for each in given)
            read = Read(read.meaning, read.notation, presumed=said)
        case = Case(f"tried.1.{of}", given=unsaid, **brought)  # type: ignore[arg-type]
        return judge(complete(document, read, (case,))[of - 1])

    return judged
