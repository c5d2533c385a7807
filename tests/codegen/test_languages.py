"""Python, NumPy, JavaScript and C give what mpmath gives, for ordinary and for special values."""

import math
import platform
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.export import export

from . import languages
from .reference import DOUBLE, SINGLE
from .vectors import Vector, vectors, write

# Units in the last place of the largest number that belongs to the result, see `scale`.
ULPS = 4.0
# Results that are angles, whose equality is that of directions: -pi and pi are one. They are not
# for `wrap_angle`, which tells one from the other.
ANGLES = {
    "euler_from_matrix": 3,
    "euler_from_quaternion": 3,
    "angles_from_matrix": 3,
    "angles_from_quaternion": 3,
    "tilt_from_accelerometer": 2,
    "heading_from_magnetometer": 1,
    "gyro_step": 3,
    "observer_step": 3,
    "euler_observer_step": 3,
}


OF_MATRICES = ("angles_from_matrix", "euler_from_matrix", "quaternion_from_matrix")


@pytest.fixture(scope="module")
def double() -> list[Vector]:
    return vectors(DOUBLE)


@pytest.fixture(scope="module")
def file(double: list[Vector], tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("vectors") / "double.txt"
    write(path, double)
    return path


def scale(vector: Vector, epsilon: float) -> float:
    """The largest number of the result, and of the sums that it comes from.

    Results of attitudes are rotations or angles, whose elements are known to the precision of the
    largest. The other functions add up their arguments.
    """
    target = vector.target
    attitudes = target.topic in ("euler", "quaternions", "sequences")
    adds = not attitudes or target.name == "quaternion_rates"
    sums = vector.arguments if adds else ()
    numbers = [abs(float(number)) for number in (*vector.results, *sums)]
    largest = max((number for number in numbers if math.isfinite(number)), default=1.0)
    if target.name == "observer_step":
        # Roll and yaw are turned apart near the pole, by how near it is.
        largest /= max(abs(math.cos(vector.results[1])), epsilon)
    if target.name in ("averaging_turn", "averaging_heading_turn", "observer_heading_turn"):
        # They take the quaternion for a unit one, and turn by it what they add up.
        largest *= max(1.0, sum(number**2 for number in vector.arguments[:4]))
    return largest


def ulps_off(vector: Vector, got: list[float], epsilon: float) -> float:
    """How far a result is off; infinity where one is NaN or infinite and the other is not."""
    unit = epsilon * max(scale(vector, epsilon), 1e-300)
    worst = 0.0
    for place, (number, expected) in enumerate(zip(got, vector.results, strict=True)):
        if not math.isfinite(number) or not math.isfinite(expected):
            same = number == expected or (math.isnan(number) and math.isnan(expected))
            worst = max(worst, 0.0 if same else math.inf)
            continue
        off = abs(float(number - expected))
        if place < ANGLES.get(vector.target.name, 0):
            off = min(off, abs(off - 2 * math.pi))
        worst = max(worst, off / unit)
    return worst


def check(made: list[Vector], results: languages.Results, epsilon: float) -> None:
    assert len(results) == len(made)
    wrong = [
        (round(ulps, 1), vector.target.name, vector.arguments, got, [*map(float, vector.results)])
        for vector, got in zip(made, results, strict=True)
        if got and (ulps := ulps_off(vector, got, epsilon)) > ULPS
    ]
    assert not wrong, "\n".join(map(str, wrong[:20]))


def test_python(double: list[Vector]) -> None:
    results = languages.python(double)
    check(double, results, DOUBLE.epsilon)
    refused = [vector for vector, got in zip(double, results, strict=True) if not got]
    # `math` raises where infinity has no sine, and Python where a divisor is zero.
    for vector in refused:
        assert any(math.isinf(a) or a == 0 for a in vector.arguments), vector


@pytest.mark.parametrize(
    "language", [languages.numpy, pytest.param(languages.kernels, marks=pytest.mark.kernels)]
)
def test_functions_of_arrays(
    double: list[Vector], language: Callable[[list[Vector]], languages.Results]
) -> None:
    results = language(double)
    check(double, results, DOUBLE.epsilon)
    by_name: dict[str, list[bool]] = {}
    for vector, got in zip(double, results, strict=True):
        if vector.target.arrays and not vector.target.over_samples:
            by_name.setdefault(vector.target.name, []).append(bool(got))
    # Ordinary values are not left to the general way, but for matrices, which are no rotations.
    for name, computed in by_name.items():
        assert all(computed[:12]) or name in OF_MATRICES, name


def test_javascript(
    program: Callable[[str], str], double: list[Vector], file: Path, tmp_path: Path
) -> None:
    program("node")
    check(double, languages.node(file, tmp_path), DOUBLE.epsilon)


def test_c_in_double_precision(
    program: Callable[[str], str], double: list[Vector], file: Path, tmp_path: Path
) -> None:
    program("gcc")
    check(double, languages.c(file, tmp_path, "double"), DOUBLE.epsilon)


@pytest.mark.slow
def test_c_in_single_precision(program: Callable[[str], str], tmp_path: Path) -> None:
    program("gcc")
    single = vectors(SINGLE)
    write(tmp_path / "single.txt", single)
    check(single, languages.c(tmp_path / "single.txt", tmp_path, "float"), SINGLE.epsilon)


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_c_is_not_contracted_whatever_the_flags(
    compiler: str, program: Callable[[str], str], tmp_path: Path
) -> None:
    _, source, *_ = export("c", tmp_path)
    fused = [] if platform.machine() == "aarch64" else ["-mfma"]
    command = [program(compiler), "-O2", *fused, "-S", "-o", "-", str(source)]

    def count(*more: str) -> int:
        told = subprocess.run([*command, *more], capture_output=True, text=True, check=True).stdout
        return len(re.findall(r"\bv?fn?m(?:add|sub)", told))

    # Of alternate products GCC makes some against its own flag.
    assert count() <= count("-ffp-contract=off") < 20
