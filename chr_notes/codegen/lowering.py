"""From a formula to a list of assignments, the same for every language."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sympy import Basic, Expr, MatrixBase, Symbol, Tuple, cse, numbered_symbols

from chr_notes.codegen.names import name_of
from chr_notes.codegen.rewriting import Rewriting
from chr_notes.codegen.target import Target
from chr_notes.derivations.computation import (
    EPSILON,
    LARGEST,
    NOTHING,
    Choice,
    Computation,
    Let,
    map_step,
    step_names,
)


@dataclass(frozen=True)
class Program:
    """A target as straight-line code.

    Parameters
    ----------
    target
        Where it comes from.
    steps
        Locals in the order in which they are computed.
    results
        The returned expressions in the locals and the arguments, row by row.
    shape
        Shape of the result: `()` for a scalar, `(3,)` for a vector, `(3, 3)` for a matrix.
    flag
        The local that says whether the attitude is at gimbal lock.
    guard
        The local that must be neither too small nor too large for the results to be right.
    valid
        The local that says whether the arguments are what the formula is made for.
    """

    target: Target
    steps: tuple[Let | Choice, ...]
    results: tuple[Expr, ...]
    shape: tuple[int, ...]
    flag: Symbol | None
    guard: Symbol | None
    valid: Symbol | None

    @property
    def expressions(self) -> Tuple:
        """Every expression, to be searched."""
        return expressions(self.steps, self.results)

    @property
    def used(self) -> set[str]:
        """Names of the arguments and locals that occur in them."""
        return {symbol.name for symbol in self.expressions.free_symbols}


def lower(target: Target, rewriting: Rewriting, checks: tuple[str, ...] = ()) -> Program:
    """Lower a target to assignments.

    The arguments take their names, functions of an angle become locals that say what they are
    (`sin_roll`), and in a formula without named steps what occurs twice is computed once.

    Parameters
    ----------
    target
        Row of the table of targets.
    rewriting
        How functions of an angle are computed.
    checks
        Which of "guard" and "valid" are computed too.
    """
    computation = target.computation()
    _check_symbols(target, computation)
    names = {argument.symbol: Symbol(argument.name, real=True) for argument in target.arguments}
    is_matrix = isinstance(computation.results, MatrixBase)
    results = tuple(
        element.xreplace(names)
        for element in (computation.results if is_matrix else [computation.results])
    )
    steps = tuple(map_step(step, lambda value: value.xreplace(names)) for step in computation.steps)
    angles, replaced = rewriting(expressions(steps, results))
    steps = tuple(
        part
        for step in (map_step(each, lambda value: value.xreplace(replaced)) for each in steps)
        for part in (step.decided() if isinstance(step, Choice) else (step,))
    )
    results = tuple(result.xreplace(replaced) for result in results)
    known = set(names.values())
    steps, results = _schedule(known, angles, steps, results)
    reports = {computation.flag, *(getattr(computation, name) for name in checks)}
    steps = needed_steps(steps, results, reports)
    size = computation.results.shape if is_matrix else ()
    return Program(
        target=target,
        steps=steps,
        results=results,
        shape=size[: 1 if size and size[1] == 1 else 2],
        flag=computation.flag,
        guard=computation.guard,
        valid=computation.valid,
    )


def expressions(steps: Iterable[Let | Choice], results: Iterable[Expr] = ()) -> Tuple:
    """Put every expression into a tuple of SymPy's, which can be searched and changed as one."""
    parts = (step.value if isinstance(step, Let) else step.branches for step in steps)
    return Tuple(*parts, *results)


def _check_symbols(target: Target, computation: Computation) -> None:
    """Refuse a formula that needs what is neither an argument nor a step before."""
    known = {argument.symbol for argument in target.arguments} | {EPSILON, LARGEST, NOTHING}
    for step in computation.steps:
        _refuse(target, expressions([step]).free_symbols - known)
        known |= set(step_names(step))
    _refuse(target, computation.results.free_symbols - known)


def _refuse(target: Target, foreign: set[Symbol]) -> None:
    if foreign:
        names = [argument.name for argument in target.arguments]
        msg = f"{target.name}: expected a formula in {names}, got also {sorted(foreign, key=str)}"
        raise ValueError(msg)


def _schedule(
    known: set[Symbol],
    angles: tuple[Let, ...],
    steps: tuple[Let | Choice, ...],
    results: tuple[Expr, ...],
) -> tuple[tuple[Let | Choice, ...], tuple[Expr, ...]]:
    """Put everything in order: functions of the arguments, then each step after what it needs.

    What occurs twice is computed once, under a name that says what it is.
    """
    ordered: list[Let | Choice] = []
    waiting: dict[Symbol, Expr] = {}
    for let in angles:
        if let.value.free_symbols <= known:
            ordered.append(let)
            known = known | {let.name}
        else:
            waiting[let.name] = let.value
    lets = [step.value for step in steps if isinstance(step, Let)]
    common, found = _common((*lets, *results))
    waiting |= common
    taken = known | {name for step in steps for name in step_names(step)}
    renamed: dict[Symbol, Symbol] = {let.name: let.name for let in angles}

    def ready(value: Basic) -> Basic:
        for local in sorted(value.free_symbols & waiting.keys(), key=list(waiting).index):
            needed = ready(waiting.pop(local))
            if local not in renamed:
                name = Symbol(name_of(needed) or f"common_{len(renamed)}", real=True)
                renamed[local] = local if name in taken else name
                taken.add(renamed[local])
            ordered.append(Let(renamed[local], needed))
        return value.xreplace(renamed)

    values = iter(found)
    for step in steps:
        # What a step needs is put in order while its values are read, hence before it.
        if isinstance(step, Let):
            value = next(values)
            if value in waiting:
                renamed[value], value = step.name, waiting.pop(value)
            ordered.append(Let(step.name, ready(value)))
        else:
            ordered.append(map_step(step, ready))
    finished = tuple(ready(value) for value in values)
    return tuple(ordered), finished


def _common(values: tuple[Basic, ...]) -> tuple[dict[Symbol, Expr], list[Basic]]:
    """Find what occurs twice, apart from what is cheap."""
    names = numbered_symbols("x")
    common: dict[Symbol, Expr] = {}
    found = list(values)
    more = True
    # Again and again, because one look takes `a d + c b` and `c b - a d` to share `a d` alone.
    while more:
        fresh, looked_through = cse([*common.values(), *found], symbols=names, order="canonical")
        more = bool(fresh)
        found = looked_through[len(common) :]
        common = dict(fresh) | dict(zip(common, looked_through, strict=False))
    cheap = {local: value for local, value in common.items() if _is_cheap(value)}

    def put_in(value: Basic) -> Basic:
        # Several times, because they may stand in each other.
        while value.free_symbols & cheap.keys():
            value = value.xreplace(cheap)
        return value

    kept = {local: put_in(value) for local, value in common.items() if local not in cheap}
    return kept, [put_in(value) for value in found]


def _is_cheap(value: Basic) -> bool:
    """Say whether to compute something again costs as little as to look it up."""
    if value.is_Boolean or value.is_number:
        return True
    coefficient, rest = value.as_coeff_Mul()
    return bool(rest.is_Symbol and coefficient != 1)


def needed_steps(
    steps: Sequence[Let | Choice], results: tuple[Expr, ...], reports: set[Symbol | None]
) -> tuple[Let | Choice, ...]:
    """Leave out the steps on which neither results nor reports depend."""
    asked = reports | Tuple(*results).free_symbols
    kept: list[Let | Choice] = []
    for step in reversed(steps):
        if asked & set(step_names(step)):
            kept.insert(0, step)
            asked |= expressions([step]).free_symbols
    return tuple(kept)
