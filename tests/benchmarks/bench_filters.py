"""Times of the filters, over a million samples and on a stream; no file of the default run.

Run together with `bench_attitudes.py`, so that one stored run holds all times.
"""

import warnings
from collections.abc import Callable
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from vqf import VQF, BasicVQF

from chr_notes import (
    Monitor,
    _recordings,
    averaging_observer,
    fixed_gain_observer,
    integrate_gyro,
    matrix_from_euler,
    monitored_observer,
    observe,
    observe_averaging,
)
from chr_notes.sensors.simulated import SensorErrors, add_errors
from chr_notes.simulation import at_rest, ideal_readings, swing, trajectory

Floats = NDArray[np.float64]
SIZE, STREAMED, PERIOD, GAIN = 1_000_000, 5_000, 0.01, 0.02
FIELD = np.array([20.0, 0.0, 45.0])
OURS, PLAIN, PEER = "chr_notes", "chr_notes without kernels", "VQF, in C++"


class Recording(NamedTuple):
    """What sensors read, and the true direction down in the body frame."""

    rates: Floats
    forces: Floats
    field: Floats
    down: Floats

    @property
    def stream(self) -> list[tuple[Floats, Floats, float]]:
        """The first samples, as they come."""
        both = zip(self.rates[:STREAMED], self.forces[:STREAMED], strict=True)
        return [(rates.copy(), force.copy(), PERIOD) for rates, force in both]


@cache
def recording() -> Recording:
    """Simulate a body that swings, with cheap sensors."""
    time = PERIOD * np.arange(SIZE)
    truth = trajectory(time, swing(time, [0.5, 0.4, 1.0], [0.2, 0.13, 0.05]), at_rest(time))
    ideal = ideal_readings(truth, FIELD)
    return Recording(
        add_errors(ideal.body_rates, time, SensorErrors(bias=0.001, noise_density=1e-4), seed=1),
        add_errors(ideal.accel, time, SensorErrors(noise_density=2e-3), seed=2),
        add_errors(ideal.mag, time, SensorErrors(noise_density=0.05), seed=3),
        matrix_from_euler(truth.euler)[..., 2],
    )


def down_from_euler(euler: Floats | list[Floats]) -> Floats:
    """Tell the direction down in the body frame."""
    return np.asarray(matrix_from_euler(euler)[..., 2])


def down_from_vqf(result: dict[str, Floats | list[Floats]]) -> Floats:
    """Tell the same of VQF, whose inertial frame has its z-axis up."""
    w, x, y, z = np.asarray(result["quat6D"]).T
    return -np.stack(
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z], axis=1
    )


class Case(NamedTuple):
    """What is timed, and how to tell the direction down of its result."""

    task: str
    library: str
    run: Callable[[Any], Any]
    down: Callable[[Any], Floats] = down_from_euler


def of_stream(filtered: Callable[..., Any]) -> Callable[[Any], list[Floats]]:
    """Take the angles of each sample."""
    return lambda stream: [each.euler for each in filtered(stream)]


def vqf_of_stream(kind: type[Any]) -> Callable[[Any], dict[str, list[Floats]]]:
    """Give each sample to the other library, and ask it for the attitude."""

    def run(stream: list[tuple[Floats, Floats, float]]) -> dict[str, list[Floats]]:
        found = kind(PERIOD)
        kept = []
        for rates, force, _ in stream:
            found.update(rates, force)
            kept.append(found.getQuat6D())
        return {"quat6D": kept}

    return run


def monitored(given: Recording) -> Floats:
    """Run our observer with a monitor of E."""
    down = float(FIELD[2] / np.linalg.norm(FIELD))
    arrays = (given.rates, given.forces, given.field)
    watch = Monitor(threshold=0.1, patience=20)
    return monitored_observer(*arrays, PERIOD, reference_down=down, monitor=watch).euler


def averaged(bias: Any) -> Callable[[Recording], Floats]:  # noqa: ANN401 (a word or numbers)
    """Run our averaging filter, which looks for the bias too where it is not given."""
    return lambda given: averaging_observer(given.rates, given.forces, PERIOD, bias=bias)


def whole_vqf(given: Recording) -> dict[str, Floats]:
    """Run the filter after which it is made, which estimates the bias too."""
    return VQF(PERIOD).updateBatch(given.rates, given.forces)


def vqf(given: Recording) -> dict[str, Floats]:
    """Run the filter of another library, which corrects by the accelerometer too."""
    return BasicVQF(PERIOD).updateBatch(given.rates, given.forces)


def fixed(given: Recording) -> Floats:
    """Run our observer."""
    return fixed_gain_observer(given.rates, given.forces, PERIOD, GAIN)


def integrate(given: Recording) -> Floats:
    """Integrate the gyros alone."""
    return integrate_gyro(given.rates, PERIOD)


OBSERVER, GYROS = "samples through an observer", "samples of gyros integrated"
MONITORED = "samples through a monitored observer"
AVERAGING = "samples averaged, with the bias"
STREAM = "samples of a stream through an observer"
AVERAGED_STREAM = "samples of a stream averaged, with the bias"
CASES = [
    Case(OBSERVER, OURS, fixed),
    Case(OBSERVER, PLAIN, fixed),
    Case(OBSERVER, PEER, vqf, down_from_vqf),
    Case(MONITORED, OURS, monitored),
    Case(MONITORED, PLAIN, monitored),
    Case(AVERAGING, OURS, averaged("running")),
    Case(AVERAGING, f"{OURS}, bias of the stillest stretch", averaged("stillest")),
    Case(AVERAGING, f"{OURS}, bias given", averaged(0.001)),
    Case(AVERAGING, PLAIN, averaged("running")),
    Case(AVERAGING, PEER, whole_vqf, down_from_vqf),
    Case(GYROS, OURS, integrate),
    Case(GYROS, PLAIN, integrate),
    Case(STREAM, OURS, of_stream(partial(observe, gain=GAIN))),
    Case(STREAM, PEER, vqf_of_stream(BasicVQF), down_from_vqf),
    Case(AVERAGED_STREAM, OURS, of_stream(observe_averaging)),
    Case(AVERAGED_STREAM, PEER, vqf_of_stream(VQF), down_from_vqf),
]


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.task}-{case.library}")
def test_speed(benchmark: Any, monkeypatch: pytest.MonkeyPatch, case: Case) -> None:  # noqa: ANN401 (pytest-benchmark has no types)
    whole = recording()
    streamed = case.task in (STREAM, AVERAGED_STREAM)
    given: Any = whole.stream if streamed else whole
    size = STREAMED if streamed else SIZE
    if case.library == PLAIN:
        monkeypatch.setattr(_recordings, "kernel", lambda _: None)
    warnings.simplefilter("ignore", UserWarning)  # a body that swings has no stillest stretch
    down = case.down(case.run(given))
    off = np.degrees(np.arccos(np.clip(np.sum(down * whole.down[:size], axis=1), -1, 1)))
    # Gyros alone drift off, and are right at first.
    assert np.sqrt(np.mean(off[: 1000 if case.task == GYROS else size] ** 2)) < 2
    benchmark.extra_info.update(size=size, task=case.task, library=case.library)
    benchmark(partial(case.run, given))
