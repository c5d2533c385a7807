"""A formula in the form in which a computer should evaluate it: named steps, then results."""

from dataclasses import dataclass

from sympy import Expr, ImmutableMatrix, Mod, Piecewise, Symbol, sign, true
from sympy.core.function import DefinedFunction
from sympy.logic.boolalg import Boolean

# Two units in the last place of pi, four of pi/2: the pitch of a quaternion or matrix that was
# meant to be at the pole is off by as much once its elements are rounded.
EPSILON = Symbol("epsilon", positive=True)
"""Distance from 1 to the next number of the type that computes: 2.2e-16 in double precision."""
LOCK_MARGIN = 8 * EPSILON
"""Gimbal lock is where pitch is closer to ±90° than this, in radians."""


class Remainder(DefinedFunction):
    """What is left of x after whole multiples of m are taken away towards zero: C's fmod."""

    nargs = (2,)

    def _eval_rewrite_as_Mod(self, x: Expr, m: Expr, **_: object) -> Expr:  # noqa: N802 (SymPy's name)
        return sign(x) * Mod(abs(x), m)

    def _eval_evalf(self, prec: int) -> Expr:
        return self.rewrite(Mod)._eval_evalf(prec)  # noqa: SLF001 (SymPy's protocol)


@dataclass(frozen=True)
class Let:
    """One named quantity.

    Parameters
    ----------
    name
        Symbol whose name says what it is; the generated code has it.
    value
        Formula in the arguments and in earlier names; a `Boolean` for a condition.
    """

    name: Symbol
    value: Expr | Boolean


@dataclass(frozen=True)
class Choice:
    """Quantities that are computed in one of several ways.

    Parameters
    ----------
    names
        What is computed.
    branches
        Condition and values; the first whose condition holds counts, the last one's is `true`.
    """

    names: tuple[Symbol, ...]
    branches: tuple[tuple[Boolean, tuple[Expr, ...]], ...]


@dataclass(frozen=True)
class Computation:
    """Named steps in order, and the results in terms of them.

    Parameters
    ----------
    steps
        Each in terms of the arguments and of earlier ones.
    results
        A formula, or a matrix of them.
    flag
        Name of the step that says whether the attitude is at gimbal lock, for results that need
        to say so.
    guard
        Name of a squared length: where it is zero there is no result, and where it overflows or
        vanishes by rounding the result is wrong, so that the arguments must be scaled.
    """

    steps: tuple[Let | Choice, ...]
    results: Expr | ImmutableMatrix
    flag: Symbol | None = None
    guard: Symbol | None = None

    def inlined(self, *branches: int) -> Expr | ImmutableMatrix:
        """Write the results in the arguments alone, for a proof.

        Parameters
        ----------
        *branches
            Which branch each `Choice` takes, in order; a choice beyond these becomes `Piecewise`.
        """
        known: dict[Symbol, Expr] = {}
        taken = iter(branches)
        for step in self.steps:
            if isinstance(step, Let):
                known[step.name] = step.value.xreplace(known)
                continue
            branch = next(taken, None)
            for index, name in enumerate(step.names):
                if branch is not None:
                    known[name] = step.branches[branch][1][index].xreplace(known)
                else:
                    known[name] = Piecewise(
                        *(
                            (values[index].xreplace(known), condition.xreplace(known))
                            for condition, values in step.branches
                        )
                    )
        return self.results.xreplace(known)


def otherwise(*values: Expr) -> tuple[Boolean, tuple[Expr, ...]]:
    """Last branch of a `Choice`."""
    return true, values
