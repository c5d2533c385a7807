"""A minute of tumbling through the observer of each language: one attitude, sample by sample."""

import ctypes
import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from chr_notes import (
    euler_from_quaternion,
    integrate_gyro,
    matrix_from_euler,
    observe_sample,
    quaternion_from_euler,
    rotate_to_body,
)
from chr_notes._recordings import run
from chr_notes.codegen.__main__ import FOLDER
from chr_notes.generated.scalar.estimation import averaging_heading_turn, observer_step

from .languages import GCC

Floats = NDArray[np.float64]
COUNT, PERIOD, GAIN = 6000, 0.01, 0.02
START = (0.0, np.pi / 2, 0.0)  # at gimbal lock


@pytest.fixture(scope="module")
def samples() -> Floats:
    """Rates of 300 °/s about an axis that wanders, and forces; some are none."""
    generator = np.random.default_rng(0)
    time = PERIOD * np.arange(COUNT)[:, np.newaxis]
    axis = np.cos(time * [0.7, 0.5, 0.3] + [0.0, 1.0, 2.0])
    rates = np.radians(300.0) * axis / np.linalg.norm(axis, axis=1, keepdims=True)
    euler = np.array(START)
    forces = np.empty((COUNT, 3))
    for sample, rate in enumerate(rates):
        euler = observe_sample(euler, rate, [0.0, 0.0, 0.0], PERIOD, 0.0)
        forces[sample] = rotate_to_body(quaternion_from_euler(euler), [0.0, 0.0, -9.8])
    forces += generator.normal(0, 1.0, forces.shape)
    rates[::97, 1], forces[::89, 2], forces[::83] = np.nan, np.inf, 0.0
    rates[1000], forces[1000:1010] = np.nan, np.nan
    return np.hstack([rates, forces])


@pytest.fixture(scope="module")
def by_python(samples: Floats) -> Floats:
    state, found = np.array(START), []
    for sample in samples:
        state = observe_sample(state, sample[:3], sample[3:], PERIOD, GAIN)
        found.append(state)
    return np.array(found)


def worst_apart(first: Floats, second: Floats) -> float:
    """The largest angle between attitudes, degrees."""
    one, other = quaternion_from_euler(first), quaternion_from_euler(second)
    signs = np.where(np.sum(one * other, axis=1, keepdims=True) < 0, -1.0, 1.0)
    return float(np.degrees(2 * np.linalg.norm(one - signs * other, axis=1).max()))


def test_the_generated_step_in_python(samples: Floats, by_python: Floats) -> None:
    state, found = START, []
    for sample in samples.tolist():
        state = observer_step(*state, *sample, PERIOD, GAIN)
        found.append(state)
    assert worst_apart(np.array(found), by_python) < 1e-9


@pytest.fixture(scope="module")
def library(program: Callable[[str], str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("tumbling") / "attitude.so"
    source = str(FOLDER / "c" / "attitude.c")
    command = [program("gcc"), *GCC[1:], "-shared", "-fPIC", source, "-o", str(path), "-lm"]
    subprocess.run(command, check=True)
    return path


# In single precision each step is off in its last digits, which nothing brings back in yaw.
@pytest.mark.parametrize(("suffix", "bound"), [("", 1e-9), ("_f", 0.005)])
def test_exported_c(
    suffix: str, bound: float, samples: Floats, by_python: Floats, library: Path
) -> None:
    number = ctypes.c_float if suffix else ctypes.c_double
    step = getattr(ctypes.CDLL(str(library)), f"attitude_observer_step{suffix}")
    step.argtypes = [number] * 11 + [ctypes.POINTER(number)]
    step.restype = None
    state, found = (number * 3)(*START), []
    for sample in samples.tolist():
        step(*state, *sample, PERIOD, GAIN, state)
        found.append([*state])
    assert worst_apart(np.array(found), by_python) < bound


def by_node(  # noqa: PLR0913, PLR0917 (a step, what it takes, and how to run it)
    step: str,
    start: tuple[float, ...],
    samples: Floats,
    constants: tuple[float, ...],
    folder: Path,
    program: Callable[[str], str],
) -> Floats:
    """Run a step of the exported module over samples."""
    module = (FOLDER / "javascript" / "attitude.mjs").as_uri()
    given = [[str(number) for number in sample] for sample in samples.tolist()]
    (folder / "samples.json").write_text(json.dumps(given), encoding="utf-8")
    (folder / "run.mjs").write_text(
        f"""\
import {{ readFileSync }} from "node:fs";
import {{ {step} }} from "{module}";
const number = (text) => text === "nan" ? NaN : text === "inf" ? Infinity : Number(text);
let state = {json.dumps(start)};
const found = JSON.parse(readFileSync("samples.json")).map(
  (sample) => (state = {step}(...state, ...sample.map(number), ...{json.dumps(constants)})),
);
console.log(JSON.stringify(found));
""",
        encoding="utf-8",
    )
    done = subprocess.run(
        [program("node"), "run.mjs"], cwd=folder, check=True, capture_output=True, text=True
    )
    return np.array(json.loads(done.stdout))


def test_exported_javascript(
    samples: Floats, by_python: Floats, tmp_path: Path, program: Callable[[str], str]
) -> None:
    found = by_node("observerStep", START, samples, (PERIOD, GAIN), tmp_path, program)
    assert worst_apart(found, by_python) < 1e-9


# Time constant, longest step, heading's time constant, reference, tolerance and patience.
# The tolerance lies between what noise and what iron do, so that no rounding decides.
CONSTANTS = (0.5, 0.15, 1.0, 1.0, 0.0, 0.3, 60.0)
AVERAGING = (np.sqrt(0.5), 0.0, np.sqrt(0.5), 0.0, *[0.0] * 10)


@pytest.fixture(scope="module")
def with_field(samples: Floats) -> Floats:
    """The same minute with a magnetometer, whose field is disturbed at times, and a step each."""
    truth = integrate_gyro(np.nan_to_num(samples[:, :3]), PERIOD, START)
    field = matrix_from_euler(truth) @ [20.0, 0.0, 45.0]
    field[2000:2500] += [40.0, 0.0, 0.0]
    field[::71, 0], field[::73] = np.nan, 0.0
    steps = np.full((COUNT, 1), PERIOD)
    steps[::1500] = 0.7
    steps[1] = 1.5 * PERIOD  # so that no rounding decides when a time is reached
    return np.hstack([samples, field, steps])


@pytest.fixture(scope="module")
def averaged_by_python(with_field: Floats) -> Floats:
    """By the generated step of floats."""
    state, found = AVERAGING, []
    for sample in with_field.tolist():
        state = averaging_heading_turn(*state, *sample, *CONSTANTS)
        found.append(state)
    return np.array(found)


def test_averaging_by_kernels(with_field: Floats, averaged_by_python: Floats) -> None:
    inputs = (with_field[:, :3], with_field[:, 3:6], with_field[:, 6:9], with_field[:, 9])
    found = run(averaging_heading_turn, AVERAGING, *inputs, *map(np.array, CONSTANTS))
    assert np.isfinite(found).all()
    assert_allclose(found, averaged_by_python, atol=1e-8)


def worst_turn(first: Floats, second: Floats) -> float:
    """The largest angle between the attitudes of states, degrees."""
    both = (first[:, :4], second[:, :4])
    return worst_apart(*(euler_from_quaternion(q, on_gimbal_lock="ignore") for q in both))


@pytest.mark.parametrize(("suffix", "bound"), [("", 1e-7), ("_f", 0.05)])
def test_averaging_in_exported_c(
    suffix: str, bound: float, with_field: Floats, averaged_by_python: Floats, library: Path
) -> None:
    number = ctypes.c_float if suffix else ctypes.c_double
    step = getattr(ctypes.CDLL(str(library)), f"attitude_averaging_heading_turn{suffix}")
    step.argtypes = [number] * 31 + [ctypes.POINTER(number)]
    step.restype = None
    state, found = (number * 14)(*AVERAGING), []
    for sample in with_field.tolist():
        step(*state, *sample, *CONSTANTS, state)
        found.append([*state])
    assert worst_turn(np.array(found), averaged_by_python) < bound


def test_averaging_in_exported_javascript(
    with_field: Floats, averaged_by_python: Floats, tmp_path: Path, program: Callable[[str], str]
) -> None:
    found = by_node("averagingHeadingTurn", AVERAGING, with_field, CONSTANTS, tmp_path, program)
    assert worst_turn(found, averaged_by_python) < 1e-7
