"""The generated C and JavaScript, for people who take them into a program of their own."""

from os.path import lexists
from pathlib import Path
from typing import Literal

from chr_notes import __version__
from chr_notes._texts import PACKAGE, read, write

GENERATED = PACKAGE / "generated"

_NAMES = {"c": "C", "js": "JavaScript"}
_FILES = {
    "c": ("c/attitude.h", "c/attitude.c"),
    "js": ("javascript/attitude.mjs", "javascript/attitude.d.mts"),
}
# What build systems and package managers look for.
_BESIDE = {
    "c": {
        "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.10)
project(attitude C)
add_library(attitude attitude.c)
target_include_directories(attitude PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
if(UNIX)
  target_link_libraries(attitude PUBLIC m)
endif()
""",
        "library.properties": f"""\
name=Attitude
version={__version__}
author=chr_notes
maintainer=chr_notes
sentence=Attitude functions, generated from checked derivations.
paragraph=Euler angles, quaternions, matrices, sensor models and filters; plain C, no state.
category=Data Processing
architectures=*
""",
    },
    "js": {
        "package.json": f"""\
{{
  "name": "attitude",
  "version": "{__version__}",
  "license": "MIT",
  "type": "module",
  "exports": {{ ".": {{ "types": "./attitude.d.mts", "default": "./attitude.mjs" }} }}
}}
""",
    },
}
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

With CMake, `add_subdirectory(attitude)` and `target_link_libraries(main attitude)` do it. The
Arduino IDE takes the folder, put among its `libraries`, as one; on boards whose double is a float,
and on those that compute float alone in hardware, use the functions in `_f`.

Each function is described in `attitude.h`: its results, between which numbers they lie, and what
becomes of NaN and of readings that are none.
""",
    "js": """\
An ES module without dependencies, for browsers and Node:

    import { eulerFromQuaternion } from "./attitude.mjs";
    const [roll, pitch, yaw, locked] = eulerFromQuaternion(1, 0, 1, 0);

After `npm install` with the path of this folder, `"attitude"` stands for the file. TypeScript finds
types in `attitude.d.mts`. Each function is described in both: its results, between which numbers
they lie, and what becomes of NaN and of readings that are none.

Functions that find Euler angles return them with one more value: whether at gimbal lock, where roll
is set to 0 and yaw carries the rest.
""",
}
_README = """\
# Attitude functions: {language}

Generated from derivations that were checked against the printed formulas; do not edit them.

{use}
Frames are north-east-down and forward-right-down, angles are radians, Euler angles come as roll,
pitch, yaw and are turned in the order yaw, pitch, roll. Functions of angles in any other sequence
take its axes as numbers, 3, 2, 1 for z, y, x: each turn is about an axis as the turns before have
left it. Turns about fixed axes are these in the reversed order. Matrices lead from the inertial to
the body frame and stand row by row. Quaternions are Hamilton's, scalar first, with v_I = q v_B q*.

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
        If the folder has a file of one of these names that is not of an export; nothing is written
        then.
    OSError
        If the folder cannot be made or written to; what was in it stays as it was.
    """
    text = _README.format(language=_NAMES[language], use=_USE[language])
    made = {Path(name).name: read(GENERATED / name) for name in _FILES[language]}
    made |= {**_BESIDE[language], "README.md": text}
    readme = folder / "README.md"
    title = text.encode().splitlines()[:1]
    if not (readme.exists() and readme.read_bytes().splitlines()[:1] == title):
        foreign = next((folder / name for name in made if lexists(folder / name)), None)
        if foreign is not None:
            msg = f"expected a folder of its own for the export, but {foreign} is there already"
            raise FileExistsError(msg)
    folder.mkdir(parents=True, exist_ok=True)
    placed = {folder / name: content for name, content in made.items()}
    write(placed)
    return [*placed]
