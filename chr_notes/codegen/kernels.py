"""Printer of C functions of arrays: loops over columns, and loops over samples for filters."""

from collections.abc import Mapping
from itertools import chain

from sympy import cos, sin

from chr_notes.codegen.c import commented, of_type
from chr_notes.codegen.expressions import ColumnC, Spelling, StepC
from chr_notes.codegen.header import folded, made_how
from chr_notes.codegen.lowering import Program, needed_steps
from chr_notes.codegen.rewriting import principal
from chr_notes.codegen.target import Target
from chr_notes.derivations.computation import Choice, Let

COLUMN, STEP = ColumnC(), StepC()
# How elements are named in a frame of axes that are named otherwise.
_ORDERS = {
    "angles": "turns",
    "matrix": "matrix",
    "q": "quaternion",
    "quaternion": "quaternion",
    "angle_rates_matrix_zyx": "rates",
    "angle_rates_matrix_zyz": "rates",
}
RUN = "(ptrdiff_t rows, const double *const *in, const ptrdiff_t *step, double *out,"


def source(columns: Mapping[Target, tuple[Program, ...]], steps: tuple[Program, ...]) -> str:
    """Print the kernels, and a table of them.

    Parameters
    ----------
    columns
        Functions of rows, lowered with guard and validity; those of any turns in two, for the usual
        axes.
    steps
        Steps of filters.
    """
    programs = (*chain(*columns.values()), *steps)
    lines = commented(made_how(programs))
    lines += ['#include "../../native/columns.h"', ""]
    for target, kinds in columns.items():
        for program in kinds:
            lines += [*_columns(program, turned=len(kinds) > 1), ""]
        if len(kinds) > 1:
            lines += [f"BY_AXES({target.name}, {len(kinds[0].results)})", ""]
    for program in steps:
        lines += [*_samples(program), ""]
    lines.append("const Kernel KERNELS[] = {")
    of_steps = ((program.target, (program,)) for program in steps)
    for target, (program, *_) in (*columns.items(), *of_steps):
        sizes = [0 if len(e) == 1 else len(e) for _, e in target.arrays]
        size = len(program.results) if program.shape else 0
        name = target.name
        lines.append(
            f'    {{"{name}", {name}, {size}, {len(sizes)}, {{{", ".join(map(str, sizes))}}}}},'
        )
    return "\n".join([*lines, "    {0},", "};", ""])


def _columns(program: Program, *, turned: bool) -> list[str]:
    """Print a kernel that computes each row by itself, turned if it is in a frame of its own."""
    target = program.target
    size = len(program.results)
    made = target.name.partition("_from_")[0]
    swapped = target.arrays if turned else ()
    loads = [
        f"LOAD({name}_{'given' if turned else 'in'}, {place}, {len(each)},"
        for place, (name, each) in enumerate(target.arrays)
    ]
    return [
        f"EVERY_INSTRUCTION_SET static int64_t {target.name}",
        f"    {RUN}",
        "     unsigned char *odd)",
        "{",
        *(["    const Frame frame = frame_of(in[1]);"] if turned else []),
        "    int64_t any = 0;",
        *(f"    double {name}_in[{len(each)}][BLOCK];" for name, each in target.arrays),
        *(f"    double {name}_given[{len(each)}][BLOCK];" for name, each in swapped),
        f"    LINES({size})",
        *(f"    {load} 0)" for load in loads),
        "    FOR_EACH_BLOCK(rows) {",
        f"        double results[{size}][BLOCK];",
        *([f"        double told[{size}][BLOCK];"] if turned else []),
        "        int64_t left[BLOCK], some = 0;",
        *(
            f"        TO_FRAME({name}_in, {name}_given, {len(each)}, {_ORDERS[name]})"
            for name, each in swapped
        ),
        *loop(program),
        *([f"        FROM_FRAME(told, results, {size}, {_ORDERS[made]})"] if turned else []),
        *(f"        {load} start + BLOCK)" for load in loads),
        f"        STORE({'told' if turned else 'results'}, {size})",
        "        if (some) {",
        "            any = 1;",
        "            for (ptrdiff_t row = 0; row < count; row++)",
        "                odd[start + row] = left[row] != 0;",
        "        }",
        "    }",
        "    FINISH",
        "    return any;",
        "}",
    ]


def loop(program: Program) -> list[str]:
    """Print the loop over a block of rows."""
    inner: list[str] = []
    for name, elements in program.target.arrays:
        inner += [
            f"const double {element.name} = {name}_in[{place}][row];"
            for place, element in enumerate(elements)
        ]
    for step in _off_the_pole(program):
        inner += _constants(step, COLUMN)
    inner += [f"results[{p}][row] = {COLUMN.written(v)};" for p, v in enumerate(program.results)]
    kept = " & ".join(_handled(program))
    inner += [f"left[row] = !({kept});", "some |= left[row];"]
    return [
        "        for (ptrdiff_t row = 0; row < padded; row++) {",
        *(part for line in inner for part in folded(f"            {line}")),
        "        }",
    ]


def _handled(program: Program) -> list[str]:
    """List the conditions under which a row is right: what is not met goes the general way.

    NaN in an element that does not enter makes the row NaN too.
    """
    names = [element.name for _, elements in program.target.arrays for element in elements]
    conditions = [f"FINITE({' + '.join(names)})"]
    angles = {call.args[0] for call in program.expressions.atoms(sin, cos, principal)}
    conditions += [
        f"(fabs({COLUMN.written(angle)}) < LARGEST_ANGLE)" for angle in sorted(angles, key=str)
    ]
    if program.valid is not None:
        conditions.append(f"{program.valid}")
    elif program.guard is not None:
        conditions.append(f"IN_RANGE({program.guard})")
    if program.flag is not None:
        conditions.append(f"!{program.flag}")
    return conditions


def _off_the_pole(program: Program) -> tuple[Let | Choice, ...]:
    """Leave out what is for gimbal lock alone: rows there go the general way."""
    steps: list[Let | Choice] = []
    for step in program.steps:
        if isinstance(step, Choice) and program.flag and step.branches[0][0] == ~program.flag:
            steps += map(Let, step.names, step.branches[0][1])
        else:
            steps.append(step)
    return needed_steps(steps, program.results, {program.flag, program.guard, program.valid})


def _constants(step: Let | Choice, language: Spelling) -> list[str]:
    if isinstance(step, Let):
        return [f"{of_type(step.value, 'double')} {step.name} = {language.written(step.value)};"]
    return [f"const double {name} = {language.conditional(step, name)};" for name in step.names]


def _samples(program: Program) -> list[str]:
    """Print a kernel that goes from sample to sample, with a state that each one changes."""
    target = program.target
    (_, state), *samples = target.arrays
    used = program.used
    lines = [
        f"static int64_t {target.name}",
        f"    {RUN}",
        "     unsigned char *odd)",
        "{",
        *(f"    double {e.name} = in[0][{place}];" for place, e in enumerate(state)),
        "    int64_t any = 0;" if program.valid else "    (void)odd;",
        "    for (ptrdiff_t row = 0; row < rows; row++) {",
    ]
    inner: list[str] = []
    for array, (_, elements) in enumerate(samples, start=1):
        inner += [
            f"const double {element.name} = in[{array}][row * step[{array}] + {place}];"
            for place, element in enumerate(elements)
            if element.name in used
        ]
    for step in program.steps:
        inner += _constants(step, STEP)
    inner += [
        f"const double next_{e.name} = {STEP.written(value)};"
        for e, value in zip(state, program.results, strict=True)
    ]
    inner += [
        f"out[row * {len(state)} + {place}] = {e.name} = next_{e.name};"
        for place, e in enumerate(state)
    ]
    if program.valid:
        inner += [f"odd[row] = !{program.valid};", "any |= odd[row];"]
    lines += [part for line in inner for part in folded(f"        {line}")]
    return [*lines, "    }", f"    return {'any' if program.valid else 0};", "}"]
