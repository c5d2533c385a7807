"""Exported code can be used where it lands."""

import subprocess
from collections.abc import Callable
from pathlib import Path

from chr_notes.__main__ import main


def test_exported_c_compiles_by_the_line_of_its_readme(
    tmp_path: Path, program: Callable[[str], str]
) -> None:
    gcc = program("gcc")
    assert main(["export", "c", str(tmp_path / "out")]) == 0
    readme = (tmp_path / "out" / "README.md").read_text(encoding="utf-8")
    line = next(part.strip() for part in readme.splitlines() if part.strip().startswith("gcc"))
    subprocess.run([gcc, *line.split()[1:]], cwd=tmp_path / "out", check=True)
    assert (tmp_path / "out" / "attitude.o").is_file()


def test_exported_javascript_runs(tmp_path: Path, program: Callable[[str], str]) -> None:
    node = program("node")
    assert main(["export", "js", str(tmp_path)]) == 0
    code = (
        'import { matrixFromEuler } from "./attitude.mjs";'
        "console.log(matrixFromEuler(0, 0, 0).join());"
    )
    (tmp_path / "use.mjs").write_text(code, encoding="utf-8")
    done = subprocess.run(
        [node, "use.mjs"], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    assert [float(x) for x in done.stdout.split(",")] == [1, 0, 0, 0, 1, 0, 0, 0, 1]
