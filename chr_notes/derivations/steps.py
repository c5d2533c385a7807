"""A derivation told step by step: words, and the statement that they lead to."""

from dataclasses import dataclass

from sympy.logic.boolalg import Boolean


@dataclass(frozen=True)
class Step:
    """One step of a derivation.

    Parameters
    ----------
    says
        What is done and why, one or two sentences of Markdown.
    statement
        What holds after it, as a SymPy relation. A test proves each one.
    """

    says: str
    statement: Boolean
