"""Printer of expressions for languages with infix operators: the languages differ in tables."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sympy import (
    Abs,
    Add,
    Basic,
    Expr,
    Float,
    I,
    Integer,
    Mul,
    Pow,
    Rational,
    Symbol,
    acos,
    asin,
    atan,
    atan2,
    conjugate,
    cos,
    floor,
    im,
    re,
    sin,
    tan,
)
from sympy.codegen.cfunctions import hypot
from sympy.core.relational import Relational
from sympy.logic.boolalg import And, Not, Or

from chr_notes.derivations.computation import EPSILON, Choice, Remainder

FUNCTIONS = (Abs, acos, asin, atan, atan2, conjugate, cos, floor, hypot, im, re, sin, tan)
HALF = Rational(1, 2)
# How tightly an operator binds: what binds less than its surroundings is put in brackets.
OR, AND, COMPARE, SUM, PRODUCT, UNARY, ATOM = range(7)


@dataclass(frozen=True)
class Language:
    """What differs between languages with infix operators.

    Parameters
    ----------
    name
        Turns the name of an argument or local into the language's way of writing names.
    number
        Writes a number.
    call
        From the name of a SymPy function, and `sqrt`, to the name of the language's. Without
        `floor` the language divides by one and rounds down.
    remainder
        Format of what is left of {0} after whole multiples of {1}.
    epsilon
        Value of `EPSILON`.
    both, either, negation
        Logical operators.
    conditional
        Format of {yes} where {condition} holds, {no} elsewhere.
    """

    name: Callable[[str], str]
    number: Callable[[float], str]
    call: Mapping[str, str]
    remainder: str
    epsilon: float
    both: str
    either: str
    negation: str
    conditional: str


def infix(value: Basic, language: Language) -> str:
    """Print one expression."""
    return _print(value, language)[0]


def conditional(choice: Choice, language: Language) -> str | None:
    """Print the choice of one value in two ways; None for any other choice."""
    if len(choice.names) != 1 or len(choice.branches) != 2:  # noqa: PLR2004 (this way or that)
        return None
    (condition, (yes,)), (_, (no,)) = choice.branches
    parts = {"condition": condition, "yes": yes, "no": no}
    return language.conditional.format(
        **{name: infix(value, language) for name, value in parts.items()}
    )


def _print(value: Basic, language: Language) -> tuple[str, int]:
    """Print an expression and say how tightly its outermost operator binds."""
    if isinstance(value, Symbol) and value != EPSILON:
        return language.name(value.name), ATOM
    if value == I:
        return "1j", ATOM
    if not value.free_symbols - {EPSILON}:
        number = float(value.subs(EPSILON, Float(language.epsilon)))
        return language.number(number), UNARY if number < 0 else ATOM
    for kind, printer in PRINTERS.items():
        if isinstance(value, kind):
            return printer(value, language)
    msg = f"expected an expression of known functions, got {value}"
    raise TypeError(msg)


def _within(value: Basic, least: int, language: Language) -> str:
    text, binds = _print(value, language)
    return text if binds >= least else f"({text})"


def _ordered(value: Basic, least: int, language: Language) -> list[str]:
    return [
        _within(part, least, language)
        for part in sorted(value.args, key=lambda part: part.sort_key())
    ]


def split_sum(value: Add) -> list[tuple[bool, Expr]]:
    """Take a sum apart into (is subtracted, term), a term that is added first."""
    terms = value.as_ordered_terms()
    parts = [(True, -term) if term.could_extract_minus_sign() else (False, term) for term in terms]
    first = next((index for index, (minus, _) in enumerate(parts) if not minus), 0)
    return [parts[first], *parts[:first], *parts[first + 1 :]]


def split_product(value: Expr) -> tuple[Expr, list[Expr], list[Expr]]:
    """Take a product apart into its number, what multiplies and what divides."""
    coefficient, factors = value.as_coeff_mul()
    above, below = [], []
    constant = Mul(*(factor for factor in factors if factor.is_number))
    if constant != 1:
        # One number for all that is known, such as 2 pi; its sign stays apart.
        sign = -1 if coefficient.could_extract_minus_sign() else 1
        above, coefficient = [sign * coefficient * constant], Integer(sign)
        factors = [factor for factor in factors if not factor.is_number]
    for factor in sorted(factors, key=lambda factor: factor.sort_key()):
        if isinstance(factor, Pow) and factor.exp.could_extract_minus_sign():
            below.append(factor.base**-factor.exp)
        else:
            above.append(factor)
    return coefficient, above, below


def _sum(value: Add, language: Language) -> tuple[str, int]:
    (minus, first), *rest = split_sum(value)
    text = f"-{_within(first, UNARY, language)}" if minus else _within(first, SUM, language)
    for subtracted, term in rest:
        text += f" {'-' if subtracted else '+'} {_within(term, PRODUCT, language)}"
    return text, SUM


def _product(value: Mul, language: Language) -> tuple[str, int]:
    coefficient, above, below = split_product(value)
    sign = "-" if coefficient.could_extract_minus_sign() else ""
    coefficient = abs(coefficient)
    if isinstance(coefficient, Rational) and coefficient.q != 1 and coefficient != HALF:
        below = [Integer(coefficient.q), *below]
        coefficient = Integer(coefficient.p)
    if coefficient != 1 or not above:
        above = [coefficient, *above]
    text = " * ".join(_within(factor, UNARY, language) for factor in above)
    if below:
        divisor = below[0] if len(below) == 1 else Mul(*below, evaluate=False)
        text += f" / {_within(divisor, UNARY, language)}"
    return sign + text, UNARY if sign and len(above) == 1 and not below else PRODUCT


def _power(value: Pow, language: Language) -> tuple[str, int]:
    if value.exp == HALF:
        return f"{language.call['sqrt']}({_within(value.base, OR, language)})", ATOM
    if value.exp.could_extract_minus_sign():
        one = language.number(1.0)
        return f"{one} / {_within(value.base**-value.exp, UNARY, language)}", PRODUCT
    if isinstance(value.exp, Integer):
        base = _within(value.base, UNARY, language)
        return " * ".join([base] * int(value.exp)), PRODUCT
    if isinstance(value.exp, Rational) and value.exp.q == 2:  # noqa: PLR2004 (a root of a power)
        return f"{language.call['sqrt']}({_within(value.base**value.exp.p, OR, language)})", ATOM
    msg = f"expected whole and half powers, got {value}"
    raise TypeError(msg)


def _relation(value: Relational, language: Language) -> tuple[str, int]:
    left, right = (_within(side, SUM, language) for side in (value.lhs, value.rhs))
    return f"{left} {value.rel_op} {right}", COMPARE


def _both(value: And, language: Language) -> tuple[str, int]:
    return f" {language.both} ".join(_ordered(value, AND, language)), AND


def _either(value: Or, language: Language) -> tuple[str, int]:
    return f" {language.either} ".join(_ordered(value, OR, language)), OR


def _negation(value: Not, language: Language) -> tuple[str, int]:
    return f"{language.negation}{_within(value.args[0], ATOM, language)}", UNARY


def _remainder(value: Remainder, language: Language) -> tuple[str, int]:
    parts = [_within(argument, UNARY, language) for argument in value.args]
    return language.remainder.format(*parts), PRODUCT


def _floor(value: floor, language: Language) -> tuple[str, int]:
    if "floor" in language.call:
        return _call(value, language)
    # Python's own floor is an integer, so it refuses NaN.
    return f"{_within(value.args[0], UNARY, language)} // 1.0", PRODUCT


def _call(value: Expr, language: Language) -> tuple[str, int]:
    inner = ", ".join(_within(argument, OR, language) for argument in value.args)
    return f"{language.call[type(value).__name__]}({inner})", ATOM


PRINTERS: dict[type | tuple[type, ...], Callable[..., tuple[str, int]]] = {
    Add: _sum,
    Mul: _product,
    Pow: _power,
    Relational: _relation,
    And: _both,
    Or: _either,
    Not: _negation,
    Remainder: _remainder,
    floor: _floor,
    FUNCTIONS: _call,
}
