"""A page about the generated code: one formula followed through all stages."""

import re
from collections.abc import Iterator
from math import radians
from pathlib import Path
from textwrap import dedent
from typing import Final

import numpy as np
from sympy import ImmutableMatrix, Symbol

from chr_notes.codegen.lowering import Program, lower
from chr_notes.codegen.python import PYTHON
from chr_notes.codegen.rewriting import by_library
from chr_notes.codegen.targets import TARGETS
from chr_notes.derivations import euler
from chr_notes.derivations.computation import Let
from chr_notes.derivations.forms.euler import euler_rates
from chr_notes.generated.scalar.euler import euler_rates_from_body_rates
from chr_notes.symbols import EULER_RATES
from chr_notes.typeset import formula

__all__ = ["generated"]

ROOT: Final = Path(__file__).resolve().parents[2]
GENERATED: Final = ROOT / "chr_notes" / "generated"
NAME: Final = "euler_rates_from_body_rates"
TARGET: Final = next(target for target in TARGETS if target.name == NAME)


def generated() -> dict[str, str]:
    """Return the text of each part of the pages by its file name."""
    return {
        "code/derived.md": _display(
            formula(ImmutableMatrix(EULER_RATES), euler.euler_rates()).latex
        ),
        "code/form.md": "\n".join(_form()),
        "code/library.md": _block("text", steps(lower(TARGET, by_library))),
        "code/number.md": "\n".join(_number()),
        "code/python.md": _block("python", python(GENERATED / "scalar" / "euler.py")),
        "code/numpy.md": _block("python", python(GENERATED / "arrays" / "euler.py")),
        "code/kernel.md": _block("c", kernel()),
        "code/javascript.md": _block("javascript", javascript()),
        "code/c.md": _block("c", c()),
    }


def _display(text: str) -> str:
    return f"$$\n{text}\n$$\n"


def _block(language: str, text: str) -> str:
    return f"```{language}\n{text}\n```\n"


def _form() -> Iterator[str]:
    """Yield the form in which the formula is computed: the named steps, then the results."""
    form = euler_rates()
    short: dict[Symbol, Symbol] = {}
    for step in form.steps:
        if isinstance(step, Let):
            short[step.name] = Symbol("s", real=True)
            yield _display(formula(short[step.name], step.value).latex)
    yield _display(formula(ImmutableMatrix(EULER_RATES), form.results.xreplace(short)).latex)


def steps(program: Program) -> str:
    """Write the steps of a program and its results, one a line."""
    lines = [f"{s.name} = {PYTHON.written(s.value)}" for s in program.steps if isinstance(s, Let)]
    names = ("roll_rate", "pitch_rate", "yaw_rate")
    for name, value in zip(names, program.results, strict=True):
        lines.append(f"{name} = {PYTHON.written(value)}")
    return "\n".join(lines)


def python(path: Path, name: str = NAME) -> str:
    """Find the function in a generated module of Python."""
    return _find(rf"^def {name}\(.*?(?=\n\n\n|\Z)", path)


def javascript() -> str:
    """Find the function in the generated module of JavaScript."""
    text = _find(
        r"^/\*\*(?:(?!\*/).)*?\*/\nexport function eulerRatesFromBodyRates\(.*?^\}",
        GENERATED / "javascript" / "attitude.mjs",
    )
    return text[text.rindex("/**") :]


def c() -> str:
    """Find the function in the generated C, in double precision."""
    return _find(rf"^void attitude_{NAME}\(.*?^\}}", GENERATED / "c" / "attitude.c")


def kernel() -> str:
    """Find the loop over a block of rows in the generated kernels."""
    whole = _find(
        rf"^EVERY_INSTRUCTION_SET static int64_t {NAME}\n.*?^\}}", GENERATED / "c" / "kernels.c"
    )
    start = whole.index("        for (ptrdiff_t row = 0; row < padded; row++) {")
    return dedent(whole[start : whole.index("        STORE")]).rstrip()


def _find(pattern: str, path: Path) -> str:
    found = re.search(pattern, path.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    if found is None:
        msg = f"expected {NAME} in {path.name}, found none"
        raise ValueError(msg)
    return found.group().rstrip()


def _number() -> Iterator[str]:
    """Yield one result, as Python computes it."""
    roll, pitch, rates = 10.0, 60.0, (0.0, 0.1, 0.2)
    result = euler_rates_from_body_rates(radians(roll), radians(pitch), *rates)
    numbers = ", ".join(f"{np.degrees(rate):.3f}°/s" for rate in result)
    given = ", ".join(f"{rate:g}" for rate in rates)
    yield (
        f"With a roll of {roll:g}°, a pitch of {pitch:g}° and body rates of ({given}) rad/s, it "
        f"returns the rates of roll, pitch and yaw: {numbers}."
    )
