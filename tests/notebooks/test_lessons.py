"""A chapter asks before it tells, ends with exercises, and says truly how long it takes."""

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import nbformat
import pytest

from chr_notes.ledger import entries

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
Node = nbformat.NotebookNode
ASIDE = re.compile(r"(?s)<details.*?</details>|```.*?```|\$\$.*?\$\$")
UNSHOWN = {"hide-input", "remove-input", "remove-cell"}
FORMULA = re.compile(r"\$[^$]+\$")
# A word at the pace of a text that is thought along with. Six seconds for a formula in it, half a
# minute for a step that one goes along with, three seconds for a line of code or of what it prints.
# An exercise takes two minutes with a pencil and up to twelve with a program. With five and a half
# on average the sum for a chapter is near what its readers took.
MINUTES: Mapping[str, float] = {
    "word": 1 / 180, "formula": 0.1, "card": 0.5, "step": 0.4, "line": 0.05, "figure": 0.5,
    "demo": 3.0, "guess": 0.7, "exercise": 5.5,
}  # fmt: skip


def outputs(notebook: Node) -> Iterator[Mapping[str, str]]:
    """Yield what the cells show, by kind."""
    for cell in notebook.cells:
        for out in cell.get("outputs", []):
            yield {kind: "".join(text) for kind, text in out.get("data", {}).items()}


def prose(notebook: Node) -> str:
    """Join the text that a reader meets without a click."""
    written = [cell.source for cell in notebook.cells if cell.cell_type == "markdown"]
    tasks = [out.get("text/markdown", "") for out in outputs(notebook)]
    return ASIDE.sub("", "\n".join([*written, *(text for text in tasks if "chr-lesson" in text)]))


def counts(notebook: Node) -> Counter[str]:
    """Count what takes a reader's time."""
    text = re.sub("<[^>]*>", "", prose(notebook))
    found = Counter(
        word=len(re.findall(r"[A-Za-z]{2,}", FORMULA.sub("", text))),
        formula=len(FORMULA.findall(text)),
    )
    for cell in notebook.cells:
        if cell.cell_type == "code" and not UNSHOWN & {*cell.metadata.get("tags", [])}:
            printed = [out.text for out in cell.outputs if out.output_type == "stream"]
            found["line"] += sum(map(bool, "\n".join([cell.source, *printed]).splitlines()))
    for out in outputs(notebook):
        shown = "".join(map(str, out.values()))
        found["card"] += len(re.findall('<div class="entry(?: misleads)?"', shown))
        found["step"] += shown.count('class="chr-step"')
        found["demo"] += "data-demo=" in shown
        found["figure"] += "chr-figure" in shown
        found["guess"] += "chr-lesson chr-guess" in shown
        found["exercise"] += "chr-lesson chr-exercise" in shown
        found["by hand"] += 'class="chr-pictures"' in shown or "data-plane=" in shown
    return found


@pytest.fixture(scope="module")
def read() -> Callable[[Path], Node]:
    """Read each notebook once."""
    kept = {path: nbformat.read(path, as_version=4) for path in NOTEBOOKS}
    return kept.__getitem__


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_each_chapter_has_guesses_and_exercises(path: Path, read: Callable[[Path], Node]) -> None:
    text = prose(read(path))
    assert "**Predict.**" not in text
    found = counts(read(path))
    assert found["guess"] >= 3
    assert 6 <= found["exercise"] <= 8
    assert found["by hand"] >= 1
    numbers = re.findall(r"\*\*Exercise (\d+)\.\*\*", text)
    assert numbers == [str(number + 1) for number in range(found["exercise"])]
    headings = re.findall(r"^## (.*)$", text, flags=re.MULTILINE)
    assert headings[headings.index("Exercises") + 1] == "Summary"


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_each_chapter_says_how_long_it_takes(path: Path, read: Callable[[Path], Node]) -> None:
    found = counts(read(path))
    minutes = sum(found[what] * each for what, each in MINUTES.items())
    (said,) = re.findall(r"\*\*How long\.\*\* About (\d+) minutes", prose(read(path)))
    assert int(said) % 5 == 0
    assert int(said) == pytest.approx(minutes, abs=5), found


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_code_fits_the_page_and_what_it_prints_a_phone(
    path: Path, read: Callable[[Path], Node]
) -> None:
    for cell in read(path).cells:
        tags = {*cell.metadata.get("tags", [])}
        if cell.cell_type == "code" and not {"remove-input", "remove-cell"} & tags:
            assert max(map(len, cell.source.splitlines())) <= 79, cell.source
        printed = [out.text for out in cell.get("outputs", []) if out.output_type == "stream"]
        assert max(map(len, "".join(printed).splitlines()), default=0) <= 57, printed


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_formulas_of_the_documents_stand_on_cards(path: Path, read: Callable[[Path], Node]) -> None:
    printed = {squeezed(entry.printed_latex): entry.id for entry in entries()}
    displayed = [out["text/latex"] for out in outputs(read(path)) if "text/latex" in out]
    text = "\n".join(cell.source for cell in read(path).cells if cell.cell_type == "markdown")
    displayed += re.findall(r"(?s)\$\$(.*?)\$\$", text)
    repeated = [printed[each] for each in map(squeezed, displayed) if each in printed]
    assert repeated == []


def squeezed(latex: str) -> str:
    """Leave what does not show out of a formula."""
    return re.sub(r"\\displaystyle|[\s$]|\\[,;!]", "", latex)


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_what_only_typesets_has_no_source_in_the_book(
    path: Path, read: Callable[[Path], Node]
) -> None:
    for cell in read(path).cells:
        if re.match(r"(show|formula|guess)\w*\(|\w*Demo\(", cell.source.lstrip()):
            assert "remove-input" in cell.metadata.get("tags", []), cell.source


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_answers_are_folded_away_in_jupyter_too(path: Path, read: Callable[[Path], Node]) -> None:
    asking = [cell for cell in read(path).cells if "chr-lesson" in str(cell.get("outputs"))]
    assert asking
    for cell in asking:
        assert cell.metadata.get("jupyter", {}).get("source_hidden"), cell.source
