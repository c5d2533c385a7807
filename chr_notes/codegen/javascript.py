"""Printer of the JavaScript module that the demos call."""

from chr_notes.codegen.expressions import Language, conditional, infix
from chr_notes.codegen.header import FLAG, WIDTH, folded, in_lines, ledger, made_how, needs, returns
from chr_notes.codegen.lowering import Program
from chr_notes.derivations.computation import Choice, Let


def camel(name: str) -> str:
    """Turn a name with underscores into JavaScript's way of writing names."""
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def number(value: float) -> str:
    """Write a number: whole ones without a point."""
    return str(int(value)) if value == int(value) else repr(value)


JAVASCRIPT = Language(
    name=camel,
    number=number,
    call={
        "Abs": "Math.abs",
        **{
            name: f"Math.{name}"
            for name in ("acos", "asin", "atan", "atan2", "cos", "floor", "hypot", "sin", "sqrt")
        },
        "tan": "Math.tan",
    },
    remainder="{0} % {1}",
    epsilon=2.0**-52,
    both="&&",
    either="||",
    negation="!",
    conditional="{condition} ? {yes} : {no}",
)


def module(programs: tuple[Program, ...]) -> str:
    """Print an ES module of functions of numbers that return a number or a flat array."""
    head = "\n".join(f"// {line}" for line in made_how(programs))
    return head + "\n\n" + "\n\n".join(_function(program) for program in programs) + "\n"


def _function(program: Program) -> str:
    target = program.target
    names = [camel(argument.name) for argument in target.arguments]
    result = "number[]" if program.shape else "number"
    if program.flag is not None:
        result = f"[...{result}, boolean]"
    lines = [
        "/**",
        f" * {returns(program)}",
        *(
            f" * @param {{number}} {name} {a.says}"
            for name, a in zip(names, target.arguments, strict=True)
        ),
        f" * @returns {{{result}}}{f' last: {FLAG}' if program.flag is not None else ''}",
        *(f" * {line}" for line in (needs(program), *ledger(target)) if line),
        " */",
        *in_lines(f"export function {camel(target.name)}(", names, ") {", "  "),
    ]
    for step in program.steps:
        lines += [part for line in _step(step) for part in folded(f"  {line}")]
    values = [infix(value, JAVASCRIPT) for value in program.results]
    values += [camel(program.flag.name)] if program.flag is not None else []
    if not program.shape:
        return "\n".join([*lines, *folded(f"  return {values[0]};"), "}"])
    return "\n".join([*lines, *in_lines("  return [", values, "];", "  "), "}"])


def _step(step: Let | Choice) -> list[str]:
    if isinstance(step, Let):
        return [f"const {camel(step.name.name)} = {infix(step.value, JAVASCRIPT)};"]
    one = conditional(step, JAVASCRIPT)
    if one is not None and len(one) <= WIDTH // 2:
        return [f"const {camel(step.names[0].name)} = {one};"]
    lines = [f"let {', '.join(camel(name.name) for name in step.names)};"]
    for place, (condition, values) in enumerate(step.branches):
        if condition == True:  # noqa: E712 (SymPy's true, not Python's)
            lines.append("} else {")
        else:
            lines.append(f"{'} else ' if place else ''}if ({infix(condition, JAVASCRIPT)}) {{")
        lines += [
            f"  {camel(name.name)} = {infix(value, JAVASCRIPT)};"
            for name, value in zip(step.names, values, strict=True)
        ]
    return [*lines, "}"]
