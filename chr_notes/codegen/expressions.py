"""Printers of expressions: SymPy's own for each language, with its spelling of a few things."""

from collections.abc import Callable, Mapping

from sympy import Add, Basic, Float, Integer, Mul, Pow, Symbol, UnevaluatedExpr
from sympy.codegen.ast import float32, float64, real
from sympy.core.relational import Relational
from sympy.logic.boolalg import And, Or
from sympy.printing.c import C99CodePrinter
from sympy.printing.codeprinter import CodePrinter
from sympy.printing.jscode import JavascriptCodePrinter
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter

from chr_notes.derivations.computation import EPSILON, LARGEST, NOTHING, Choice

TYPES = {"double": float64, "float": float32}


class Spelling(CodePrinter):
    """What SymPy's printers write in another way: numbers, names, and what is not a number.

    A number that the language would have to work out, such as `pi/2 - 8 epsilon`, is worked out
    before, and a power of a name is a product.
    """

    settings: Mapping[str, object] = {}
    precision = "double"
    nothing = "nan"

    def __init__(self) -> None:
        super().__init__(dict(self.settings))

    def written(self, value: Basic) -> str:
        """Print an expression."""
        of_type = TYPES[self.precision]
        constants = {EPSILON: Float(of_type.eps), LARGEST: Float(of_type.max)}
        return str(self.doprint(_prepared(value.xreplace(constants))))

    def chosen(self, condition: Basic, yes: str, no: str) -> str:
        """Write what is one value where a condition holds and another elsewhere."""
        return f"{self.written(condition)} ? {yes} : {no}"

    def conditional(self, choice: Choice, name: Symbol) -> str:
        """Write one of the values of a choice as one expression."""
        place = choice.names.index(name)
        *branches, (_, values) = choice.branches
        text = self.written(values[place])
        for condition, values in reversed(branches):
            text = self.chosen(condition, self.written(values[place]), text)
        return text

    def _as_ordered_terms(self, value: Add, order: str | None = None) -> list[Basic]:
        """Begin a sum with a term that is not taken away, if one of its first two is such."""
        terms: list[Basic] = super()._as_ordered_terms(value, order=order)
        first, second, *rest = terms
        minus = first.could_extract_minus_sign() and not second.could_extract_minus_sign()
        return [second, first, *rest] if minus else terms

    def _print_Symbol(self, value: Symbol) -> str:
        return self.nothing if value == NOTHING else str(value.name)

    def number(self, value: Float | Integer) -> str:
        """Write a number with as many digits as it needs, and a point."""
        return repr(float(value))

    def _print_Float(self, value: Float | Integer) -> str:
        return self.number(value)

    _print_Integer = _print_One = _print_Zero = _print_NegativeOne = _print_Float

    def _print_Relational(self, value: Relational) -> str:
        return f"{self._print(value.lhs)} {value.rel_op} {self._print(value.rhs)}"

    def _print_Pow(self, value: Pow, rational: bool = False) -> str:  # noqa: ARG002, FBT001, FBT002
        if value.exp.is_negative:
            return f"{self._print(Integer(1))}/{self.parenthesize(1 / value, PRECEDENCE['Pow'])}"
        return str(super()._print_Pow(value))


def _joined(sign: str) -> Callable[[Spelling, And | Or], str]:
    """Write a sign between conditions, and brackets about each: C compilers ask for some."""

    def printed(printer: Spelling, value: And | Or) -> str:
        parts = (printer.parenthesize(part, PRECEDENCE["Atom"]) for part in value.args)
        return f" {sign} ".join(parts)

    return printed


def _called(prefix: str) -> Callable[[Spelling, Basic], str]:
    """Write a function by its own name, after a prefix."""

    def printed(printer: Spelling, value: Basic) -> str:
        arguments = ", ".join(map(printer._print, value.args))  # noqa: SLF001 (SymPy's protocol)
        return f"{prefix}{type(value).__name__}({arguments})"

    return printed


def _prepared(value: Basic) -> Basic:
    """Work out every part that is a number but not whole, and write powers as products."""
    if value.is_number and not value.is_Integer:
        return Float(float(value), 17)
    if isinstance(value, Pow):
        base, exponent = _prepared(value.base), value.exp
        if isinstance(exponent, Integer) and abs(exponent) > 1:
            product = UnevaluatedExpr(Mul(*[base] * abs(exponent), evaluate=False))
            return product if exponent > 0 else 1 / product
        return Pow(base, exponent)
    known = [part for part in value.args if part.is_number]
    if isinstance(value, Add | Mul) and len(known) > 1:
        rest = [_prepared(part) for part in value.args if not part.is_number]
        return value.func(_prepared(value.func(*known)), *rest)
    return value.func(*map(_prepared, value.args)) if value.args else value


class C(Spelling, C99CodePrinter):
    """C in double precision."""

    suffix = ""
    """What the names of functions end in."""
    nothing = "(double)NAN"  # a float in math.h

    _print_Or = _joined("||")


class SingleC(C):
    """C in single precision."""

    settings: Mapping[str, object] = {"type_aliases": {real: float32}}
    precision = "float"
    suffix = "_f"
    nothing = "NAN"

    def number(self, value: Float | Integer) -> str:
        """Write a number that is not of type double."""
        return f"{super().number(value)}f"


class ColumnC(C):
    """C in a loop without branches, with the project's own functions of angles."""

    _print_sin = _print_cos = _print_atan2 = _print_principal = _called("column_")
    _print_And = _joined("&")


class StepC(ColumnC):
    """C in a loop over samples, where branches cost nothing."""

    _print_sin = _print_cos = _print_atan2 = _print_principal = _called("step_")
    _print_cos_of_root = _print_sinc_of_root = _print_sin
    _print_cos_of_share = _print_sin_of_share = _print_sin

    def _print_Add(self, value: Add, order: str | None = None) -> str:
        """Add up in pairs: fewer sums wait for others."""
        terms = self._as_ordered_terms(value, order=order)
        if len(terms) != 4:  # noqa: PLR2004
            return str(super()._print_Add(value, order=order))
        first, second = (Add(*terms[at : at + 2], evaluate=False) for at in (0, 2))
        return f"({self._print(first)}) + ({self._print(second)})"


class JavaScript(Spelling, JavascriptCodePrinter):
    """JavaScript."""

    nothing = "NaN"

    def number(self, value: Float | Integer) -> str:
        """Write a number, without a point where it is whole."""
        return super().number(value).removesuffix(".0")

    def _print_Symbol(self, value: Symbol) -> str:
        return camel(super()._print_Symbol(value))

    _print_hypot = _print_expm1 = _print_log1p = _called("Math.")


class Python(Spelling, PythonCodePrinter):
    """Python with `math`."""

    settings: Mapping[str, object] = {"fully_qualified_modules": False}

    def chosen(self, condition: Basic, yes: str, no: str) -> str:
        """Write what is one value where a condition holds and another elsewhere."""
        return f"{yes} if {self.written(condition)} else {no}"

    def _print_floor(self, value: Basic) -> str:
        # Python's own floor is an integer, so it refuses NaN.
        return f"(({self._print(value.args[0])}) // 1.0)"


class NumPy(Spelling, NumPyPrinter):
    """NumPy."""

    settings = Python.settings

    def chosen(self, condition: Basic, yes: str, no: str) -> str:
        """Write what is one value where a condition holds and another elsewhere."""
        return f"where({self.written(condition)}, {yes}, {no})"

    _print_principal = _print_products = _called("")
    _print_And, _print_Or = _joined("&"), _joined("|")


def camel(name: str) -> str:
    """Turn a name with underscores into JavaScript's way of writing names."""
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)
