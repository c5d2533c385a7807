"""Importing the package is cheap, and all its names are there."""

import importlib
import subprocess
import sys
import tomllib
from pathlib import Path
from types import ModuleType

import pytest

import chr_notes

HEAVY = ("sympy", "scipy", "matplotlib", "anywidget")


def test_import_loads_nothing_heavy() -> None:
    code = f"import sys, chr_notes; print([m for m in {HEAVY} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_each_name_is_what_its_module_defines() -> None:
    for name in chr_notes.__all__:
        value = getattr(chr_notes, name)
        module = getattr(value, "__module__", "chr_notes.conventions")
        assert module.startswith("chr_notes."), name
        assert getattr(sys.modules[module], name, None) is value, name


def test_what_is_imported_is_public() -> None:
    here = {
        name
        for name, value in vars(chr_notes).items()
        if not name.startswith("_") and not isinstance(value, ModuleType)
    }
    assert here == set(chr_notes.__all__)


@pytest.mark.parametrize("package", ["demos", "plots"])
def test_what_lacks_its_extra_says_what_to_install(
    package: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [name for name in sys.modules if name.startswith(f"chr_notes.{package}")]:
        monkeypatch.delitem(sys.modules, name)
    for name in ("anywidget", "traitlets", "matplotlib", "mpl_toolkits"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ModuleNotFoundError, match=r'install "chr-notes\[notebooks\]"'):
        importlib.import_module(f"chr_notes.{package}")


def test_each_file_of_data_is_named_for_the_wheel() -> None:
    package = Path(chr_notes.__file__).parent
    settings = tomllib.loads((package.parent / "pyproject.toml").read_text(encoding="utf-8"))
    patterns = settings["tool"]["setuptools"]["package-data"]["*"]
    files = (path for path in package.rglob("*") if path.is_file())
    data = [path for path in files if path.suffix not in (".py", ".pyc", ".so")]
    assert data
    assert [path for path in data if not any(path.match(pattern) for pattern in patterns)] == []
