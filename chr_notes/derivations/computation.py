"""A formula in the form in which a computer should evaluate it: named steps, then results."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from sympy import Basic, Expr, ImmutableMatrix, Piecewise, Symbol, false, true
from sympy.logic.boolalg import Boolean

# Two units in the last place of pi, four of pi/2: the pitch of a quaternion or matrix that was
# meant to be at the pole is off by as much once its elements are rounded.
EPSILON = Symbol("epsilon", positive=True)
"""Distance from 1 to the next number of the type that computes: 2.2e-16 in double precision."""
LARGEST = Symbol("largest", positive=True)
"""Largest number of the type that computes: 1.8e308 in double precision."""
NOTHING = Symbol("nothing", real=True)
"""What is returned where there is no answer: not a number."""
LOCK_MARGIN = 8 * EPSILON
"""Gimbal lock is where pitch is closer to ±90° than this, in radians."""


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

    def decided(self) -> "tuple[Let | Choice, ...]":
        """Leave out the branches that are known not to be taken."""
        branches = [branch for branch in self.branches if branch[0] != false]
        first = next(place for place, (condition, _) in enumerate(branches) if condition == true)
        if first:
            return (Choice(self.names, tuple(branches[: first + 1])),)
        return tuple(map(Let, self.names, branches[0][1]))


def step_names(step: Let | Choice) -> tuple[Symbol, ...]:
    """Names that a step gives a value."""
    return (step.name,) if isinstance(step, Let) else step.names


def map_step(step: Let | Choice, change: Callable[[Basic], Basic]) -> Let | Choice:
    """Change the values of a step and keep its names."""
    if isinstance(step, Let):
        return Let(step.name, change(step.value))
    return Choice(
        step.names,
        tuple(
            (change(condition), tuple(change(value) for value in values))
            for condition, values in step.branches
        ),
    )


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
        vanishes by rounding the result is wrong, so that the arguments must be scaled. Or of the
        determinant of what has to be a rotation.
    valid
        Name of the step that says whether the arguments are what the formula is made for.
    """

    steps: tuple[Let | Choice, ...]
    results: Expr | ImmutableMatrix
    flag: Symbol | None = None
    guard: Symbol | None = None
    valid: Symbol | None = None

    def of(self, values: Mapping[Symbol, Expr], prefix: str = "") -> "Computation":
        """Put values in for its arguments, so that it can be a part of another computation.

        Parameters
        ----------
        values
            From its arguments to what stands for them.
        prefix
            What its own names begin with then.
        """
        names = [name for step in self.steps for name in step_names(step)]
        known = {name: Symbol(f"{prefix}{name.name}", real=True) for name in names} | dict(values)
        steps = tuple(map_step(step, lambda value: value.xreplace(known)) for step in self.steps)
        renamed = [
            Let(known[step.name], step.value)
            if isinstance(step, Let)
            else Choice(tuple(known[name] for name in step.names), step.branches)
            for step in steps
        ]
        return Computation(tuple(renamed), self.results.xreplace(known))

    def at(self, values: Mapping[Symbol, Expr]) -> "Computation":
        """Put numbers in for some arguments, and let what is a number then enter as one.

        Parameters
        ----------
        values
            From arguments to numbers.
        """
        known = dict(values)
        steps: list[Let | Choice] = []
        for step in self.steps:
            now = map_step(step, lambda value: value.xreplace(known))
            for part in now.decided() if isinstance(now, Choice) else (now,):
                if isinstance(part, Let) and part.value.is_number:
                    known[part.name] = part.value
                else:
                    steps.append(part)
        return replace(self, steps=tuple(steps), results=self.results.xreplace(known))

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
