"""The examples of docstrings give what stands under them."""

import doctest
import importlib
import pkgutil
from inspect import isfunction

import pytest

import chr_notes

MODULES = [
    module.name
    for module in pkgutil.walk_packages(chr_notes.__path__, "chr_notes.")
    if not module.name.startswith("chr_notes.generated") and "_speedups" not in module.name
]
FOUND = [
    example
    for name in MODULES
    if not name.endswith("__main__")
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
