"""From a formula to a list of assignments, the same for every language."""

from dataclasses import dataclass

from sympy import Expr, Function, MatrixBase, Symbol, cos, cse, numbered_symbols, sin, tan
from sympy.core.function import AppliedUndef

from chr_notes.codegen.targets import Target

NAMED = (sin, cos, tan)


@dataclass(frozen=True)
class Program:
    """A target as straight-line code.

    Parameters
    ----------
    target
        Where it comes from.
    assignments
        Locals in the order in which they are computed.
    results
        The returned expressions in the locals and the arguments, row by row.
    shape
        Shape of the result: `()` for a scalar, `(3,)` for a vector, `(3, 3)` for a matrix.
    """

    target: Target
    assignments: tuple[tuple[Symbol, Expr], ...]
    results: tuple[Expr, ...]
    shape: tuple[int, ...]


def lower(target: Target) -> Program:
    """Lower a target to assignments.

    The arguments take their names, functions of a single argument become locals that say what
    they are (`sin_roll`), and what still occurs twice is computed once.

    Parameters
    ----------
    target
        Row of the table of targets.
    """
    formula = target.formula()
    names = {argument.symbol: Symbol(argument.name, real=True) for argument in target.arguments}
    foreign = formula.free_symbols - set(names)
    if foreign:
        found = sorted(foreign, key=str)
        msg = f"{target.name}: expected a formula in {list(names)}, got also {found}"
        raise ValueError(msg)
    is_matrix = isinstance(formula, MatrixBase)
    elements = [element.xreplace(names) for element in (formula if is_matrix else [formula])]
    named = _name_functions(elements)
    inverse = {call: local for local, call in named}
    elements = [element.xreplace(inverse) for element in elements]
    common, results = cse(elements, symbols=numbered_symbols("x"), order="canonical")
    shape = () if not is_matrix else (formula.rows, formula.cols)[: 1 if formula.cols == 1 else 2]
    return Program(target, (*named, *common), tuple(results), shape)


def _name_functions(elements: list[Expr]) -> list[tuple[Symbol, Expr]]:
    """Give each function of one argument a local of its own, in the order of the arguments."""
    calls: set[Function] = {call for element in elements for call in element.atoms(*NAMED)}
    return [
        (Symbol(f"{call.func.__name__}_{call.args[0]}", real=True), call)
        for call in sorted(calls, key=str)
        if call.args[0].is_Symbol and not isinstance(call, AppliedUndef)
    ]
