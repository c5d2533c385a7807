"""One printed statement, and the notation in which the documents write."""

from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Literal, Self, cast

from sympy import And, Basic, Eq, Equality, Expr, Integer, MatrixExpr, Rational, Symbol, evaluate
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
    place
        Where it stands, section and paragraph. A paragraph counts from the section's heading, or
        from the numbered equation before it, and goes on through the formulas within it.
    says
        What it is, in our words.
    statement
        The mathematical statement as printed: unevaluated, its terms, factors and relations in
        the document's own order. Words are stated as the proposition that they assert.
    """

    id: str
    kind: Kind
    place: str
    says: str
    statement: Boolean

    @property
    def document(self) -> str:
        """The topic's stem, which the id begins with."""
        return self.id.split(".")[0]


def as_printed() -> AbstractContextManager[None]:
    """Let SymPy leave terms and factors where they are written, in formulas built within."""
    return cast("AbstractContextManager[None]", evaluate(x=False))


class InOrder(And):
    """Statements that all hold, in the order in which the document makes them.

    `And` sorts what it joins.
    """

    def __new__(cls, *statements: Boolean) -> Self:
        """Join statements and leave them where they stand."""
        joined = Basic.__new__(cls, *statements)
        joined._argset = frozenset(statements)  # noqa: SLF001 (what And looks its parts up in)
        return joined

    def _latex(self, printer: LatexPrinter) -> str:
        return r" \quad\text{and}\quad ".join(printer.doprint(part) for part in self.args)


class Leads(InOrder):
    """Statements of which each leads to the next."""

    def _latex(self, printer: LatexPrinter) -> str:
        return r" \quad\Rightarrow\quad ".join(printer.doprint(part) for part in self.args)


class Chain(InOrder):
    """A chain of equalities, `a = b = c`: the equations `a = b` and `a = c`."""

    def _latex(self, printer: LatexPrinter) -> str:
        first, *others = self.args
        # The further signs have nothing on their left, so that a page can break lines there.
        ends = (rf" {{}}= {printer.doprint(part.rhs)}" for part in others)
        return f"{printer.doprint(first.lhs)} = {printer.doprint(first.rhs)}{''.join(ends)}"


def chain(first: Basic, *others: Basic) -> Chain:
    """Print a quantity as equal to several others, one after the other."""
    return Chain(*(Eq(first, other, evaluate=False) for other in others))


class Nearly(Equality):
    """An equation that the document gives as an approximation; judged as an equation."""

    def _latex(self, printer: LatexPrinter) -> str:
        return rf"{printer.doprint(self.lhs)} \approx {printer.doprint(self.rhs)}"


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
