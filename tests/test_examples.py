"""The examples of docstrings give what stands under them."""

import doctest
import importlib
from inspect import isfunction
from pathlib import Path

import pytest

import chr_notes

# Only what has examples is imported: some that have none derive formulas, which takes seconds.
FOLDER = Path(chr_notes.__file__).parent
MODULES = [
    ".".join(("chr_notes", *path.relative_to(FOLDER).with_suffix("").parts)).removesuffix(
        ".__init__"
    )
    for path in sorted(FOLDER.rglob("*.py"))
    if "generated" not in path.parts and ">>>" in path.read_text(encoding="utf-8")
]
FOUND = [
    example
    for name in MODULES
    for example in doctest.DocTestFinder(exclude_empty=True).find(importlib.import_module(name))
    if example.examples
]


@pytest.mark.parametrize("example", FOUND, ids=lambda example: example.name)
def test_an_example_gives_what_it_says(
    example: doctest.DocTest, capsys: pytest.CaptureFixture[str]
) -> None:
    failed, tried = doctest.DocTestRunner().run(example)
    assert tried > 0
    assert failed == 0, capsys.readouterr().out


def test_each_public_function_has_an_example() -> None:
    functions = [getattr(chr_notes, name) for name in chr_notes.__all__]
    without = [f.__name__ for f in functions if isfunction(f) and ">>>" not in (f.__doc__ or "")]
    assert without == []
