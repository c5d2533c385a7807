"""What happens while the package is imported: a command says it in a line, a library raises it."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

# As NumPy does it, which takes what ends its import for a fault of its own.
INTERRUPTED = """\
import signal
try:
    signal.raise_signal(signal.SIGINT)
except BaseException as error:
    raise ImportError("of NumPy") from error
"""
CHOICE = "CHR_NOTES_KERNELS: expected off or require, got 'bogus'"
COMMANDS = {"module": ["-m", "chr_notes"], "script": ["chr-notes"]}

Start = Callable[..., tuple[int, list[str]]]
of_each_command = pytest.mark.parametrize("asked", COMMANDS.values(), ids=COMMANDS)


@pytest.fixture
def start(tmp_path: Path) -> Start:
    """Run Python in a folder of which it takes modules first: its exit code, and what it says."""
    (tmp_path / "chr-notes").write_text("from chr_notes.__main__ import run\nrun()\n", "utf-8")

    def run(*asked: str, **variables: str) -> tuple[int, list[str]]:
        done = subprocess.run(
            [sys.executable, *asked, "--version"],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(tmp_path), **variables},
            capture_output=True,
            text=True,
            check=False,
        )
        return done.returncode, done.stderr.splitlines()

    return run


@of_each_command
@pytest.mark.usefixtures("ctrl_c")
def test_who_stops_a_command_while_it_is_imported_gets_a_line(
    asked: list[str], start: Start, tmp_path: Path
) -> None:
    (tmp_path / "numpy.py").write_text(INTERRUPTED, "utf-8")
    assert start(*asked) == (130, ["chr-notes: stopped before the end"])


@pytest.mark.usefixtures("ctrl_c")
def test_a_program_that_imports_the_package_hears_ctrl_c(start: Start, tmp_path: Path) -> None:
    (tmp_path / "numpy.py").write_text(INTERRUPTED, "utf-8")
    code, said = start("-c", "import chr_notes")
    assert (code, said[-1]) == (1, "ImportError: of NumPy")
    assert "KeyboardInterrupt" in said


@of_each_command
def test_a_command_says_in_a_line_what_is_wrong_with_the_variable(
    asked: list[str], start: Start
) -> None:
    assert start(*asked, CHR_NOTES_KERNELS="bogus") == (1, [f"chr-notes: {CHOICE}"])
    code, said = start("-c", "import chr_notes", CHR_NOTES_KERNELS="bogus")
    assert (code, said[-1]) == (1, f"ValueError: {CHOICE}")
