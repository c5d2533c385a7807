"""The pages about the generated code say what the code and the stored run say."""

import inspect
import json
import re
from textwrap import indent
from types import ModuleType

import numpy as np
import pytest

from chr_notes.book import code_pages
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


def test_each_time_of_the_stored_run_is_on_the_page(parts: dict[str, str]) -> None:
    run = json.loads(code_pages.SPEED.read_text(encoding="utf-8"))
    assert set(run) == {
        *("cpu", "threads", "vector_instructions", "system", "python", "libraries", "rows")
    }
    for row in run["rows"]:
        assert f"| {row['library']} | {row['nanoseconds']:,g} |" in parts["speed.md"]
    assert run["cpu"] in parts["speed.md"]


def test_factors_compare_with_the_first_row_of_each_task() -> None:
    cases = [
        {"size": size, "task": "a task", "library": library, "nanoseconds": time}
        for size in code_pages.SIZES
        for library, time in (
            (code_pages.SCALAR if size == 1 else "chr_notes", 20.0),
            ("another", 50.0),
            ("a fast one", 1.0),
        )
    ]
    run = {
        "rows": cases,
        "cpu": "a processor",
        "vector_instructions": "none",
        "system": "a system",
        "python": "3",
        "libraries": {"another": "1.0"},
    }
    text = "\n".join(code_pages.speed(run))
    assert text.count("|  | another | 50 | 2.5 |") == len(code_pages.SIZES)
    assert text.count("|  | a fast one | 1 | 0.05 |") == len(code_pages.SIZES)
    assert "another 1.0" in text


def test_the_page_names_those_that_are_faster() -> None:
    run = json.loads(code_pages.SPEED.read_text(encoding="utf-8"))
    text = "\n".join(code_pages.speed(run))
    for size, words in code_pages.SIZES.items():
        ours = code_pages.SCALAR if size == 1 else "chr_notes"
        rows = [r for r in run["rows"] if r["size"] == size]
        times = {(r["task"], r["library"]): r["nanoseconds"] for r in rows}
        part = text.split(f"## {words.capitalize()}\n")[1].split("\n## ")[0]
        start = "Faster here than ours: "
        told = next((line for line in part.splitlines() if line.startswith(start)), start)
        named = set(re.split(r"(?<=\)), ", told.removeprefix(start).rstrip("."))) - {""}
        faster = {(task, library) for (task, library), t in times.items() if t < times[task, ours]}
        assert named == {f"{library} ({task})" for task, library in faster}


def test_lists_are_faster_for_products_and_matrices_as_the_page_says() -> None:
    rows = json.loads(code_pages.SPEED.read_text(encoding="utf-8"))["rows"]
    times = {(r["task"], r["library"]): r["nanoseconds"] for r in rows if r["size"] == 1}
    for task in ("products of quaternions", "matrices from quaternions"):
        assert times[task, "transforms3d, given lists"] < times[task, "transforms3d"]


def test_plain_numbers_are_for_one_attitude_and_arrays_for_many_as_the_page_says() -> None:
    rows = json.loads(code_pages.SPEED.read_text(encoding="utf-8"))["rows"]
    times = {(r["size"], r["task"], r["library"]): r["nanoseconds"] for r in rows}
    tasks = {r["task"] for r in rows if r["size"] == 1}
    assert tasks
    for task in tasks:
        one, array = times[1, task, code_pages.SCALAR], times[1, task, "chr_notes"]
        hundred, thousand, million = (times[n, task, "chr_notes"] for n in (100, 1000, 1_000_000))
        assert one < array
        assert hundred < one
        assert thousand < million


def test_kernels_are_faster_than_python_in_filters() -> None:
    rows = json.loads(code_pages.SPEED.read_text(encoding="utf-8"))["rows"]
    times = {(r["task"], r["library"]): r["nanoseconds"] for r in rows}
    without = [task for task, library in times if library == "chr_notes without kernels"]
    assert len(without) == 2
    for task in without:
        assert times[task, "chr_notes"] < times[task, "chr_notes without kernels"]
