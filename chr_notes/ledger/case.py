"""What is brought before the judgement with one printed statement."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from sympy import Basic
from sympy.logic.boolalg import Boolean

from chr_notes.derivations.steps import Step
from chr_notes.printed.statement import Printed

Read = Callable[[Basic], Basic]


class CannotJudgeError(Exception):
    """A statement is neither proved nor shown to fail with what was brought before it."""


@dataclass(frozen=True)
class Condition:
    """A condition under which a statement is claimed to hold.

    Parameters
    ----------
    holds
        The condition, for the reader and for the check that the witness lies outside it.
    by
        Substitutions that state it, one mapping a case; the statement must hold in all of them.
        An inequality `Ne` needs none: it is proved where a component of the difference is the
        difference that the condition excludes.
    """

    holds: Boolean
    by: tuple[Mapping[Basic, Basic], ...] = ({},)


@dataclass(frozen=True)
class Reading:
    """One of several ways to read a document that contradicts itself.

    Parameters
    ----------
    convention
        What this way of reading presumes.
    read
        The meaning of the document's symbols then.
    point
        Values at which a statement that does not hold under this reading fails.
    """

    convention: Boolean
    read: Read
    point: Mapping[Basic, Basic]


@dataclass(frozen=True)
class Case:
    """A printed statement with all that is needed to judge it; the verdict is computed.

    Parameters
    ----------
    printed
        What the document prints.
    read
        Replaces the document's symbols by the derived quantities that they name, unevaluated.
    given
        What the document itself, or the convention, presumes: the range of an angle, a gain
        between 0 and 1. Everything is judged within it, the witness included.
    condition
        For a statement that holds only under it.
    correction
        For a wrong statement: the right one, in the document's notation.
    witness
        Values at which the statement fails, angles in radians.
    readings
        For statements that contradict one another: the readings under which some of them hold.
    steps
        The derivation of the right form or of the condition.
    remark
        Markdown for the reader.
    """

    printed: Printed
    read: Read
    given: tuple[Condition, ...] = ()
    condition: Condition | None = None
    correction: Boolean | None = None
    witness: Mapping[Basic, Basic] = field(default_factory=dict)
    readings: tuple[Reading, ...] = ()
    steps: tuple[Step, ...] = ()
    remark: str | None = None


def complete(
    printed: tuple[Printed, ...], read: Read, settled: tuple[Case, ...]
) -> tuple[Case, ...]:
    """List the cases of a document in printed order, those that need nothing brought included.

    Parameters
    ----------
    printed
        All statements of the document.
    read
        The reading for the statements that are not in `settled`.
    settled
        Cases with a condition, a correction, or a reading of their own.
    """
    by_id = {case.printed.id: case for case in settled}
    return tuple(by_id.get(statement.id, Case(statement, read)) for statement in printed)
