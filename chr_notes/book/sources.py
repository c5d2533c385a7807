"""The sources of the book, its notebooks among them: those of a clone, or an installed package's.

A package carries the notebooks without their outputs, which are ten times as large; whoever builds
the book from it runs them first.
"""

import hashlib
import json
import subprocess
import sys
from os.path import lexists
from pathlib import Path
from typing import Any

from chr_notes._texts import PACKAGE, archived, is_there, read, write
from chr_notes.book.handout import without_solutions

CLONE = PACKAGE.parent
PACKED = PACKAGE / "packed"  # in the archive of an installed package
ORIGIN = CLONE if (CLONE / "book" / "_config.yml").is_file() else PACKED

_RUN = """\
import sys, pathlib
from nbclient.exceptions import CellExecutionError
from chr_notes.book import sources
try:
    sources.run(pathlib.Path(sys.argv[1]))
except CellExecutionError as error:
    sys.exit(f"{error.ename}: {error.evalue}")
"""
_WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
_OUTPUTS_OF = "outputs_of"  # a field of a notebook's metadata: the code that its outputs are of
_METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def find(folder: Path) -> Path:
    """Say where the sources are: in the clone, else in a folder that gets the package's.

    Parameters
    ----------
    folder
        Filled if there is no clone. What it has already stays as it is, and a notebook is not run
        again while its code is that of its outputs.

    Returns
    -------
    pathlib.Path
        It has the folders ``book`` and ``notebooks``.

    Raises
    ------
    RuntimeError
        If there are no sources at all, or a notebook is damaged or does not run.
    """
    _require_sources()
    if ORIGIN == CLONE:
        return CLONE
    missing = {}
    for name, content in archived().items():
        _, packed, place = name.rpartition(f"{PACKED.name}/")
        target = folder / place
        try:
            if packed:
                target.stat()  # a file in the place of a folder ends it before any is made
        except FileNotFoundError:
            notebook = target.suffix == ".ipynb"
            missing[target] = _written(numbered(content)) if notebook else content.decode()
    for target in missing:
        target.parent.mkdir(parents=True, exist_ok=True)
    write(missing)
    for path in sorted((folder / "notebooks").glob("*.ipynb")):
        _run_once(path)
    return folder


def copy_notebooks(folder: Path, *, solutions: bool = True) -> list[Path]:
    """Copy the notebooks of the chapters, as they are: a clone's with their outputs.

    Parameters
    ----------
    folder
        Made if it is not there.
    solutions
        Whether the exercises keep their solutions; for a class they may be left out.

    Returns
    -------
    list of pathlib.Path
        The copies.

    Raises
    ------
    FileExistsError
        If one of them is there already; then none is written.
    OSError
        If there is no room for one; then none is left.
    RuntimeError
        If an installed package has none.
    """
    _require_sources()
    texts = {}
    for path in _notebooks():
        notebook = numbered(read(path))
        if not solutions:
            without_solutions(notebook)
        texts[folder / path.name] = _written(notebook)
    for target in texts:
        if lexists(target):
            msg = f"{target} is there already, and may be your work; choose another folder"
            raise FileExistsError(msg)
    folder.mkdir(parents=True, exist_ok=True)
    write(texts)
    return [*texts]


def numbered(text: str | bytes) -> dict[str, Any]:
    """Read a notebook, and name cells by their number where a package leaves their names out."""
    notebook: dict[str, Any] = json.loads(text)
    for number, cell in enumerate(notebook["cells"]):
        cell.setdefault("id", f"cell-{number}")
    return notebook


def _written(notebook: dict[str, Any]) -> str:
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"


def _notebooks() -> list[Path]:
    if ORIGIN == CLONE:
        return sorted((CLONE / "notebooks").glob("*.ipynb"))
    return [PACKAGE / name for name in sorted(archived()) if name.endswith(".ipynb")]


def run(path: Path) -> None:
    """Execute a notebook in its own folder and write it back, without what differs by the run."""
    # Here, so that copies can be made without them.
    import nbformat  # noqa: PLC0415
    from nbclient import NotebookClient  # noqa: PLC0415

    notebook = nbformat.read(path, as_version=4)
    NotebookClient(
        notebook,
        timeout=900,
        record_timing=False,
        coalesce_streams=True,  # else a busy machine tears what is printed apart
        extra_arguments=["--IPKernelApp.log_level=40"],  # it warns of connections of this machine
        resources={"metadata": {"path": path.parent}},
    ).execute()
    notebook.metadata = _METADATA
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        for output in cell.get("outputs", []):
            output.pop("transient", None)
            output.get("data", {}).pop(_WIDGET_VIEW, None)
    write({path: nbformat.writes(notebook) + "\n"})


def _run_once(path: Path) -> None:
    import nbformat  # noqa: PLC0415

    try:
        notebook = nbformat.read(path, as_version=4)
    except (AttributeError, ValueError, nbformat.ValidationError) as error:
        msg = f"expected a notebook in {path}, but it is damaged; mend or remove it"
        raise RuntimeError(msg) from error
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    code = hashlib.sha256("\0".join(cell.source for cell in cells).encode()).hexdigest()[:16]
    if notebook.metadata.get(_OUTPUTS_OF) == code and all(cell.execution_count for cell in cells):
        return
    sys.stdout.write(f"Running {path.name} …\n")
    sys.stdout.flush()
    # In a process of its own, for the client of a kernel takes to itself what is to stop us.
    done = subprocess.run(  # noqa: S603 - a fixed command
        [sys.executable, "-c", _RUN, str(path)], check=False, stderr=subprocess.PIPE, text=True
    )
    if done.returncode != 0:
        msg = f"{path} does not run to its end: {done.stderr.strip().splitlines()[-1]}"
        raise RuntimeError(msg)
    notebook = nbformat.read(path, as_version=4)
    notebook.metadata[_OUTPUTS_OF] = code
    write({path: nbformat.writes(notebook) + "\n"})


def _require_sources() -> None:
    if not is_there(ORIGIN / "book" / "_config.yml"):
        msg = (
            f"expected the sources of the book in {CLONE} or in {PACKED}, found none in either: "
            "install chr-notes again, or clone the project"
        )
        raise RuntimeError(msg)
