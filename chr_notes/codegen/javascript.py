"""Printer of the JavaScript module that the demos call."""

from chr_notes.codegen import header
from chr_notes.codegen.edges import edges
from chr_notes.codegen.expressions import JavaScript, camel
from chr_notes.codegen.lowering import Program

JAVASCRIPT = JavaScript()


def module(programs: tuple[Program, ...]) -> str:
    """Print an ES module of functions of numbers that return a number or a flat array."""
    head = "\n".join(f"// {line}" for line in header.made_how(programs))
    return head + "\n\n" + "\n\n".join(_function(program) for program in programs) + "\n"


def declarations(programs: tuple[Program, ...]) -> str:
    """Print what TypeScript has to know of that module."""
    lines = [f"// {line}" for line in header.made_how(programs)]
    for program in programs:
        arguments = [f"{camel(argument.name)}: number" for argument in program.target.arguments]
        start = f"export function {camel(program.target.name)}("
        lines += ["", *_comment(program)]
        lines += header.in_lines(start, arguments, f"): {_result(program)};", "  ")
    return "\n".join([*lines, ""])


def _result(program: Program) -> str:
    types = ["number"] * len(program.results) + ["boolean"] * (program.flag is not None)
    return f"[{', '.join(types)}]" if program.shape else "number"


def _comment(program: Program) -> list[str]:
    target = program.target
    last = f" last: {header.FLAG}" if program.flag is not None else ""
    return [
        "/**",
        f" * {header.returns(program)}",
        *(f" * {line}" for line in (*edges(program), *header.rests_on(program))),
        *(f" * @param {{number}} {camel(a.name)} {a.says}" for a in target.arguments),
        f" * @returns {{{_result(program)}}}{last}",
        " */",
    ]


def _function(program: Program) -> str:
    names = [camel(argument.name) for argument in program.target.arguments]
    lines = [
        *_comment(program),
        *header.in_lines(f"export function {camel(program.target.name)}(", names, ") {", "  "),
    ]
    for step in program.steps:
        step_lines = header.statements(step, JAVASCRIPT, lambda _: "const", "let", "  ")
        lines += [part for line in step_lines for part in header.folded(f"  {line}")]
    values = [JAVASCRIPT.written(value) for value in program.results]
    values += [camel(program.flag.name)] if program.flag is not None else []
    if not program.shape:
        return "\n".join([*lines, *header.folded(f"  return {values[0]};"), "}"])
    return "\n".join([*lines, *header.in_lines("  return [", values, "];", "  "), "}"])
