"""What docstrings refer to is where they say, and so the book can link it."""

import importlib
import inspect
import re

import pytest

import chr_notes

SECTION = re.compile(r"^See Also\n-+\n(.*?)(?:\n\n[A-Z]|\Z)", re.MULTILINE | re.DOTALL)
NAME = re.compile(r"^([\w.]+)(?: :.*)?$", re.MULTILINE)
PUBLIC = [name for name in chr_notes.__all__ if callable(getattr(chr_notes, name))]


@pytest.mark.parametrize("name", PUBLIC)
def test_what_stands_beside_it_is_there(name: str) -> None:
    value = getattr(chr_notes, name)
    for section in SECTION.findall(inspect.getdoc(value) or ""):
        for found in NAME.findall(section):
            module, _, own = found.rpartition(".")
            holder = importlib.import_module(module or value.__module__)
            assert getattr(holder, own).__module__ == holder.__name__, found
