"""Times of the filters over a million samples; no file of the default run.

Run together with `bench_attitudes.py`, so that one stored run holds all times.
"""

from collections.abc import Callable
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from vqf import VQF, BasicVQF

from chr_notes import (
    _recordings,
    averaging_observer,
    fixed_gain_observer,
    integrate_gyro,
    matrix_from_euler,
)
from chr_notes.sensors.simulated import SensorErrors, add_errors
from chr_notes.simulation import at_rest, ideal_readings, swing, trajectory

Floats = NDArray[np.float64]
SIZE, PERIOD, GAIN = 1_000_000, 0.01, 0.02
OURS, PLAIN, PEER = "chr_notes", "chr_notes without kernels", "VQF, in C++"


class Recording(NamedTuple):
    """What two sensors read, and the true direction down in the body frame."""

    rates: Floats
    forces: Floats
    down: Floats


@cache
def recording() -> Recording:
    """Simulate a body that swings, with cheap sensors."""
    time = PERIOD * np.arange(SIZE)
    truth = trajectory(time, swing(time, [0.5, 0.4, 1.0], [0.2, 0.13, 0.05]), at_rest(time))
    ideal = ideal_readings(truth)
    return Recording(
        add_errors(ideal.body_rates, time, SensorErrors(bias=0.001, noise_density=1e-4), seed=1),
        add_errors(ideal.accel, time, SensorErrors(noise_density=2e-3), seed=2),
        matrix_from_euler(truth.euler)[..., 2],
    )


def down_from_euler(euler: Floats) -> Floats:
    """Tell the direction down in the body frame."""
    return np.asarray(matrix_from_euler(euler)[..., 2])


def down_from_vqf(result: dict[str, Floats]) -> Floats:
    """Tell the same of VQF, whose inertial frame has its z-axis up."""
    w, x, y, z = result["quat6D"].T
    return -np.stack(
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z], axis=1
    )


class Case(NamedTuple):
    """What is timed, and how to tell the direction down of its result."""

    task: str
    library: str
    run: Callable[[Recording], Any]
    down: Callable[[Any], Floats] = down_from_euler


def observe(given: Recording) -> Floats:
    """Run our observer."""
    return fixed_gain_observer(given.rates, given.forces, PERIOD, GAIN)


def integrate(given: Recording) -> Floats:
    """Integrate the gyros alone."""
    return integrate_gyro(given.rates, PERIOD)


def vqf(given: Recording) -> dict[str, Floats]:
    """Run the filter of another library, which corrects by the accelerometer too."""
    return BasicVQF(PERIOD).updateBatch(given.rates, given.forces)


def average(given: Recording) -> Floats:
    """Run our averaging filter, which looks for the bias too."""
    return averaging_observer(given.rates, given.forces, PERIOD, bias="running")


def whole_vqf(given: Recording) -> dict[str, Floats]:
    """Run the filter after which it is made, which estimates the bias too."""
    return VQF(PERIOD).updateBatch(given.rates, given.forces)


OBSERVER, GYROS = "samples through an observer", "samples of gyros integrated"
AVERAGING = "samples averaged, with the bias"
CASES = [
    Case(OBSERVER, OURS, observe),
    Case(OBSERVER, PLAIN, observe),
    Case(OBSERVER, PEER, vqf, down_from_vqf),
    Case(AVERAGING, OURS, average),
    Case(AVERAGING, PLAIN, average),
    Case(AVERAGING, PEER, whole_vqf, down_from_vqf),
    Case(GYROS, OURS, integrate),
    Case(GYROS, PLAIN, integrate),
]


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.task}-{case.library}")
def test_speed(benchmark: Any, monkeypatch: pytest.MonkeyPatch, case: Case) -> None:  # noqa: ANN401 (pytest-benchmark has no types)
    given = recording()
    if case.library == PLAIN:
        monkeypatch.setattr(_recordings, "kernel", lambda _: None)
    down = case.down(case.run(given))
    off = np.degrees(np.arccos(np.clip(np.sum(down * given.down, axis=1), -1, 1)))
    # Gyros alone drift off, and are right at first.
    assert np.sqrt(np.mean(off[: 1000 if case.task == GYROS else SIZE] ** 2)) < 2
    benchmark.extra_info.update(size=SIZE, task=case.task, library=case.library)
    benchmark(partial(case.run, given))
