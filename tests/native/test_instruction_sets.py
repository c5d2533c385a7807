"""Kernels built for one instruction set or another give the same bits."""

import ctypes
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from chr_notes.generated.arrays.shapes import SHAPES

ROOT = Path(__file__).resolve().parents[2]
FLAGS = (
    *("-std=c99", "-O3", "-fvect-cost-model=dynamic"),
    *("-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-shared", "-fPIC"),
)
LEVELS = ("x86-64", "x86-64-v3", "x86-64-v4")
SOURCE = f"""\
#include "{ROOT}/chr_notes/generated/c/kernels.c"
const char *name(int place) {{ return KERNELS[place].name; }}
int64_t run(int place, ptrdiff_t rows, const double **in, const ptrdiff_t *step, double *out,
    unsigned char *odd)
{{
    return KERNELS[place].run(rows, in, step, out, odd);
}}
int supported(void)
{{
#if defined(__AVX512F__)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl");
#elif defined(__AVX2__)
    return __builtin_cpu_supports("avx2");
#else
    return 1;
#endif
}}
"""
ROWS = 1000 + 13  # no whole number of blocks


@pytest.fixture(scope="module")
def built(
    program: Callable[[str], str], tmp_path_factory: pytest.TempPathFactory
) -> list[ctypes.CDLL]:
    folder = tmp_path_factory.mktemp("kernels")
    (folder / "kernels.c").write_text(SOURCE, encoding="utf-8")
    libraries = []
    for level in LEVELS:
        path = folder / f"{level}.so"
        flags = (*FLAGS, f"-march={level}", "-DONE_INSTRUCTION_SET")
        command = [program("gcc"), *flags, str(folder / "kernels.c"), "-o", str(path), "-lm"]
        subprocess.run(command, check=True)
        library = ctypes.CDLL(str(path))
        library.name.restype = ctypes.c_char_p
        if library.supported():
            libraries.append(library)
    return libraries


@pytest.mark.slow
def test_bits_are_the_same(built: list[ctypes.CDLL]) -> None:
    assert len(built) > 1, "this processor has one instruction set alone"
    generator = np.random.default_rng(0)
    for place, name in enumerate(SHAPES):
        assert built[0].name(place).decode() == name
        arrays, result = SHAPES[name]
        given = [generator.normal(size=(ROWS, *shape)) for shape in arrays.values()]
        for array in given:
            array[::97] *= 1e7  # some that are left
        pointers = (ctypes.c_void_p * len(given))(*(a.ctypes.data for a in given))
        steps = (ctypes.c_ssize_t * len(given))(*(a[0].size for a in given))
        found = []
        for library in built:
            out, odd = np.empty((ROWS, *result)), np.zeros(ROWS, dtype=np.uint8)
            to = (ctypes.c_void_p(out.ctypes.data), ctypes.c_void_p(odd.ctypes.data))
            library.run(place, ctypes.c_ssize_t(ROWS), pointers, steps, *to)
            out[np.isnan(out)] = np.nan  # the sign of what is no number is left to the processor
            found.append((out.tobytes(), odd.tobytes()))
        assert all(each == found[0] for each in found[1:]), name
