"""The ledger: every printed statement with a verdict that was computed.

The verdicts are stored, see `chr_notes.ledger.stored`; nothing here needs SymPy.
`chr_notes.ledger.cases` has what was brought, `chr_notes.ledger.judgement` reaches the verdicts.
"""

from functools import cache

from chr_notes.ledger import stored
from chr_notes.ledger.entry import Entry, Verdict, Weight, Witness
from chr_notes.ledger.stored import StaleError


def entries() -> tuple[Entry, ...]:
    """Return all entries, in the order in which the documents print them.

    Raises
    ------
    StaleError
        If the stored verdicts are not those of the present sources.
    """
    return tuple(entry for document in stored.DOCUMENTS for entry in stored.read(document))


@cache
def _by_id(document: str) -> dict[str, Entry]:
    known = document in stored.DOCUMENTS
    return {entry.id: entry for entry in stored.read(document)} if known else {}


def entry(name: str) -> Entry:
    """Return one entry.

    Parameters
    ----------
    name
        Its id, for example `"euler.5.5"`.

    Raises
    ------
    KeyError
        If no document prints anything under that id.
    StaleError
        If the stored verdicts are not those of the present sources.
    """
    found = _by_id(name.partition(".")[0])
    if name not in found:
        msg = f"expected the id of an entry, such as 'euler.5.5', got {name!r}"
        raise KeyError(msg)
    return found[name]


__all__ = ["Entry", "StaleError", "Verdict", "Weight", "Witness", "entries", "entry"]
