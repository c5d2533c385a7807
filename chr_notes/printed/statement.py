"""One printed statement, and the notation in which the documents write."""

from dataclasses import dataclass
from typing import Literal, Self

from sympy import Basic, Expr, Integer, MatrixExpr, Rational, Symbol
from sympy.core.symbol import Str
from sympy.logic.boolalg import Boolean
from sympy.matrices.expressions.matexpr import MatrixElement
from sympy.printing.latex import LatexPrinter

Kind = Literal["equation", "claim", "table cell"]


@dataclass(frozen=True)
class Printed:
    """What a document prints in one place.

    Parameters
    ----------
    id
        The entry's id; its first part names the document, its second the section.
    kind
        Equation, claim (a sentence of words) or table cell.
    says
        What it is, in our words.
    statement
        The mathematical statement as printed, unevaluated. Words are stated as the proposition
        that they assert.
    """

    id: str
    kind: Kind
    says: str
    statement: Boolean

    @property
    def document(self) -> str:
        """The topic's stem, which the id begins with."""
        return self.id.split(".")[0]


class Rotation(MatrixExpr):
    """A document's symbol for a rotation matrix: its two frames and its angles.

    It only stands for a matrix. Which one that is, the ledger's reading says.
    """

    def __new__(cls, source: str | Str, target: str | Str, *angles: Expr) -> Self:
        """Make the symbol R with the source frame below and the target frame above."""
        frames = (name if isinstance(name, Str) else Str(name) for name in (source, target))
        return super().__new__(cls, *frames, *angles)

    @property
    def shape(self) -> tuple[Integer, Integer]:
        """Three by three."""
        return Integer(3), Integer(3)

    @property
    def frames(self) -> tuple[str, str]:
        """Source and target, as printed."""
        return self.args[0].name, self.args[1].name

    @property
    def angles(self) -> tuple[Basic, ...]:
        """The angles in the order in which the document lists them."""
        return self.args[2:]

    def _entry(self, i: Basic, j: Basic, **_: object) -> MatrixElement:
        return MatrixElement(self, i, j)

    def _latex(self, printer: LatexPrinter) -> str:
        below, above = (name.replace("v", "v_") if len(name) > 1 else name for name in self.frames)
        angles = ", ".join(printer.doprint(angle) for angle in self.angles)
        return f"R_{{{below}}}^{{{above}}}" + (rf"\left({angles}\right)" if angles else "")


class Approximately(Boolean):
    """A quantity given by a number, which is right if it differs by half its last digit at most."""

    def __new__(cls, quantity: Basic, number: str | Str) -> Self:
        """Say that a quantity is about a number.

        Parameters
        ----------
        quantity
            What the number is given for.
        number
            The number as printed, such as `"0.017"` or `"220 e 3"`.
        """
        return super().__new__(cls, quantity, number if isinstance(number, Str) else Str(number))

    @property
    def lhs(self) -> Basic:
        """The quantity."""
        return self.args[0]

    @property
    def rhs(self) -> Rational:
        """The number."""
        mantissa, _, exponent = self.args[1].name.partition("e")
        return Rational(mantissa.strip()) * Integer(10) ** int(exponent or 0)

    @property
    def unit(self) -> Rational:
        """One unit in the last printed digit."""
        mantissa, _, exponent = self.args[1].name.partition("e")
        decimals = len(mantissa.strip().partition(".")[2])
        return Integer(10) ** (int(exponent or 0) - decimals)

    @property
    def number(self) -> str:
        """The number as LaTeX."""
        mantissa, _, exponent = self.args[1].name.partition("e")
        power = rf" \times 10^{{{exponent.strip()}}}" if exponent else ""
        return f"{mantissa.strip()}{power}"

    def _latex(self, printer: LatexPrinter) -> str:
        return rf"{printer.doprint(self.lhs)} \approx {self.number}"


def words(text: str) -> Symbol:
    """Make a symbol for a thing that a document names in words, typeset as text."""
    return Symbol(rf"\text{{{text}}}")
