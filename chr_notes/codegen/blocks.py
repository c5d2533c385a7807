"""From a program to calls of NumPy's functions on blocks, with storage that is used again.

Values are real or complex. The real and the imaginary part of a complex one are blocks like others,
named `value.real` and `value.imag`.
"""

from dataclasses import dataclass, field

from sympy import (
    Abs,
    Add,
    Basic,
    Expr,
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
from sympy.core.relational import Relational
from sympy.logic.boolalg import And, Not, Or

from chr_notes.codegen.expressions import split_product, split_sum
from chr_notes.codegen.lowering import Program, parts
from chr_notes.derivations.computation import EPSILON, Choice, Let, Remainder

DOUBLE = 2.0**-52
UFUNCS = {
    Abs: "absolute",
    acos: "arccos",
    asin: "arcsin",
    atan: "arctan",
    atan2: "arctan2",
    conjugate: "conjugate",
    cos: "cos",
    floor: "floor",
    sin: "sin",
    tan: "tan",
    Remainder: "fmod",
    And: "logical_and",
    Or: "logical_or",
    Not: "logical_not",
}
PARTS = {re: "real", im: "imag"}
COMPARISONS = {"<": "less", "<=": "less_equal", ">": "greater", ">=": "greater_equal"}
# These make a block of booleans, which is small, so NumPy finds the storage.
CONDITIONS = (Relational, And, Or, Not)


@dataclass(frozen=True)
class Call:
    """One call of a NumPy function on whole blocks.

    Parameters
    ----------
    function
        Its name in NumPy.
    operands
        Names of values, or numbers.
    result
        Name of the value that it makes, or into which `copyto` copies.
    where
        Name of the condition that says which elements count; for `copyto` alone.
    inside
        Name of the condition without which the call is left out, because no element needs it.
    says
        The formula whose first call it is.
    """

    function: str
    operands: tuple[str | float, ...]
    result: str
    where: str | None = None
    inside: str | None = None
    says: Let | None = None


@dataclass
class Calls:
    """Collects the calls of one program.

    Parameters
    ----------
    complex
        Names of the values that are complex numbers.
    places
        Where values are that are parts of others: `x` and `y` of `x + i y`.
    """

    complex: set[str] = field(default_factory=set)
    places: dict[str, str] = field(default_factory=dict)
    made: list[Call] = field(default_factory=list)
    inside: str | None = None
    count: int = 0
    says: Let | None = None

    def add(self, function: str, *operands: str | float, into: str | None, **rest: str) -> str:
        """Add a call and give the name of its result, a fresh one where none is asked for."""
        into = into or self._fresh()
        if self.complex & set(operands):
            self.complex.add(into)
        self.made.append(Call(function, operands, into, inside=self.inside, says=self.says, **rest))
        self.says = None
        return into

    def _fresh(self) -> str:
        self.count += 1
        return f"${self.count - 1}"

    def value(self, value: Basic, into: str | None = None) -> str | float:
        """Add the calls that compute an expression.

        Parameters
        ----------
        value
            The expression.
        into
            Name of its value; without it a number or a name stays what it is.
        """
        if value.has(I):
            return self._assembled(value, into or self._fresh())
        if isinstance(value, Symbol) and value != EPSILON:
            operand: str | float = self.places.get(value.name, value.name)
        elif isinstance(value, (re, im)):
            operand = f"{self.value(value.args[0])}.{PARTS[type(value)]}"
        elif not value.free_symbols - {EPSILON}:
            operand = float(value.subs(EPSILON, DOUBLE))
        else:
            return self._compound(value, into)
        return operand if into in (None, operand) else self.add("copyto", operand, into=into)

    def _assembled(self, value: Expr, into: str) -> str:
        """Add the calls that compute `x + i y` from real x and y."""
        self.complex.add(into)
        for part, expression in zip(PARTS.values(), parts(value), strict=True):
            self.value(expression, into=f"{into}.{part}")
        return into

    def _compound(self, value: Basic, into: str | None) -> str:
        if isinstance(value, Add):
            return self._sum(value, into)
        if isinstance(value, Mul):
            return self._product(value, into)
        if isinstance(value, Pow):
            return self._power(value, into)
        if isinstance(value, Relational):
            sides = [self.value(side) for side in (value.lhs, value.rhs)]
            return self.add(COMPARISONS[value.rel_op], *sides, into=into)
        if type(value) not in UFUNCS:
            msg = f"expected an expression of functions that NumPy has, got {value}"
            raise TypeError(msg)
        arguments = value.args
        if isinstance(value, (And, Or)):
            arguments = sorted(arguments, key=lambda part: part.sort_key())
        operands = [self.value(argument) for argument in arguments]
        return self.add(UFUNCS[type(value)], *operands, into=into)

    def _sum(self, value: Add, into: str | None) -> str:
        (minus, first), *rest = split_sum(value)
        total = self.value(-first if minus else first)
        for place, (subtracted, term) in enumerate(rest, 1):
            function = "subtract" if subtracted else "add"
            last = place == len(rest)
            total = self.add(function, total, self.value(term), into=into if last else None)
        return str(total)

    def _product(self, value: Mul, into: str | None) -> str:
        coefficient, above, below = split_product(value)
        operands: list[tuple[str, Expr]] = [("multiply", factor) for factor in above]
        if coefficient not in (1, -1):
            operands.append(("multiply", coefficient))
        if below:
            divisor = below[0] if len(below) == 1 else Mul(*below, evaluate=False)
            operands.append(("divide", divisor))
        if not operands or operands[0][0] == "divide":
            operands.insert(0, ("multiply", Integer(1)))
        negated = coefficient == -1
        total = self.value(operands[0][1])
        for place, (function, factor) in enumerate(operands[1:], 1):
            last = place == len(operands) - 1 and not negated
            total = self.add(function, total, self.value(factor), into=into if last else None)
        # NumPy 2.4's own `negative` misreads elements that lie 64 bytes apart.
        return self.add("multiply", total, -1.0, into=into) if negated else str(total)

    def _power(self, value: Pow, into: str | None) -> str:
        base, exponent = value.base, value.exp
        if exponent.could_extract_minus_sign():
            return self.add("divide", 1.0, self.value(base**-exponent), into=into)
        if isinstance(exponent, Rational) and exponent.q == 2:  # noqa: PLR2004 (a root)
            return self.add("sqrt", self.value(base**exponent.p), into=into)
        if exponent == 2:  # noqa: PLR2004 (a square)
            return self.add("square", self.value(base), into=into)
        if isinstance(exponent, Integer):
            operand = self.value(base)
            return self.add("multiply", operand, self.value(base ** (exponent - 1)), into=into)
        msg = f"expected whole and half powers, got {value}"
        raise TypeError(msg)

    def choose(self, choice: Choice) -> None:
        """Compute the first branch everywhere, and the others only where a block has need of them.

        A branch copies over the ones after it, so the first whose condition holds counts. A
        comparison with NaN does not hold, here as in every other language.
        """
        (condition, values), *others = choice.branches
        for name, value in zip(choice.names, values, strict=True):
            self.value(value, into=name.name)
        if isinstance(condition, Not):
            other = str(self.value(condition.args[0]))
        else:
            other = self.add("logical_not", self.value(condition), into=None)
        self.inside = other
        for condition, values in reversed(others):
            where = other
            if condition != True:  # noqa: E712 (SymPy's true, not Python's)
                where = self.add("logical_and", other, self.value(condition), into=None)
            for name, value in zip(choice.names, values, strict=True):
                self.add("copyto", self.value(value), into=name.name, where=where)
        self.inside = None


def calls(program: Program) -> tuple[list[Call], set[str]]:
    """List the calls of a program, and say which of the values are complex.

    Results that have no name are `out[0]`, `out[1]` and so on.
    """
    collected = Calls(_complex_arguments(program), _places(program))
    for step in program.steps:
        if isinstance(step, Let):
            collected.says = step
            name = step.name.name
            collected.value(step.value, into=collected.places.get(name, name))
        else:
            collected.choose(step)
    placed = in_place(program)
    for index, result in enumerate(program.results):
        if placed.get(str(result)) != index:
            place = f"out[{index}]"
            collected.says = Let(Symbol(place), result)
            collected.value(result, into=place)
    return collected.made, collected.complex


def _complex_arguments(program: Program) -> set[str]:
    given = program.target.arguments
    return {argument.name for argument in given if not argument.symbol.is_real}


def _places(program: Program) -> dict[str, str]:
    """Find the locals that are parts of a complex one, which are computed where they belong."""
    lets = [step for step in program.steps if isinstance(step, Let)]
    computed = {let.name for let in lets}
    return {
        part.name: f"{let.name.name}.{name}"
        for let in lets
        if let.value.has(I)
        for name, part in zip(PARTS.values(), parts(let.value), strict=True)
        if part in computed
    }


def in_place(program: Program) -> dict[str, int]:
    """Find the locals that are results, which are computed where they belong at once."""
    computed: set[Symbol] = set()
    for step in program.steps:
        computed |= {step.name} if isinstance(step, Let) else set(step.names)
    places = reversed(list(enumerate(program.results)))
    return {result.name: index for index, result in places if result in computed}
