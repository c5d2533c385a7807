"""The lowest versions that the project declares are ones that were tried."""

import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement

TOML = Path(__file__).resolve().parents[1] / "pyproject.toml"
PROJECT = tomllib.loads(TOML.read_text(encoding="utf-8"))["project"]
CORE = {each.name: each.specifier for each in map(Requirement, PROJECT["dependencies"])}
EXTRA = map(Requirement, PROJECT["optional-dependencies"]["test"])
PINNED = {each.name: str(s.version) for each in EXTRA for s in each.specifier if s.operator == "=="}


def release(version: str) -> list[int]:
    numbers = [int(part) for part in version.split(".")]
    return numbers + [0] * (3 - len(numbers))


def test_sympy_is_pinned_for_the_tests() -> None:
    assert "sympy" in PINNED


@pytest.mark.parametrize("name", sorted(CORE.keys() & PINNED.keys()))
def test_what_the_tests_pin_is_the_lowest_that_the_core_permits(name: str) -> None:
    """`nox -s oldest` tries the others."""
    lowest = [specifier.version for specifier in CORE[name] if specifier.operator == ">="]
    assert [release(version) for version in lowest] == [release(PINNED[name])]
