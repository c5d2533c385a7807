"""A test of derivations that fails says in which file to look."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from . import test_forms

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    ("test", "file"),
    [
        ("test_euler_rates", "chr_notes/derivations/euler.py"),
        ("test_tilt", "chr_notes/derivations/forms/estimation.py"),
    ],
)
def test_a_failing_test_of_forms_names_the_derivation(
    request: pytest.FixtureRequest, test: str, file: str
) -> None:
    item = SimpleNamespace(function=getattr(test_forms, test))
    plugin = request.config.pluginmanager.get_plugin(str(ROOT / "tests" / "conftest.py"))
    assert file in [*plugin.files_to_mend(item)]
