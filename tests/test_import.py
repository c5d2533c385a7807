"""Importing the package is cheap, and all its names are there."""

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import chr_notes

HEAVY = ("sympy", "scipy", "matplotlib", "anywidget")
# Their data classes would take most of the time.
SENSORS = ("sensors", "calibration", "ellipsoid", "monitor", "observer")


def fresh(code: str) -> str:
    """What a new interpreter prints."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def test_import_loads_nothing_heavy() -> None:
    names = (*HEAVY, *(f"chr_notes.{name}" for name in SENSORS))
    assert fresh(f"import sys, chr_notes; print([m for m in {names} if m in sys.modules])") == "[]"


@pytest.mark.parametrize("name", chr_notes.__all__)
def test_each_name_is_what_its_module_defines(name: str) -> None:
    value = getattr(chr_notes, name)
    module = getattr(value, "__module__", "chr_notes.conventions")
    assert module.startswith("chr_notes.")
    assert getattr(sys.modules[module], name) is value


def test_all_names_are_there_without_having_been_used() -> None:
    names = "{*chr_notes.__all__, 'sensors', 'observer', 'euler'}"
    code = f"import chr_notes; print({names} <= set(dir(chr_notes)))"
    assert fresh(code) == "True"
    assert fresh("from chr_notes import *; print(observe.__name__)") == "observe"


def test_a_module_is_loaded_when_it_is_asked_for() -> None:
    code = "import chr_notes; print(chr_notes.sensors.__name__, chr_notes.observe.__name__)"
    assert fresh(code) == "chr_notes.sensors observe"


def test_a_misspelt_name_is_an_error() -> None:
    with pytest.raises(AttributeError, match=r"module 'chr_notes' has no attribute 'obsreve'"):
        _ = chr_notes.obsreve  # type: ignore[attr-defined]


def test_each_file_of_data_is_named_for_the_wheel() -> None:
    package = Path(chr_notes.__file__).parent
    settings = tomllib.loads((package.parent / "pyproject.toml").read_text(encoding="utf-8"))
    patterns = settings["tool"]["setuptools"]["package-data"]["*"]
    files = (path for path in package.rglob("*") if path.is_file())
    data = [path for path in files if path.suffix not in (".py", ".pyc", ".so")]
    assert data
    assert [path for path in data if not any(path.match(pattern) for pattern in patterns)] == []
