"""What the observer does with damaged samples, and that a stream gives what a recording gives."""

import functools
import itertools
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import chr_notes
from chr_notes import UnitWarning, fixed_gain_observer, integrate_gyro, observe
from tests.attitudes import apart

Floats = NDArray[np.float64]
LEVEL = np.array([0.0, 0.0, -9.80665])


def test_samples_with_nan_are_held_out() -> None:
    generator = np.random.default_rng(1)
    rates = generator.normal(0, 0.3, (40, 3))
    forces = LEVEL + generator.normal(0, 1.0, (40, 3))
    gyro_holes, accel_holes = rates.copy(), forces.copy()
    gyro_holes[10, 1] = np.inf
    accel_holes[20, 2] = np.nan
    accel_holes[30] = 0.0
    found = fixed_gain_observer(gyro_holes, accel_holes, 0.01, 0.1)
    assert np.flatnonzero(np.isnan(found).any(axis=1)).tolist() == [10]
    whole = fixed_gain_observer(rates, forces, 0.01, 0.1)
    assert_array_equal(found[:10], whole[:10])
    assert apart(found[11:], whole[11:]).max() < 0.05
    # Where the accelerometer is missing, the gyros go on alone.
    for hole in (20, 30):
        alone = integrate_gyro(rates[[hole]], 0.01, found[hole - 1], method="quaternion")
        assert_allclose(found[hole], alone[0], atol=1e-15)


def test_the_start_is_the_first_tilt_that_is_shown() -> None:
    forces = np.array([[np.nan, 0, 0], [0, 0, 0], [0, -1, -1], [0, 0, -1]])
    found = fixed_gain_observer(np.zeros((4, 3)), forces, 0.01, 0.5)
    assert_allclose(np.degrees(found[:, 0]), [np.nan, np.nan, 45, 22.5])


def test_a_stream_starts_as_a_recording_does() -> None:
    rates = np.tile([0.0, 0.0, 1.0], (4, 1))
    forces = np.array([[np.nan] * 3, [0, 0, 0], LEVEL, LEVEL])
    streamed = list(observe(zip(rates, forces, [0.1] * 4, strict=True), 0.1))
    found = fixed_gain_observer(rates, forces, 0.1, 0.1)
    assert_allclose(np.array([each.euler for each in streamed]), found[2:], atol=1e-15)
    assert np.isnan(found[:2]).all()
    assert_allclose(found[:, 2], [np.nan, np.nan, 0.0, 0.1], atol=1e-16)


@pytest.mark.parametrize("wild", [1e12, -1e200, 1e308, np.inf, np.nan])
def test_a_wild_number_is_held_out_like_nan(wild: float) -> None:
    rates, forces = np.full((5, 3), 0.1), np.tile(LEVEL, (5, 1))
    expected = fixed_gain_observer(
        np.delete(rates, 2, axis=0), np.delete(forces, 2, axis=0), 0.1, 0
    )
    rates[2, 1] = wild
    found = fixed_gain_observer(rates, forces, 0.1, 0)
    assert np.isnan(found[2]).all()
    assert_array_equal(np.delete(found, 2, axis=0), expected)
    assert chr_notes.rejected_samples(rates, forces).tolist() == [False, False, True, False, False]


def test_no_force_is_wild_because_its_unit_does_not_matter() -> None:
    rates, forces = np.zeros((3, 3)), np.tile([0.0, -1.0, -1.0], (3, 1))
    found = fixed_gain_observer(rates, 1e200 * forces, 0.01, 0.5)
    assert_array_equal(found, fixed_gain_observer(rates, forces, 0.01, 0.5))
    assert not chr_notes.rejected_samples(rates, 1e200 * forces).any()


def test_after_the_wildest_number_that_counts_the_tilt_comes_back() -> None:
    rates, forces = np.zeros((2000, 3)), np.tile([0.0, -1.0, -1.0], (2000, 1))
    rates[10] = 5e11
    with pytest.warns(UnitWarning, match=r"got 8\.66e\+09 rad at 10, the first of 1:"):
        found = fixed_gain_observer(rates, forces, 0.01, 0.1)
    assert_allclose(found[-1, :2], [np.pi / 4, 0], atol=1e-5)


def test_steps_may_vary() -> None:
    rates = np.tile([0.1, 0.0, 0.0], (3, 1))
    found = fixed_gain_observer(rates, np.full((3, 3), np.nan), [0.1, 0.3, 0.0], 0.5, (0, 0, 0))
    assert_allclose(found[:, 0], [0.01, 0.04, 0.04])


def test_a_stream_gives_the_same_numbers() -> None:
    generator = np.random.default_rng(2)
    rates = generator.normal([0, 0, 20.0], 2.0, (300, 3))  # yaw goes round several times
    forces = LEVEL + generator.normal(0, 3.0, (300, 3))
    rates[50], forces[100], forces[0] = np.nan, np.nan, np.nan
    steps = generator.uniform(0.001, 0.02, 300)
    # The array form starts from the first tilt, the stream when that comes.
    expected = fixed_gain_observer(rates[1:], forces[1:], steps[1:], 0.05)
    # Lists and arrays are taken in turn.
    mixed = [row.tolist() if place % 3 else row for place, row in enumerate(rates)]
    streamed = list(observe(zip(mixed, forces, steps, strict=True), 0.05))
    assert [each.held_out for each in (streamed[0], streamed[49], streamed[-1])] == [1, 2, 3]
    found = np.array([each.euler for each in streamed])
    same = (np.delete(found, 49, axis=0), np.delete(expected, 49, axis=0))
    assert_allclose(*same, rtol=0, atol=2e-14)
    # What the array leaves open, a stream answers: predicted to stay, and corrected.
    still = fixed_gain_observer(np.zeros((1, 3)), forces[[50]], steps[50], 0.05, found[48])
    assert_allclose(found[49], still[0], atol=1e-15)


def test_a_stream_counts_what_it_leaves_out() -> None:
    nothing, unread = np.zeros(3), np.full(3, np.nan)
    given = [(unread, LEVEL), (nothing, nothing), (nothing, [0, 0, np.inf]), (nothing, LEVEL)]
    streamed = observe([(*each, 0.01) for each in given], 0.05)
    assert [each.held_out for each in streamed] == [1, 2, 3, 3]


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_stream_counts_a_wild_rate_about_each_axis(axis: int) -> None:
    rates = np.where(np.arange(3) == axis, 1e12, 0.1)
    streamed = observe([(np.zeros(3), LEVEL, 0.01), (rates, LEVEL, 0.01)], 0.05)
    assert [each.held_out for each in streamed] == [0, 1]


def test_a_recording_tells_what_it_leaves_out() -> None:
    rates, forces = np.zeros((5, 3)), np.tile((0.0, 0.0, -1.0), (5, 1))
    rates[1, 2] = np.inf
    forces[2, 0] = forces[1, 0] = np.nan
    forces[3] = 0
    out = chr_notes.rejected_samples(rates, forces)
    assert out.tolist() == [False, True, True, True, False]
    streamed = list(chr_notes.observe(zip(rates, forces, [0.01] * 5, strict=True), 0.1))
    assert streamed[-1].held_out == out.sum()
    with pytest.raises(ValueError, match="got 5, 4"):
        chr_notes.rejected_samples(rates, forces[1:])


def test_one_step_is_that_of_a_recording() -> None:
    rates, force, initial = [0.1, -0.2, 0.3], [1.0, 2.0, -9.0], [0.1, 0.2, 0.3]
    expected = fixed_gain_observer([rates], [force], 0.02, 0.3, initial)[0]
    assert_allclose(
        chr_notes.observe_sample(initial, rates, force, 0.02, 0.3), expected, atol=1e-15
    )


@pytest.mark.parametrize("method", ["quaternion", "euler"])
@pytest.mark.parametrize("half", [np.pi, -np.pi, 3 * np.pi])
def test_half_a_turn_stays_within_its_range(half: float, method: Any) -> None:  # noqa: ANN401
    up = np.array([[0.0, 0.0, 1.0]])
    for initial in ([half, 0.0, 0.0], [0.0, 0.0, half]):
        found = fixed_gain_observer([[0.0, 0.0, 0.0]], up, 0.01, 0.0, initial, method=method)
        assert ((found >= -np.pi) & (found < np.pi)).all()
        assert_allclose(np.abs(found[0]), np.abs(initial) % (2 * np.pi), atol=1e-15)


def test_a_start_may_be_written_in_any_range() -> None:
    # Pitch beyond 90° is the same attitude as with all three angles turned the other way.
    beyond, within = np.array([0.3, 2.0, 0.1]), np.array([0.3 - np.pi, np.pi - 2.0, 0.1 - np.pi])
    rates, forces = np.full((20, 3), np.nan), np.tile(LEVEL, (20, 1))
    rates[10:] = 0.1
    found = fixed_gain_observer(rates, forces, 0.01, 0.3, beyond)[10:]
    assert_allclose(found, fixed_gain_observer(rates, forces, 0.01, 0.3, within)[10:], atol=1e-12)
    one = chr_notes.observe_sample(beyond, rates[0], LEVEL, 0.01, 0.3)
    assert_allclose(one, chr_notes.observe_sample(within, rates[0], LEVEL, 0.01, 0.3), atol=1e-12)


def test_a_stream_is_read_no_further_than_asked() -> None:
    endless = ((np.zeros(3), LEVEL, 0.01) for _ in itertools.count())
    assert len(list(itertools.islice(observe(endless, 0.1), 3))) == 3


def swinging(count: int) -> tuple[Floats, Floats, Floats]:
    """Rates, forces and fields of a body that turns past half turns and straight up."""
    generator = np.random.default_rng(3)
    rates = generator.normal([3.0, 8.0, 0.0], 1.0, (count, 3))
    forces = LEVEL + generator.normal(0, 3.0, (count, 3))
    forces[::37], rates[::41], rates[::53] = np.nan, np.inf, 900.0
    return rates, forces, generator.normal([20.0, 0.0, 45.0], 1.0, (count, 3))


@pytest.mark.parametrize("stream", ["observe", "observe with a field", "observe_averaging"])
@pytest.mark.filterwarnings("ignore:body_rates and dt")
def test_lists_give_the_same_bits_as_arrays(stream: str) -> None:
    rates, forces, field = swinging(400)
    columns = [rates, forces, [0.01] * 400, *([field] if "field" in stream else [])]
    run: Any = chr_notes.observe_averaging
    if stream != "observe_averaging":
        run = functools.partial(observe, gain=0.05)
    by_arrays = [each.euler for each in run(zip(*columns, strict=True))]
    columns = [c.tolist() if isinstance(c, np.ndarray) else c for c in columns]
    assert_array_equal([each.euler for each in run(zip(*columns, strict=True))], by_arrays)
    assert len(by_arrays) == 399


@pytest.mark.parametrize("start", [(np.pi, 0.0, 0.3), (0.2, np.pi / 2, 0.1), (0.0, 0.0, -np.pi)])
def test_a_stream_writes_half_turns_and_the_pole_as_a_recording_does(start: Any) -> None:  # noqa: ANN401 (three numbers)
    nothing = np.zeros((3, 3))
    expected = fixed_gain_observer(nothing, nothing, 0.01, 0.5, start)
    found = observe(zip(nothing, nothing + LEVEL, [0.01] * 3, strict=True), 0.0, start)
    assert_array_equal([each.euler for each in found], expected)


@pytest.mark.parametrize("dt", [-0.01, np.nan, np.inf])
def test_a_wrong_step_is_refused_when_it_comes(dt: float) -> None:
    for run in (functools.partial(observe, gain=0.1), chr_notes.observe_averaging):
        stream: Any = run([(np.zeros(3), LEVEL, each) for each in (0.01, 0.01, dt)])
        assert len(list(itertools.islice(stream, 2))) == 2
        with pytest.raises(ValueError, match="dt: expected seconds, not negative, got"):
            next(stream)


@pytest.mark.parametrize("count", [2, 5])
def test_a_sample_of_too_few_or_too_many_parts_is_refused(count: int) -> None:
    sample: Any = (np.zeros(3), LEVEL, 0.01, LEVEL, LEVEL)[:count]
    for run in (functools.partial(observe, gain=0.1), chr_notes.observe_averaging):
        stream: Any = run([sample])
        with pytest.raises(ValueError, match=f"stream: expected samples of .*one of {count} parts"):
            next(stream)


def test_a_stream_warns_of_a_turn_that_is_too_far() -> None:
    for run in (functools.partial(observe, gain=0.1), chr_notes.observe_averaging):
        fast = np.array([0.0, 0.0, 400.0])
        stream: Any = run([(rates, LEVEL, 0.01) for rates in (np.zeros(3), np.zeros(3), fast)])
        assert len(list(itertools.islice(stream, 2))) == 2
        with pytest.warns(UnitWarning, match="got 4 rad"):
            next(stream)
