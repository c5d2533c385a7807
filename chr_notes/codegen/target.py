"""What a row of the table of generated functions holds."""

from collections.abc import Callable
from dataclasses import dataclass

from sympy import Expr, ImmutableMatrix, Symbol

from chr_notes.derivations.computation import Computation


@dataclass(frozen=True)
class Argument:
    """One scalar argument of a generated function.

    Parameters
    ----------
    name
        Its name in the generated code.
    symbol
        The symbol that it stands for in the derivation.
    says
        Meaning and unit.
    """

    name: str
    symbol: Symbol
    says: str


Array = tuple[str, tuple[Argument, ...]]
"""Name and elements of an array that a function of arrays takes."""


@dataclass(frozen=True)
class Target:
    """One generated function.

    Parameters
    ----------
    topic
        The stem of the file that it stands in.
    name
        Its name, `target_from_source`.
    says
        What it returns.
    formula
        Gives the derived formula: a scalar, a matrix returned row by row, or a computation of one
        of these.
    entries
        Ids of the ledger entries that state it; empty where the documents do not have it.
    arrays
        What a function of arrays takes, which NumPy and the kernels have then: one element, a
        vector, or a matrix row by row. Empty where nobody needs it for arrays.
    arguments
        Its scalar arguments in order; with none given, the elements of the arrays.
    over_samples
        Whether the first of them is a state and the others samples that change it one by one:
        the step of a filter.
    """

    topic: str
    name: str
    says: str
    formula: Callable[[], Expr | ImmutableMatrix | Computation]
    entries: tuple[str, ...] = ()
    arrays: tuple[Array, ...] = ()
    arguments: tuple[Argument, ...] = ()
    over_samples: bool = False

    def __post_init__(self) -> None:
        """Take the arguments from the arrays, where these have all of them."""
        elements = (element for _, each in self.arrays for element in each)
        object.__setattr__(self, "arguments", self.arguments or tuple(elements))

    def computation(self) -> Computation:
        """Give the formula as a computation, which may have no steps."""
        formula = self.formula()
        return formula if isinstance(formula, Computation) else Computation((), formula)
