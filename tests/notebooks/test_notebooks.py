"""What nbval does not see: notebooks that were not run, outputs that cannot stay the same."""

import re
from pathlib import Path
from typing import Any

import nbformat
import pytest

NOTEBOOKS = sorted((Path(__file__).resolve().parents[2] / "notebooks").glob("*.ipynb"))
AT_MOST_SKIPPED = 5
SKIPPING = {"nbval-skip", "nbval-ignore-output", "skip-execution"}
WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
CHANGES_EACH_TIME = re.compile(r"\bat 0x[0-9a-f]+|/(home|tmp|root|work|Users)/\w|file://")


def read(path: Path) -> Any:
    return nbformat.read(path, as_version=4)


def code_cells(path: Path) -> list[Any]:
    cells = [cell for cell in read(path).cells if cell.cell_type == "code"]
    return [cell for cell in cells if cell.source.strip()]


def tags(cell: Any) -> set[str]:
    return set(cell.metadata.get("tags", []))


def texts(cell: Any) -> str:
    data = [value for out in cell.outputs for value in out.get("data", {}).values()]
    return "\n".join([*(out.get("text", "") for out in cell.outputs), *map(str, data)])


@pytest.fixture(params=NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
def notebook(request: pytest.FixtureRequest) -> Path:
    path: Path = request.param
    return path


def test_there_are_notebooks() -> None:
    assert NOTEBOOKS


def test_run_once_from_top_to_bottom(notebook: Path) -> None:
    counts = [cell.execution_count for cell in code_cells(notebook)]
    assert counts == list(range(1, len(counts) + 1))


def test_errors_are_where_they_are_announced(notebook: Path) -> None:
    for cell in code_cells(notebook):
        errors = [out for out in cell.outputs if out.output_type == "error"]
        assert bool(errors) == ("raises-exception" in tags(cell)), cell.source


def test_outputs_are_the_same_each_time(notebook: Path) -> None:
    assert "widgets" not in read(notebook).metadata
    for cell in code_cells(notebook):
        assert not CHANGES_EACH_TIME.search(texts(cell)), cell.source
        for output in cell.outputs:
            # A picture of pixels is not compared, and a widget's view names a random model.
            kinds = set(output.get("data", {}))
            assert not kinds & {"image/png", WIDGET_VIEW}, cell.source


def test_cells_do_not_end_in_a_semicolon(notebook: Path) -> None:
    # IPython hides the output then, and nbval sees it.
    for cell in code_cells(notebook):
        assert not cell.source.rstrip().endswith(";"), cell.source


def test_few_outputs_go_unchecked() -> None:
    skipped = [
        (path.stem, cell.source)
        for path in NOTEBOOKS
        for cell in code_cells(path)
        if tags(cell) & SKIPPING
    ]
    assert len(skipped) <= AT_MOST_SKIPPED, skipped
