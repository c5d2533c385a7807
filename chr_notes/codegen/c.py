"""Printer of C99: `attitude.h` and `attitude.c`, each function in double and in float."""

from collections.abc import Iterable
from functools import partial
from textwrap import wrap

from sympy import Basic
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFunction

from chr_notes.codegen.edges import edges
from chr_notes.codegen.expressions import C, SingleC
from chr_notes.codegen.header import (
    FLAG,
    WIDTH,
    folded,
    made_how,
    rests_on,
    returns,
    statements,
)
from chr_notes.codegen.lowering import Program

_UNCONTRACTED = """
/* No product and sum in one instruction: results are the same everywhere. */
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif"""
LANGUAGES = (C(), SingleC())


def header(programs: tuple[Program, ...]) -> str:
    """Print `attitude.h`."""
    lines = [
        *commented(made_how(programs)),
        "#ifndef ATTITUDE_H",
        "#define ATTITUDE_H",
        "",
        "#ifdef __cplusplus",
        'extern "C" {',
        "#endif",
        "",
    ]
    for program in programs:
        lines += _comment(program)
        for language in LANGUAGES:
            lines += _signature(program, language, ");")
        lines.append("")
    lines += ["#ifdef __cplusplus", "}", "#endif", "", "#endif"]
    return "\n".join(lines) + "\n"


def source(programs: tuple[Program, ...]) -> str:
    """Print `attitude.c`."""
    bodies = [
        "\n".join(_function(program, language)) for program in programs for language in LANGUAGES
    ]
    includes = ('#include "attitude.h"', "", "#include <math.h>")
    head = "\n".join([*commented(made_how(programs)), *includes, _UNCONTRACTED])
    return "\n\n".join([head, *bodies]) + "\n"


def commented(lines: Iterable[str]) -> list[str]:
    """Put lines into a comment."""
    return ["/*", *(f" * {line}" for line in lines), " */"]


def _comment(program: Program) -> list[str]:
    target = program.target
    lines = [
        returns(program),
        *(f"{argument.name}: {argument.says}" for argument in target.arguments),
        *([f"Returns {FLAG}."] if program.flag is not None else []),
        *edges(program),
        *rests_on(program),
    ]
    return commented(lines)


def _signature(program: Program, language: C, end: str) -> list[str]:
    target, number = program.target, language.precision
    arguments = [f"{number}\xa0{argument.name}" for argument in target.arguments]
    result = number
    if program.shape:
        result = "int" if program.flag is not None else "void"
        arguments.append(f"{number}\xa0out[{len(program.results)}]")
    start = f"{result} attitude_{target.name}{language.suffix}("
    # A break may stand between arguments, not within one.
    whole = f"{start}{', '.join(arguments)}{end}"
    return [line.replace("\xa0", " ") for line in wrap(whole, WIDTH, subsequent_indent="    ")]


def _function(program: Program, language: C) -> list[str]:
    constant = partial(of_type, number=language.precision)
    lines = [*_signature(program, language, ")"), "{"]
    used = program.used
    lines += [
        f"    (void)({argument.name});"
        for argument in program.target.arguments
        if argument.name not in used
    ]
    for step in program.steps:
        step_lines = statements(step, language, constant, language.precision, "    ")
        lines += [part for line in step_lines for part in folded(f"    {line}")]
    values = [language.written(value) for value in program.results]
    if not program.shape:
        return [*lines, *folded(f"    return {values[0]};"), "}"]
    for index, value in enumerate(values):
        lines += folded(f"    out[{index}] = {value};")
    if program.flag is not None:
        lines.append(f"    return {program.flag.name};")
    return [*lines, "}"]


def of_type(value: Basic, number: str) -> str:
    """Declare a constant by its value: a condition, or a number of that type."""
    return f"const {'int' if isinstance(value, BooleanFunction | Relational) else number}"
