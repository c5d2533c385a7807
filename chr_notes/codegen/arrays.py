"""Printer of functions of arrays, as one writes them by hand with NumPy."""

import re

import numpy as np
from sympy import Symbol

from chr_notes.codegen import header
from chr_notes.codegen.expressions import NumPy
from chr_notes.codegen.lowering import Program
from chr_notes.codegen.together import PRODUCTS, together
from chr_notes.derivations.computation import NOTHING, Choice, Let

NUMPY = NumPy()
PRINCIPAL = '''
# Arrays, which NumPy takes in less time than numbers.
NONE, PI, INVERSE, TURN, LOW = (array(number) for number in
    (0.0, 3.141592653589793, 0.1591545, 6.2831853069365025, 2.430840202602477e-10))


def less_turns(angle: Floats, turns: Floats) -> Floats:
    """Take whole turns off: 2 pi is in two parts, the first of which has exact multiples."""
    rest: Floats = angle - turns*TURN - turns*LOW
    return rest


def principal(angle: Floats) -> Floats:
    """Angle in [-pi, pi) less whole turns; one that lies there is left as it is."""
    turns = rint(angle*INVERSE + NONE)  # of -0.0 too it is 0.0, and what is left -0.0
    found = less_turns(angle, turns)
    if count_nonzero(abs(found) >= PI):
        # The number of turns was rounded, and is off for large angles: the inverse has few digits.
        found = less_turns(angle, turns + copysign(abs(found) > PI, found))
        large = abs(angle) >= 1e6
        if count_nonzero(large):
            found = where(large, arctan2(sin(angle), cos(angle)), found)
        found = where(found >= PI, -PI, found)
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
    called = {name for name in re.findall(r"(?<!\.)\b(\w+)\(", body) if hasattr(np, name)}
    used = {"bool_", "float64", *called, *re.findall(r"\bnan\b", body)} - {"abs"}
    imports = [
        f"from numpy import {', '.join(sorted(used))}",
        "from numpy.typing import NDArray",
        "",
        "Floats = NDArray[float64]",
        "Told = tuple[NDArray[bool_] | None, Floats | None]",
    ]
    return header.docstring(programs) + "\n".join(imports) + f"\n\n\n{body}\n"


def table(programs: tuple[Program, ...]) -> str:
    """Print the shapes of the last axes of each function's arrays and of its result."""
    lines = ["SHAPES: dict[str, tuple[dict[str, tuple[int, ...]], tuple[int, ...]]] = {"]
    for program in programs:
        given = {name: shape(elements) for name, elements in program.target.arrays}
        lines += header.in_lines(
            f'    "{program.target.name}": (',
            [str(given).replace("'", '"'), str(program.shape)],
            "),",
        )
    return header.docstring(()) + "\n".join([*lines, "}", ""])


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
    used = program.used
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
    *seldom, (_, usual) = step.branches
    if flag is not None and step.branches[0][0] == ~flag:
        # What stands at gimbal lock is worked out only where an attitude is.
        (_, usual), (_, at_lock) = step.branches
        seldom = [(flag, at_lock)]
    elif NOTHING in usual or not (
        usual[0].is_Symbol and all(value.is_number for _, values in seldom for value in values)
    ):
        # Numbers that stand for what is at an end of a range are seldom put in, all else often.
        texts = ((f"    {name} = ", NUMPY.conditional(step, name)) for name in step.names)
        return [line for each in texts for line in header.in_brackets(*each)]
    pairs = zip(step.names, usual, strict=True)
    lines = [line for pair in pairs for line in _step(Let(*pair), None)]
    for condition, values in reversed(seldom):
        where = NUMPY.written(condition)
        lines.append(f"    if count_nonzero({where}):")
        for name, value in zip(step.names, values, strict=True):
            there = f"where({where}, {NUMPY.written(value)}, {name})"
            lines += header.in_brackets(f"        {name} = ", there)
    return lines


def _docstring(program: Program) -> list[str]:
    # What the arrays hold the function's own first lines say, and their shapes `shapes` does.
    lines = [f'    """{header.returns(program)}']
    told = [header.FLAG] if program.flag is not None else []
    told += [f"the {program.guard}".replace("_", " ")] if program.guard is not None else []
    lines += ["", *header.folded(f"    Returns {', and '.join(told)}.")] if told else []
    last = header.rests_on(program)
    lines += ["", *(f"    {line}" for line in last)] if last else []
    return [*lines, '    """'] if len(lines) > 1 else [f'{lines[0]}"""']
