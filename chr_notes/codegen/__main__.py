"""Write the generated files, or compare them: `python -m chr_notes.codegen [--check]`."""

import argparse
import sys
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

from chr_notes.codegen import arrays, c, javascript, kernels, page_parts, python
from chr_notes.codegen.header import COMMAND, made_how
from chr_notes.codegen.lowering import Program, lower
from chr_notes.codegen.rewriting import by_library, for_columns, without_roots
from chr_notes.codegen.sequence_targets import TARGETS as SEQUENCES
from chr_notes.codegen.sequence_targets import of_usual_axes
from chr_notes.codegen.target import Target
from chr_notes.codegen.targets import TARGETS

FOLDER = Path(__file__).resolve().parents[1] / "generated"
NATIVE = FOLDER.parent / "native"


def files() -> dict[str, str]:
    """Make all generated files.

    Returns
    -------
    dict
        From the path below `generated/` to the text of the file.
    """
    programs = tuple(lower(target, by_library) for target in TARGETS)
    rows = [target for target in TARGETS if target.arrays and not target.over_samples]
    columns = tuple(lower(target, for_columns, ("guard",)) for target in rows)
    checked = {
        target: tuple(
            lower(each, for_columns, ("guard", "valid"))
            for each in (of_usual_axes(target) if target in SEQUENCES else (target,))
        )
        for target in rows
    }
    steps = tuple(program for program in programs if program.target.over_samples)
    compiled = kernels.source(
        checked,
        tuple(lower(_of_squares(step.target), by_library, ("valid",)) for step in steps),
    )
    made = {
        "scalar/__init__.py": '"""Functions of floats, for one attitude at a time."""\n',
        "arrays/__init__.py": '"""Functions of arrays, for many attitudes at once."""\n',
        "arrays/shapes.py": arrays.table((*columns, *steps)),
        "javascript/attitude.mjs": javascript.module(programs),
        "javascript/attitude.d.mts": javascript.declarations(programs),
        "c/attitude.h": c.header(programs),
        "c/attitude.c": c.source(programs),
        "c/kernels.c": compiled,
        **_stamps(compiled),
    }
    made |= {f"pages/{name}": text for name, text in page_parts.parts(programs, checked).items()}
    for topic in dict.fromkeys(target.topic for target in TARGETS):
        made[f"scalar/{topic}.py"] = python.module(_of_topic(programs, topic))
        made[f"arrays/{topic}.py"] = arrays.module(_of_topic(columns, topic))
    return made


def _stamps(compiled: str) -> dict[str, str]:
    """Give the kernels a stamp by which Python tells whether a binary was built from them."""
    sources = [compiled, *(path.read_text(encoding="utf-8") for path in sorted(NATIVE.iterdir()))]
    stamp = sha256("".join(sources).encode()).hexdigest()[:16]
    return {
        "__init__.py": f'"""{made_how(())[0]}"""\n\nSTAMP = "{stamp}"\n',
        "c/stamp.h": f'/* {made_how(())[0]} */\n#define STAMP "{stamp}"\n',
    }


def _of_squares(target: Target) -> Target:
    return replace(target, formula=lambda: without_roots(target.computation()))


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
