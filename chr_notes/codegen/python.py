"""Printers of Python: `math` for one attitude, NumPy for arrays of them."""

from sympy.printing.numpy import NumPyPrinter
from sympy.printing.pycode import PythonCodePrinter

from chr_notes.codegen.header import made_how, returns
from chr_notes.codegen.lowering import Program

_SCALAR = PythonCodePrinter({"fully_qualified_modules": False})
_ARRAYS = NumPyPrinter({"fully_qualified_modules": True})


def scalar_module(programs: tuple[Program, ...]) -> str:
    """Print a module of functions of floats that return a float or a flat tuple."""
    body = "\n\n\n".join(_scalar_function(program) for program in programs)
    used = sorted(name for name in ("cos", "sin", "sqrt", "tan", "atan2") if f"{name}(" in body)
    head = '"""' + "\n".join(made_how(programs)) + '\n"""\n\n'
    return f"{head}from math import {', '.join(used)}\n\n\n{body}\n"


def _scalar_function(program: Program) -> str:
    target = program.target
    arguments = ", ".join(f"{argument.name}: float" for argument in target.arguments)
    result = (
        "float" if not program.shape else f"tuple[{', '.join(['float'] * len(program.results))}]"
    )
    lines = [f"def {target.name}({arguments}) -> {result}:", *_docstring(program)]
    lines += [f"    {local} = {_SCALAR.doprint(value)}" for local, value in program.assignments]
    values = [_SCALAR.doprint(value) for value in program.results]
    if not program.shape:
        return "\n".join([*lines, f"    return {values[0]}"])
    return "\n".join([*lines, "    return (", *(f"        {value}," for value in values), "    )"])


def array_module(programs: tuple[Program, ...]) -> str:
    """Print a module of functions of arrays of one shape, which write to `out`."""
    body = "\n\n\n".join(_array_function(program) for program in programs)
    head = '"""' + "\n".join(made_how(programs)) + '\n"""\n\n'
    return f"{head}import numpy\nfrom numpy.typing import NDArray\n\n\n{body}\n"


def _array_function(program: Program) -> str:
    target = program.target
    array = "NDArray[numpy.float64]"
    arguments = ", ".join(f"{argument.name}: {array}" for argument in target.arguments)
    lines = [f"def {target.name}({arguments}, out: {array}) -> None:", *_docstring(program)]
    lines += [f"    {local} = {_ARRAYS.doprint(value)}" for local, value in program.assignments]
    for index, value in enumerate(program.results):
        lines.append(f"    out[{_place(index, program.shape)}] = {_ARRAYS.doprint(value)}")
    return "\n".join(lines)


def _place(index: int, shape: tuple[int, ...]) -> str:
    """Index of one element on the last axes."""
    if len(shape) < 2:  # noqa: PLR2004 (a matrix has two axes)
        return ", ".join(["...", *([str(index)] if shape else [])])
    row, column = divmod(index, shape[1])
    return f"..., {row}, {column}"


def _docstring(program: Program) -> list[str]:
    target = program.target
    entries = ", ".join(target.entries)
    return [
        f'    """{returns(target, program.shape)}',
        "",
        *(f"    {argument.name}: {argument.says}" for argument in target.arguments),
        "",
        f"    Ledger: {entries}.",
        '    """',
    ]
