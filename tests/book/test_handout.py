"""Notebooks for a class ask all that the chapters ask, and give no answer away."""

import json
import re
import runpy
from pathlib import Path

import nbformat
import numpy as np
import pytest

import chr_notes
from chr_notes.__main__ import main
from chr_notes.book import sources
from chr_notes.book.handout import without_solutions
from chr_notes.lesson import Pictures, Task, exercise
from chr_notes.lesson.pictures import from_above

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_questions_stay_and_solutions_go(path: Path) -> None:
    before = json.loads(path.read_text(encoding="utf-8"))
    after = json.loads(path.read_text(encoding="utf-8"))
    without_solutions(after)
    nbformat.validate(after)
    exercises = [cell for cell in after["cells"] if "exercise(" in "".join(cell["source"])]
    exercises = [cell for cell in exercises if cell["id"].partition("-exercise-")[1]]
    assert len(exercises) == 8
    assert len(after["cells"]) == len(before["cells"]) + 8
    asked = {
        cell["id"]: cell["outputs"][0]["data"]["text/plain"]
        for cell in before["cells"]
        if cell["id"] in {each["id"] for each in exercises}
    }
    for cell in exercises:
        compile(cell["source"], cell["id"], "exec")
        assert "worked" not in cell["source"]
        shown = "".join(cell["outputs"][0]["data"]["text/markdown"])
        assert "Worked solution" not in shown
        assert "data-task" not in shown
        assert cell["outputs"][0]["data"]["text/plain"] == asked[cell["id"]]
        assert ("asked=Pictures(" in cell["source"]) == ("chr-pictures" in shown)
    kept = [cell for cell in after["cells"] if cell in before["cells"]]
    assert len(kept) == len(before["cells"]) - 8


def test_a_package_whose_notebooks_have_no_outputs_asks_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("setuptools.setup", lambda **_: None)
    texts = runpy.run_path(str(FOLDER.parent / "setup.py"))["sources_of_the_book"]()
    for path in NOTEBOOKS:
        packed = sources.numbered(texts[f"packed/notebooks/{path.name}"])
        nbformat.validate(packed)
        assert not any(cell.get("outputs") for cell in packed["cells"])
        kept = json.loads(path.read_text(encoding="utf-8"))
        for notebook in (packed, kept):
            without_solutions(notebook)
        asked, expected = (
            [("".join(cell["source"]), cell["metadata"]) for cell in notebook["cells"]]
            for notebook in (packed, kept)
        )
        assert asked == expected


def test_what_a_question_or_another_cell_uses_stays() -> None:
    source = (
        "SIZE = 2\nSHARED = 3\nHINT = 4\n\n\ndef worked():\n    return SIZE * SHARED\n\n\n"
        "exercise(1, f'{SIZE} times 3?', worked, wrong={'sign': HINT})"
    )
    cells = [
        {"cell_type": "code", "id": name, "source": text, "outputs": [], "metadata": {}}
        for name, text in (("a", source), ("b", "print(SHARED)"))
    ]
    notebook = {"cells": cells}
    without_solutions(notebook)
    asking, answer, other = notebook["cells"]
    assert asking["source"] == "SIZE = 2\nSHARED = 3\nexercise(1, f'{SIZE} times 3?')"
    assert answer["source"] == ""
    assert other["source"] == "print(SHARED)"


PICTURED = """
def turned(degrees):
    return chr_notes.matrix_from_euler(np.radians([0, 0, degrees]))


def worked():
    return 70.0


exercise(
    1, "Which one?", worked, Pictures(lambda each: from_above(turned(each))), wrong={"sign": -70.0}
)"""


def test_a_question_keeps_its_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    names = {"chr_notes": chr_notes, "np": np, "from_above": from_above, "Pictures": Pictures}
    monkeypatch.setattr("inspect.getsource", lambda _: "def worked():\n    return 70.0")

    def shown(source: str) -> str:
        given = {**names, "exercise": lambda *args, **more: tasks.append(exercise(*args, **more))}
        tasks: list[Task] = []
        exec(source, given)  # noqa: S102 (as a notebook does)
        return tasks[0].body

    before = shown(PICTURED)
    outputs = [{"data": {"text/markdown": before, "text/plain": "Which one?"}}]
    cell = {"cell_type": "code", "id": "a", "source": PICTURED, "outputs": outputs, "metadata": {}}
    without_solutions({"cells": [cell]})
    assert "worked" not in cell["source"]
    images = re.compile("<img [^>]*>")
    assert len(images.findall(before)) == 2
    assert images.findall(shown(cell["source"])) == images.findall(before)
    assert "Sign: " not in shown(cell["source"])


def test_an_exercise_without_a_solution_only_asks() -> None:
    task = exercise(3, "How far?")
    assert "**Exercise 3.** How far?" in task._repr_markdown_()
    assert "chr-answer" not in task._repr_markdown_()


def test_the_command_leaves_solutions_out(tmp_path: Path) -> None:
    assert main(["notebooks", "--without-solutions", str(tmp_path / "class")]) == 0
    copies = sorted((tmp_path / "class").glob("*.ipynb"))
    assert [path.name for path in copies] == [path.name for path in NOTEBOOKS]
    for path in copies:
        assert "Worked solution" not in path.read_text(encoding="utf-8")
