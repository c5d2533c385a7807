"""How functions of an angle are computed: each once, under a name that says what it is."""

from collections.abc import Callable
from dataclasses import replace

from sympy import (
    Abs,
    And,
    Basic,
    Expr,
    Function,
    Ge,
    Pow,
    Symbol,
    Tuple,
    Wild,
    atan2,
    cos,
    expand_func,
    false,
    pi,
    sin,
    sqrt,
    tan,
    true,
)
from sympy.codegen.cfunctions import hypot

from chr_notes.codegen.names import name_of
from chr_notes.derivations.computation import Choice, Computation, Let, map_step
from chr_notes.derivations.forms.estimation import KNOWN
from chr_notes.derivations.forms.filters import SIDES

Rewriting = Callable[[Tuple], tuple[tuple[Let, ...], dict[Basic, Expr]]]


def by_library(values: Tuple) -> tuple[tuple[Let, ...], dict[Basic, Expr]]:
    """Give each function of an angle a local of its own.

    Parameters
    ----------
    values
        All expressions of a program.

    Returns
    -------
    lets
        The locals, in the order in which to compute them.
    replaced
        What they stand for in the expressions.
    """
    lets: list[Let] = []
    replaced: dict[Basic, Expr] = {}
    calls, powers = values.atoms(sin, cos, tan), values.atoms(Pow)
    for angle in sorted({call.args[0] for call in calls}, key=_name):
        name = _name(angle)
        known = angle if angle.is_Symbol else Symbol(name, real=True)
        lets += [Let(known, angle)] if known != angle else []
        for function in (sin, cos, tan):
            if function(angle) in calls:
                local = Symbol(f"{function.__name__}_{name}", real=True)
                lets.append(Let(local, function(known)))
                replaced[function(angle)] = local
        secant = Symbol(f"sec_{name}", real=True)
        secants = {1 / cos(angle): secant, 1 / Abs(cos(angle)): Abs(secant)}
        if secants.keys() & powers:
            lets.append(Let(secant, 1 / replaced[cos(angle)]))
            replaced |= secants
    return tuple(lets), replaced


class principal(Function):  # noqa: N801 (its name in C and NumPy)
    """An angle less whole turns, in [-pi, pi); one that lies there is left as it is."""


def for_columns(values: Tuple) -> tuple[tuple[Let, ...], dict[Basic, Expr]]:
    """Do as `by_library`, with functions that take less time for many rows.

    A quotient stands for the tangent and a root for `hypot`. They need no care here: a row whose
    squares would overflow or vanish is scaled first, by the guard. So one of zeros is no matter.
    Whole turns are taken off, instead of asking for the angle whose sine and cosine are those of
    another, which costs five times as much.
    """
    tangents = {call: sin(call.args[0]) / cos(call.args[0]) for call in values.atoms(tan)}
    turned: dict[Basic, Expr] = {}
    for call in values.atoms(atan2):
        sine, cosine = call.args
        if isinstance(sine, sin) and cosine == cos(angle := sine.args[0]):
            turned |= {call: principal(angle), And(angle >= -pi, angle < pi): false}
            turned |= {relation: false for relation in values.atoms(Ge) if relation.rhs == pi}
    lets, replaced = by_library(values.xreplace(tangents | turned))
    replaced |= {call: value.xreplace(replaced) for call, value in tangents.items()} | turned
    replaced |= {call: expand_func(call) for call in values.atoms(hypot)}
    replaced[KNOWN] = true
    return lets, replaced


class cos_of_root(Function):  # noqa: N801 (its name in C)
    """Cosine of a factor times a root."""


class sinc_of_root(Function):  # noqa: N801
    """Sine of a factor times a root, divided by the angle."""


class cos_of_share(Function):  # noqa: N801
    """Cosine of a share of the angle that a root and a number make."""


class sin_of_share(Function):  # noqa: N801
    """Sine of it, divided by the root."""


def without_roots(computation: Computation) -> Computation:
    """Leave the roots to the kernels' own functions, which need none for a small angle.

    A step of a filter waits for the one before it, and longest for roots and quotients.
    """
    values = {step.name: step.value for step in computation.steps if isinstance(step, Let)}
    known: dict[Basic, Expr] = {}
    factor, square, x = Wild("factor"), Wild("square"), Wild("x")
    for name, value in values.items():
        root = value.match(factor * sqrt(square))
        share = value.match(factor * atan2(square, x))
        if root and not root[factor].has(Pow):
            known[cos(name)] = cos_of_root(root[factor], root[square])
            known[sin(name) / name] = sinc_of_root(root[factor], root[square])
        elif share and isinstance(values.get(share[square]), Pow):
            length = share[square]
            given = (share[factor], values[length].base, share[x], SIDES)
            known[cos(name)] = cos_of_share(*given)
            known[sin(name) / length] = sin_of_share(*given)
    steps: list[Let | Choice] = []
    for step in computation.steps:
        # Their own functions know what comes of a zero.
        if isinstance(step, Choice) and all(value in known for value in step.branches[0][1]):
            pairs = zip(step.names, step.branches[0][1], strict=True)
            steps += [Let(name, known[value]) for name, value in pairs]
        else:
            steps.append(map_step(step, lambda value: value.xreplace(known)))
    return replace(computation, steps=tuple(steps))


def _name(angle: Expr) -> str:
    name = name_of(angle)
    if name is None:
        msg = f"expected an angle with a name, got {angle}"
        raise ValueError(msg)
    return name
