"""Bundle and minify the demos: ``python -m chr_notes.demos.build [--check]``.

One ES module a widget for anywidget, and one classic script for the pages of the book, which
also works from ``file://``. The output is committed, so that neither installing nor building
the book needs Node; only a change of the JavaScript does. ``--check`` bundles into a temporary
folder and compares whole folders with what is committed.
"""

import argparse
import filecmp
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from chr_notes.aircraft import PARTS
from chr_notes.conventions import NOTES_GRAVITY, STANDARD_GRAVITY
from chr_notes.demos.base import BUILT, SOURCES
from chr_notes.demos.tilt import NOTHING
from chr_notes.palette import DASHES
from chr_notes.printed.table_1 import ROWS

ESBUILD = "esbuild@0.28.2"
"""The exact bundler: the same version writes the same bytes."""

WIDGETS = ("drift", "gimbal_lock", "quaternion", "tilt")
PAGES = "pages"
CONSTANTS = {
    "STANDARD_GRAVITY": STANDARD_GRAVITY,
    "NOTES_GRAVITY": NOTES_GRAVITY,
    "NOTHING": NOTHING,
    "TABLE_1": dict(ROWS),
    "AIRCRAFT": PARTS,
    "DASHES": dict(DASHES),
}
"""What the modules have from Python, by the name that stands for it in them."""

_BANNER = f"""\
// Bundled by `python -m chr_notes.demos.build` with {ESBUILD}. Do not edit.
// From chr_notes/demos/*.js and chr_notes/generated/javascript."""


def bundle(folder: Path) -> None:
    """Write all bundles into `folder`.

    Raises
    ------
    RuntimeError
        Without Node's ``npx``, or with esbuild's message when a source is wrong.
    """
    npx = shutil.which("npx")
    if npx is None:
        msg = "bundling the demos needs Node.js with npx on the path; reading and using them do not"
        raise RuntimeError(msg)
    common = [npx, "--yes", ESBUILD, "--bundle", "--minify", "--charset=utf8", "--target=es2022"]
    common += ["--log-level=warning", f"--banner:js={_BANNER}"]
    common += [f"--define:{name}={json.dumps(value)}" for name, value in CONSTANTS.items()]
    jobs = [["--format=esm", f"--outfile={folder / name}.mjs", f"{name}.js"] for name in WIDGETS]
    jobs += [["--format=iife", f"--outfile={folder / PAGES}.js", f"{PAGES}.js"]]
    for job in jobs:
        command = [*common, *job]
        done = subprocess.run(command, cwd=SOURCES, check=False, capture_output=True, text=True)  # noqa: S603 - no user's input
        if done.returncode != 0:
            msg = f"{ESBUILD} failed on {job[-1]}:\n{done.stderr.strip()}"
            raise RuntimeError(msg)


def differences(folder: Path) -> list[str]:
    """Return what keeps `folder` from being equal to the committed one, a line each."""
    fresh, committed = ({path.name for path in place.iterdir()} for place in (folder, BUILT))
    common = sorted(fresh & committed)
    _, changed, unreadable = filecmp.cmpfiles(folder, BUILT, common, shallow=False)
    return (
        [f"missing: {name}" for name in sorted(fresh - committed)]
        + [f"not from any source: {name}" for name in sorted(committed - fresh)]
        + [f"out of date: {name}" for name in sorted(changed + unreadable)]
    )


def check() -> list[str]:
    """Bundle into a temporary folder and return the differences from what is committed."""
    with tempfile.TemporaryDirectory() as temporary:
        bundle(Path(temporary))
        return differences(Path(temporary))


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; return 1 when ``--check`` finds a difference."""
    parser = argparse.ArgumentParser(prog="python -m chr_notes.demos.build", description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    if parser.parse_args(arguments).check:
        found = check()
        sys.stdout.write("\n".join(found or ["the bundles are up to date"]) + "\n")
        return 1 if found else 0
    with tempfile.TemporaryDirectory() as temporary:
        bundle(Path(temporary))
        shutil.rmtree(BUILT, ignore_errors=True)
        shutil.copytree(temporary, BUILT)
    sys.stdout.write(f"wrote {len(WIDGETS) + 1} bundles to {BUILT}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
