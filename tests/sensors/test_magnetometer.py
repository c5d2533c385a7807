"""Calibration of magnetometers, simulated and recorded."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from chr_notes import (
    CalibrationWarning,
    MagnetometerCalibration,
    fit_ellipsoid,
    fit_hard_iron,
    fit_magnetometer,
    matrix_from_euler,
)
from tests.sampling import few

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
HARD_IRON = np.array([120.0, -45.0, 300.0])


def recorded(recordings: Path, file: str) -> Floats:
    return np.loadtxt(recordings / file, delimiter=",", skiprows=1)


def turned_about(generator: np.random.Generator, count: int = 600) -> Floats:
    """A field of strength 50, seen from all around."""
    field = generator.normal(size=(count, 3))
    return 50 * field / np.linalg.norm(field, axis=1, keepdims=True)


def largest_angle(found: MagnetometerCalibration, samples: Floats, actual: Floats) -> float:
    corrected = found.correct(samples)
    along = (corrected * actual).sum(axis=1) / 50 / np.linalg.norm(corrected, axis=1)
    return float(np.degrees(np.arccos(np.clip(along, -1, 1))).max())


@given(seeds)
@few(25)
def test_iron_is_found_up_to_a_rotation(seed: int) -> None:
    generator = np.random.default_rng(seed)
    soft_iron = np.eye(3) + generator.uniform(-0.2, 0.2, (3, 3))
    iron = MagnetometerCalibration(soft_iron, generator.uniform(-50, 50, 3))
    field = generator.normal(size=(200, 3))
    field *= 50 / np.linalg.norm(field, axis=1, keepdims=True)
    found = fit_magnetometer(iron.measure(field))
    norms = np.linalg.norm(found.correct(iron.measure(field)), axis=1)
    assert_allclose(norms, norms[0], rtol=1e-8)
    assert_allclose(found.soft_iron, found.soft_iron.T, atol=1e-12)
    assert_allclose(np.linalg.det(found.soft_iron), 1)
    # What the iron left, undone by what was found, is a rotation and a scale.
    rest = soft_iron @ np.linalg.inv(found.soft_iron)
    assert_allclose(rest @ rest.T, np.cbrt(np.linalg.det(rest)) ** 2 * np.eye(3), atol=1e-7)


@pytest.mark.parametrize(
    ("file", "columns", "largest"),
    [("bazhin_mag_cloud.csv", [0, 1, 2], 0.022), ("ckexplorer_acc_mag_log.csv", [3, 4, 5], 0.014)],
)
def test_recorded_fields_are_calibrated(
    recordings: Path, file: str, columns: list[int], largest: float
) -> None:
    samples = recorded(recordings, file)[:, columns]
    norms = np.linalg.norm(fit_magnetometer(samples).correct(samples), axis=1)
    assert np.std(norms) / np.mean(norms) <= largest


def test_a_cloud_that_is_no_ellipsoid_is_refused() -> None:
    with pytest.raises(ValueError, match="samples: expected at least 10 rows"):
        fit_magnetometer(np.eye(3))


@given(seeds, st.sampled_from([3.0, 4.0, 1e3, 1e9]))
@example(67729102, 3.0)
@few(8)
def test_spikes_cost_no_direction(seed: int, size: float) -> None:
    generator = np.random.default_rng(seed)
    actual = turned_about(generator)
    clean = actual + HARD_IRON + generator.normal(0, 0.3, actual.shape)
    spiked = clean.copy()
    rows = np.sort(generator.permutation(600)[:6])
    spiked[rows, generator.integers(0, 3, 6)] += size * 50 * generator.choice([-1, 1], 6)
    with pytest.warns(CalibrationWarning, match=r"left out [67] of 600 rows .* off, \d+ \["):
        found = fit_magnetometer(spiked)
    assert largest_angle(found, actual + HARD_IRON, actual) < 0.3
    # Noise alone may bring one more, as in `test_noise_alone_is_no_outlier`.
    outliers = fit_ellipsoid(spiked).outliers
    assert set(rows) <= set(outliers)
    assert len(outliers) <= len(rows) + 1


@pytest.mark.parametrize("value", [0.0, -4096.0, 32767.0])
@pytest.mark.parametrize("count", [1, 3, 100])
def test_dropped_reads_and_overflow_codes_are_named_as_rows(value: float, count: int) -> None:
    generator = np.random.default_rng(1)
    actual = turned_about(generator)
    samples = actual + HARD_IRON + generator.normal(0, 0.3, actual.shape)
    samples[5 : 5 + count] = value
    with pytest.warns(CalibrationWarning, match=rf"left out {count} of 600 rows .* off, 5 \["):
        found = fit_magnetometer(samples)
    assert largest_angle(found, actual + HARD_IRON, actual) < 0.3


def test_rows_are_counted_with_those_of_nan() -> None:
    generator = np.random.default_rng(2)
    samples = turned_about(generator)
    samples[3], samples[7] = np.nan, 1e4
    assert fit_ellipsoid(samples).outliers.tolist() == [7]


def test_noise_alone_is_no_outlier(samples: Callable[[int, int], int]) -> None:
    for seed in range(samples(6, 20)):
        generator = np.random.default_rng(seed)
        field = turned_about(generator, 2000) + generator.normal(0, 1.0, (2000, 3))
        assert len(fit_ellipsoid(field).outliers) <= 1


def test_too_many_outliers_are_refused() -> None:
    generator = np.random.default_rng(3)
    samples = turned_about(generator)
    samples[:160] = generator.normal(0, 300, (160, 3))
    with pytest.raises(ValueError, match="from all around of which more than a quarter lie off"):
        fit_magnetometer(samples)
    samples[:160] = 1000.0
    with pytest.raises(ValueError, match=r"160 of 600 rows lie far off .* row 0"):
        fit_magnetometer(samples)


def test_a_sensor_that_rests_most_of_the_time_is_calibrated_all_the_same() -> None:
    generator = np.random.default_rng(4)
    actual = np.concatenate([turned_about(generator, 300), np.tile([[30.0, 0.0, 40.0]], (5000, 1))])
    samples = actual + HARD_IRON + generator.normal(0, 0.3, actual.shape)
    assert largest_angle(fit_magnetometer(samples), actual + HARD_IRON, actual) < 0.3


def test_a_long_rest_in_a_disturbed_place_does_not_bend_the_sphere() -> None:
    generator = np.random.default_rng(13)
    about, rest = turned_about(generator, 3000), np.tile([[30.3, 0.0, 40.4]], (9000, 1))
    samples = np.concatenate([about, rest]) + generator.normal(0, 0.3, (12000, 3))
    assert largest_angle(fit_magnetometer(samples), about, about) < 0.3


def test_a_field_that_varies_from_place_to_place_is_not_called_faulty() -> None:
    generator = np.random.default_rng(14)
    field = turned_about(generator, 4000) * (1 + generator.normal(0, 0.003, (4000, 1)))
    field[:400] *= np.linspace(1.0, 1.1, 400)[:, np.newaxis]
    with pytest.warns(
        CalibrationWarning, match=r"left out \d+ of 4000 .* differs from place"
    ) as said:
        fit_magnetometer(field)
    assert "spikes" not in str(said[0].message)
    field[7] = 4096
    with pytest.warns(
        CalibrationWarning, match=r"off, 7 \[4096.* codes; and \d+ of them .* place to"
    ):
        fit_magnetometer(field)


@given(seeds, st.floats(1e-3, 1e3))
@few(25)
def test_the_strength_of_the_field_may_be_given(seed: int, field: float) -> None:
    generator = np.random.default_rng(seed)
    iron = MagnetometerCalibration(np.eye(3) + generator.uniform(-0.1, 0.1, (3, 3)), HARD_IRON)
    samples = iron.measure(turned_about(generator, 100))
    found = fit_magnetometer(samples, field)
    assert_allclose(np.linalg.norm(found.correct(samples), axis=1), field, rtol=1e-7)


def test_a_sensor_that_was_not_turned_is_told_so() -> None:
    samples = np.random.default_rng(13).normal([20.0, 0.0, 45.0], 0.3, (1000, 3))
    with pytest.raises(ValueError, match=r"vary by 0\.\d% of their size: was the sensor turned"):
        fit_magnetometer(samples)


def test_a_row_without_end_is_as_good_as_none() -> None:
    samples = turned_about(np.random.default_rng(14))
    samples[[3, 4, 5]] = [[np.inf, 0, 0], [1e300, 0, 0], [np.nan, 0, 0]]
    assert_allclose(fit_magnetometer(samples).hard_iron, 0, atol=1e-9)


def test_a_height_without_end_is_as_good_as_none_for_a_level_vehicle() -> None:
    turned = np.linspace(0, 2 * np.pi, 200)
    samples = np.c_[20 * np.cos(turned) + 3, 20 * np.sin(turned) + 4, np.full(200, 40.0)]
    samples[5, 2] = np.inf
    assert_allclose(fit_hard_iron(samples).hard_iron, [3, 4, 0], atol=0.2)


def test_poses_count_once_however_often_they_are_read() -> None:
    generator = np.random.default_rng(5)
    poses = np.repeat(turned_about(generator, 8), 50, axis=0)
    samples = poses + generator.normal(0, 0.1, poses.shape)
    with pytest.raises(
        ValueError, match=r"at least 9 directions.* got 8, each read many times \(400 rows\)"
    ):
        fit_magnetometer(samples)


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("sign", [1, -1])
def test_what_is_missing_is_said(axis: int, sign: int) -> None:
    actual = turned_about(np.random.default_rng(6), 3000)
    half = actual[sign * actual[:, axis] < -0.4 * 50] + HARD_IRON
    side = f"{'+' if sign > 0 else '-'}{'xyz'[axis]}"
    with pytest.raises(ValueError, match=rf"within \d+° of \{side} of the sensor: turn that side"):
        fit_magnetometer(half)


def vehicle(generator: np.random.Generator, tilt: float, down: float = 45.0) -> Floats:
    """What a vehicle reads that is driven about and tilts a little."""
    tilts = np.radians(generator.uniform(-tilt, tilt, (600, 2)))
    euler = np.column_stack([tilts, generator.uniform(0, 2 * np.pi, 600)])
    actual = matrix_from_euler(euler) @ [20.0, 0.0, down]
    noise = generator.normal([12.0, -4.0, 30.0], 0.3, actual.shape)
    return np.asarray(actual + noise)


@given(seeds, st.floats(0, 30), st.sampled_from([45.0, -45.0]))
def test_a_vehicle_that_is_never_turned_over_has_a_way_out(
    seed: int, tilt: float, down: float
) -> None:
    samples = vehicle(np.random.default_rng(seed), tilt, down)
    found = fit_hard_iron(samples, field=(20.0, down))
    assert_allclose(found.hard_iron, [12.0, -4.0, 30.0], atol=0.3)


def test_a_known_strength_is_enough_where_the_vehicle_tilts() -> None:
    samples = vehicle(np.random.default_rng(7), 10.0)
    found = fit_hard_iron(samples, field=float(np.hypot(20, 45)))
    assert_allclose(found.hard_iron, [12.0, -4.0, 30.0], atol=0.3)


def test_a_level_vehicle_finds_the_iron_in_the_plane() -> None:
    found = fit_hard_iron(vehicle(np.random.default_rng(8), 0.0))
    assert_allclose(found.hard_iron, [12.0, -4.0, 0.0], atol=0.1)


@pytest.mark.parametrize("field", [None, (20.0, 45.0)])
def test_outliers_of_a_vehicle_are_left_out(field: tuple[float, float] | None) -> None:
    samples = vehicle(np.random.default_rng(9), 0.0)
    samples[[5, 70]], samples[100:103, 0] = [[0.0, 0.0, 0.0], [-4096.0] * 3], 200.0
    with pytest.warns(CalibrationWarning, match="left out 5 of 600 rows that lie far off, 5 "):
        found = fit_hard_iron(samples, field)
    assert_allclose(found.hard_iron[:2], [12.0, -4.0], atol=0.3)


LEVEL = vehicle(np.random.default_rng(10), 0.0)
REFUSED = {
    "few": (LEVEL[:5], None, "samples: expected at least 6 rows without NaN, got 5"),
    "flat": (LEVEL, float(np.hypot(20, 45)), r"give both parts, field=\(horizontal, down\)"),
    "no turn": (LEVEL[LEVEL[:, 0] > 20], None, "at least half a turn of heading, got"),
    "weak field": (LEVEL, 0.0, "field: expected a positive number, got 0"),
    "three parts": (LEVEL, (1.0, 2.0, 3.0), r"field: expected a strength, or \(horizontal, down\)"),
    "no down": (LEVEL, (20.0, 0.0), r"field: expected a strength, or \(horizontal, down\)"),
    "equal rows": (np.ones((20, 3)), None, "samples: expected readings around a circle"),
}


@pytest.mark.parametrize(("samples", "field", "message"), REFUSED.values(), ids=REFUSED)
def test_a_vehicle_that_tells_too_little_is_refused(
    samples: Floats, field: float | tuple[float, ...] | None, message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        fit_hard_iron(samples, field)


def test_a_field_without_strength_is_refused() -> None:
    with pytest.raises(ValueError, match="field: expected a positive number, got -1"):
        fit_magnetometer(turned_about(np.random.default_rng(11)), field=-1.0)


def test_a_spiked_recording_is_calibrated_as_without(recordings: Path) -> None:
    samples = recorded(recordings, "ckexplorer_acc_mag_log.csv")[:, 3:]
    clean = fit_magnetometer(samples)
    generator = np.random.default_rng(12)
    rows = generator.permutation(12000)[:120]
    spiked = samples.copy()
    spiked[rows, generator.integers(0, 3, 120)] += 1.2
    with pytest.warns(CalibrationWarning, match="left out 120 of 12000 rows"):
        found = fit_magnetometer(spiked)
    assert_allclose(found.correct(samples), clean.correct(samples), atol=0.001)
