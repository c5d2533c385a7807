"""Bundle and minify the demos: ``python -m chr_notes.demos.build [--check]``.

One script, for the pages of the book, which also works from ``file://``, and for the widgets in a
notebook (see base.py), and a still picture of each state that a page opens with. The output is
committed, so that neither installing nor building the book needs Node; only a change of the
JavaScript does. ``--check`` bundles into a temporary folder and compares whole folders with what
is committed.
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
from chr_notes.demos import (
    ConverterDemo,
    DriftDemo,
    FilterDemo,
    FramesDemo,
    GimbalLockDemo,
    MagnetometerDemo,
    QuaternionDemo,
    TiltDemo,
    ValidationDemo,
    magnetometer,
    validation,
)
from chr_notes.demos.base import BUILT, BUNDLE, SOURCES
from chr_notes.demos.converter import CONVENTIONS
from chr_notes.demos.detective import DETECTIVE
from chr_notes.demos.filter import RUN
from chr_notes.demos.noise import MODULUS, MULTIPLIER
from chr_notes.demos.tilt import NOTHING
from chr_notes.palette import DASHES, PALETTE
from chr_notes.printed.table_1 import ROWS

ESBUILD = "esbuild@0.28.2"
"""The exact bundler: the same version writes the same bytes."""

BUNDLES = {"demos": "bundle.js", "converter": "converter_bundle.js"}
"""Source of each script that is built."""
STILLS = (
    ConverterDemo(),
    FilterDemo(),
    FramesDemo(),
    DriftDemo(),
    GimbalLockDemo(),
    MagnetometerDemo(),
    QuaternionDemo(),
    TiltDemo(),
    ValidationDemo(),
    FramesDemo(frame=2.0, axis=1.0, yaw=40.0, pitch=30.0, roll=25.0),
    DriftDemo(angle_error=1.0, time=60.0),
    GimbalLockDemo(yaw=30.0, pitch=60.0, roll=20.0),
    MagnetometerDemo(tilt=0.0),
    GimbalLockDemo(view=1.0, roll=12.0, flown=75.0),
    GimbalLockDemo(view=2.0, pitch=60.0, roll=55.0),
    TiltDemo(forward_acceleration=2.0),
    TiltDemo(roll=30.0, pitch=10.0),
)
"""What has a still picture: each demo as it is made, and each state that a page opens with."""

CONSTANTS = {
    "STANDARD_GRAVITY": STANDARD_GRAVITY,
    "NOTES_GRAVITY": NOTES_GRAVITY,
    "NOTHING": NOTHING,
    "TABLE_1": dict(ROWS),
    "AIRCRAFT": PARTS,
    "DASHES": dict(DASHES),
    "MAGNETOMETER": magnetometer.SETTING._asdict(),
    "VALIDATION": validation.SETTING._asdict(),
    "MULTIPLIER": MULTIPLIER,
    "MODULUS": MODULUS,
    "FILTER_RUN": RUN._asdict(),
    "CONVENTIONS": CONVENTIONS,
    "DETECTIVE": DETECTIVE,
}
"""What the modules have from Python, by the name that stands for it in them."""

_BANNER = f"""\
// Bundled by `python -m chr_notes.demos.build` with {ESBUILD}. Do not edit.
// From chr_notes/demos/*.js and chr_notes/generated/javascript."""


def bundle(folder: Path) -> None:
    """Write the scripts and the stills into `folder`.

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
    write_stills(folder, common)
    for name, source in BUNDLES.items():
        out = [f"--global-name={BUNDLE}", f"--outfile={folder / name}.js"]
        _output([*common, "--format=iife", *out, source], source)


def write_stills(folder: Path, common: list[str]) -> None:
    """Write a picture of each state that a page opens with, drawn by the demo itself in Node."""
    script = [*common, "--format=esm", "--platform=node", "still.js"]
    source = _output(script, "still.js")
    asked = {
        "stills": [{"demo": demo.element, "state": demo.state()} for demo in STILLS],
        "palettes": [
            {name: getattr(colour, theme) for name, colour in PALETTE.items()}
            for theme in ("light", "dark")
        ],
    }
    with tempfile.TemporaryDirectory() as beside:
        path = Path(beside) / "still.mjs"  # too long for an argument
        path.write_text(source, encoding="utf-8")
        node = [str(shutil.which("node")), str(path)]
        drawn = json.loads(_output(node, "still.js", json.dumps(asked)))
    for demo, picture in zip(STILLS, drawn, strict=True):
        (folder / demo.still_name()).write_text(picture, encoding="utf-8")


def _output(command: list[str], source: str, given: str = "") -> str:
    done = subprocess.run(  # noqa: S603 - no user's input
        command, cwd=SOURCES, check=False, capture_output=True, text=True, input=given
    )
    if done.returncode != 0:
        msg = f"{ESBUILD} or Node failed on {source}:\n{done.stderr.strip()}"
        raise RuntimeError(msg)
    return done.stdout


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
        sys.stdout.write("\n".join(found or ["script and stills are up to date"]) + "\n")
        return 1 if found else 0
    with tempfile.TemporaryDirectory() as temporary:
        bundle(Path(temporary))
        shutil.rmtree(BUILT, ignore_errors=True)
        shutil.copytree(temporary, BUILT)
    sys.stdout.write(f"wrote {len(BUNDLES)} scripts and {len(STILLS)} stills to {BUILT}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
