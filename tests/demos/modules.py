"""Modules of the demos in Node, as they stand: what needs no page is tried without one."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from chr_notes import matrix_from_euler
from chr_notes.demos.base import SOURCES
from chr_notes.demos.converter import CONVENTIONS
from chr_notes.demos.detective import DETECTIVE

ROTATION = np.round(matrix_from_euler([0.1, 0.2, 0.3]), 6).tolist()
"""A matrix to type and to paste, by rows."""

CALL = """\
import { readFileSync } from "node:fs";
Object.assign(globalThis, CONSTANTS);
const module = await import("./demos/FILE");
const given = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(given.map((each) => module.FUNCTION(...each))));
"""


def called(folder: Path, file: str, function: str, given: list[list[Any]]) -> Any:  # noqa: ANN401
    """Call a function of a module with each of some lists of arguments, and return the results."""
    shutil.copytree(SOURCES, folder / "demos", dirs_exist_ok=True)
    generated = SOURCES.parent / "generated" / "javascript"
    shutil.copytree(generated, folder / "generated" / "javascript", dirs_exist_ok=True)
    (folder / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    tables = json.dumps({"CONVENTIONS": CONVENTIONS, "DETECTIVE": DETECTIVE})
    source = CALL.replace("CONSTANTS", tables)
    (folder / "call.js").write_text(
        source.replace("FUNCTION", function).replace("FILE", file), encoding="utf-8"
    )
    done = subprocess.run(
        [str(shutil.which("node")), str(folder / "call.js")], input=json.dumps(given), check=True,
        capture_output=True, text=True,
    )  # fmt: skip
    return json.loads(done.stdout)
