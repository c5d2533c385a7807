"""The generated C and JavaScript, for people who take them into a program of their own."""

import shutil
from pathlib import Path
from typing import Literal

GENERATED = Path(__file__).resolve().parent / "generated"

_NAMES = {"c": "C", "js": "JavaScript"}
_FILES = {"c": ("c/attitude.h", "c/attitude.c"), "js": ("javascript/attitude.mjs",)}
_USE = {
    "c": """\
Put both files into your project and call the functions that `attitude.h` declares. They need C99
and `math.h`, allocate nothing and keep no state. Names that end in `_f` take and return float
instead of double. Results of several numbers go into the last argument. Functions that find Euler
angles return 1 at gimbal lock, where roll is set to 0 and yaw carries the rest, else 0.

    #include <stdio.h>
    #include "attitude.h"

    int main(void)
    {
        double euler[3];
        int locked = attitude_euler_from_quaternion(1.0, 0.0, 1.0, 0.0, euler);
        printf("%g %g %g, locked: %d\\n", euler[0], euler[1], euler[2], locked);
        return 0;
    }

It prints `0 1.5708 0, locked: 1`, saved as `main.c` and compiled by these lines:

    gcc -std=c99 -O2 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Werror \
-c attitude.c
    gcc -std=c99 -o main main.c attitude.o -lm
""",
    "js": """\
An ES module without dependencies, for browsers and Node:

    import { eulerFromQuaternion } from "./attitude.mjs";
    const [roll, pitch, yaw, locked] = eulerFromQuaternion(1, 0, 1, 0);

Functions that find Euler angles return them with one more value: whether at gimbal lock, where roll
is set to 0 and yaw carries the rest.
""",
}
_README = """\
# Attitude functions: {language}

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
        Made if it is not there; files that were exported before are replaced.

    Returns
    -------
    list of Path
        What was written.

    Raises
    ------
    FileExistsError
        If the folder has a `README.md` that is not of this export; nothing is written then.
    OSError
        If the folder cannot be made or written to.
    """
    text = _README.format(language=_NAMES[language], use=_USE[language])
    readme = folder / "README.md"
    if readme.exists() and readme.read_bytes().splitlines()[:1] != [text.encode().splitlines()[0]]:
        msg = f"expected a folder of its own for the export, but {readme} belongs to something else"
        raise FileExistsError(msg)
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name in _FILES[language]:
        target = folder / Path(name).name
        shutil.copyfile(GENERATED / name, target)
        written.append(target)
    readme.write_text(text, encoding="utf-8", newline="\n")
    return [*written, readme]
