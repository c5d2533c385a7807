"""The pages about the generated code say what the code and the stored run say."""

import ast
import json

import numpy as np
import pytest

from chr_notes.book import code_pages


@pytest.fixture(scope="module")
def parts() -> dict[str, str]:
    return code_pages.generated()


def test_the_function_is_shown_whole_in_each_language(parts: dict[str, str]) -> None:
    for name, start, end in (
        ("python", "def euler_rates_from_body_rates(", ")"),
        ("numpy", "def euler_rates_from_body_rates(", ")"),
        ("javascript", "/**", "}"),
        ("c", "void attitude_euler_rates_from_body_rates(", "}"),
    ):
        lines = parts[f"code/{name}.md"].splitlines()
        assert lines[0].startswith("```")
        assert lines[-1] == "```"
        assert lines[1].startswith(start)
        assert lines[-2].strip().startswith((end, "add(", "multiply(", "divide("))
    for name in ("python", "numpy"):
        assert len(ast.parse("\n".join(parts[f"code/{name}.md"].splitlines()[1:-1])).body) == 1


def test_the_steps_shown_compute_the_rates(parts: dict[str, str]) -> None:
    given = {"roll": 0.3, "pitch": -0.8, "p": 0.1, "q": -0.2, "r": 0.4}
    expected = code_pages.euler_rates_from_body_rates(*given.values())
    for name in ("library", "half_tangent"):
        known = {"sin": np.sin, "cos": np.cos, "tan": np.tan, **given}
        for line in parts[f"code/{name}.md"].splitlines()[1:-1]:
            local, formula = line.split(" = ")
            known[local] = eval(formula, {}, known)  # noqa: S307 (our own arithmetic)
        found = [known[rate] for rate in ("roll_rate", "pitch_rate", "yaw_rate")]
        np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_near_the_pole_one_way_loses_digits_and_the_other_does_not(parts: dict[str, str]) -> None:
    rows = [
        [float(cell) for cell in line.strip("|").split("|")]
        for line in parts["code/near_the_pole.md"].splitlines()[2:]
    ]
    for _, right, from_cosine, from_tangents in rows:
        assert from_tangents == pytest.approx(right, rel=1e-6)
        assert from_cosine == pytest.approx(right, rel=1e-1) or from_cosine != right
    assert abs(rows[-1][2] / rows[-1][1] - 1) > 1e-6


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
    assert text.count("|  | another | 50 | 2.5 |") == 3
    assert "another 1.0" in text
