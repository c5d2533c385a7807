"""Write the generated files, or compare them: `python -m chr_notes.codegen [--check]`."""

import argparse
import sys
from pathlib import Path

from chr_notes.codegen import arrays, c, javascript, loops, python
from chr_notes.codegen.header import COMMAND
from chr_notes.codegen.loop_targets import LOOPS
from chr_notes.codegen.lowering import Program, lower
from chr_notes.codegen.rewriting import by_half_tangent, by_library
from chr_notes.codegen.targets import TARGETS

FOLDER = Path(__file__).resolve().parents[1] / "generated"


def files() -> dict[str, str]:
    """Make all generated files.

    Returns
    -------
    dict
        From the path below `generated/` to the text of the file.
    """
    programs = tuple(lower(target, by_library) for target in TARGETS if not target.complex)
    blocks = tuple(lower(target, by_half_tangent, guarded=True) for target in TARGETS)
    topics = list(dict.fromkeys(target.topic for target in TARGETS))
    made = {
        "__init__.py": '"""Generated code; `python -m chr_notes.codegen` writes it."""\n',
        "scalar/__init__.py": '"""Functions of floats, for one attitude at a time."""\n',
        "arrays/__init__.py": '"""Functions of arrays, for many attitudes at once."""\n',
        "loops/__init__.py": '"""Functions of recordings, sample after sample."""\n',
        "javascript/attitude.mjs": javascript.module(programs),
        "c/attitude.h": c.header(programs),
        "c/attitude.c": c.source(programs),
    }
    for topic in topics:
        made[f"scalar/{topic}.py"] = python.module(_of_topic(programs, topic))
        made[f"arrays/{topic}.py"] = arrays.module(_of_topic(blocks, topic))
    for topic in dict.fromkeys(loop.topic for loop in LOOPS):
        own = tuple(loop for loop in LOOPS if loop.topic == topic)
        made[f"loops/{topic}.py"] = loops.module(own, programs)
    return made


def _of_topic(programs: tuple[Program, ...], topic: str) -> tuple[Program, ...]:
    return tuple(program for program in programs if program.target.topic == topic)


def compare(folder: Path, made: dict[str, str]) -> list[str]:
    """List what differs between a folder and the files as made now.

    Missing and extra files count; Python's caches do not.
    """
    there = {
        path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(folder.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }
    return [
        *(f"missing: {name}" for name in sorted(made.keys() - there.keys())),
        *(f"extra: {name}" for name in sorted(there.keys() - made.keys())),
        *(
            f"differs: {name}"
            for name in sorted(made)
            if name in there and made[name] != there[name]
        ),
    ]


def main(arguments: list[str] | None = None) -> int:
    """Run the command."""
    parser = argparse.ArgumentParser(prog=COMMAND, description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    options = parser.parse_args(arguments)
    made = files()
    if options.check:
        differences = compare(FOLDER, made)
        for line in differences:
            print(line, file=sys.stderr)
        if differences:
            print(f"Run `{COMMAND}` and commit the result.", file=sys.stderr)
        return int(bool(differences))
    for name in compare(FOLDER, made):
        kind, path = name.split(": ")
        if kind == "extra":
            (FOLDER / path).unlink()
    for path, text in made.items():
        (FOLDER / path).parent.mkdir(parents=True, exist_ok=True)
        (FOLDER / path).write_text(text, encoding="utf-8", newline="\n")
    print(f"{len(made)} files written to {FOLDER.name}/")
    return 0


if __name__ == "__main__":
    sys.exit(main())
