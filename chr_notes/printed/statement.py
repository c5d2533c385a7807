"""One printed statement, and the notation in which the documents write."""

from dataclasses import dataclass
from typing import Literal, Self

from sympy import Basic, Expr, Integer, MatrixExpr, Symbol
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


def words(text: str) -> Symbol:
    """Make a symbol for a thing that a document names in words, typeset as text."""
    return Symbol(rf"\text{{{text}}}")
