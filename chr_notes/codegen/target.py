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


@dataclass(frozen=True)
class Target:
    """One generated function.

    Parameters
    ----------
    name
        Its name, `target_from_source`.
    topic
        The stem of the file that it stands in.
    says
        What it returns.
    arguments
        Its scalar arguments in order.
    formula
        Gives the derived formula: a scalar, a matrix returned row by row, or a computation of one
        of these.
    entries
        Ids of the ledger entries that state it; empty where the documents do not have it.
    """

    name: str
    topic: str
    says: str
    arguments: tuple[Argument, ...]
    formula: Callable[[], Expr | ImmutableMatrix | Computation]
    entries: tuple[str, ...] = ()

    @property
    def complex(self) -> bool:
        """Whether it takes pairs of numbers as complex ones; it is made for NumPy alone then."""
        return not all(argument.symbol.is_real for argument in self.arguments)
