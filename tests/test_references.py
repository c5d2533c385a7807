"""What docstrings refer to is where they say, and so the book can link it."""

import importlib
import inspect
import re

import chr_notes

SECTION = re.compile(r"^See Also\n-+\n(.*?)(?:\n\n[A-Z]|\Z)", re.MULTILINE | re.DOTALL)
NAME = re.compile(r"^([\w.]+)(?: :.*)?$", re.MULTILINE)
PUBLIC = [name for name in chr_notes.__all__ if callable(getattr(chr_notes, name))]


def test_what_stands_beside_it_is_there() -> None:
    for name in PUBLIC:
        value = getattr(chr_notes, name)
        for section in SECTION.findall(inspect.getdoc(value) or ""):
            for found in NAME.findall(section):
                module, _, own = found.rpartition(".")
                holder = importlib.import_module(module or value.__module__)
                there = getattr(getattr(holder, own, None), "__module__", None)
                assert there == holder.__name__, f"{found}, named by {name}"
