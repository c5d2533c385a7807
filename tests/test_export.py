"""Exported code can be used where it lands."""

import math
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.__main__ import main

from .codegen.languages import WARNINGS


def test_exported_c_compiles_and_runs_by_its_readme(
    tmp_path: Path, program: Callable[[str], str]
) -> None:
    gcc = program("gcc")
    assert main(["export", "c", str(tmp_path / "out")]) == 0
    readme = (tmp_path / "out" / "README.md").read_text(encoding="utf-8")
    code = [line[4:] for line in readme.splitlines() if line.startswith("    ")]
    commands = [line.split() for line in code if line.startswith("gcc")]
    assert set(WARNINGS) <= set(commands[0])
    program_text = "\n".join(line for line in code if not line.startswith("gcc"))
    (tmp_path / "out" / "main.c").write_text(program_text + "\n", encoding="utf-8")
    assert len(commands) == 2
    for _, *arguments in commands:
        subprocess.run([gcc, *arguments], cwd=tmp_path / "out", check=True)
    done = subprocess.run([tmp_path / "out" / "main"], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "0 1.5708 0, locked: 1"
    assert f"It prints `{done.stdout.strip()}`" in readme


def test_exported_javascript_runs(tmp_path: Path, program: Callable[[str], str]) -> None:
    node = program("node")
    assert main(["export", "js", str(tmp_path)]) == 0
    readme = (tmp_path / "README.md").read_text(encoding="utf-8")
    lines = [line[4:] for line in readme.splitlines() if line.startswith("    ")]
    code = "\n".join([*lines, "console.log([roll, pitch, yaw, Number(locked)].join());"])
    (tmp_path / "use.mjs").write_text(code, encoding="utf-8")
    done = subprocess.run(
        [node, "use.mjs"], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    assert [float(x) for x in done.stdout.split(",")] == [0, math.pi / 2, 0, 1]


@pytest.mark.parametrize("language", ["c", "js"])
def test_an_export_replaces_itself_and_nothing_of_others(language: str, tmp_path: Path) -> None:
    assert main(["export", language, str(tmp_path / "own")]) == 0
    assert main(["export", language, str(tmp_path / "own")]) == 0
    (tmp_path / "README.md").write_text("# My rocket\n", encoding="utf-8")
    assert main(["export", language, str(tmp_path)]) == 2
    assert {path.name for path in tmp_path.iterdir()} == {"own", "README.md"}
    assert (tmp_path / "README.md").read_text(encoding="utf-8") == "# My rocket\n"


def test_a_folder_that_cannot_be_made_is_said_in_a_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    assert main(["export", "c", str(tmp_path / "file")]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("export: ")
    assert said.err.count("\n") == 1
