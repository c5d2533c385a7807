"""The committed bundles are what the sources give, and a change in either is seen."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.demos import build
from chr_notes.demos.base import BUILT


@pytest.mark.full  # `.ci/run` and `nox -s lint` check the same by name
def test_committed_bundles_are_as_made_now(program: Callable[[str], str]) -> None:
    program("npx")
    assert build.check() == []


def test_check_sees_missing_extra_and_changed_files(tmp_path: Path) -> None:
    fresh = tmp_path / "fresh"
    shutil.copytree(BUILT, fresh)
    assert build.differences(fresh) == []
    (fresh / "drift_0_1_0_0_0_10.svg").write_text("changed", encoding="utf-8")
    (fresh / "new.svg").write_text("", encoding="utf-8")
    (fresh / "demos.js").unlink()
    assert build.differences(fresh) == [
        "missing: new.svg",
        "not from any source: demos.js",
        "out of date: drift_0_1_0_0_0_10.svg",
    ]


def test_scripts_of_a_page_are_small() -> None:
    for name in build.BUNDLES:
        assert (BUILT / f"{name}.js").stat().st_size <= 120_000


def test_script_says_how_it_was_made() -> None:
    for name in build.BUNDLES:
        first = (BUILT / f"{name}.js").read_text(encoding="utf-8").partition("\n")[0]
        assert first.startswith("// Bundled by `python -m chr_notes.demos.build` with esbuild@")
