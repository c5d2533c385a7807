"""A derivation told step by step: words, and the statement that they lead to."""

from dataclasses import dataclass

from sympy import Basic, Eq
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


def equation(left: Basic, right: Basic) -> Eq:
    """Say that two sides are equal. SymPy does not compare them at once, as `Eq` alone does."""
    return Eq(left, right, evaluate=False)
