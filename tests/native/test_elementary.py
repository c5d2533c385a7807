"""The project's own sine, cosine and arctangent: their numbers, and their errors."""

import ctypes
import importlib.util
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import mpmath
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
HEADER = ROOT / "chr_notes" / "native" / "elementary.h"
FLAGS = ("-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC")
SOURCE = f"""\
#include "{HEADER}"
double sine(double x) {{ return column_sin(x); }}
double cosine(double x) {{ return column_cos(x); }}
double angle(double y, double x) {{ return column_atan2(y, x); }}
double any_sine(double x) {{ return step_sin(x); }}
double any_cosine(double x) {{ return step_cos(x); }}
double any_angle(double y, double x) {{ return step_atan2(y, x); }}
double root_cosine(double f, double y) {{ return step_cos_of_root(f, y); }}
double root_sine(double f, double y) {{ return step_sinc_of_root(f, y); }}
double share_cosine(double s, double y, double x, double both)
{{ return step_cos_of_share(s, y, x, both); }}
double share_sine(double s, double y, double x, double both)
{{ return step_sin_of_share(s, y, x, both); }}
"""
MP = mpmath.mp.clone()
MP.prec = 200


@pytest.fixture(scope="module")
def functions(
    program: Callable[[str], str], tmp_path_factory: pytest.TempPathFactory
) -> dict[str, Callable[..., float]]:
    folder = tmp_path_factory.mktemp("elementary")
    (folder / "functions.c").write_text(SOURCE, encoding="utf-8")
    library = folder / "functions.so"
    command = [program("gcc"), *FLAGS, str(folder / "functions.c"), "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    loaded = ctypes.CDLL(str(library))
    found = {}
    for name, arguments in re.findall(r"^double (\w+)\((.*?)\)", SOURCE, re.MULTILINE):
        function = getattr(loaded, name)
        function.restype = ctypes.c_double
        function.argtypes = [ctypes.c_double] * arguments.count("double")
        found[name] = function
    return found


@pytest.fixture(scope="module")
def minimax() -> ModuleType:
    spec = importlib.util.spec_from_file_location("minimax", ROOT / "tools" / "minimax.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    # A dataclass looks its module up.
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(__import__("sys").modules, "minimax", module)
        spec.loader.exec_module(module)
    return module


def ulps_off(found: float, exact: mpmath.mpf) -> float:
    return float(abs(MP.mpf(found) - exact) / MP.mpf(np.spacing(abs(float(exact)))))


def angles(largest: float) -> list[float]:
    generator = np.random.default_rng(0)
    quarters = np.round(generator.uniform(-largest, largest, 300) / (np.pi / 2))
    near = quarters * np.pi / 2  # where one of the two is nearly zero
    tiny = 10.0 ** generator.uniform(-300, 0, 100)
    return [*generator.uniform(-largest, largest, 1500), *near[abs(near) < largest], *tiny]


@pytest.mark.parametrize(("largest", "bound"), [(4.0, 1.3), (1e5, 2.0), (1e6, 2.0)])
def test_sine_and_cosine(
    functions: dict[str, Callable[..., float]], largest: float, bound: float
) -> None:
    for x in map(float, angles(largest)):
        assert ulps_off(functions["sine"](x), MP.sin(MP.mpf(x))) < bound, x
        assert ulps_off(functions["cosine"](x), MP.cos(MP.mpf(x))) < bound, x


def test_arctangent(functions: dict[str, Callable[..., float]]) -> None:
    generator = np.random.default_rng(1)
    pairs = generator.normal(size=(2000, 2)) * 10.0 ** generator.uniform(-8, 8, (2000, 2))
    for y, x in pairs.tolist():
        assert ulps_off(functions["angle"](y, x), MP.atan2(MP.mpf(y), MP.mpf(x))) < 1.8, (y, x)


@pytest.mark.parametrize("factor", [0.5, 1e-3])
def test_a_factor_of_a_root(functions: dict[str, Callable[..., float]], factor: float) -> None:
    generator = np.random.default_rng(3)
    ends = np.array([2**-5.5, np.pi / 4])  # of each of the two series
    few = [angle for end in ends for angle in generator.uniform(0, end, 300)]
    for angle in [*few, *ends, *1.001 * ends, 1e-9, 1e-150]:
        square = float((angle / factor) ** 2)
        part = MP.mpf(factor) * MP.sqrt(MP.mpf(square))
        assert ulps_off(functions["root_cosine"](factor, square), MP.cos(part)) < 2, angle
        found, exact = functions["root_sine"](factor, square), MP.sin(part) / part
        assert ulps_off(found, exact) < 4, angle
    assert functions["root_sine"](factor, 0.0) == 1.0


@pytest.mark.parametrize("share", [0.0, 1e-9, 0.01, 0.25, 0.5])
def test_a_share_of_an_angle(functions: dict[str, Callable[..., float]], share: float) -> None:
    generator = np.random.default_rng(2)
    ends = np.arcsin([2**-6.5, 2**-3])  # of each of the two series
    few = [angle for end in ends for angle in generator.uniform(0, end, 300)]
    all_of_them = [*few, *generator.uniform(0, np.pi, 100), *ends, *1.001 * ends, 1e-9, 1e-160]
    for angle in all_of_them:
        square, x = float(np.sin(angle) ** 2), float(np.cos(angle))
        given = share, square, x, square + x * x
        root = MP.sqrt(MP.mpf(square))
        part = MP.mpf(share) * MP.atan2(root, MP.mpf(x))
        assert ulps_off(functions["share_cosine"](*given), MP.cos(part)) < 1.6, angle
        sine = MP.sin(part) / root if square else 0
        assert ulps_off(functions["share_sine"](*given), MP.mpf(sine)) < 4, angle


@pytest.mark.parametrize("y", [0.0, -0.0, 1.0, -1.0])
@pytest.mark.parametrize("x", [0.0, -0.0, 1.0, -1.0])
def test_the_corners_of_the_arctangent(
    functions: dict[str, Callable[..., float]], y: float, x: float
) -> None:
    found = functions["angle"](y, x)
    assert found == np.arctan2(y, x)
    assert np.signbit(found) == np.signbit(np.arctan2(y, x))


@pytest.mark.parametrize("x", [1e6, -1e12, 1e300, np.inf, -np.inf, np.nan])
def test_beyond_its_range_a_step_takes_the_library(
    functions: dict[str, Callable[..., float]], x: float
) -> None:
    with np.errstate(invalid="ignore"):
        np.testing.assert_allclose(functions["any_sine"](x), np.sin(x), rtol=1e-15)
        np.testing.assert_allclose(functions["any_cosine"](x), np.cos(x), rtol=1e-15)
    for y in (0.0, 1.0, np.inf, np.nan):
        np.testing.assert_allclose(functions["any_angle"](y, x), np.arctan2(y, x), rtol=1e-15)


@pytest.mark.slow
def test_the_numbers_are_those_that_are_derived(minimax: ModuleType) -> None:
    text = HEADER.read_text(encoding="utf-8")
    for wanted in minimax.WANTED:
        body = text.split(f"{wanted.name}(")[1].split("\n}")[0]
        numbers = [float.fromhex(n) for n in re.findall(r"-?0x[\d.a-f]+p[+-]\d+", body)]
        derived = minimax.remez(wanted)
        start = numbers.index(derived[0])
        assert numbers[start : start + wanted.terms] == derived
    halves = [float.fromhex(n) for n in re.findall(r"HALF_PI_\d (0x\S+)", text)]
    assert halves == minimax.parts_of_half_pi()
