"""Run the generated functions of each language over a file of vectors."""

import math
import subprocess
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path

import numpy as np

from chr_notes._kernels import kernel
from chr_notes.codegen.__main__ import FOLDER
from chr_notes.codegen.javascript import camel
from chr_notes.codegen.lowering import Program, lower
from chr_notes.codegen.rewriting import by_library
from chr_notes.codegen.targets import TARGETS
from chr_notes.generated.arrays.shapes import SHAPES

from .vectors import Vector

Results = list[list[float]]
WARNINGS = [
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Werror",
]
GCC = ("gcc", "-std=c99", "-O2", *WARNINGS)


@cache
def programs() -> dict[str, Program]:
    """The functions as they are computed, by name."""
    return {target.name: lower(target, by_library) for target in TARGETS}


def python(vectors: list[Vector]) -> Results:
    """Call the functions of floats; where `math` refuses infinity, nothing is returned."""
    return [_python(vector) for vector in vectors]


def _python(vector: Vector) -> list[float]:
    target = vector.target
    module = import_module(f"chr_notes.generated.scalar.{target.topic}")
    try:
        results = getattr(module, target.name)(*vector.arguments)
    except (ValueError, ZeroDivisionError):
        # C and JavaScript go on with NaN, or with infinity where a divisor is zero.
        assert not all(math.isfinite(result) for result in vector.results), vector
        return []
    return [float(result) for result in (results if isinstance(results, tuple) else [results])]


def _arrays(name: str, vectors: list[Vector]) -> list[np.ndarray]:
    """The arguments of all vectors of a function as its arrays, a row each."""
    own = [v for v in vectors if v.target.name == name]
    given = []
    for (_, elements), shape in zip(
        programs()[name].target.arrays, SHAPES[name][0].values(), strict=True
    ):
        # An array may have elements that the function does not need.
        names = [argument.name for argument in programs()[name].target.arguments]
        columns = [
            [v.arguments[names.index(e.name)] if e.name in names else 0.0 for v in own]
            for e in elements
        ]
        given.append(np.ascontiguousarray(np.transpose(columns)).reshape(len(own), *shape))
    return given


def numpy(vectors: list[Vector]) -> Results:
    """Call the functions of arrays, each once with all its vectors as rows.

    Of a row that is to be scaled first, by the guard, nothing is returned.
    """
    results = {}
    for name, program in programs().items():
        if name not in SHAPES or program.target.over_samples:
            continue
        given = _arrays(name, vectors)
        out = np.empty((len(given[0]), *SHAPES[name][1]))
        function = getattr(
            import_module(f"chr_notes.generated.arrays.{program.target.topic}"), name
        )
        with np.errstate(all="ignore"):
            flag, guard = function(*given, out)
        rows = out.reshape(len(out), -1)
        rows = (rows if flag is None else np.column_stack([rows, flag])).tolist()
        lengths = [1.0] * len(rows) if guard is None or program.valid is not None else guard
        kept = zip(rows, lengths, strict=True)
        results[name] = [row if 2.0**-380 < length < 2.0**380 else [] for row, length in kept]
    return _in_order(vectors, results)


def kernels(vectors: list[Vector]) -> Results:
    """Call the kernels; of a row that one leaves to the general way nothing is returned."""
    results = {}
    for name, program in programs().items():
        if name not in SHAPES or program.target.over_samples:
            continue
        given = _arrays(name, vectors)
        function = kernel(name)
        assert function is not None
        done = function(*given, None)
        out, left = done if isinstance(done, tuple) else (done, bytes(len(given[0])))
        flag = [0.0] * (program.flag is not None)
        rows = out.reshape(len(out), -1).tolist()
        results[name] = [[] if odd else row + flag for row, odd in zip(rows, left, strict=True)]
    return _in_order(vectors, results)


def _in_order(vectors: list[Vector], results: dict[str, Results]) -> Results:
    remaining = {name: iter(rows) for name, rows in results.items()}
    return [next(remaining.get(vector.target.name, iter([[]]))) for vector in vectors]


def node(file: Path, folder: Path) -> Results:
    """Call the JavaScript functions in Node."""
    module = (FOLDER / "javascript" / "attitude.mjs").as_uri()
    names = ", ".join(f"{name}: attitude.{camel(name)}" for name in programs())
    counts = ", ".join(f"{name}: {len(p.target.arguments)}" for name, p in programs().items())
    script = folder / "run.mjs"
    script.write_text(
        f"""\
import {{ readFileSync }} from "node:fs";
import * as attitude from "{module}";
const functions = {{ {names} }};
const counts = {{ {counts} }};
for (const line of readFileSync({str(file)!r}, "utf8").trim().split("\\n")) {{
  const [name, ...numbers] = line.split(" ");
  const results = functions[name](...numbers.slice(0, counts[name]).map(Number));
  console.log([results].flat().map(Number).join(" "));
}}
""",
        encoding="utf-8",
    )
    return _run(["node", str(script)])


def c(file: Path, folder: Path, kind: str) -> Results:
    """Compile the C functions with every warning an error, and call them.

    Parameters
    ----------
    file
        The vectors.
    folder
        For what is compiled.
    kind
        "double" or "float".
    """
    suffix = "" if kind == "double" else "_f"
    calls = "\n".join(_c_call(program, kind, suffix) for program in programs().values())
    main = folder / f"main_{kind}.c"
    main.write_text(
        f"""\
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "attitude.h"

int main(int count, char **names)
{{
    static char line[8192];
    FILE *file = count == 2 ? fopen(names[1], "r") : NULL;
    if (!file) return 1;
    while (fgets(line, sizeof line, file)) {{
        {kind} in[64];
        {kind} out[16] = {{0}};
        char *end = strchr(line, ' ');
        *end = 0;
        for (int i = 0; i < 64; i++) {{
            in[i] = ({kind})strtod(end + 1, &end);
            end -= *end == 0;
        }}
{calls}
    }}
    return 0;
}}
""",
        encoding="utf-8",
    )
    source = FOLDER / "c"
    program = folder / f"run_{kind}"
    command = [*GCC, f"-I{source}", str(main), str(source / "attitude.c"), "-o", str(program)]
    subprocess.run([*command, "-lm"], check=True)
    return _run([str(program), str(file)])


def _c_call(program: Program, kind: str, suffix: str) -> str:
    target = program.target
    name = f"attitude_{target.name}{suffix}"
    given = ", ".join(f"in[{place}]" for place in range(len(target.arguments)))
    size = len(program.results)
    if not program.shape:
        call = f"out[0] = {name}({given});"
    elif program.flag is not None:
        call = f"out[{size}] = ({kind}){name}({given}, out);"
        size += 1
    else:
        call = f"{name}({given}, out);"
    return (
        f'        if (!strcmp(line, "{target.name}")) {{ {call} for (int i = 0; i < {size}; i++) '
        f'printf("%.17g ", (double)out[i]); puts(""); }}'
    )


def _run(command: list[str]) -> Results:
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return [[float(word) for word in line.split()] for line in done.stdout.splitlines()]


Runner = Callable[[list[Vector]], Results]
