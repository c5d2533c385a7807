"""Printer of the JavaScript module that the demos call."""

from sympy.printing.jscode import JavascriptCodePrinter

from chr_notes.codegen.header import made_how, returns
from chr_notes.codegen.lowering import Program

_PRINTER = JavascriptCodePrinter()


def camel(name: str) -> str:
    """Turn a name with underscores into JavaScript's way of writing names."""
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def module(programs: tuple[Program, ...]) -> str:
    """Print an ES module of functions of numbers that return a number or a flat array."""
    head = "\n".join(f"// {line}" for line in made_how(programs))
    return head + "\n\n" + "\n\n".join(_function(program) for program in programs) + "\n"


def _function(program: Program) -> str:
    target = program.target
    names = {argument.name: camel(argument.name) for argument in target.arguments}
    names |= {str(local): camel(str(local)) for local, _ in program.assignments}
    arguments = ", ".join(names[argument.name] for argument in target.arguments)
    lines = [
        "/**",
        f" * {returns(target, program.shape)}",
        *(f" * @param {{number}} {names[a.name]} {a.says}" for a in target.arguments),
        f" * @returns {{{'number[]' if program.shape else 'number'}}}",
        f" * Ledger: {', '.join(target.entries)}.",
        " */",
        f"export function {camel(target.name)}({arguments}) {{",
    ]
    symbols = {local: type(local)(names[str(local)]) for local, _ in program.assignments}
    for value in (*(v for _, v in program.assignments), *program.results):
        symbols |= {s: type(s)(names[str(s)]) for s in value.free_symbols}
    for local, value in program.assignments:
        lines.append(f"  const {symbols[local]} = {_PRINTER.doprint(value.xreplace(symbols))};")
    values = [_PRINTER.doprint(value.xreplace(symbols)) for value in program.results]
    if program.shape:
        lines += ["  return [", *(f"    {value}," for value in values), "  ];", "}"]
    else:
        lines += [f"  return {values[0]};", "}"]
    return "\n".join(lines)
