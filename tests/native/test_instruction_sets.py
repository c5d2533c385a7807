"""Kernels built for one instruction set or another give the bits of the kernels that run.

Those chose the best set of this processor. The plainest is built here, without optimisation for
the sake of time, which must not change a bit either; with `--full` each one as the package does.
"""

import ctypes
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from chr_notes._kernels import kernel
from chr_notes.generated.arrays.shapes import SHAPES

ROOT = Path(__file__).resolve().parents[2]
FLAGS = (
    *("-std=c99", "-ftree-vectorize", "-fvect-cost-model=dynamic"),
    *("-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-shared", "-fPIC"),
)
LEVELS = {"x86-64": "-O0"}
ALL_LEVELS = {"x86-64": "-O3", "x86-64-v3": "-O3", "x86-64-v4": "-O3"}
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
    program: Callable[[str], str],
    tmp_path_factory: pytest.TempPathFactory,
    pytestconfig: pytest.Config,
) -> list[ctypes.CDLL]:
    folder = tmp_path_factory.mktemp("kernels")
    (folder / "kernels.c").write_text(SOURCE, encoding="utf-8")
    libraries = []
    for level, optimised in (ALL_LEVELS if pytestconfig.getoption("full") else LEVELS).items():
        path = folder / f"{level}.so"
        flags = (*FLAGS, optimised, f"-march={level}", "-DONE_INSTRUCTION_SET")
        command = [program("gcc"), *flags, str(folder / "kernels.c"), "-o", str(path), "-lm"]
        subprocess.run(command, check=True)
        library = ctypes.CDLL(str(path))
        library.name.restype = ctypes.c_char_p
        if library.supported():
            libraries.append(library)
    return libraries


@pytest.mark.slow
@pytest.mark.kernels
def test_bits_are_the_same(built: list[ctypes.CDLL]) -> None:
    assert built
    generator = np.random.default_rng(0)
    for place, name in enumerate(SHAPES):
        assert built[0].name(place).decode() == name
        arrays, result = SHAPES[name]
        given = [generator.normal(size=(ROWS, *shape)) for shape in arrays.values()]
        for array in given:
            array[::97] *= 1e7  # some that are left
        pointers = (ctypes.c_void_p * len(given))(*(a.ctypes.data for a in given))
        steps = (ctypes.c_ssize_t * len(given))(*(a[0].size for a in given))
        running = kernel(name)
        assert running is not None
        done = running(*given, None)
        expected = bits(*(done if isinstance(done, tuple) else (done, bytes(ROWS))))
        for library in built:
            out, odd = np.empty((ROWS, *result)), np.zeros(ROWS, dtype=np.uint8)
            to = (ctypes.c_void_p(out.ctypes.data), ctypes.c_void_p(odd.ctypes.data))
            library.run(place, ctypes.c_ssize_t(ROWS), pointers, steps, *to)
            assert bits(out, odd) == expected, name


def bits(out: NDArray[np.float64], odd: bytes | NDArray[np.uint8]) -> tuple[bytes, bytes]:
    """What a kernel gives; of a row that is left, only that it is."""
    left = np.frombuffer(odd, dtype=np.uint8)
    rows = out.reshape(ROWS, -1).copy()
    rows[np.isnan(rows)] = np.nan  # the sign of what is no number is left to the processor
    return rows.tobytes(), left.tobytes()
