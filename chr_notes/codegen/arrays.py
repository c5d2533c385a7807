"""Printer of NumPy functions that work on blocks of rows and allocate nothing of their size."""

import re
from dataclasses import replace

from chr_notes.codegen.blocks import Call, calls, in_place
from chr_notes.codegen.expressions import infix
from chr_notes.codegen.header import FLAG, WIDTH, folded, in_lines, ledger, made_how, returns
from chr_notes.codegen.lowering import Program
from chr_notes.codegen.python import PYTHON

# How the comments write formulas.
_OF_PAIRS = {"conjugate": "conjugate", "re": "real", "im": "imag"}
COMMENTS = replace(PYTHON, call={**PYTHON.call, **_OF_PAIRS})

_BOOLEAN = re.compile("less|greater|logical")
WORK, PAIRS = 16, 8
"""How many arrays of real and of complex numbers a function is given for what it computes."""


def module(programs: tuple[Program, ...]) -> str:
    """Print a module of functions of arrays of one shape, which write to `out`."""
    body = "\n\n\n".join(_function(program) for program in programs)
    pairs = any(program.target.complex for program in programs)
    types = (
        ["float64"]
        + ["complex128"] * pairs
        + ["bool_"] * any(program.flag is not None for program in programs)
    )
    used = sorted({call.function for program in programs for call in calls(program)[0]})
    head = '"""' + "\n".join(made_how(programs)) + '\n"""\n\n'
    imports = "\n".join(
        [
            "from collections.abc import Sequence",
            "",
            *in_lines("from numpy import (", sorted([*used, *types]), ")"),
            "from numpy.typing import NDArray",
            "",
            "Block = NDArray[float64]",
            *(["Pairs = NDArray[complex128]"] if pairs else []),
        ]
    )
    return f"{head}{imports}\n\n\n{body}\n"


def _function(program: Program) -> str:
    target = program.target
    made, complex_values = calls(program)
    kinds = {name: "Pairs" if name in complex_values else "Block" for name in _names(program)}
    results = sorted({kinds[name] for name in _results(program)})
    arguments = [f"{argument.name}: {kinds[argument.name]}" for argument in target.arguments]
    arguments += [f"out: Sequence[{' | '.join(results)}]", "work: Sequence[Block]"]
    arguments += ["pairs: Sequence[Pairs]"] if target.complex else []
    told = (program.guard, program.flag)
    reports = [symbol.name for symbol in told if symbol is not None]
    types = [
        kind if symbol is not None else "None"
        for symbol, kind in zip(told, ("Block", "NDArray[bool_]"), strict=True)
    ]
    result = f"tuple[{', '.join(types)}]" if reports else "None"
    lines = in_lines(f"def {target.name}(", arguments, f") -> {result}:")
    lines += _docstring(program)
    storage = _storage(made, complex_values, _fixed(program), reports)
    inside = None
    defined: set[str] = set()
    for place, call in enumerate(made):
        if call.inside is not None and call.inside != inside:
            lines.append(f"    if {_operand(call.inside, storage)}.any():")
        inside = call.inside
        indent = "        " if inside else "    "
        alone = place + 1 == len(made) or made[place + 1].says is not None
        whole = _whole(call.result)
        if whole != call.result and not whole.startswith("$") and whole not in defined:
            # The first part of a complex local: the whole gets its name.
            lines.append(f"{indent}{whole} = {storage[whole]}")
            defined.add(whole)
        lines += [indent + line for line in _statement(call, storage, alone=alone)]
    if reports:
        lines.append(f"    return {', '.join(map(str, told))}")
    return "\n".join(lines)


def _names(program: Program) -> list[str]:
    return [*(argument.name for argument in program.target.arguments), *_results(program)]


def _results(program: Program) -> list[str]:
    return [f"out[{index}]" for index in range(len(program.results))]


def _docstring(program: Program) -> list[str]:
    target = program.target
    size = len(program.results)
    elements = "an array for the result" if size == 1 else f"{size} arrays for the elements"
    lines = [
        f'    """{returns(program)}',
        "",
        *(f"    {argument.name}: {argument.says}" for argument in target.arguments),
        f"    out: {elements}",
        f"    work: {WORK} arrays for what is computed on the way",
    ]
    if target.complex:
        lines.append(f"    pairs: {PAIRS} arrays of complex numbers for the same")
    told = [program.guard.name.replace("_", " ")] if program.guard is not None else []
    told += [FLAG] if program.flag is not None else []
    if told:
        lines += ["", f"    Returns the {', and '.join(told)}."]
    entries = [f"    {line}" for line in ledger(target)]
    return [*lines, *([""] if entries else []), *entries, '    """']


def _fixed(program: Program) -> dict[str, str]:
    """Say where arguments and results are: a local that is a result has its place in `out`."""
    named = {name: f"out[{index}]" for name, index in in_place(program).items()}
    return {name: name for name in _names(program)} | named


def _whole(name: str) -> str:
    """Give the name of the complex value of which this is a part, or of the value itself."""
    return name.removesuffix(".real").removesuffix(".imag")


def _storage(
    made: list[Call], complex_values: set[str], fixed: dict[str, str], reports: list[str]
) -> dict[str, str]:
    """Give each value an array of `work` or `pairs`, which serves again once it is not needed.

    Booleans need none: a block of them is small, so NumPy allocates it.
    """
    last = {}
    for place, call in enumerate(made):
        for name in (*call.operands, call.result, call.where, call.inside):
            if isinstance(name, str):
                last[_whole(name)] = place
    last |= dict.fromkeys(reports, len(made))
    free = {"work": list(range(WORK)), "pairs": list(range(PAIRS))}
    storage = dict(fixed)
    rows: dict[str, tuple[str, int]] = {}
    for place, call in enumerate(made):
        result = _whole(call.result)
        for name in [name for name in rows if last[name] <= place and name != result]:
            kind, row = rows.pop(name)
            free[kind] = sorted([*free[kind], row])
        if result in storage:
            continue
        if _BOOLEAN.match(call.function):
            storage[result] = result.replace("$", "condition_")
            continue
        kind = "pairs" if result in complex_values else "work"
        if not free[kind]:
            msg = f"expected at most {WORK} values at once, {PAIRS} of them complex, got {call}"
            raise ValueError(msg)
        rows[result] = kind, free[kind].pop(0)
        storage[result] = "{}[{}]".format(*rows[result])
    return storage


def _operand(operand: str | float, storage: dict[str, str]) -> str:
    if isinstance(operand, float):
        return repr(operand)
    # A local is known by its name, what has none by its place.
    whole = _whole(operand)
    return operand.replace(whole, storage.get(whole, whole)) if whole.startswith("$") else operand


def _statement(call: Call, storage: dict[str, str], *, alone: bool) -> list[str]:
    """Print a call, after its formula where that takes more than one."""
    operands = ", ".join(_operand(operand, storage) for operand in call.operands)
    lines = []
    if call.says is not None and not alone:
        formula = folded(f"{call.says.name} = {infix(call.says.value, COMMENTS)}", WIDTH - 10)
        lines += [f"# {line}" for line in formula]
    whole = _whole(call.result)
    is_part = whole != call.result
    place = _operand(call.result, storage) if is_part else storage[whole]
    is_local = call.result != place and not is_part and not call.result.startswith("$")
    if call.function == "copyto":
        where = f", where={_operand(call.where, storage)}" if call.where else ""
        if is_local and not call.where:
            lines.append(f"{call.result} = {place}")
        return [*lines, f"copyto({_operand(call.result, storage)}, {operands}{where})"]
    if _BOOLEAN.match(call.function):
        return [*lines, f"{place} = {call.function}({operands})"]
    named = f"{call.result} = " if is_local else ""
    return [*lines, f"{named}{call.function}({operands}, out={place})"]
