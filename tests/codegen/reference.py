"""Values of the generated functions with 50 digits, straight from the derivations.

Nothing of lowering or printing is used: SymPy's expressions are walked and computed by mpmath, and
only constants are rounded to the type that computes, as they are in any language.
"""

import struct
import sys
from collections.abc import Callable
from functools import cache
from math import prod
from operator import itemgetter
from typing import Any

import mpmath
from sympy import Add, Basic, Expr, Float, MatrixBase, Mul, Pow, Rational, Symbol
from sympy.core.relational import Relational
from sympy.logic.boolalg import And, BooleanTrue, Not, Or

from chr_notes.codegen.target import Target
from chr_notes.derivations.computation import EPSILON, LARGEST, NOTHING, Choice, Let

MP = mpmath.mp.clone()
MP.dps = 50
NAN = MP.nan
Number = Any
computation_of = cache(Target.computation)


def single(value: float) -> float:
    """Round to single precision."""
    return float(struct.unpack("f", struct.pack("f", value))[0])


class Reference:
    """Computes targets.

    Parameters
    ----------
    rounded
        Rounds a constant to the type that computes.
    epsilon
        Distance from 1 to the next number of that type.
    largest
        Its largest number.
    """

    def __init__(self, rounded: Callable[[float], float], epsilon: float, largest: float) -> None:
        self.rounded = rounded
        self.epsilon = epsilon
        self.largest = largest
        self.ways: dict[Basic, Callable[[dict[Symbol, Number]], Number]] = {}

    def results(self, target: Target, values: tuple[float, ...]) -> list[Number]:
        """Compute the elements of the result, and after them the flag if there is one."""
        computation = computation_of(target)
        known: dict[Symbol, Number] = {
            argument.symbol: MP.mpf(value)
            for argument, value in zip(target.arguments, values, strict=True)
        }
        known |= {LARGEST: MP.mpf(self.largest), NOTHING: NAN}
        for step in computation.steps:
            if isinstance(step, Let):
                known[step.name] = self.value(step.value, known)
            else:
                known |= self.choose(step, known)
        elements = computation.results
        elements = list(elements) if isinstance(elements, MatrixBase) else [elements]
        flag = [known[computation.flag]] if computation.flag is not None else []
        return [*(self.value(element, known) for element in elements), *flag]

    def choose(self, choice: Choice, known: dict[Symbol, Number]) -> dict[Symbol, Number]:
        """Compute the first branch whose condition holds."""
        for condition, values in choice.branches:
            if self.value(condition, known):
                pairs = zip(choice.names, values, strict=True)
                return {name: self.value(value, known) for name, value in pairs}
        msg = f"expected a branch that holds, got {choice}"
        raise AssertionError(msg)

    def value(self, expression: Basic, known: dict[Symbol, Number]) -> Number:
        """Compute one expression."""
        way = self.ways.get(expression)
        if way is None:
            way = self.ways[expression] = self.way(expression)
        return way(known)

    def way(self, expression: Basic) -> Callable[[dict[Symbol, Number]], Number]:
        """Look once how an expression is computed."""
        if isinstance(expression, Symbol) and expression != EPSILON:
            return itemgetter(expression)
        if isinstance(expression, BooleanTrue):
            return lambda _: True
        if _is_constant(expression):
            constant = self.constant(expression)
            return lambda _: constant
        operation = OPERATIONS[_kind(expression)]
        ways = [self.way(argument) for argument in expression.args]
        return lambda known: operation(expression, [way(known) for way in ways])

    def constant(self, expression: Basic) -> Number:
        """Compute an expression without symbols, rounded as the type that computes does."""
        constant = expression.subs(EPSILON, Float(self.epsilon, 30))
        if isinstance(constant, Rational):
            return MP.mpf(constant.p) / constant.q
        return MP.mpf(self.rounded(float(constant)))


@cache
def _is_constant(expression: Basic) -> bool:
    return isinstance(expression, Expr) and not expression.free_symbols - {EPSILON}


@cache
def _kind(expression: Basic) -> str:
    for kind in (Add, Mul, Pow, Relational, And, Or, Not):
        if isinstance(expression, kind):
            return kind.__name__
    return type(expression).__name__


def _power(_: Basic, parts: list[Number]) -> Number:
    base, exponent = parts
    if MP.isnan(base):
        return NAN
    if base == 0 and exponent < 0:
        return MP.inf
    return (
        MP.sqrt(base) ** int(2 * exponent) if exponent != int(exponent) else base ** int(exponent)
    )


def _periodic(function: Callable[[Number], Number]) -> Callable[..., Number]:
    return lambda _, parts: function(parts[0]) if MP.isfinite(parts[0]) else NAN


def _atan2(_: Basic, parts: list[Number]) -> Number:
    if all(MP.isfinite(part) for part in parts):
        return MP.atan2(*parts)
    y, x = parts
    if MP.isnan(x) or MP.isnan(y):
        return NAN
    # An infinite part is longer than any finite one; two are equally long.
    y, x = (MP.sign(p) if MP.isinf(p) else MP.mpf(0) for p in (y, x))
    return MP.atan2(y, x)


def _relation(expression: Basic, parts: list[Number]) -> bool:
    left, right = parts
    if expression.rel_op == "!=":
        return bool(left != right)
    if MP.isnan(left) or MP.isnan(right):
        return False
    return {
        "<": left < right,
        "<=": left <= right,
        ">": left > right,
        ">=": left >= right,
        "==": left == right,
    }[expression.rel_op]


def _sum(_: Basic, parts: list[Number]) -> Number:
    # mpmath keeps what cancels only to its digits: terms that differ by more are summed exactly.
    return MP.fsum(parts)


OPERATIONS: dict[str, Callable[..., Number]] = {
    "Add": _sum,
    "Mul": lambda _, parts: prod(parts),
    "Pow": _power,
    "Relational": _relation,
    "And": lambda _, parts: all(parts),
    "Or": lambda _, parts: any(parts),
    "Not": lambda _, parts: not parts[0],
    "sin": _periodic(MP.sin),
    "cos": _periodic(MP.cos),
    "tan": _periodic(MP.tan),
    "floor": _periodic(MP.floor),
    "Abs": lambda _, parts: abs(parts[0]),
    "exp": lambda _, parts: MP.exp(parts[0]),
    "expm1": lambda _, parts: MP.expm1(parts[0]),
    "log1p": lambda _, parts: MP.log1p(parts[0]),
    "hypot": lambda _, parts: MP.hypot(*parts),
    "atan2": _atan2,
}

DOUBLE = Reference(float, 2.0**-52, sys.float_info.max)
SINGLE = Reference(single, 2.0**-23, (2 - 2.0**-23) * 2.0**127)
