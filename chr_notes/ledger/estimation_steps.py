"""The steps of Euler integration, which several entries of the note on estimation share."""

from sympy import Eq, Expr, Integral, Symbol

from chr_notes.derivations.steps import Step
from chr_notes.symbols import T

_TIME = Symbol("t", real=True)


def held(rate: Expr, before: Expr, after: Expr) -> tuple[Step, ...]:
    """Tell how an angle goes on with its rate held through one period."""
    gain = Integral(rate, (_TIME, 0, T))
    return (
        Step("An angle gains what its rate adds up to in one period.", Eq(after, before + gain)),
        Step("The rate is held until the next sample comes.", Eq(gain, T * rate)),
    )
