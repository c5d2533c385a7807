"""The kernels, which are compiled where they are installed, give no cause for a warning."""

import subprocess
from collections.abc import Callable
from pathlib import Path

KERNELS = Path(__file__).resolve().parents[2] / "chr_notes" / "generated" / "c" / "kernels.c"


def test_gcc_does_not_warn(program: Callable[[str], str]) -> None:
    flags = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only")
    done = subprocess.run(
        [program("gcc"), *flags, str(KERNELS)], capture_output=True, text=True, check=False
    )
    assert not done.stderr
