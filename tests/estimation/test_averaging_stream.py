"""The averaging filter on a stream gives what it gives over a recording."""

from itertools import islice, repeat

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes import (
    accelerometer_at_rest,
    averaged_attitude,
    integrate_gyro,
    matrix_from_euler,
    observe_averaging,
)

Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def log() -> tuple[Floats, Floats, Floats, Floats]:
    """A body that rests and tumbles by turns, with NaN, glitches, jitter and a gap."""
    random = np.random.default_rng(0)
    time = 0.01 * np.arange(4000)[:, np.newaxis]
    moves = (time % 10 > 4).astype(float)
    rates = moves * 2 * np.cos(time * [0.7, 0.5, 0.3] + [0.0, 1.0, 2.0])
    truth = integrate_gyro(rates, 0.01)
    forces = accelerometer_at_rest(truth) + (0.01 + moves) * random.normal(size=(4000, 3))
    field = matrix_from_euler(truth) @ [18.0, 0.0, 45.0] + 0.2 * random.normal(size=(4000, 3))
    rates += 0.001 * random.normal(size=(4000, 3)) + [0.01, -0.004, 0.006]
    steps = 0.01 + 0.002 * random.uniform(-1, 1, 4000)
    forces[:3], rates[1000:1010], forces[1500:1700, 0], field[2000:2100] = np.nan, np.nan, np.inf, 0
    forces[2200], rates[2300], field[2400:2600], steps[2700] = 1e9, 1e13, [60.0, 0.0, 0.0], 3.0
    return rates, forces, steps, field


@pytest.mark.parametrize("bias", ["running", 0.0, [0.01, -0.004, 0.006]])
@pytest.mark.parametrize("heading", [False, True])
def test_stream_and_recording(
    bias: str | float | list[float],
    heading: bool,  # noqa: FBT001 (pytest gives it)
    log: tuple[Floats, ...],
) -> None:
    rates, forces, steps, field = log
    mag = field if heading else None
    stream = zip(rates, forces, steps, *([field] if heading else []), strict=True)
    found = list(observe_averaging(stream, bias=bias))  # type: ignore[arg-type]
    expected = averaged_attitude(rates, forces, steps, mag=mag, bias=bias)  # type: ignore[arg-type]
    assert len(found) == len(rates) - 3
    told = np.isfinite(expected.euler[3:]).all(axis=1)
    assert told.sum() == len(rates) - 3 - 10 - 1
    euler = np.array([each.euler for each in found])
    assert np.isfinite(euler).all()
    assert_allclose(euler[told], expected.euler[3:][told], atol=1e-12)
    for name in ("averaged", "tilt_bound", "heading_averaged"):
        got = [getattr(each, name) for each in found]
        assert_allclose(got, getattr(expected, name)[3:], rtol=1e-12)
    assert expected.heading_averaged.any() == heading


def test_the_bias_is_learnt_at_the_first_rest(log: tuple[Floats, ...]) -> None:
    rates, forces = log[0][3:400], log[1][3:400]
    found = [e.euler for e in observe_averaging(zip(rates, forces, repeat(0.01), strict=False))]
    turned = np.diff(np.unwrap([euler[2] for euler in found])) / 0.01
    assert turned[:150].mean() == pytest.approx(0.006, abs=1e-3)
    assert abs(turned[220:].mean()) < 2e-4


def test_it_waits_for_no_later_sample() -> None:
    samples = iter([([0, 0, 0], [0, 0, -9.8], 0.01)] * 5)
    stream = observe_averaging(samples)
    assert len(list(islice(stream, 2))) == 2
    assert len(list(samples)) == 3


def test_what_looks_ahead_or_has_no_meaning_is_refused() -> None:
    with pytest.raises(ValueError, match=r'"running" or numbers for a stream, got .stillest'):
        next(observe_averaging([], bias="stillest"))
    with pytest.raises(ValueError, match=r'bias: expected "stillest", "running" or numbers'):
        next(observe_averaging([], bias="still"))
    with pytest.raises(ValueError, match="bias: expected a number or shape"):
        next(observe_averaging([], bias=[1, 2]))
    with pytest.raises(ValueError, match="dt: expected seconds"):
        list(observe_averaging([([0, 0, 0], [0, 0, -9.8], -0.01)]))
    first, then = ([0, 0, 0], [0, 0, -9.8], 0.01, [20, 0, 40]), ([0, 0, 0], [0, 0, -9.8], 0.01)
    for samples in ([first, then], [then, first]):
        with pytest.raises(ValueError, match="a magnetic field in each sample or in none"):
            list(observe_averaging(samples))


def test_samples_are_rows_of_any_array(log: tuple[Floats, ...]) -> None:
    rates, forces, steps, field = (each[:200] for each in log)
    expected = [
        each.euler for each in observe_averaging(zip(rates, forces, steps, field, strict=True))
    ]
    for layout in (np.asfortranarray, lambda a: a[:, ::-1].copy()[:, ::-1]):
        stream = zip(*map(layout, (rates, forces)), steps, layout(field), strict=True)
        euler = [each.euler for each in observe_averaging(stream)]
        assert_allclose(euler, expected, rtol=0, atol=1e-15)


def test_lists_are_samples_too() -> None:
    (only,) = observe_averaging([([0, 0, 0], [0, 0, -1], 0.1, [1, 0, 1])])
    assert_array_equal(only.euler + 0.0, [0, 0, 0])
    assert only.averaged == 0
