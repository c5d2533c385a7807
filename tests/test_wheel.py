"""The wheel without its compiled part is small, and has what the package reads."""

import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
import yaml

from chr_notes._texts import ARCHIVES, PACKAGE

LARGEST = 800_000
TEXTS = ("demos/built", "generated/javascript", "generated/pages", "ledger/verdicts")
STRING_OR_COMMENT = re.compile(r"""("[^"\n]*"|'[^'\n]*'|url\([^)]*\))|/\*.*?\*/\s*""", re.DOTALL)
COMMENT_IN_LINES = re.compile(r"(?m)^ */\*(?:[^*]|\*(?!/))*\*/\s*")
WITHOUT = {
    ".css": partial(STRING_OR_COMMENT.sub, lambda found: found[1] or ""),
    ".js": partial(COMMENT_IN_LINES.sub, ""),
}
BESIDE = {"generated/c/attitude.c", "lesson/lesson.js", "packed/book/_config.yml"}


@pytest.mark.full
def test_a_wheel_of_python_alone_is_small_and_whole(
    tmp_path: Path, record_property: Callable[[str, object], None]
) -> None:
    build = [sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "-w", str(tmp_path), "."]
    subprocess.run(build, cwd=PACKAGE.parent, check=True, env={**os.environ, "CC": "false"})
    (wheel,) = tmp_path.glob("*.whl")
    record_property("measured", f"wheel without kernels {wheel.stat().st_size / 1000:.0f} kB")
    assert wheel.stat().st_size <= LARGEST
    texts: dict[str, str] = {}
    with zipfile.ZipFile(wheel) as package:
        names = {name for name in package.namelist() if name.startswith("chr_notes/")}
        for path, decompress in ARCHIVES.items():
            content = decompress(package.read(f"chr_notes/{path.name}"))
            parts = map(bytes.decode, content.split(b"\0"))
            texts |= dict(zip(parts, parts, strict=True))
    assert {Path(name).suffix for name in names} <= {".py", ".typed", ".bz2", ".xz"}
    assert "chr_notes/codegen/__main__.py" not in names
    notebooks = {path.name for path in (PACKAGE.parent / "notebooks").glob("*.ipynb")}
    assert BESIDE | {f"packed/notebooks/{name}" for name in notebooks} <= texts.keys()
    for folder in TEXTS:
        assert {f"{folder}/{path.name}" for path in (PACKAGE / folder).iterdir()} <= texts.keys()
    for name in ("book/_config.yml", "book/_toc.yml"):
        whole = (PACKAGE.parent / name).read_text(encoding="utf-8")
        assert yaml.safe_load(texts[f"packed/{name}"]) == yaml.safe_load(whole)
    for kind, without in WITHOUT.items():
        bare = [name for name in texts if name.endswith(kind)]
        assert bare
        for name in bare:
            place = PACKAGE.parent / name.removeprefix("packed/")
            whole = (place if place.is_file() else PACKAGE / name).read_text(encoding="utf-8")
            assert texts[name] == (whole if "/built/" in name else without(whole))


def test_without_a_compiler_there_are_no_kernels_of_a_build_before(tmp_path: Path) -> None:
    shutil.copy(PACKAGE.parent / "setup.py", tmp_path)
    for folder in ("chr_notes", "build/chr_notes"):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "_compiled.abi3.so").touch()
    build = [sys.executable, "setup.py", "-q", "build_ext", "--inplace", "--build-lib", "build"]
    environment = {**os.environ, "CC": "false"}
    subprocess.run(build, cwd=tmp_path, check=True, env=environment, capture_output=True)
    assert [*tmp_path.rglob("_compiled*")] == []
