"""The ledger: every printed statement with a verdict that was computed."""

from functools import cache

from chr_notes.derivations.steps import Step
from chr_notes.ledger import dead_reckoning, estimation, euler, quaternions, sensors, validation
from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.entry import Entry, Verdict, Witness
from chr_notes.ledger.judgement import judge

TOPICS = (euler, quaternions, sensors, estimation, dead_reckoning, validation)
CASES: dict[str, Case] = {case.printed.id: case for topic in TOPICS for case in topic.CASES}


@cache
def entry(name: str) -> Entry:
    """Judge one entry.

    Parameters
    ----------
    name
        Its id, for example `"euler.5.5"`.

    Raises
    ------
    KeyError
        If no document prints anything under that id.
    """
    if name not in CASES:
        msg = f"expected the id of an entry, such as {next(iter(CASES))!r}, got {name!r}"
        raise KeyError(msg)
    return judge(CASES[name])


def entries() -> tuple[Entry, ...]:
    """Judge all entries, in the order in which the documents print them."""
    return tuple(entry(name) for name in CASES)


__all__ = [
    "CASES",
    "CannotJudgeError",
    "Case",
    "Entry",
    "Step",
    "Verdict",
    "Witness",
    "entries",
    "entry",
]
