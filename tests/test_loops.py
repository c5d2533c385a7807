"""Filters over many samples: plain and compiled."""

import inspect
from collections.abc import Callable

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from numpy.typing import NDArray

from chr_notes import _loops, fixed_gain_observer
from chr_notes.generated.loops import dead_reckoning, estimation

LOOPS = [
    loop
    for module in (estimation, dead_reckoning)
    for _, loop in inspect.getmembers(module, inspect.isfunction)
    if "dt_samples" in inspect.signature(loop).parameters
]


def recording(count: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    generator = np.random.default_rng(0)
    rates = generator.normal(0, 0.5, (count, 3))
    forces = generator.normal(0, 1.0, (count, 3)) + np.array([0, 0, -9.8])
    return rates, forces


@pytest.mark.parametrize("loop", LOOPS, ids=lambda loop: loop.__name__)
def test_compiled_loops_give_the_same_numbers(loop: Callable[..., object]) -> None:
    generator = np.random.default_rng(1)
    names = list(inspect.signature(loop).parameters)
    inputs = [name for name in names if name.endswith("_samples")]
    kept = [name for name in names if name.endswith("_kept")]
    single = len(names) - len(inputs) - len(kept)
    # Large enough to pass the pole and to turn the long way round; every twentieth is missing.
    samples = generator.normal(0, 2.0, (len(inputs), 2000))
    samples[:-1, ::20] = np.nan
    samples[-1] = 0.01
    start = [0.3] * single
    rows = [[0.0] * 2000 for _ in kept]
    plain = loop(*start, *samples.tolist(), *rows)
    arrays = np.empty((len(kept), 2000))
    assert_array_equal(_loops.compiled(loop)(*start, *samples, *arrays), plain)
    assert_array_equal(arrays, rows)
    assert np.isfinite(arrays).all()


def test_long_recordings_are_compiled_and_come_out_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    rates, forces = recording(20_000)
    plain = fixed_gain_observer(rates, forces, 0.01, 0.02)
    calls = []
    monkeypatch.setattr(_loops, "LONG", 20_000)
    compiled = _loops.compiled
    monkeypatch.setattr(_loops, "compiled", lambda loop: calls.append(loop) or compiled(loop))
    assert_array_equal(fixed_gain_observer(rates, forces, 0.01, 0.02), plain)
    assert calls == [estimation.fixed_gain_observer]


def test_parts_of_a_recording_join(monkeypatch: pytest.MonkeyPatch) -> None:
    rates, forces = recording(1000)
    whole = fixed_gain_observer(rates, forces, 0.01, 0.02)
    monkeypatch.setattr(_loops, "_LISTED", 17)
    assert_array_equal(fixed_gain_observer(rates, forces, 0.01, 0.02), whole)
    monkeypatch.setattr(_loops, "LONG", 1)
    monkeypatch.setattr(_loops, "_COMPILED", 23)
    assert_array_equal(fixed_gain_observer(rates, forces, 0.01, 0.02), whole)
