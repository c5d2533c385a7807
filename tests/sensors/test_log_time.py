"""Times of a log: their unit, and what is left out of them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes.sensors.log_time import Times, even, timed

STEADY = np.arange(1000) * 0.01


def refuse(why: str) -> None:
    raise ValueError(why)


def of(values: NDArray[np.float64], unit: str | None = "s") -> Times:
    return timed(values, unit, lambda row: f"row {row}", refuse)


@pytest.mark.parametrize(("unit", "size"), [("s", 1.0), ("ms", 1e3), ("us", 1e6), ("ns", 1e9)])
@pytest.mark.parametrize("rate", [4.0, 50.0, 100.0, 1000.0, 2500.0])
def test_the_unit_is_found_by_the_size_of_the_steps(unit: str, size: float, rate: float) -> None:
    values = 17 * size + np.arange(500) / rate * size
    if unit == "ms" and rate == 1000.0:
        values[100:] += 1.0  # a step of one alone would be a counter's
    times = of(values, None)
    assert times.unit == unit
    assert times.rate == pytest.approx(rate)
    assert times.time is not None
    assert times.time[0] == 0


def test_a_counter_is_no_time() -> None:
    with pytest.raises(ValueError, match="time: cannot tell its unit from steps of 1; pass units="):
        of(np.arange(100.0), None)
    assert of(np.arange(100.0), "ms").rate == pytest.approx(1000)


@pytest.mark.parametrize(
    ("factor", "unit"),
    [(1000.0, "s"), (1e6, "s"), (1e6, "ms"), (1e-3, "s"), (1.0, "ms"), (1.0, "ns")],
)
def test_a_unit_that_cannot_be_is_refused(factor: float, unit: str) -> None:
    with pytest.raises(ValueError, match="time: expected a sensor's rate"):
        of(STEADY * factor, unit)


def test_gaps_and_jitter() -> None:
    values = STEADY + np.random.default_rng(0).normal(0, 0.0005, 1000)
    values = np.delete(values, slice(400, 450))
    times = of(values)
    assert [(gap.start, gap.stop, gap.place) for gap in times.gaps] == [(399, 401, "row 400")]
    assert times.gaps[0].seconds == pytest.approx(0.51, abs=0.003)
    assert times.jitter == pytest.approx(0.0707, rel=0.1)
    assert times.warnings == ["1 gap in time, the longest of 0.51 s at row 400"]
    assert times.dt is not None
    assert times.time is not None
    assert_allclose(times.dt[1:], np.diff(times.time))


def test_repeated_and_backward_times_are_left_out() -> None:
    values = STEADY.copy()
    values[[10, 20]] = values[[9, 19]]
    values[500] = values[495]
    times = of(values)
    assert (times.repeated, times.backward) == (2, 1)
    assert times.kept is not None
    assert_array_equal(np.flatnonzero(~times.kept), [10, 20, 500])
    assert times.time is not None
    assert (np.diff(times.time) > 0).all()
    assert times.warnings[0].startswith(
        "2 rows come at the same time as an earlier one, the first at"
    )


def test_times_that_begin_again_are_refused() -> None:
    with pytest.raises(
        ValueError, match=r"row 500: time: expected rising times, got 0 s after 4.99"
    ):
        of(np.concatenate([STEADY[:500], STEADY[:500]]))
    with pytest.raises(ValueError, match="time: expected rising times, got 5, 5, 5"):
        of(np.full(10, 5.0))
    with pytest.raises(ValueError, match="60 of 100 rows at the time of the row before"):
        of(np.sort(np.concatenate([np.arange(40), np.arange(40), np.arange(20)]) * 0.01))


@pytest.mark.parametrize("jump", [1.9e8, -1.9e8, 4000.0])
def test_a_clock_that_was_set_counts_as_a_usual_step(jump: float) -> None:
    values = STEADY.copy()
    values[300:] += jump
    times = of(values)
    assert [(each.start, each.seconds) for each in times.clock_jumps] == [
        (299, pytest.approx(jump + 0.01))
    ]
    assert times.time is not None
    assert_allclose(times.time, STEADY, atol=1e-6)
    assert "the clock was set 1 time," in times.warnings[0]


def test_a_counter_of_32_bits_goes_on() -> None:
    values = (2**32 - 5_000_000 + np.arange(1000) * 10_000.0) % 2**32
    times = of(values, "us")
    assert times.time is not None
    assert_allclose(times.time, STEADY, atol=1e-9)
    assert "began again" in times.assumed[0]


def test_rows_without_time_are_left_out() -> None:
    values = STEADY.copy()
    values[[3, 7]] = np.nan
    times = of(values)
    assert times.kept is not None
    assert_array_equal(np.flatnonzero(~times.kept), [3, 7])
    assert times.warnings[0] == "2 rows have no time, the first at row 3: left out"


def test_a_rate_in_place_of_times() -> None:
    times = even(5, 50.0, had_times=True)
    assert times.time is not None
    assert_allclose(times.time, np.arange(5) / 50)
    assert times.assumed == [
        "one sample every 0.02 s, by the rate given, and not the times of the log"
    ]
    for rate in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="rate: expected a positive number"):
            even(5, rate, had_times=False)
