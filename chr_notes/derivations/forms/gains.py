"""Forms of gains as time constants, and of the weight that one sample of a mean has."""

from functools import cache

from sympy import And, Expr, Symbol, exp, log
from sympy.codegen.cfunctions import expm1, log1p

from chr_notes.derivations import averaging, estimation
from chr_notes.derivations.computation import NOTHING, Choice, Computation, Let, otherwise

# Positive where it is one, which is for the form to see.
TIME_CONSTANT = Symbol("time_constant", real=True)
RESULT = Symbol("result", real=True)


def gain(time_constant: Expr) -> Expr:
    """Gain of a time constant, with all its digits where it is small."""
    derived = averaging.gain_from_time_constant()
    decay = next(iter(derived.atoms(exp)))
    digits = derived.subs(decay, 1 + expm1(decay.args[0]))
    return digits.xreplace({averaging.tau: time_constant})


@cache
def gain_from_time_constant() -> Computation:
    """Gain of a time constant that is one."""
    found = gain(TIME_CONSTANT)
    branches = ((TIME_CONSTANT > 0, (found,)), otherwise(NOTHING))
    return Computation((Choice((RESULT,), branches),), RESULT)


@cache
def time_constant_from_gain() -> Computation:
    """Time constant of a gain that has one, with all its digits where the gain is small."""
    logarithm = Symbol("logarithm_of_what_is_kept", real=True)
    derived = averaging.time_constant_from_gain()
    constant = derived.subs(next(iter(derived.atoms(log))), -logarithm)
    within = And(estimation.L > 0, estimation.L < 1)
    kept = Choice((logarithm,), ((within, (log1p(-estimation.L),)), otherwise(NOTHING)))
    return Computation((kept, Let(RESULT, constant)), RESULT)
