"""The sources of the book where there is no clone: copied, run, and nobody's work overwritten."""

from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from chr_notes.__main__ import main
from chr_notes.book import sources

CHAPTERS = sorted(path.name for path in (sources.CLONE / "notebooks").glob("*.ipynb"))


@pytest.fixture
def packed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A package with one page and two notebooks, of which one has run."""
    folder = tmp_path / "packed"
    (folder / "book").mkdir(parents=True)
    (folder / "book" / "_config.yml").write_text("title: none\n", encoding="utf-8")
    (folder / "notebooks").mkdir()
    cells = {"fresh": new_code_cell("print(6 * 7)"), "run": new_code_cell("1", execution_count=1)}
    for name, cell in cells.items():
        nbformat.write(new_notebook(cells=[cell]), folder / "notebooks" / f"{name}.ipynb")
    monkeypatch.setattr(sources, "PACKED", folder)
    monkeypatch.setattr(sources, "ORIGIN", folder)
    return folder


def test_a_clone_has_its_own(tmp_path: Path) -> None:
    assert sources.find(tmp_path) == sources.CLONE
    assert list(tmp_path.iterdir()) == []


@pytest.mark.usefixtures("packed")
def test_a_folder_gets_what_is_packed_and_notebooks_are_run_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "mine"
    assert sources.find(folder) == folder
    assert capsys.readouterr().out == "Running fresh.ipynb …\n"
    (cell,) = nbformat.read(folder / "notebooks" / "fresh.ipynb", as_version=4).cells
    assert cell.outputs[0].text == "42\n"
    # What the user changed stays.
    (folder / "book" / "_config.yml").write_text("title: mine\n", encoding="utf-8")
    sources.find(folder)
    assert capsys.readouterr().out == ""
    assert (folder / "book" / "_config.yml").read_text(encoding="utf-8") == "title: mine\n"


def test_a_notebook_that_fails_is_named(packed: Path, tmp_path: Path) -> None:
    failing = new_notebook(cells=[new_code_cell("1 / 0")])
    nbformat.write(failing, packed / "notebooks" / "fresh.ipynb")
    with pytest.raises(RuntimeError, match=r"fresh\.ipynb does not run to its end: ZeroDivision"):
        sources.find(tmp_path / "mine")


def test_notebooks_are_copied_and_never_over_others(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "mine"
    assert main(["notebooks", str(folder)]) == 0
    assert capsys.readouterr().out.splitlines() == [str(folder / name) for name in CHAPTERS]
    changed = folder / CHAPTERS[-1]
    changed.write_text("my work", encoding="utf-8")
    (folder / CHAPTERS[0]).unlink()
    assert main(["notebooks", str(folder)]) == 2
    assert "may be your work; choose another folder" in capsys.readouterr().err
    assert changed.read_text(encoding="utf-8") == "my work"
    assert not (folder / CHAPTERS[0]).exists()
