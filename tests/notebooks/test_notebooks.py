"""A notebook that was saved in a wrong state is refused, and few outputs are left unchecked."""

import base64
import re
import shutil
from pathlib import Path

import nbformat
import pytest
from nbclient.exceptions import CellExecutionError
from nbformat.v4 import new_code_cell, new_notebook, new_output

from chr_notes.ledger import StaleError

from . import run

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
AT_MOST_SKIPPED = 5
SKIPPING = {"nbval-skip", "nbval-ignore-output", "skip-execution"}
Node = nbformat.NotebookNode


def test_few_outputs_go_unchecked() -> None:
    assert NOTEBOOKS
    cells = [cell for path in NOTEBOOKS for cell in nbformat.read(path, as_version=4).cells]
    skipped = [cell.source for cell in cells if SKIPPING & set(cell.metadata.get("tags", []))]
    assert len(skipped) <= AT_MOST_SKIPPED, skipped


def cell(source: str, count: int | None, *outputs: Node, tag: str = "") -> Node:
    metadata = {"tags": [tag] if tag else []}
    return new_code_cell(source, execution_count=count, outputs=[*outputs], metadata=metadata)


ONE = new_output("stream", name="stdout", text="1\n")
ERROR = new_output("error", ename="ZeroDivisionError", evalue="division by zero", traceback=[])
ANNOUNCED = "raises-exception"
DRAWN = base64.b64encode(b'<svg style="stroke: #123456"/>').decode()
OF_ONE_COLOUR = new_output(
    "execute_result",
    data={"text/html": f'<img class="chr-figure" src="data:image/svg+xml;base64,{DRAWN}">'},
    execution_count=1,
)
DRAWS = "def draw():\n    return plots.show()"
WRONGLY_STORED = {
    "never_run": [cell("x = 1", None)],
    "run_in_another_order": [cell("x = 1", 2), cell("x", 1)],
    "an_error": [cell("1 / 0", 1, ERROR)],
    "announced_error_not_stored": [cell("1 / 0", 1, tag=ANNOUNCED)],
    "path_of_one_machine": [cell("x", 1, new_output("stream", name="stdout", text="file://x\n"))],
    "figure_that_is_not_last": [cell("plots.show()\nprint(1)", 1, ONE)],
    "figure_of_a_function_that_is_not_last": [cell(DRAWS, 1), cell("draw()\nprint(1)", 2, ONE)],
    "figure_that_is_kept": [cell("kept = plots.show()", 1)],
    "figure_of_one_colour": [cell("plots.show()", 1, OF_ONE_COLOUR)],
    "semicolon": [cell("x = 1;", 1)],
    "comment_that_steers": [cell("# NBVAL_IGNORE_OUTPUT\nprint(2)", 1, ONE)],
}
WRONG_WHEN_RUN = {
    "another_output": [cell("print(2)", 1, ONE)],
    "announced_error_does_not_come": [cell("x = 1", 1, ERROR, tag=ANNOUNCED)],
    "left_out": [cell("print(1)", 1, ONE), cell("x = 1", 2, tag="nbval-skip")],
}
RIGHT = {"right": [cell("print(1)", 1, ONE), cell("1 / 0", 2, ERROR, tag=ANNOUNCED)]}


def refused(pytester: pytest.Pytester, cases: dict[str, list[Node]], *options: str) -> set[str]:
    """Say which notebooks the README's command refuses."""
    folder = pytester.mkdir("notebooks")
    for name in ("pyproject.toml", "conftest.py", "notebooks/conftest.py"):
        shutil.copy(ROOT / name, pytester.path / name)
    for name, cells in cases.items():
        nbformat.write(new_notebook(cells=cells), folder / f"{name}.ipynb")
    # In a process of its own: nbval leaves a file open with each kernel, which would be told of a
    # later test.
    done = pytester.runpytest_subprocess("-n0", "--nbval", "notebooks", *options)
    assert done.ret == 1
    return {*re.findall(r"^FAILED notebooks/(\w+)\.ipynb", done.stdout.str(), re.MULTILINE)}


def test_verdicts_that_are_out_of_date_are_told_in_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(_: Path) -> None:
        raise CellExecutionError(*error)

    monkeypatch.setattr(run, "run", fails)
    name = str(NOTEBOOKS[0])
    error = "", StaleError.__name__, "the verdicts are out of date; run: this"
    assert run.main([name, name]) == 2
    (told,) = capsys.readouterr().err.splitlines()
    assert told == f"{NOTEBOOKS[0].name} is as before: {error[2]}"
    error = "", "ValueError", "wrong"
    with pytest.raises(CellExecutionError):
        run.main([name])
    assert run.main([name, "euler"]) == 2
    assert "expected a notebook, such as notebooks/" in capsys.readouterr().err


@pytest.mark.slow
def test_what_was_stored_in_a_wrong_state_is_refused(pytester: pytest.Pytester) -> None:
    assert refused(pytester, WRONGLY_STORED | RIGHT, "-m", "stored") == {*WRONGLY_STORED}


@pytest.mark.slow
def test_what_runs_otherwise_is_refused(pytester: pytest.Pytester) -> None:
    assert refused(pytester, WRONG_WHEN_RUN | RIGHT) == {*WRONG_WHEN_RUN}
