"""Functions of derived formulas that are made when they are first called, not when imported.

Each process that collects the tests imports them all, and runs half of them.
"""

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from sympy import Basic, lambdify


def computing(arguments: Basic | Sequence[Basic], formula: Callable[[], Any]) -> Callable[..., Any]:
    """What computes a formula, which is derived at the first call."""

    @cache
    def made() -> Callable[..., Any]:
        function: Callable[..., Any] = lambdify(arguments, formula())
        return function

    def compute(*values: object) -> Any:  # noqa: ANN401 - a number or an array, as of the formula
        return made()(*values)

    return compute
