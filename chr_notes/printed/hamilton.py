"""The notation in which the quaternion note writes: products, inverse, conjugate, vectors.

These only stand for quaternions. Which ones they are, the ledger's reading says.
"""

from typing import Self

from sympy import Basic, Integer, MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement
from sympy.printing.latex import LatexPrinter


class QuaternionNotation(MatrixExpr):
    """A column of four, scalar first."""

    def __new__(cls, *parts: Basic) -> Self:
        """Make the notation of quaternions or vectors, which stay as they are."""
        return super().__new__(cls, *parts)

    @property
    def shape(self) -> tuple[Integer, Integer]:
        """Four by one."""
        return Integer(4), Integer(1)

    def _entry(self, i: Basic, j: Basic, **_: object) -> MatrixElement:
        return MatrixElement(self, i, j)


class Product(QuaternionNotation):
    """Quaternion product, in this order."""

    def _latex(self, printer: LatexPrinter) -> str:
        return r"\,".join(
            rf"\left({printer.doprint(part)}\right)"
            if isinstance(part, Product)
            else printer.doprint(part)
            for part in self.args
        )


class Reciprocal(QuaternionNotation):
    """The inverse of a quaternion."""

    def _latex(self, printer: LatexPrinter) -> str:
        return rf"\left({printer.doprint(self.args[0])}\right)^{{-1}}"


class Conjugate(QuaternionNotation):
    """A quaternion with its vector part negated."""

    def _latex(self, printer: LatexPrinter) -> str:
        return rf"\left({printer.doprint(self.args[0])}\right)^{{*}}"


class Pure(QuaternionNotation):
    """A vector as the quaternion with scalar part zero."""

    def _latex(self, printer: LatexPrinter) -> str:
        return rf"\begin{{pmatrix}} 0 \\ {printer.doprint(self.args[0])} \end{{pmatrix}}"
