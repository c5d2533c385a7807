"""The pages about the generated code say what the code and the stored run say."""

import inspect
import re
from textwrap import indent
from types import ModuleType

import numpy as np
import pytest

from chr_notes.book import SOURCES, code_pages
from chr_notes.generated.arrays import euler as arrays
from chr_notes.generated.scalar import euler as scalar


@pytest.fixture(scope="module")
def parts() -> dict[str, str]:
    return code_pages.generated()


def code(part: str) -> str:
    """What stands between the fences."""
    first, *lines, last = part.splitlines()
    assert (first[:3], last) == ("```", "```")
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("part", "module", "name"),
    [
        ("python", scalar, code_pages.NAME),
        ("numpy", arrays, code_pages.NAME),
    ],
)
def test_the_python_functions_are_those_of_the_modules(
    parts: dict[str, str], part: str, module: ModuleType, name: str
) -> None:
    shown = inspect.getsource(getattr(module, name)).rstrip()
    assert code(parts[f"code/{part}.md"]) == shown


@pytest.mark.parametrize(
    ("name", "file", "start"),
    [
        ("javascript", "javascript/attitude.mjs", "/**"),
        ("c", "c/attitude.c", "void attitude_euler_rates_from_body_rates("),
    ],
)
def test_the_other_functions_are_shown_whole(
    parts: dict[str, str], name: str, file: str, start: str
) -> None:
    shown = code(parts[f"code/{name}.md"])
    assert shown.startswith(start)
    assert shown.endswith("\n}")
    assert shown.count("\n}") == 1
    assert f"{shown}\n" in (code_pages.GENERATED / file).read_text(encoding="utf-8")


def test_the_steps_shown_compute_the_rates(parts: dict[str, str]) -> None:
    given = {"roll": 0.3, "pitch": -0.8, "p": 0.1, "q": -0.2, "r": 0.4}
    expected = code_pages.euler_rates_from_body_rates(*given.values())
    known = {"sin": np.sin, "cos": np.cos, "tan": np.tan, **given}
    for line in parts["code/library.md"].splitlines()[1:-1]:
        local, formula = line.split(" = ")
        known[local] = eval(formula, {}, known)  # noqa: S307 (our own arithmetic)
    found = [known[rate] for rate in ("roll_rate", "pitch_rate", "yaw_rate")]
    np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_the_loop_shown_is_that_of_the_kernel(parts: dict[str, str]) -> None:
    shown = code(parts["code/kernel.md"])
    text = (code_pages.GENERATED / "c" / "kernels.c").read_text(encoding="utf-8")
    assert indent(shown, " " * 8) in text
    assert "sin_roll" in shown
    assert shown.count("{") == shown.count("}") == 1
    assert shown.endswith("\n}")  # the page tells of the last lines: those of the loop


def test_the_page_tells_the_rows_of_a_block() -> None:
    kernels = (code_pages.GENERATED.parent / "native" / "columns.h").read_text(encoding="utf-8")
    rows = re.search(r"BLOCK = (\d+)", kernels)
    page = (SOURCES / "from_derivation_to_code.md").read_text(encoding="utf-8")
    assert rows is not None
    assert re.search(rf"blocks\s+of\s+{rows[1]}\b", page)
