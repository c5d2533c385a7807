"""Steps of filters over a recording: by kernels and by Python the same."""

import inspect
from collections.abc import Callable

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes import _recordings, fixed_gain_observer
from chr_notes._kernels import of_arrays
from chr_notes.generated.arrays.shapes import SHAPES
from chr_notes.generated.scalar import dead_reckoning, estimation

STEPS = [
    *(estimation.gyro_step, estimation.gyro_turn, estimation.observer_turn),
    *(estimation.observer_step, estimation.euler_observer_step),
    dead_reckoning.dead_reckoning_held,
]
Inputs = list[NDArray[np.float64]]


def recording(step: Callable[..., object], count: int) -> tuple[NDArray[np.float64], Inputs]:
    """A state to start from, and samples; every twentieth has something missing."""
    generator = np.random.default_rng(1)
    state, *inputs = SHAPES[step.__name__][0].items()
    samples = []
    for name, shape in inputs:
        if name == "dt":
            samples.append(generator.uniform(0.001, 0.02, count))
        elif name == "gain":
            samples.append(np.array(0.05))
        else:
            values = generator.normal(0, 2.0, (count, *shape))
            values[:: 20 + len(samples)] = (np.nan, 0.0, np.inf)[len(samples)]
            samples.append(values)
    return generator.normal(0, 0.5, state[1]), samples


@pytest.mark.kernels
@pytest.mark.parametrize("step", STEPS, ids=lambda step: step.__name__)
def test_kernels_and_python_give_the_same(
    step: Callable[..., tuple[float, ...]], monkeypatch: pytest.MonkeyPatch
) -> None:
    state, inputs = recording(step, 500)
    by_kernel = _recordings.run(step, state.tolist(), *inputs)
    monkeypatch.setattr(_recordings, "kernel", lambda _: None)
    by_python = _recordings.run(step, state.tolist(), *inputs)
    assert np.isfinite(by_kernel).all()
    assert_allclose(by_kernel, by_python, rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize("step", STEPS, ids=lambda step: step.__name__)
def test_a_recording_is_one_step_after_another(step: Callable[..., tuple[float, ...]]) -> None:
    state, inputs = recording(step, 30)
    expected = []
    now, take = state, of_arrays(step)
    for sample in range(30):
        now = take(now, *(a[sample] if a.ndim else float(a) for a in inputs), None)
        expected.append(now)
    assert_array_equal(_recordings.run(step, state.tolist(), *inputs), np.array(expected))


def test_a_recording_may_stand_at_any_place_of_a_file() -> None:
    rates = np.random.default_rng(0).normal(size=(50, 3))
    forces = rates + np.array([0, 0, -9.8])
    read = [np.frombuffer(b"-" + a.tobytes(), offset=1).reshape(a.shape) for a in (rates, forces)]
    found = fixed_gain_observer(*read, 0.01, 0.02)
    assert_array_equal(found, fixed_gain_observer(rates, forces, 0.01, 0.02))


def test_parts_of_a_recording_join(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_recordings, "kernel", lambda _: None)
    generator = np.random.default_rng(0)
    rates = generator.normal(0, 0.5, (1000, 3))
    forces = generator.normal(0, 1.0, (1000, 3)) + np.array([0, 0, -9.8])
    whole = fixed_gain_observer(rates, forces, 0.01, 0.02)
    monkeypatch.setattr(_recordings, "_TOGETHER", 17)
    assert_array_equal(fixed_gain_observer(rates, forces, 0.01, 0.02), whole)


def test_each_step_takes_its_state_and_samples_in_order() -> None:
    for step in STEPS:
        arrays, result = SHAPES[step.__name__]
        sizes = [int(np.prod(shape)) for shape in arrays.values()]
        assert len(inspect.signature(step).parameters) == sum(sizes)
        assert result == next(iter(arrays.values()))
