"""Typesetting of checked objects: the only place where SymPy becomes LaTeX."""

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import (
    Add,
    And,
    Basic,
    Expr,
    Ge,
    Gt,
    Identity,
    Integer,
    Le,
    Lt,
    MatMul,
    MatrixBase,
    Mul,
    Or,
    Symbol,
    ZeroMatrix,
    atan2,
    fraction,
)
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.trigonometric import TrigonometricFunction
from sympy.matrices.expressions.matexpr import MatrixElement
from sympy.printing.latex import LatexPrinter
from sympy.printing.precedence import precedence_traditional

_SETTINGS = {
    "mat_str": "pmatrix",
    "mat_delim": "",
    "fold_func_brackets": True,
    "ln_notation": True,
    "inv_trig_style": "full",
}


class _Printer(LatexPrinter):
    """LaTeX as a textbook has it: indices from one, statements joined by 'and'."""

    def _needs_function_brackets(self, argument: Basic) -> bool:
        # A symbol needs none, nor a fraction, whose line holds it together.
        return not (argument.is_Symbol or fraction(argument)[1] != 1)

    def _print_Symbol(self, symbol: Symbol, style: str = "plain") -> str:  # noqa: N802 (SymPy's hook)
        # The letter that the text has: ε and not ϵ.
        return super()._print_Symbol(symbol, style).replace(r"\epsilon", r"\varepsilon")

    def _print_MatrixBase(self, matrix: MatrixBase) -> str:  # noqa: N802 (SymPy's hook)
        # A dot product is written as a row times a column, and is a number.
        return (
            self._print(matrix[0]) if matrix.shape == (1, 1) else super()._print_MatrixBase(matrix)
        )

    def _print_MatrixElement(self, element: MatrixElement) -> str:  # noqa: N802 (SymPy's hook)
        row, column = (
            self._print(index + 1 if isinstance(index, Integer) else index)
            for index in (element.i, element.j)
        )
        place = row if element.parent.shape[1] == 1 else row + column
        return rf"\left[{self._print(element.parent)}\right]_{{{place}}}"

    def _print_And(self, statement: And) -> str:  # noqa: N802 (SymPy's hook)
        chain = _chain(statement.args)
        if chain:
            return "".join(part if isinstance(part, str) else self._print(part) for part in chain)
        return r" \quad\text{and}\quad ".join(self._print(part) for part in statement.args)

    def _print_Add(self, total: Add, order: str | None = None) -> str:  # noqa: N802 (SymPy's hook)
        # As one writes by hand: a sum begins with a term that has no minus.
        flat = total.func(*_left_opened(total), evaluate=False)
        terms = self._as_ordered_terms(flat, order=order)
        first = next((term for term in terms if not _has_minus(term)), terms[0])
        written = ""
        for term in (first, *(term for term in terms if term is not first)):
            minus = _has_minus(term)
            size = -term if minus else term
            text = self._print(size)
            text = rf"\left({text}\right)" if self._needs_add_brackets(size) else text
            written += f" {'-' if minus else '+'} {text}"
        return written.removeprefix(" + ").removeprefix(" ")

    def _print_AppliedUndef(self, call: AppliedUndef) -> str:  # noqa: N802 (SymPy's hook)
        arguments = ", ".join(self._print(argument) for argument in call.args)
        return rf"{self._print(Symbol(call.func.__name__))}\left({arguments}\right)"

    def _print_Or(self, statement: Or) -> str:  # noqa: N802 (SymPy's hook)
        return r" \quad\text{or}\quad ".join(self._print(part) for part in statement.args)

    def _print_ZeroMatrix(self, _: ZeroMatrix) -> str:  # noqa: N802 (SymPy's hook)
        return "0"

    def _print_Identity(self, _: Identity) -> str:  # noqa: N802 (SymPy's hook)
        return "1"

    def _print_MatMul(self, product: MatMul) -> str:  # noqa: N802 (SymPy's hook)
        # A number needs no brackets, be it a fraction.
        first, *others = product.args
        if first.is_Rational and first > 0 and others:
            return f"{self._print(first)} {self._print(MatMul(*others, evaluate=False))}"
        # As SymPy does it, which looks for a minus by working the product out, inverses included.
        minus = first.is_Number and first.is_negative
        factors = others if first == -1 else [-first if minus else first, *others]
        level = precedence_traditional(product)
        texts = [
            self._print(each)
            if isinstance(each, Mul) and not isinstance(each, MatMul)
            else self.parenthesize(each, level)
            for each in factors
        ]
        return f"{'- ' if minus else ''}{' '.join(texts)}"

    def _print_atan2(self, angle: atan2) -> str:
        arguments = ", ".join(self._print(argument) for argument in angle.args)
        return rf"\mathrm{{atan2}}\left({arguments}\right)"


class _AsWritten(_Printer):
    """The same, but terms and factors stay where the object has them."""

    def __init__(self) -> None:
        super().__init__({**_SETTINGS, "order": "none"})

    def _print_Add(self, total: Add, order: str | None = None) -> str:  # noqa: ARG002, N802
        written = ""
        for term in _left_opened(total):
            minus, size = _sign(term)
            text = self._print(size)
            text = rf"\left({text}\right)" if self._needs_add_brackets(size) else text
            written += f" {'-' if minus else '+'} {text}"
        return written.removeprefix(" + ").removeprefix(" ")

    def _print_Mul(self, product: Expr) -> str:  # noqa: N802 (SymPy's hook, for 1/x as well)
        minus, size = _sign(product)
        above, below = [], []
        for factor in _left_opened(size) if size.is_Mul else (size,):
            if factor.is_Pow and factor.exp.is_negative and factor.exp.is_Number:
                below.append(factor.base**-factor.exp)
            else:
                above.append(factor)
        text = self._factors(above)
        text = rf"\frac{{{text or '1'}}}{{{self._factors(below)}}}" if below else text
        return f"- {text}" if minus else text

    def _print_MatMul(self, product: MatMul) -> str:  # noqa: N802 (SymPy's hook)
        *factors, last = product.args
        if not (last.is_Pow and last.exp == -1):
            return str(super()._print_MatMul(product))
        minus = factors[0] == -1
        above = self._print(MatMul(*factors[minus:]) if len(factors) > 1 + minus else factors[-1])
        return rf"{'- ' if minus else ''}\frac{{{above}}}{{{self._print(last.base)}}}"

    def _factors(self, factors: list[Expr]) -> str:
        texts = [
            rf"\left({self._print(factor)}\right)"
            if len(factors) > 1 and (factor.is_Add or _sign(factor)[0])
            else self._print(factor)
            for factor in factors
        ]
        return " ".join(texts)


def _left_opened(whole: Expr) -> tuple[Expr, ...]:
    """Take a sum or product as one reads it: Python makes of a + b + c the sum of a + b and c."""
    first, *others = whole.args
    return (*_left_opened(first), *others) if first.func == whole.func else whole.args


def _has_minus(term: Expr) -> bool:
    """Whether a term is written with a minus; that of a matrix is in its first factor."""
    number = term.args[0] if isinstance(term, MatMul) else term
    return bool(number.could_extract_minus_sign())


def _sign(term: Expr) -> tuple[bool, Expr]:
    """Take the minus in front of a product off."""
    if not term.is_Mul:
        return False, term
    first, *others = _left_opened(term)
    if not first.is_negative or not first.is_Number:
        return False, term
    rest = others if first == -1 else [-first, *others]
    return True, rest[0] if len(rest) == 1 else term.func(*rest, evaluate=False)


def _chain(relations: tuple[Basic, ...]) -> list[Basic | str]:
    """Order inequalities as in `0 < a < b`, or give nothing if they make no such chain."""
    if not all(isinstance(relation, Gt | Ge | Lt | Le) for relation in relations):
        return []
    signs = {each.lts: "<" if isinstance(each, Gt | Lt) else r"\leq" for each in relations}
    next_one = {each.lts: each.gts for each in relations}
    starts = set(next_one) - set(next_one.values())
    if len(next_one) != len(relations) or len(starts) != 1:
        return []
    here = starts.pop()
    chain: list[Basic | str] = [here]
    while here in next_one:
        chain += [f" {signs[here]} ", next_one[here]]
        here = next_one.pop(here)
    return [] if next_one else chain


def latex(expression: Basic | MatrixBase, *, as_written: bool = False) -> str:
    """Typeset a SymPy object.

    Parameters
    ----------
    expression
        Expression, matrix or statement.
    as_written
        Whether the terms of sums and the factors of products stay in the order that the object
        has them in, as those of a printed formula must; else they come in SymPy's.

    Returns
    -------
    str
        LaTeX without delimiters, with the commands of the AMS packages.
    """
    printer = _AsWritten() if as_written else _Printer(_SETTINGS)
    return str(printer.doprint(expression))


@dataclass(frozen=True)
class Formula:
    """A typeset formula that a notebook cell can show."""

    latex: str

    def __repr__(self) -> str:
        """Give the LaTeX source, where nothing can be typeset."""
        return self.latex

    def _repr_markdown_(self) -> str:
        return f"$$\n{self.latex}\n$$"


def formula(
    left: Basic | MatrixBase, right: Basic | MatrixBase, angles: Sequence[Symbol] = ()
) -> Formula:
    """Show `left = right` in a notebook, typeset from the objects themselves.

    Parameters
    ----------
    left, right
        The two sides.
    angles
        In which order their sines and cosines are to stand in each product; else in SymPy's.
    """

    def ordered(product: Expr) -> Expr:
        numbers = [factor for factor in product.args if factor.is_Number]
        others = [factor for factor in product.args if not factor.is_Number]
        others.sort(key=lambda factor: [not factor.has(angle) for angle in angles])
        return Mul(*numbers, *others, evaluate=False)

    if not angles:
        return Formula(f"{latex(left)} = {latex(right)}")
    right = right.replace(lambda each: each.is_Mul and each.has(TrigonometricFunction), ordered)
    return Formula(f"{latex(left)} = {latex(right, as_written=True)}")
