"""What nbval does not see: how a notebook is stored, and errors that are announced and don't come.

Checked with each notebook, before its cells are run again.
"""

import ast
import base64
import re
from collections.abc import Callable, Generator, Iterator
from pathlib import Path

import nbformat
import pytest

Node = nbformat.NotebookNode
WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
FIGURE = re.compile(r'class="chr-figure"[^>]*;base64,([^"]+)"')
ONE_COLOUR = re.compile(r"(?:fill|stroke): #\w+")
CHANGES_EACH_TIME = re.compile(r"\bat 0x[0-9a-f]+|/(home|tmp|root|work|Users)/\w|file://")


def code_cells(notebook: Node) -> list[Node]:
    """List the cells that do something."""
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    return [cell for cell in cells if cell.source.strip()]


def raises(cell: Node) -> bool:
    """Tell whether a cell is announced to end in an error."""
    return "raises-exception" in cell.metadata.get("tags", [])


def texts(cell: Node) -> str:
    """Join all that the outputs of a cell say."""
    data = [value for out in cell.outputs for value in out.get("data", {}).values()]
    return "\n".join([*(out.get("text", "") for out in cell.outputs), *map(str, data)])


def run_once_from_top_to_bottom(notebook: Node) -> None:
    counts = [cell.execution_count for cell in code_cells(notebook)]
    assert counts == list(range(1, len(counts) + 1)), f"cells were run in the order {counts}"


def errors_are_where_they_are_announced(notebook: Node) -> None:
    for cell in code_cells(notebook):
        errors = [out for out in cell.outputs if out.output_type == "error"]
        assert bool(errors) == raises(cell), cell.source


def outputs_are_the_same_each_time(notebook: Node) -> None:
    assert "widgets" not in notebook.metadata
    for cell in code_cells(notebook):
        assert not CHANGES_EACH_TIME.search(texts(cell)), cell.source
        for output in cell.outputs:
            # A picture of pixels is not compared, and a widget's view names a random model.
            kinds = set(output.get("data", {}))
            assert not kinds & {"image/png", WIDGET_VIEW}, cell.source


def cells_do_not_end_in_a_semicolon(notebook: Node) -> None:
    # IPython hides the output then, and nbval sees it.
    for cell in code_cells(notebook):
        assert not cell.source.rstrip().endswith(";"), cell.source


def figures_that_are_drawn_are_shown(notebook: Node) -> None:
    # A cell shows what its last line gives, and a figure of a line before is lost.
    drawing = {"plots.show"}
    for cell in code_cells(notebook):
        drawn = 0
        for statement in ast.parse(cell.source).body:
            calls = [each for each in ast.walk(statement) if isinstance(each, ast.Call)]
            found = sum(ast.unparse(each.func) in drawing for each in calls)
            if isinstance(statement, ast.FunctionDef):
                drawing |= {statement.name} if found else set()
            else:
                drawn += found
        assert drawn == texts(cell).count('class="chr-figure"'), cell.source


def figures_have_colours_of_both_themes(notebook: Node) -> None:
    for cell in code_cells(notebook):
        for figure in FIGURE.findall(texts(cell)):
            assert not ONE_COLOUR.findall(base64.b64decode(figure).decode()), cell.source


def comments_do_not_steer_the_check(notebook: Node) -> None:
    # Tags do, and those are counted.
    for cell in code_cells(notebook):
        assert "NBVAL" not in cell.source, cell.source


CHECKS = (
    run_once_from_top_to_bottom,
    errors_are_where_they_are_announced,
    outputs_are_the_same_each_time,
    cells_do_not_end_in_a_semicolon,
    figures_that_are_drawn_are_shown,
    figures_have_colours_of_both_themes,
    comments_do_not_steer_the_check,
)


class Stored(pytest.Item):
    """A check of a notebook as it is stored."""

    def __init__(self, *, check: Callable[[Node], None], **given: object) -> None:
        """Keep the check."""
        super().__init__(**given)
        self.check = check
        self.add_marker("stored")

    def runtest(self) -> None:
        """Read the notebook and check it."""
        self.check(nbformat.read(self.path, as_version=4))

    def reportinfo(self) -> tuple[Path, int, str]:
        """Name the notebook and the check."""
        return self.path, 0, f"{self.path.name}: {self.name}"


class StoredFile(pytest.File):
    """A notebook as it is stored."""

    def collect(self) -> Iterator[Stored]:
        """Give a test a check."""
        for check in CHECKS:
            yield Stored.from_parent(self, name=check.__name__, check=check)


@pytest.hookimpl(tryfirst=True)
def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.File | None:
    """Check each notebook as it is stored, before nbval runs its cells."""
    return StoredFile.from_parent(parent, path=file_path) if file_path.suffix == ".ipynb" else None


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, None, None]:
    """Refuse a cell that is announced to end in an error and does not."""
    yield
    if item.get_closest_marker("stored") is None and raises(item.cell):
        kinds = [out["output_type"] for out in item.test_outputs]
        assert "error" in kinds, "this cell is tagged raises-exception and raised nothing"
