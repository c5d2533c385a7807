"""Which gyro axis is which axis of another sensor."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import chr_notes
from chr_notes import relate_axes
from chr_notes.sensors.axes import _SIGNED
from tests.sampling import few

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
STEP = 0.01
FIELD = np.array([20.0, 0.0, 43.0])


def turned_by_hand(seed: int, seconds: float = 40.0) -> tuple[Floats, Floats]:
    """Body rates and attitudes of a sensor that is turned about all axes."""
    generator = np.random.default_rng(seed)
    time = np.arange(0, seconds, STEP)
    phases, speeds = generator.uniform(0, 2 * np.pi, (2, 3)), generator.uniform(0.8, 2.0, (2, 3))
    rates = sum(
        1.2 * np.sin(np.outer(time, speed) + phase)
        for speed, phase in zip(speeds, phases, strict=True)
    )
    euler = chr_notes.integrate_gyro(rates, STEP)
    return np.asarray(rates), chr_notes.quaternion_from_euler(euler)


RATES, ATTITUDES = turned_by_hand(1)
MAG = chr_notes.rotate_to_body(ATTITUDES, FIELD)
ACCEL = chr_notes.rotate_to_body(ATTITUDES, [0.0, 0.0, -9.80665])


@given(seeds, st.sampled_from(range(48)), st.sampled_from([1.0, 57.29578, 1000.0]))
@few(25)
def test_every_signed_permutation_is_found_with_its_unit(
    seed: int, which: int, unit: float
) -> None:
    generator = np.random.default_rng(seed)
    rates, attitudes = turned_by_hand(seed)
    field = chr_notes.rotate_to_body(attitudes, FIELD) + generator.normal(0, 0.5, rates.shape)
    read = unit * (rates + generator.normal(0, 0.01, rates.shape)) @ _SIGNED[which]
    found = relate_axes(read, field, STEP)
    assert found.known
    assert_array_equal(found.permutation, _SIGNED[which])
    assert_allclose(found.factor * unit, 1, atol=0.03)
    # The less there is of turns about some line, the less is known of what the gyro reads along it.
    weakest = np.linalg.svd(rates / np.sqrt(len(rates)), compute_uv=False)[-1]
    assert_allclose(found.matrix * unit, _SIGNED[which], atol=0.02 / weakest)
    assert found.explained > 0.9


def test_gravity_tells_too_while_the_body_does_not_accelerate() -> None:
    found = relate_axes(RATES[:, [2, 0, 1]], ACCEL, STEP)
    assert found.known
    assert_array_equal(found.permutation @ [3, 1, 2], [1, 2, 3])


def test_a_sensor_that_is_negated_reads_the_same_equation() -> None:
    assert_allclose(relate_axes(RATES, -MAG, STEP).matrix, relate_axes(RATES, MAG, STEP).matrix)


def test_an_axis_of_the_sensor_that_is_negated_looks_like_half_a_turn() -> None:
    found = relate_axes(RATES, MAG * [-1, 1, 1], STEP)
    assert_array_equal(found.permutation, np.diag([1, -1, -1]))


def test_turns_about_one_axis_leave_candidates_of_one_unit() -> None:
    time = np.arange(0, 30, STEP)
    rates = np.zeros((len(time), 3))
    rates[:, 2] = np.sin(2 * time)
    attitudes = chr_notes.quaternion_from_euler(chr_notes.integrate_gyro(rates, STEP))
    noise = np.random.default_rng(0).normal(0, 0.3, (len(time), 3))
    found = relate_axes(np.degrees(rates), chr_notes.rotate_to_body(attitudes, FIELD) + noise, STEP)
    assert not found.known
    assert str(found).startswith("cannot tell")
    assert any((candidate == np.eye(3)).all() for candidate in found.candidates)
    # Where z reads is known; the other two columns are not.
    assert {tuple(candidate[:, 2]) for candidate in found.candidates} == {(0, 0, 1)}
    assert_allclose(found.factors, np.radians(1), rtol=0.05)


def test_a_body_that_is_pushed_more_than_turned_cannot_tell() -> None:
    pushes = np.random.default_rng(3).normal(0, 4.0, (len(RATES) // 20, 3)).repeat(20, axis=0)
    found = relate_axes(RATES, ACCEL + pushes, STEP)
    assert not found.known
    assert len(found.candidates) == 48
    assert np.isnan(found.factors).all()


@pytest.mark.parametrize(
    ("rates", "vector"),
    [
        (np.zeros((500, 3)), np.tile(FIELD, (500, 1))),
        (np.random.default_rng(0).normal(0, 1e-3, (4000, 3)), np.tile(FIELD, (4000, 1))),
        (RATES, np.random.default_rng(1).normal(size=RATES.shape)),
        (RATES, np.zeros_like(RATES)),
        (np.full((500, 3), np.nan), np.tile(FIELD, (500, 1))),
        (np.zeros((0, 3)), np.zeros((0, 3))),
        (RATES[:2], MAG[:2]),
    ],
)  # fmt: skip
def test_without_turns_nothing_is_told(rates: Floats, vector: Floats) -> None:
    found = relate_axes(rates, vector, STEP)
    assert not found.known
    assert found.certainty < 3


def test_damaged_rows_gaps_and_a_magnet_that_passes_do_no_harm() -> None:
    rates, field, steps = RATES.copy(), MAG.copy(), np.full(len(RATES), STEP)
    rates[::97], field[50::131] = np.nan, np.inf
    field[1000:1300] += 60.0 * np.sin(np.linspace(0, np.pi, 300))[:, np.newaxis]
    rates, field, steps = (
        np.delete(each, slice(2000, 2300), axis=0) for each in (rates, field, steps)
    )
    steps[2000] = 3.01
    found = relate_axes(np.degrees(rates[:, [1, 2, 0]]), field, steps)
    assert found.known
    assert_array_equal(found.permutation @ [2, 3, 1], [1, 2, 3])
    assert str(found).startswith("x, y, z are the gyro's z, x, y, in deg/s (explains ")
    assert found.explained > 0.8


@pytest.mark.parametrize("trial", ["01_slow_rotation", "06_fast_rotation", "15_fast_translation"])
def test_recordings_with_permuted_axes_in_degrees(recordings: Path, trial: str) -> None:
    log = np.genfromtxt(recordings / f"broad_{trial}_A_95hz_ned.csv", delimiter=",", names=True)
    rates = np.stack([log[f"g{axis}_rad_s"] for axis in "xyz"], axis=1)
    field = np.stack([log[f"m{axis}_uT"] for axis in "xyz"], axis=1)
    force = np.stack([log[f"a{axis}_m_s2"] for axis in "xyz"], axis=1)
    wrong = np.degrees(rates[:, [1, 2, 0]] * [1, -1, 1])
    found = relate_axes(wrong, field, 1 / 95.238)
    assert found.known
    assert_array_equal(found.permutation @ [2, -3, 1], [1, 2, 3])
    assert_allclose(np.degrees(found.factor), 1, atol=0.03)
    by_force = relate_axes(wrong, force, 1 / 95.238)
    if by_force.known:  # not where the body is thrown about
        assert_array_equal(by_force.permutation, found.permutation)
    assert by_force.known == (trial != "15_fast_translation")


REFUSED = {
    "one sample": ((RATES[0], MAG[0], STEP), r"body_rates: expected shape \(N, 3\), got \(3,\)"),
    "lengths that differ": ((RATES, MAG[1:], STEP), "expected as many rows in each of body_rates"),
    "a step of NaN": ((RATES, MAG, np.nan), "dt: expected seconds, not negative, got nan"),
}


@pytest.mark.parametrize(("given_", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(given_: tuple[Any, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        relate_axes(*given_)
