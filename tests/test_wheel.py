"""The wheel without its compiled part is small, and has what the package reads."""

import os
import subprocess
import sys
import tarfile
import zipfile
from io import BytesIO
from pathlib import Path

import pytest

from chr_notes._texts import PACKAGE

LARGEST = 800_000
TEXTS = ("demos/built", "generated/javascript", "generated/pages", "ledger/verdicts")


@pytest.mark.full
def test_a_wheel_of_python_alone_is_small_and_whole(tmp_path: Path) -> None:
    build = [sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "-w", str(tmp_path), "."]
    subprocess.run(build, cwd=PACKAGE.parent, check=True, env={**os.environ, "CC": "false"})
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.stat().st_size <= LARGEST
    with zipfile.ZipFile(wheel) as package:
        names = package.namelist()
        content = package.read("chr_notes/texts.tar.xz")
    with tarfile.open(fileobj=BytesIO(content)) as archive:
        texts = {*archive.getnames()}
    assert "chr_notes/codegen/__main__.py" not in names
    assert {"generated/c/attitude.c", "packed/book/_config.yml"} <= texts
    for folder in TEXTS:
        there = {f"{folder}/{path.name}" for path in (PACKAGE / folder).iterdir()}
        assert there <= texts
        assert not any(name.startswith(f"chr_notes/{folder}/") for name in names)
    notebooks = {path.name for path in (PACKAGE.parent / "notebooks").glob("*.ipynb")}
    assert {f"packed/notebooks/{name}" for name in notebooks} <= texts
