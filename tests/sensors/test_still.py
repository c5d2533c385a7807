"""Where a sensor lay still."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes import static_interval, static_intervals
from chr_notes.sensors.still import without_glitches

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
NOISE = np.random.default_rng(0).normal(0, 0.001, (2000, 3))
FORCE = np.array([0.0, 0.0, -9.8])


def moved(*parts: slice) -> tuple[Floats, Floats]:
    """Rates and forces at 100 Hz of a sensor that lies still but for these parts."""
    rates, forces = NOISE + np.array([0.02, -0.01, 0.0]), 10 * NOISE[::-1] + FORCE
    for part in parts:
        swing = np.sin(0.1 * np.arange(part.stop - part.start))[:, np.newaxis]
        rates[part] += swing * [1.0, 0.5, -0.5]
        forces[part] += swing * [-0.5, 3.0, 0.3]
    return rates, forces


def test_the_stillest_stretch_is_where_it_was_put() -> None:
    rates = np.random.default_rng(1).normal(0, 0.1, (1000, 3)) + 50
    rates[400:500] = rates[400:500] / 1000 + 50
    assert static_interval(rates, 100) == slice(400, 500)
    rates[450] = np.nan
    found = static_interval(rates, 40)
    assert found.start >= 400
    assert found.stop <= 500
    assert not found.start <= 450 < found.stop


def test_the_stillest_stretch_is_that_of_a_plain_search() -> None:
    rates = np.random.default_rng(2).normal(0, 0.1, (60, 3))
    spreads = [rates[a : a + 7].var(axis=0).sum() for a in range(54)]
    best = int(np.argmin(spreads))
    assert static_interval(rates, 7) == slice(best, best + 7)


def test_of_stretches_that_are_as_still_the_first_is_found() -> None:
    rates = np.tile([[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], (4, 1))
    assert static_interval(rates, 2) == slice(0, 2)
    assert static_interval(np.zeros((9, 3)), 3) == slice(0, 3)


def test_a_stretch_that_is_not_there_is_refused() -> None:
    with pytest.raises(
        ValueError, match="length: expected from 2 to the 5 samples there are, got 6"
    ):
        static_interval(np.zeros((5, 3)), 6)
    with pytest.raises(ValueError, match="expected 3 samples in a row without NaN, got none"):
        static_interval([[0, 0, 0], [0, 0, 0], [np.nan, 0, 0], [0, 0, 0], [0, 0, 0]], 3)
    with pytest.raises(ValueError, match="expected 2 samples in a row without NaN, got none"):
        static_interval(np.full((5, 3), np.nan), 2)
    with pytest.raises(TypeError, match="'float' object cannot be interpreted as an integer"):
        static_interval(np.zeros((5, 3)), 2.5)  # type: ignore[arg-type]


@given(seeds, st.sampled_from([1e-1, 1.0, 1e7, 1e11]))
def test_a_glitch_moves_the_stillest_stretch_nowhere_else_than_to_one_as_still(
    seed: int, size: float
) -> None:
    generator = np.random.default_rng(seed)
    rates = generator.normal(0, 0.5, (2000, 3))
    rates[700:1000] = generator.normal(0, 0.001, (300, 3))
    rates[generator.integers(0, 2000, 5), generator.integers(0, 3, 5)] += size
    found = static_interval(rates, 200)
    assert found.start >= 700
    assert found.stop <= 1000


def test_a_stretch_without_a_glitch_comes_before_one_that_is_as_still() -> None:
    rates = np.zeros((300, 3))
    rates[50] = 1e7
    assert static_interval(rates, 100) == slice(51, 151)
    rates[::20] = 1e7
    rates[200:] += np.sin(np.arange(100.0))[:, np.newaxis]
    assert static_interval(rates, 100).stop <= 201


def test_what_passes_for_a_glitch() -> None:
    rates = NOISE.copy()
    assert not without_glitches(rates)[1].any()
    rates[[0, 500, 501, 1999]] += [1e3, 0.0, 0.0]
    steady, glitches = without_glitches(rates)
    assert_array_equal(np.flatnonzero(glitches), [0, 500, 501, 1999])
    assert np.abs(steady).max() < 0.005
    # A motion is none.
    smooth = np.sin(np.arange(500) / 10)[:, np.newaxis] * [1.0, 0.1, 0.0]
    assert not without_glitches(smooth)[1].any()
    assert not without_glitches(smooth + NOISE[:500])[1].any()


def test_all_still_stretches_are_found() -> None:
    rates, forces = moved(slice(300, 500), slice(900, 1400))
    found = static_intervals(rates, forces, 0.01)
    expected = [slice(0, 300), slice(500, 900), slice(1400, 2000)]
    assert len(found) == len(expected)
    for one, other in zip(found, expected, strict=True):
        assert_allclose([one.start, one.stop], [other.start, other.stop], atol=3)


@given(seeds)
def test_glitches_and_missing_rows_hide_no_stretch(seed: int) -> None:
    generator = np.random.default_rng(seed)
    rates, forces = moved(slice(300, 500), slice(900, 1400))
    before = static_intervals(rates, forces, 0.01)
    # Two in five rows at most: where three are bad, they are what the median shows.
    pairs = generator.permutation(330)[:10, np.newaxis] * 6 + [0, 2]
    bad = generator.permutation(pairs.ravel())
    rates[bad[:5]], forces[bad[5:10]] = 1e7, np.nan
    forces[bad[10:], 1] += 1e4
    after = static_intervals(rates, forces, 0.01)
    assert len(after) == len(before)
    for one, other in zip(after, before, strict=True):
        assert_allclose([one.start, one.stop], [other.start, other.stop], atol=10)


def test_the_unit_of_the_accelerometer_does_not_matter() -> None:
    rates, forces = moved(slice(300, 500))
    assert static_intervals(rates, forces, 0.01) == static_intervals(rates, forces / 9.8, 0.01)


def test_a_motion_that_one_sensor_alone_sees_is_seen() -> None:
    rates, forces = moved(slice(300, 500))
    still, upright = moved()
    expected = static_intervals(rates, forces, 0.01)
    assert len(expected) == 2
    for found in (static_intervals(rates, upright, 0.01), static_intervals(still, forces, 0.01)):
        assert [(part.start, part.stop) for part in found] == [
            (pytest.approx(part.start, abs=5), pytest.approx(part.stop, abs=5)) for part in expected
        ]


@pytest.mark.parametrize("seed", [10, 13, 22, 51, 96])
def test_rests_are_found_beside_turns_that_vary_as_little(seed: int) -> None:
    """Six rests of three seconds, with a quarter of a turn at a steady rate after each."""
    generator = np.random.default_rng(seed)
    turning = np.arange(2400) % 400 >= 300
    rates, angle = generator.normal(0, 0.001, (2400, 3)), np.cumsum(0.0157 * turning)
    rates[turning, 0] += 1.57
    up = np.stack([0 * angle, -np.sin(angle), -np.cos(angle)], axis=1)
    found = static_intervals(rates, 9.8 * up + generator.normal(0, 0.003, (2400, 3)), 0.01)
    assert [round(each.start, -1) for each in found] == [*range(0, 2400, 400)]


def test_a_steady_turn_is_no_rest() -> None:
    rates, forces = moved()
    rates[800:1200, 2] += 0.5
    found = static_intervals(rates, forces, 0.01)
    assert [(part.start, part.stop) for part in found] == [
        (0, pytest.approx(800, abs=5)),
        (pytest.approx(1200, abs=5), 2000),
    ]


def test_a_gap_in_time_ends_a_stretch() -> None:
    rates, forces = moved()
    steps = np.full(2000, 0.01)
    steps[1200] = 30.0
    assert static_intervals(rates, forces, steps) == [slice(0, 1200), slice(1200, 2000)]


def test_short_stretches_are_asked_for() -> None:
    rates, forces = moved(slice(300, 500), slice(580, 900))
    assert len(static_intervals(rates, forces, 0.01)) == 2
    assert len(static_intervals(rates, forces, 0.01, shortest=0.4)) == 3


def test_where_nothing_is_still_nothing_is_found() -> None:
    rates, forces = moved(slice(0, 2000))
    assert static_intervals(rates, forces, 0.01) == []
    assert static_intervals(np.degrees(NOISE), forces, 0.01) == []
    assert static_intervals(rates[:5], forces[:5], 0.01) == []
    assert static_intervals(rates[:0], forces[:0], 0.01) == []
    assert static_intervals(np.full((500, 3), np.nan), forces[:500], 0.01) == []


def test_a_sensor_of_coarse_steps_may_lie_still() -> None:
    rates, forces = moved(slice(300, 500))
    found = static_intervals(np.round(rates / 0.005) * 0.005, np.round(forces / 0.5) * 0.5, 0.01)
    assert len(found) == 2


def test_the_six_positions_of_a_session_are_found(recordings: Path) -> None:
    session = np.loadtxt(recordings / "imucal_ferraris_session.csv", delimiter=",", skiprows=1)
    listed = json.loads((recordings / "imucal_ferraris_session_list.json").read_text())
    found = static_intervals(np.radians(session[:, 1:4]), session[:, 4:], 1 / 102.4)
    for name, part in listed.items():
        inside = [f.start <= part["start"] and part["end"] <= f.stop for f in found]
        across = [f.start < part["end"] and part["start"] < f.stop for f in found]
        if name.endswith("rot"):
            assert not any(
                f.start < part["end"] - 5 and part["start"] + 5 < f.stop for f in found
            ), name
        else:
            assert sum(inside) == sum(across) == 1, name


@pytest.mark.parametrize("trial", ["01_slow_rotation", "06_fast_rotation", "15_fast_translation"])
def test_a_recording_moves_where_it_was_marked(recordings: Path, trial: str) -> None:
    file = recordings / f"broad_{trial}_A_95hz_ned.csv"
    log = np.genfromtxt(file, delimiter=",", names=True)
    rates, forces = (
        np.stack([log[f"{letter}{axis}_{unit}"] for axis in "xyz"], axis=1)
        for letter, unit in (("g", "rad_s"), ("a", "m_s2"))
    )
    still = np.zeros(len(log), dtype=bool)
    for part in static_intervals(rates, forces, 1 / 95.24):
        still[part] = True
    assert (still == (log["moving"] == 0)).mean() > 0.97


REFUSED = {
    "lengths": (np.zeros((3, 3)), np.zeros((4, 3)), 0.01, 1.0, "as many rows in each of"),
    "dt": (np.zeros((3, 3)), np.zeros((3, 3)), -0.01, 1.0, "dt: expected seconds, not negative"),
    "shortest": (np.zeros((3, 3)), np.zeros((3, 3)), 0.01, 0.0, "shortest: expected a positive"),
}


@pytest.mark.parametrize(
    ("rates", "forces", "dt", "shortest", "message"), REFUSED.values(), ids=REFUSED
)
def test_what_cannot_be_searched_is_refused(
    rates: Floats, forces: Floats, dt: float, shortest: float, message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        static_intervals(rates, forces, dt, shortest=shortest)
