"""How functions of an angle are computed: by the library, or through the tangent of its half.

NumPy has vectorised tangents, and sines and cosines that take several times as long. With
t = tan(x/2) and u = 2 / (1 + t²), which is 1 + cos(x), the sine is t u and the cosine u - 1. The
secant is 1 + tan(x) t, in which nothing cancels near ±90°. A test has SymPy prove each line.
"""

from collections.abc import Callable

from sympy import Abs, Basic, Expr, Pow, Symbol, cos, sin, sqrt, tan
from sympy.codegen.cfunctions import hypot

from chr_notes.codegen.names import half, name_of
from chr_notes.derivations.computation import Let

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
        functions = {"sin": sin(angle), "cos": cos(angle), "tan": tan(angle)}
        lets += [Let(named[name], functions[name]) for name in functions if name in needed]
        if "sec" in needed:
            lets.append(Let(named["sec"], 1 / named["cos"]))
        replaced |= {functions[name]: named[name] for name in functions if name in needed}
    return tuple(lets), replaced


def by_half_tangent(values: tuple[Basic, ...]) -> tuple[tuple[Let, ...], dict[Basic, Expr]]:
    """Do as `by_library`, with tangents for all functions of an angle and roots for `hypot`."""
    lets: list[Let] = []
    replaced = _secants(values)
    for angle, needed in _angles(values).items():
        tangent, half_tangent = _local("tan", angle), Symbol(f"tan_{half(_name(angle))}", real=True)
        if "tan" in needed or "sec" in needed:
            lets.append(Let(tangent, tan(angle)))
            replaced[tan(angle)] = tangent
        if needed != ["tan"]:
            lets.append(Let(half_tangent, tan(angle / 2)))
        if "sec" in needed:
            lets.append(Let(_local("sec", angle), secant(tangent, half_tangent)))
        if "sin" in needed or "cos" in needed:
            from_cosine = Symbol(f"one_plus_cos_{_name(angle)}", real=True)
            lets.append(Let(from_cosine, one_plus_cosine(half_tangent)))
        if "sin" in needed:
            replaced[sin(angle)] = _local("sin", angle)
            lets.append(Let(replaced[sin(angle)], half_tangent * from_cosine))
        if "cos" in needed:
            replaced[cos(angle)] = _local("cos", angle)
            lets.append(Let(replaced[cos(angle)], from_cosine - 1))
    for value in values:
        replaced |= {call: root_of_squares(*call.args) for call in value.atoms(hypot)}
    return tuple(lets), replaced


def one_plus_cosine(half_tangent: Expr) -> Expr:
    """1 + cos(x) from tan(x/2); times the tangent it is the sine."""
    return 2 / (1 + half_tangent**2)


def secant(tangent: Expr, half_tangent: Expr) -> Expr:
    """1 / cos(x) from tan(x) and tan(x/2)."""
    return 1 + tangent * half_tangent


def root_of_squares(x: Expr, y: Expr) -> Expr:
    """Write `hypot` as a root: NumPy's own takes forty times as long, and no care is needed here.

    A row whose squares would overflow or vanish is scaled first, by the guard.
    """
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
