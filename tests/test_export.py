"""Exported code can be used where it lands."""

import math
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.__main__ import main

from .codegen.languages import WARNINGS

TYPESCRIPT = "typescript@5.9.3"


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


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A folder in which the exported package is installed."""
    assert main(["export", "js", str(tmp_path / "node_modules" / "attitude")]) == 0
    return tmp_path


def lines_of_use(package: Path) -> list[str]:
    readme = (package / "node_modules" / "attitude" / "README.md").read_text(encoding="utf-8")
    return [line[4:] for line in readme.splitlines() if line.startswith("    ")]


@pytest.mark.parametrize("name", ["./node_modules/attitude/attitude.mjs", "attitude"])
def test_exported_javascript_runs(name: str, package: Path, program: Callable[[str], str]) -> None:
    node = program("node")
    lines = [line.replace("./attitude.mjs", name) for line in lines_of_use(package)]
    code = "\n".join([*lines, "console.log([roll, pitch, yaw, Number(locked)].join());"])
    (package / "use.mjs").write_text(code, encoding="utf-8")
    done = subprocess.run(
        [node, "use.mjs"], cwd=package, check=True, capture_output=True, text=True
    )
    assert [float(x) for x in done.stdout.split(",")] == [0, math.pi / 2, 0, 1]


def test_typescript_accepts_right_uses_alone(package: Path, program: Callable[[str], str]) -> None:
    npx = program("npx")
    lines = [line.replace("./attitude.mjs", "attitude") for line in lines_of_use(package)]
    use = "const sum: number = roll + pitch; const flag: KIND = locked;"
    use += "const turned: [number, number, number] = rotateToBody(1, 0, 0, 0, 1, 2, 3);"
    code = "\n".join(['import { rotateToBody } from "attitude";', *lines, use])
    for name, kind in (("right", "boolean"), ("wrong", "number")):
        (package / f"{name}.mts").write_text(code.replace("KIND", kind), encoding="utf-8")
    command = [npx, "--yes", "--package", TYPESCRIPT, "tsc", "--strict", "--noEmit"]
    done = subprocess.run(
        [*command, "--target", "es2022", "--module", "nodenext", "right.mts", "wrong.mts"],
        cwd=package, capture_output=True, text=True, check=False,
    )  # fmt: skip
    found = [line for line in done.stdout.splitlines() if "error" in line]
    assert len(found) == 1, done.stdout + done.stderr
    assert found[0].startswith("wrong.mts")
    assert "Type 'boolean' is not assignable to type 'number'" in found[0]


@pytest.mark.parametrize("language", ["c", "js"])
def test_an_export_replaces_itself_and_nothing_of_others(language: str, tmp_path: Path) -> None:
    assert main(["export", language, str(tmp_path / "own")]) == 0
    assert main(["export", language, str(tmp_path / "own")]) == 0
    files = [path.name for path in (tmp_path / "own").iterdir()]
    for name in files:
        (tmp_path / name).write_text("# My rocket\n", encoding="utf-8")
        assert main(["export", language, str(tmp_path)]) == 1
        assert {path.name for path in tmp_path.iterdir()} == {"own", name}
        assert (tmp_path / name).read_text(encoding="utf-8") == "# My rocket\n"
        (tmp_path / name).unlink()


def test_a_folder_that_cannot_be_made_is_said_in_a_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    assert main(["export", "c", str(tmp_path / "file")]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("export: ")
    assert said.err.count("\n") == 1
