"""Parts of the book's page about the generated code: the stages before a function is printed."""

from collections.abc import Iterator, Mapping
from textwrap import dedent
from typing import Final

from sympy import ImmutableMatrix, Symbol

from chr_notes.codegen.arguments import ANGLE_RATES
from chr_notes.codegen.header import made_how
from chr_notes.codegen.kernels import loop
from chr_notes.codegen.lowering import Program
from chr_notes.codegen.python import PYTHON
from chr_notes.codegen.target import Target
from chr_notes.derivations.computation import Let
from chr_notes.derivations.forms.euler import euler_rates
from chr_notes.symbols import EULER_RATES
from chr_notes.typeset import formula

__all__ = ["parts"]

_NAME: Final = "euler_rates_from_body_rates"


def parts(
    programs: tuple[Program, ...], columns: Mapping[Target, tuple[Program, ...]]
) -> dict[str, str]:
    """Return the text of each part by its file name.

    Parameters
    ----------
    programs
        All lowered functions.
    columns
        Functions of rows, lowered for the kernels.
    """
    program = next(each for each in programs if each.target.name == _NAME)
    (in_rows,) = columns[program.target]
    rows = dedent("\n".join(loop(in_rows)))
    made = "\n".join(f"% {line}" for line in made_how(()))
    texts = {
        "form.md": "\n".join(_form()),
        "library.md": f"```text\n{_steps(program)}\n```",
        "kernel.md": f"```c\n{rows}\n```",
    }
    return {name: f"{made}\n\n{text}\n" for name, text in texts.items()}


def _form() -> Iterator[str]:
    """Yield the form in which the formula is computed: the named steps, then the results."""
    form = euler_rates()
    short: dict[Symbol, Symbol] = {}
    for step in form.steps:
        if isinstance(step, Let):
            short[step.name] = Symbol("s", real=True)
            yield _display(formula(short[step.name], step.value).latex)
    yield _display(formula(ImmutableMatrix(EULER_RATES), form.results.xreplace(short)).latex)


def _display(text: str) -> str:
    return f"$$\n{text}\n$$"


def _steps(program: Program) -> str:
    """Write the steps of a program and its results, one a line."""
    lines = [f"{s.name} = {PYTHON.written(s.value)}" for s in program.steps if isinstance(s, Let)]
    for rate, value in zip(ANGLE_RATES, program.results, strict=True):
        lines.append(f"{rate.name} = {PYTHON.written(value)}")
    return "\n".join(lines)
