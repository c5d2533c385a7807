"""Conditions under which a statement is judged, and those that a document presumes in words."""

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import And, Basic, Or, false
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from chr_notes.ledger.rules import substitutions
from chr_notes.printed import BY_ID


@dataclass(frozen=True)
class Condition:
    """A condition under which a statement is claimed to hold.

    Parameters
    ----------
    holds
        The condition: what the reader sees, and what the proof is made under.
    """

    holds: Boolean

    def check(self) -> None:
        """Refuse a condition that says nothing, that cannot be met, or that no rule can state.

        Each case checks its own, so that the message names the entry.

        Raises
        ------
        ValueError
            Then.
        """
        if not isinstance(self.holds, Basic) or not self.holds.args:
            msg = f"expected a relation or several as condition, got {self.holds}"
            raise ValueError(msg)
        for relation in self.relations:
            if not isinstance(relation, Relational) or not relation.lhs.free_symbols:
                msg = f"expected relations with a quantity on the left, got {relation}"
                raise ValueError(msg)
        if any(self.holds.xreplace(dict(by)) == false for by in substitutions(self.holds)):
            msg = f"expected a condition that can be met, got {self.holds}"
            raise ValueError(msg)

    @property
    def relations(self) -> tuple[Basic, ...]:
        """All that it is made of, in whichever ways it may be met."""
        waiting, found = [self.holds], []
        while waiting:
            part = waiting.pop()
            if isinstance(part, And | Or):
                waiting += part.args
            else:
                found.append(part)
        return tuple(found)

    @property
    def by(self) -> tuple[Mapping[Basic, Basic], ...]:
        """Substitutions that reach all of it, one mapping a case, by `chr_notes.ledger.rules`."""
        return substitutions(self.holds)


@dataclass(frozen=True)
class Presumed:
    """What a document says that statements of it presume: a part of how it is read.

    Parameters
    ----------
    holds
        The condition.
    words
        The words that say so, as they stand in our account of a printed statement.
    says
        The id of that statement.
    by
        The ids of the statements that presume it: this one itself, if no other is named.
    """

    holds: Condition
    words: str
    says: str
    by: tuple[str, ...] = ()

    @property
    def presuming(self) -> tuple[str, ...]:
        """The ids of the statements that are judged under the condition."""
        return self.by or (self.says,)

    @property
    def is_said(self) -> bool:
        """Whether the words stand where they are said to."""
        return self.words != "" and self.words in BY_ID[self.says].says
