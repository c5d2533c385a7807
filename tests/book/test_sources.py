"""The sources of the book where there is no clone: copied, run, and nobody's work overwritten."""

import bz2
import errno
import hashlib
import os
import signal
import threading
from collections.abc import Iterator
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from chr_notes import _texts
from chr_notes.__main__ import main
from chr_notes.book import sources

CHAPTERS = sorted(path.name for path in (sources.CLONE / "notebooks").glob("*.ipynb"))


def write(folder: Path, **cells: nbformat.NotebookNode) -> None:
    """Write what an installed package has: the archive of one page and of notebooks."""
    (folder / "packed" / "book").mkdir(parents=True, exist_ok=True)
    (folder / "packed" / "book" / "_config.yml").write_text("title: none\n", encoding="utf-8")
    (folder / "packed" / "notebooks").mkdir(exist_ok=True)
    for name, cell in cells.items():
        path = folder / "packed" / "notebooks" / f"{name}.ipynb"
        of = hashlib.sha256(cell.source.encode()).hexdigest()[:16]
        nbformat.write(new_notebook(cells=[cell], metadata={"outputs_of": of}), path)
    files = {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*.*")}
    parts = [part for path, content in files.items() for part in (str(path).encode(), content)]
    next(iter(_texts.ARCHIVES)).write_bytes(bz2.compress(b"\0".join(parts)))
    _texts.archived.cache_clear()


@pytest.fixture
def packed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An installed package with one page and two notebooks, of which one has run."""
    folder = tmp_path / "package"
    folder.mkdir()
    monkeypatch.setattr(_texts, "ARCHIVES", {tmp_path / "prose.bz2": bz2.decompress})
    monkeypatch.setattr(sources, "ORIGIN", sources.PACKED)
    run = new_code_cell("1", execution_count=1)
    write(folder, fresh=new_code_cell("print(6 * 7)"), run=run)
    yield folder
    _texts.archived.cache_clear()


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
    # Outputs of other code are not shown.
    path = folder / "notebooks" / "fresh.ipynb"
    notebook = nbformat.read(path, as_version=4)
    notebook.cells[0].source = "print(6 * 8)"
    nbformat.write(notebook, path)
    sources.find(folder)
    assert capsys.readouterr().out == "Running fresh.ipynb …\n"
    (cell,) = nbformat.read(path, as_version=4).cells
    assert cell.outputs[0].text == "48\n"


def test_a_notebook_that_fails_is_named(packed: Path, tmp_path: Path) -> None:
    write(packed, fresh=new_code_cell("1 / 0"))
    with pytest.raises(RuntimeError, match=r"fresh\.ipynb does not run to its end: ZeroDivision"):
        sources.find(tmp_path / "mine")


@pytest.mark.usefixtures("packed")
@pytest.mark.parametrize("text", ["{}", "[]", '{"cells": ['])
def test_a_damaged_notebook_is_named(text: str, tmp_path: Path) -> None:
    path = tmp_path / "mine" / "notebooks" / "fresh.ipynb"
    path.parent.mkdir(parents=True)
    path.write_text(text, encoding="utf-8")
    with pytest.raises(RuntimeError, match=r"a notebook in .*fresh\.ipynb, but it is damaged"):
        sources.find(tmp_path / "mine")


@pytest.mark.full
def test_one_that_is_stopped_stays_as_it_was(
    packed: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(packed, fresh=new_code_cell("import time\ntime.sleep(600)"))
    stopped = (threading.get_ident(), signal.SIGTERM)
    threading.Timer(3, signal.pthread_kill, stopped).start()
    assert main(["book", str(tmp_path / "mine")]) == 143
    assert capsys.readouterr().err == "book: stopped before the end\n"
    folder = tmp_path / "mine" / "notebooks"
    assert {path.name for path in folder.iterdir()} == {"fresh.ipynb", "run.ipynb"}
    (cell,) = nbformat.read(folder / "fresh.ipynb", as_version=4).cells
    assert cell.execution_count is None


def test_sources_without_room_leave_nothing_begun(
    packed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_bytes = Path.write_bytes

    def full(self: Path, content: bytes) -> int:
        write_bytes(self, content[:1])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OSError, match="No space left on device"):
        sources.find(tmp_path / "mine")
    assert packed.is_dir()
    assert not [path for path in (tmp_path / "mine").rglob("*") if path.is_file()]


def test_notebooks_are_copied_and_never_over_others(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "mine"
    assert main(["notebooks", str(folder)]) == 0
    assert capsys.readouterr().out.splitlines() == [str(folder / name) for name in CHAPTERS]
    for name in CHAPTERS:
        stored = sources.CLONE / "notebooks" / name
        assert (folder / name).read_text(encoding="utf-8") == stored.read_text(encoding="utf-8")
    changed = folder / CHAPTERS[-1]
    changed.write_text("my work", encoding="utf-8")
    (folder / CHAPTERS[0]).unlink()
    assert main(["notebooks", str(folder)]) == 1
    assert "may be your work; choose another folder" in capsys.readouterr().err
    assert changed.read_text(encoding="utf-8") == "my work"
    assert not (folder / CHAPTERS[0]).exists()
    changed.unlink()
    changed.symlink_to("kept elsewhere")
    assert main(["notebooks", str(folder)]) == 1
    assert changed.is_symlink()


@pytest.mark.usefixtures("packed")
def test_an_installed_package_has_notebooks_to_copy(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    assert sources.copy_notebooks(folder) == [folder / "fresh.ipynb", folder / "run.ipynb"]
    (cell,) = nbformat.read(folder / "fresh.ipynb", as_version=4).cells
    assert cell.source == "print(6 * 7)"


def test_a_text_is_read_from_the_file_or_from_the_archive(packed: Path) -> None:
    kept = _texts.PACKAGE / "packed" / "book" / "_config.yml"
    assert _texts.is_there(kept)
    assert _texts.read(kept) == "title: none\n"
    file = packed / "packed" / "book" / "_config.yml"
    file.write_text("title: file\n", encoding="utf-8")
    assert _texts.read(file) == "title: file\n"
    assert not _texts.is_there(kept.with_name("none.yml"))
    with pytest.raises(FileNotFoundError, match=r"none\.yml"):
        _texts.read(kept.with_name("none.yml"))
