"""Filters over many samples: plain and compiled."""

import inspect
import time
from collections.abc import Callable
from math import sin

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


def seconds(call: Callable[[], object], times: int = 3) -> float:
    """Shortest of some runs, in time of this thread alone: what else runs only ever adds."""
    taken = []
    for _ in range(times):
        start = time.thread_time()
        call()
        taken.append(time.thread_time() - start)
    return min(taken)


@pytest.mark.parametrize("loop", LOOPS, ids=lambda loop: loop.__name__)
def test_compiled_loops_give_the_same_numbers(loop: Callable[..., object]) -> None:
    pytest.importorskip("numba", reason="the extra `fast` is not installed")
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
    pytest.importorskip("numba", reason="the extra `fast` is not installed")
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
    monkeypatch.setattr(_loops, "_CHUNK", 17)
    assert_array_equal(fixed_gain_observer(rates, forces, 0.01, 0.02), whole)


def test_a_million_samples_compiled_are_faster_than_vqf() -> None:
    pytest.importorskip("numba", reason="the extra `fast` is not installed")
    vqf = pytest.importorskip("vqf", reason="vqf is not installed")
    rates, forces = recording(1_000_000)
    fixed_gain_observer(rates[: _loops.LONG], forces[: _loops.LONG], 0.01, 0.02)
    ours = seconds(lambda: fixed_gain_observer(rates, forces, 0.01, 0.02))
    theirs = seconds(lambda: vqf.BasicVQF(0.01).updateBatch(rates, forces))
    assert ours < theirs


def test_a_plain_sample_costs_little(monkeypatch: pytest.MonkeyPatch) -> None:
    """At most 0.8 µs, on a machine that adds up a sine in 0.05 µs.

    The same interpreter runs the same code up to six times slower on some virtual machines, so
    the bound is in units of what is measured there.
    """
    monkeypatch.setattr(_loops, "find_spec", lambda _: None)
    rates, forces = recording(100_000)
    unit = seconds(lambda: _sines(100_000)) / 100_000
    taken = seconds(lambda: fixed_gain_observer(rates, forces, 0.01, 0.02)) / 100_000
    assert taken / unit < 0.8 / 0.05


def _sines(count: int) -> float:
    total = 0.0
    for _ in range(count):
        total += sin(0.3)
    return total
