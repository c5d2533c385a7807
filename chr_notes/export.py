"""The generated C and JavaScript, for people who take them into a program of their own."""

import shutil
from pathlib import Path
from typing import Literal

GENERATED = Path(__file__).resolve().parent / "generated"

_FILES = {"c": ("c/attitude.h", "c/attitude.c"), "js": ("javascript/attitude.mjs",)}
_USE = {
    "c": """\
Put both files into your project and call the functions that `attitude.h` declares:

    #include "attitude.h"

They need C99 and `math.h`, allocate nothing and keep no state. Names that end in `_f` take and
return float instead of double.

    gcc -std=c99 -O2 -Wall -Wextra -Wconversion -Werror -c attitude.c
""",
    "js": """\
An ES module without dependencies, for browsers and Node:

    import { matrixFromEuler } from "./attitude.mjs";
""",
}
_README = """\
# Attitude functions

Generated from derivations that were checked against the printed formulas; do not edit them.

{use}
Frames are north-east-down and forward-right-down, angles are radians, Euler angles come as roll,
pitch, yaw and are turned in the order yaw, pitch, roll. Matrices lead from the inertial to the body
frame and stand row by row. Quaternions are Hamilton's, scalar first, with v_I = q v_B q*.

Licence: MIT.
"""


def export(language: Literal["c", "js"], folder: Path) -> list[Path]:
    """Write the generated code of one language, with a README, into a folder.

    Parameters
    ----------
    language
        `"c"` or `"js"`.
    folder
        Made if it is not there; files of the same names are replaced.

    Returns
    -------
    list of Path
        What was written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name in _FILES[language]:
        target = folder / Path(name).name
        shutil.copyfile(GENERATED / name, target)
        written.append(target)
    readme = folder / "README.md"
    readme.write_text(_README.format(use=_USE[language]), encoding="utf-8")
    return [*written, readme]
