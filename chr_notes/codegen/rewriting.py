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
    Wild,
    atan2,
    cos,
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

Rewriting = Callable[[tuple[Basic, ...]], tuple[tuple[Let, ...], dict[Basic, Expr]]]


def by_library(values: tuple[Basic, ...]) -> tuple[tuple[Let, ...], dict[Basic, Expr]]:
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
    replaced = _secants(values)
    for angle, functions_of_it in _angles(values).items():
        named = {name: _local(name, angle) for name in ("sin", "cos", "tan", "sec")}
        needed = {*functions_of_it, *(["cos"] if "sec" in functions_of_it else [])}
        called = [function for function in (sin, cos, tan) if function.__name__ in needed]
        known = angle if angle.is_Symbol else Symbol(_name(angle), real=True)
        lets += [Let(known, angle)] if known != angle else []
        lets += [Let(named[function.__name__], function(known)) for function in called]
        if "sec" in needed:
            lets.append(Let(named["sec"], 1 / named["cos"]))
        replaced |= {function(angle): named[function.__name__] for function in called}
    return tuple(lets), replaced


class principal(Function):  # noqa: N801 (its name in C and NumPy)
    """An angle less whole turns, in [-pi, pi); one that lies there is left as it is."""


def for_columns(values: tuple[Basic, ...]) -> tuple[tuple[Let, ...], dict[Basic, Expr]]:
    """Do as `by_library`, with functions that take less time for many rows.

    A quotient stands for the tangent and a root for `hypot`. They need no care here: a row whose
    squares would overflow or vanish is scaled first, by the guard. So one of zeros is no matter.
    Whole turns are taken off, instead of asking for the angle whose sine and cosine are those of
    another, which costs five times as much.
    """
    tangents = {
        call: sin(call.args[0]) / cos(call.args[0]) for value in values for call in value.atoms(tan)
    }
    turned: dict[Basic, Expr] = {}
    for call in (call for value in values for call in value.atoms(atan2)):
        angle = call.args[0].args[0] if isinstance(call.args[0], sin) else None
        if angle is not None and call.args[1] == cos(angle):
            turned |= {call: principal(angle), And(angle >= -pi, angle < pi): false}
            relations = [relation for each in values for relation in each.atoms(Ge)]
            turned |= {relation: false for relation in relations if relation.rhs == pi}
    lets, replaced = by_library(tuple(value.xreplace(tangents | turned) for value in values))
    replaced |= {call: value.xreplace(replaced) for call, value in tangents.items()} | turned
    replaced[KNOWN] = true
    for value in values:
        replaced |= {call: root_of_squares(*call.args) for call in value.atoms(hypot)}
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


def root_of_squares(x: Expr, y: Expr) -> Expr:
    """Write `hypot` as a root."""
    return sqrt(x**2 + y**2)


def _name(angle: Expr) -> str:
    name = name_of(angle)
    if name is None:
        msg = f"expected an angle with a name, got {angle}"
        raise ValueError(msg)
    return name


def _local(function: str, angle: Expr) -> Symbol:
    return Symbol(f"{function}_{_name(angle)}", real=True)


def _angles(values: tuple[Basic, ...]) -> dict[Expr, list[str]]:
    """Find the angles of which functions are taken, and which functions, in order of names."""
    found: dict[Expr, set[str]] = {}
    secants = _secants(values)
    for value in values:
        for call in value.xreplace(secants).atoms(sin, cos, tan):
            found.setdefault(call.args[0], set()).add(type(call).__name__)
    for power in secants:
        angle = next(iter(power.atoms(cos))).args[0]
        found.setdefault(angle, set()).add("sec")
    return {angle: sorted(found[angle]) for angle in sorted(found, key=_name)}


def _secants(values: tuple[Basic, ...]) -> dict[Basic, Expr]:
    """Find 1/cos(x) and 1/|cos(x)|, and what stands for them."""
    found: dict[Basic, Expr] = {}
    for value in values:
        for power in value.atoms(Pow):
            if power.exp == -1 and isinstance(power.base, cos):
                found[power] = _local("sec", power.base.args[0])
            elif power.exp == -1 and isinstance(power.base, Abs):
                inner = power.base.args[0]
                if isinstance(inner, cos):
                    found[power] = Abs(_local("sec", inner.args[0]))
    return found
