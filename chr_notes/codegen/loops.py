"""Printer of loops over samples, for filters: straight Python that numba can compile too.

A loop is put together from targets. The main one of each stage is written into the loop, because
a call takes as long as the arithmetic; the rare ones are called.
"""

from dataclasses import dataclass

from sympy import Expr, Symbol

from chr_notes.codegen import python
from chr_notes.codegen.expressions import infix
from chr_notes.codegen.header import WIDTH, in_lines, made_how
from chr_notes.codegen.lowering import Program
from chr_notes.codegen.target import Argument, Target


@dataclass(frozen=True)
class Stage:
    """One step of a loop, from the state and a sample to a new state.

    Parameters
    ----------
    target
        Computes the new state; its arguments are found by name.
    sets
        Which parts of the state its results are, in order.
    needs
        Input without which, where it is NaN, the state stays as it is.
    within
        Part of the state and a bound: the result holds where its magnitude is below.
    otherwise
        Targets that are called one after another where it is not, each with names for its results.
    """

    target: str
    sets: tuple[str, ...]
    needs: str
    within: tuple[str, float] | None = None
    otherwise: tuple[tuple[str, tuple[str, ...]], ...] = ()


@dataclass(frozen=True)
class Loop:
    """A generated loop.

    Parameters
    ----------
    name, topic, says
        As for a target.
    state
        What each sample changes, and what is kept of each.
    constants
        What stays the same.
    inputs
        What a sample consists of.
    stages
        What is done with a sample, in order.
    """

    name: str
    topic: str
    says: str
    state: tuple[str, ...]
    constants: tuple[Argument, ...]
    inputs: tuple[Argument, ...]
    stages: tuple[Stage, ...]


def module(loops: tuple[Loop, ...], lowered: tuple[Program, ...]) -> str:
    """Print a module of loops, and of the functions that they call.

    Parameters
    ----------
    loops
        Of one topic.
    lowered
        All targets.
    """
    programs = {program.target.name: program for program in lowered}
    called = list(
        dict.fromkeys(
            name for loop in loops for stage in loop.stages for name, _ in stage.otherwise
        )
    )
    bodies = [python.function(programs[name]) for name in called]
    bodies += [_loop(loop, programs) for loop in loops]
    used = {stage.target for loop in loops for stage in loop.stages} | set(called)
    body = "\n\n\n".join(bodies)
    how = made_how(tuple(programs[name] for name in sorted(used)))
    head = '"""' + "\n".join(how) + '\n"""\n\n'
    abc = "from collections.abc import Iterable, MutableSequence\n"
    return f"{head}{abc}{python.imports(body)}\nSamples = Iterable[float]\n\n\n{body}\n"


def _loop(loop: Loop, programs: dict[str, Program]) -> str:
    inputs = [argument.name for argument in loop.inputs]
    arguments = [
        *(f"{name}: float" for name in loop.state),
        *(f"{argument.name}: float" for argument in loop.constants),
        *(f"{name}_samples: Samples" for name in inputs),
        *(f"{name}_kept: MutableSequence[float]" for name in loop.state),
    ]
    result = f"tuple[{', '.join(['float'] * len(loop.state))}]"
    samples = ", ".join(f"{name}_samples" for name in inputs)
    lines = [
        *in_lines(f"def {loop.name}(", arguments, f") -> {result}:"),
        *_docstring(loop),
        "    sample = 0",
        *_wrapped(f"    for {', '.join(inputs)} in zip(", samples, "):"),
    ]
    for stage in loop.stages:
        lines += [f"        {line}" for line in _stage(stage, loop, programs)]
    lines += [f"        {name}_kept[sample] = {name}" for name in loop.state]
    return "\n".join([*lines, "        sample += 1", f"    return {', '.join(loop.state)}"])


def _wrapped(start: str, middle: str, end: str) -> list[str]:
    whole = f"{start}{middle}{end}"
    return [whole] if len(whole) <= WIDTH else [start, f"        {middle}", f"    {end}"]


def _stage(stage: Stage, loop: Loop, programs: dict[str, Program]) -> list[str]:
    program = programs[stage.target]
    known = {*loop.state, *(argument.name for argument in (*loop.constants, *loop.inputs))}
    _check(program.target, known)
    results = dict(zip(stage.sets, program.results, strict=True))
    lines = [f"if {stage.needs} == {stage.needs}:"]
    for step in program.steps:
        lines += python.step_lines(step)
    if stage.within is None:
        return [*lines, *(f"    {line}" for line in _assignments(results))]
    # The result that decides is computed first, the others only where they count.
    name, bound = stage.within
    deciding = Symbol(f"new_{name}", real=True)
    lines.append(f"    {deciding} = {infix(results[name], python.PYTHON)}")
    lines.append(f"    if {-bound!r} < {deciding} < {bound!r}:")
    taken = _assignments({**results, name: deciding})
    lines += [f"        {line}" for line in taken]
    lines.append("    else:")
    for called, names in stage.otherwise:
        target = programs[called].target
        _check(target, known)
        known |= set(names)
        flag = ["_"] if programs[called].flag is not None else []
        call = f"{called}({', '.join(argument.name for argument in target.arguments)})"
        lines.append(f"        {', '.join([*names, *flag])} = {call}")
    return lines


def _assignments(results: dict[str, Expr]) -> list[str]:
    """Assign new values to the state, in an order in which none is needed after it changed."""
    waiting = dict(results)
    lines: list[str] = []
    while waiting:
        free = next(
            (
                name
                for name in waiting
                if not any(
                    Symbol(name, real=True) in value.free_symbols
                    for other, value in waiting.items()
                    if other != name
                )
            ),
            None,
        )
        if free is None:
            values = [infix(value, python.PYTHON) for value in waiting.values()]
            return [*lines, *in_lines(f"{', '.join(waiting)} = (", values, ")")]
        lines.append(f"{free} = {infix(waiting.pop(free), python.PYTHON)}")
    return lines


def _check(target: Target, known: set[str]) -> None:
    missing = {argument.name for argument in target.arguments} - known
    if missing:
        msg = f"{target.name}: expected arguments among {sorted(known)}, got also {sorted(missing)}"
        raise ValueError(msg)


def _docstring(loop: Loop) -> list[str]:
    arguments = (*loop.constants, *loop.inputs)
    return [
        f'    """{loop.says}.',
        "",
        f"    Starts with {', '.join(loop.state)}, and returns them after the last sample.",
        "    What they are after each sample is written to the arguments that end in `_kept`. A",
        "    stage whose input is NaN leaves them as they are.",
        "",
        *(f"    {argument.name}: {argument.says}" for argument in arguments),
        '    """',
    ]
