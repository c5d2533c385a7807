"""A minute of tumbling through the observer of each language: one attitude, sample by sample."""

import ctypes
import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from chr_notes import observe_sample, quaternion_from_euler, rotate_to_body
from chr_notes.codegen.__main__ import FOLDER
from chr_notes.generated.scalar.estimation import observer_step

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


def test_exported_javascript(
    samples: Floats, by_python: Floats, tmp_path: Path, program: Callable[[str], str]
) -> None:
    module = (FOLDER / "javascript" / "attitude.mjs").as_uri()
    given = [[str(number) for number in sample] for sample in samples.tolist()]
    (tmp_path / "samples.json").write_text(json.dumps(given), encoding="utf-8")
    (tmp_path / "run.mjs").write_text(
        f"""\
import {{ readFileSync }} from "node:fs";
import {{ observerStep }} from "{module}";
const number = (text) => text === "nan" ? NaN : text === "inf" ? Infinity : Number(text);
let state = {json.dumps(START)};
const found = JSON.parse(readFileSync("samples.json")).map(
  (sample) => (state = observerStep(...state, ...sample.map(number), {PERIOD}, {GAIN})),
);
console.log(JSON.stringify(found));
""",
        encoding="utf-8",
    )
    done = subprocess.run(
        [program("node"), "run.mjs"], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    assert worst_apart(np.array(json.loads(done.stdout)), by_python) < 1e-9
