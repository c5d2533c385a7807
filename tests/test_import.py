"""Importing the package is cheap."""

import subprocess
import sys

HEAVY = ("sympy", "scipy", "matplotlib", "anywidget", "numba")


def test_import_loads_nothing_heavy() -> None:
    code = f"import sys, chr_notes; print([m for m in {HEAVY} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
