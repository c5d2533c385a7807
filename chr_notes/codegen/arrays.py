"""Printer of functions of arrays, as one writes them by hand with NumPy."""

import re

import numpy as np
from sympy import Symbol

from chr_notes.codegen import header
from chr_notes.codegen.expressions import NumPy
from chr_notes.codegen.lowering import Program, expressions
from chr_notes.codegen.together import PRODUCTS, together
from chr_notes.derivations.computation import Choice, Let

NUMPY = NumPy()
PRINCIPAL = '''
def less_turns(angle: Floats, turns: Floats) -> Floats:
    """Take whole turns off: 2 pi is in three parts, whose first multiples are exact."""
    rest: Floats = angle - turns*6.2831853069365025 - turns*2.4308402025215864e-10
    return rest - turns*8.089064995183803e-21


def principal(angle: Floats) -> Floats:
    """Angle from -pi to pi less whole turns; one that lies there is left as it is."""
    turns = rint(angle*0.15915494309189535)
    found = less_turns(angle, turns)
    beyond = abs(found) > 3.141592653589793
    if count_nonzero(beyond):  # their number was rounded
        found = less_turns(angle, turns + copysign(beyond, found))
    large = abs(angle) >= 1e6
    if count_nonzero(large):
        found = where(large, arctan2(sin(angle), cos(angle)), found)
    return found
'''.strip()
HELPERS = {"principal": PRINCIPAL, "products": PRODUCTS}
"""Functions that stand once in a module, by their names."""


def shape(elements: tuple[object, ...]) -> tuple[int, ...]:
    """Last axes of an array by its elements: none for one of them, 3 by 3 for a matrix."""
    return {1: (), 9: (3, 3)}.get(len(elements), (len(elements),))


def module(programs: tuple[Program, ...]) -> str:
    """Print a module of functions of arrays, which write their result into an array."""
    functions = [_function(program) for program in programs]
    shared = [text for name, text in HELPERS.items() if any(f"{name}(" in f for f in functions)]
    body = "\n\n\n".join([*shared, *functions])
    head = '"""' + "\n".join(header.made_how(programs)) + '\n"""\n\n'
    called = {name for name in re.findall(r"(?<!\.)\b(\w+)\(", body) if hasattr(np, name)}
    used = {"bool_", "float64", *called, *re.findall(r"\bnan\b", body)} - {"abs"}
    imports = [
        f"from numpy import {', '.join(sorted(used))}",
        "from numpy.typing import NDArray",
        "",
        "Floats = NDArray[float64]",
        "Told = tuple[NDArray[bool_] | None, Floats | None]",
    ]
    return head + "\n".join(imports) + f"\n\n\n{body}\n"


def table(programs: tuple[Program, ...]) -> str:
    """Print the shapes of the last axes of each function's arrays and of its result."""
    lines = [
        '"""' + "\n".join(header.made_how(())),
        '"""',
        "",
        "SHAPES: dict[str, tuple[dict[str, tuple[int, ...]], tuple[int, ...]]] = {",
    ]
    for program in programs:
        given = {name: shape(elements) for name, elements in program.target.arrays}
        lines += header.in_lines(
            f'    "{program.target.name}": (',
            [str(given).replace("'", '"'), str(program.shape)],
            "),",
        )
    return "\n".join([*lines, "}", ""])


def _function(program: Program) -> str:
    target = program.target
    arguments = [f"{name}: Floats" for name, _ in target.arrays]
    lines = header.in_lines(f"def {target.name}(", [*arguments, "out: Floats"], ") -> Told:")
    lines += _docstring(program)
    if whole := together(program):
        *steps, last = whole
        lines += [line for step in steps for line in _step(step, None)]
        lines += header.in_brackets("    out[...] = ", NUMPY.written(last.value))
        return "\n".join([*lines, "    return None, None"])
    used = {s.name for v in expressions(program.steps, program.results) for s in v.free_symbols}
    for name, elements in target.arrays:
        for place, element in enumerate(elements):
            if element.name in used and (element.name != name or len(elements) > 1):
                lines.append(f"    {element.name} = {name}{_place(place, shape(elements))}")
    for step in program.steps:
        lines += _step(step, program.flag)
    for place, value in enumerate(program.results):
        to = f"    out{_place(place, program.shape)} = "
        lines += header.in_brackets(to, NUMPY.written(value))
    lines.append(f"    return {program.flag}, {program.guard}")
    return "\n".join(lines)


def _place(place: int, axes: tuple[int, ...]) -> str:
    places = {0: [], 1: [place], 2: [place // 3, place % 3]}[len(axes)]
    return f"[{', '.join(['...', *map(str, places)])}]"


def _step(step: Let | Choice, flag: Symbol | None) -> list[str]:
    if isinstance(step, Let):
        return header.in_brackets(f"    {step.name} = ", NUMPY.written(step.value))
    lines = []
    if flag is not None and step.branches[0][0] == ~flag:
        # What stands at gimbal lock is worked out only where an attitude is.
        (_, usual), (_, instead) = step.branches
        for name, value in zip(step.names, usual, strict=True):
            lines += _step(Let(name, value), None)
        lines.append(f"    if count_nonzero({flag}):")
        for name, value in zip(step.names, instead, strict=True):
            at_lock = f"where({flag}, {NUMPY.written(value)}, {name})"
            lines += header.in_brackets(f"        {name} = ", at_lock)
        return lines
    for name in step.names:
        lines += header.in_brackets(f"    {name} = ", NUMPY.conditional(step, name))
    return lines


def _docstring(program: Program) -> list[str]:
    target = program.target
    lines = [f'    """{header.returns(program)}', ""]
    for name, elements in target.arrays:
        axes = "".join(f", {size}" for size in shape(elements))
        what = elements[0].says if len(elements) == 1 else ", ".join(e.name for e in elements)
        lines.append(f"    {name}: {what}, shape (...{axes})")
    lines.append(f"    out: for the result, shape (...{''.join(f', {n}' for n in program.shape)})")
    told = [header.FLAG] if program.flag is not None else []
    told += [f"the {program.guard}".replace("_", " ")] if program.guard is not None else []
    lines += ["", *header.folded(f"    Returns {', and '.join(told)}.")] if told else []
    last = [line for line in (header.needs(program), *header.ledger(target)) if line]
    lines += ["", *(f"    {line}" for line in last)] if last else []
    return [*lines, '    """']
