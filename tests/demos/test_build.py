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
    (fresh / "gimbal_lock.mjs").write_text("changed", encoding="utf-8")
    (fresh / "new.mjs").write_text("", encoding="utf-8")
    (fresh / "pages.js").unlink()
    assert build.differences(fresh) == [
        "missing: new.mjs",
        "not from any source: pages.js",
        "out of date: gimbal_lock.mjs",
    ]


def test_scripts_of_a_page_are_small() -> None:
    assert (BUILT / "pages.js").stat().st_size <= 120_000


def test_bundles_say_how_they_were_made() -> None:
    for path in (*BUILT.glob("*.mjs"), BUILT / "pages.js"):
        first = path.read_text(encoding="utf-8").partition("\n")[0]
        assert first.startswith("// Bundled by `python -m chr_notes.demos.build` with esbuild@"), (
            path
        )
