"""Printer of C99: `attitude.h` and `attitude.c`, each function in double and in float."""

from dataclasses import dataclass
from functools import partial
from textwrap import wrap

from sympy import Basic
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFunction

from chr_notes.codegen.edges import edges
from chr_notes.codegen.expressions import C, SingleC, Spelling
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


@dataclass(frozen=True)
class Precision:
    """A floating-point type of C.

    Parameters
    ----------
    type
        Its name.
    suffix
        What the names of its functions end in.
    language
        How its expressions are written.
    """

    type: str
    suffix: str
    language: Spelling


_UNCONTRACTED = """
/* No product and sum in one instruction: results are the same everywhere. */
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif"""
PRECISIONS = (Precision("double", "", C()), Precision("float", "_f", SingleC()))


def header(programs: tuple[Program, ...]) -> str:
    """Print `attitude.h`."""
    lines = [
        *_made_how(programs),
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
        for precision in PRECISIONS:
            lines += _signature(program, precision, ");")
        lines.append("")
    lines += ["#ifdef __cplusplus", "}", "#endif", "", "#endif"]
    return "\n".join(lines) + "\n"


def source(programs: tuple[Program, ...]) -> str:
    """Print `attitude.c`."""
    bodies = [
        "\n".join(_function(program, precision)) for program in programs for precision in PRECISIONS
    ]
    includes = ('#include "attitude.h"', "", "#include <math.h>")
    head = "\n".join([*_made_how(programs), *includes, _UNCONTRACTED])
    return "\n\n".join([head, *bodies]) + "\n"


def _made_how(programs: tuple[Program, ...]) -> list[str]:
    return ["/*", *(f" * {line}" for line in made_how(programs)), " */"]


def _comment(program: Program) -> list[str]:
    target = program.target
    lines = [
        returns(program),
        *(f"{argument.name}: {argument.says}" for argument in target.arguments),
        *([f"Returns {FLAG}."] if program.flag is not None else []),
        *edges(program),
        *rests_on(program),
    ]
    return ["/*", *(f" * {line}" for line in lines), " */"]


def _signature(program: Program, precision: Precision, end: str) -> list[str]:
    target = program.target
    arguments = [f"{precision.type} {argument.name}" for argument in target.arguments]
    result = precision.type
    if program.shape:
        result = "int" if program.flag is not None else "void"
        arguments.append(f"{precision.type} out[{len(program.results)}]")
    start = f"{result} attitude_{target.name}{precision.suffix}("
    # A break may stand between arguments, not within one.
    whole = f"{start}{', '.join(arguments)}{end}".replace(
        f"{precision.type} ", precision.type + "_"
    )
    lines = wrap(whole, WIDTH, subsequent_indent="    ", break_on_hyphens=False)
    return [line.replace(precision.type + "_", f"{precision.type} ") for line in lines]


def _function(program: Program, precision: Precision) -> list[str]:
    language = precision.language
    constant = partial(of_type, number=precision.type)
    lines = [*_signature(program, precision, ")"), "{"]
    used = program.used
    lines += [
        f"    (void)({argument.name});"
        for argument in program.target.arguments
        if argument.name not in used
    ]
    for step in program.steps:
        step_lines = statements(step, language, constant, precision.type, "    ")
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
