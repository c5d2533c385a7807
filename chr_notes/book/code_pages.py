"""A page about the generated code: one formula followed through all stages."""

import re
from collections.abc import Iterator
from math import radians
from pathlib import Path
from typing import Final

import numpy as np
from sympy import ImmutableMatrix

from chr_notes._texts import PACKAGE, read
from chr_notes.derivations import euler
from chr_notes.generated.scalar.euler import euler_rates_from_body_rates
from chr_notes.symbols import EULER_RATES
from chr_notes.typeset import formula

__all__ = ["generated"]

GENERATED: Final = PACKAGE / "generated"
NAME: Final = "euler_rates_from_body_rates"
PARTS: Final = ("form.md", "library.md", "kernel.md")


def generated() -> dict[str, str]:
    """Return the text of each part of the pages by its file name."""
    return {
        "code/derived.md": _display(
            formula(ImmutableMatrix(EULER_RATES), euler.euler_rates()).latex
        ),
        **{f"code/{name}": _part(GENERATED / "pages" / name) for name in PARTS},
        "code/number.md": "\n".join(_number()),
        "code/python.md": _block("python", python(GENERATED / "scalar" / "euler.py")),
        "code/numpy.md": _block("python", python(GENERATED / "arrays" / "euler.py")),
        "code/javascript.md": _block("javascript", javascript()),
        "code/c.md": _block("c", c()),
    }


def _display(text: str) -> str:
    return f"$$\n{text}\n$$\n"


def _part(path: Path) -> str:
    """Read what the generator writes for the page, without the line that says so."""
    return read(path).partition("\n\n")[2]


def _block(language: str, text: str) -> str:
    return f"```{language}\n{text}\n```\n"


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


def _find(pattern: str, path: Path) -> str:
    found = re.search(pattern, read(path), re.MULTILINE | re.DOTALL)
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
