"""Printer of Python for one attitude at a time, with `math`."""

import math
import re

from sympy import true

from chr_notes.codegen import header
from chr_notes.codegen.expressions import Python
from chr_notes.codegen.lowering import Program
from chr_notes.derivations.computation import Choice, Let

PYTHON = Python()


def module(programs: tuple[Program, ...]) -> str:
    """Print a module of functions of floats that return a float or a flat tuple."""
    body = "\n\n\n".join(function(program) for program in programs)
    return f"{header.docstring(programs)}{imports(body)}\n{body}\n"


def imports(body: str) -> str:
    """Import what the functions of a module call."""
    used = sorted({name for name in re.findall(r"\b(\w+)\(", body) if hasattr(math, name)})
    used += [PYTHON.nothing] if re.search(rf"\b{PYTHON.nothing}\b", body) else []
    return f"from math import {', '.join(used)}\n\n" if used else ""


def function(program: Program) -> str:
    """Print a function of floats that returns a float or a flat tuple."""
    target = program.target
    arguments = [f"{argument.name}: float" for argument in target.arguments]
    types = ["float"] * len(program.results) + ["bool"] * (program.flag is not None)
    result = f"tuple[{', '.join(types)}]" if program.shape else "float"
    lines = header.in_lines(f"def {target.name}(", arguments, f") -> {result}:")
    lines += _docstring(program)
    for step in program.steps:
        lines += step_lines(step)
    values = [PYTHON.written(value) for value in program.results]
    values += [program.flag.name] if program.flag is not None else []
    if not program.shape:
        return "\n".join([*lines, *header.in_brackets("    return ", values[0])])
    return "\n".join([*lines, *header.in_lines("    return (", values, ")")])


def step_lines(step: Let | Choice) -> list[str]:
    """Print a step of a program, indented once."""
    if isinstance(step, Let):
        return header.in_brackets(f"    {step.name} = ", PYTHON.written(step.value))
    if header.is_short(step, PYTHON):
        return [f"    {step.names[0]} = {PYTHON.conditional(step, step.names[0])}"]
    lines = []
    for place, (condition, values) in enumerate(step.branches):
        if condition is true:
            lines.append("    else:")
        else:
            lines.append(f"    {'elif' if place else 'if'} {PYTHON.written(condition)}:")
        for name, value in zip(step.names, values, strict=True):
            lines += header.in_brackets(f"        {name} = ", PYTHON.written(value))
    return lines


def _docstring(program: Program) -> list[str]:
    target = program.target
    parts = [[f"{argument.name}: {argument.says}" for argument in target.arguments]]
    if program.flag is not None:
        parts.append([f"Also returns {header.FLAG}."])
    parts.append(header.rests_on(program))
    lines = [f'    """{header.returns(program)}']
    for part in parts:
        lines += ["", *(f"    {line}" for line in part)] if part else []
    return [*lines, '    """']
