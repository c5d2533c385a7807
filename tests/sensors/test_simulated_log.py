"""The simulated log: its vices are there, and without them it is the truth."""

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import chr_notes
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.sensors import simulated_log as module
from chr_notes.sensors.simulated_log import SimulatedLog, simulated_log

Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def log() -> SimulatedLog:
    return simulated_log()


def read(log: SimulatedLog, name: str) -> Floats:
    """Three columns in the axes of the package."""
    values = [value for column, value in log.columns.items() if column.startswith(name)]
    return chr_notes.change_axes(np.stack(values, axis=1), "flu", "frd")


def test_it_is_the_same_for_the_same_seed_and_another_for_another(log: SimulatedLog) -> None:
    again, other = simulated_log(), simulated_log(1)
    for name, values in log.columns.items():
        assert_array_equal(again.columns[name], values)
    assert (other.columns["acc_x_g"][:100] != log.columns["acc_x_g"][:100]).any()


def test_corrected_by_its_own_sensors_it_is_the_truth(log: SimulatedLog) -> None:
    force = log.accel.correct(read(log, "acc") * STANDARD_GRAVITY)
    ideal = chr_notes.accelerometer_from_acceleration(log.truth.acceleration, log.truth.euler)
    quiet = log.truth.time < module.MOTOR[0]
    assert np.nanmedian(np.abs(force - ideal)[quiet]) < 0.03
    rates = log.gyro.correct(np.radians(read(log, "gyro")), ideal, log.temperature)
    assert np.nanmedian(np.abs(rates - log.truth.body_rates)) < 0.004
    field = log.mag.correct(read(log, "mag"))
    norm = np.linalg.norm(field, axis=1)[log.truth.time < module.MAGNET[0]]
    assert_allclose(np.nanmedian(norm), np.linalg.norm([20.0, 1.0, 44.0]), rtol=0.02)
    assert np.nanpercentile(np.abs(norm - np.nanmedian(norm)), 99) < 3


def test_its_vices_are_there(log: SimulatedLog) -> None:
    steps = np.diff(log.columns["time_ms"])
    assert steps.min() > 0
    assert (steps > 400).sum() == 1
    assert 0.5 < steps[steps < 100].std() < 2
    gyro, accel, mag = (
        np.stack([v for k, v in log.columns.items() if k.startswith(n)])
        for n in ("gyro", "acc", "mag")
    )
    for values in (gyro, accel, mag):
        assert np.isnan(values).any(axis=0).sum() == 4
    assert (np.abs(gyro) == module.RANGE_DEG).any(axis=0).sum() > 10
    assert (accel == 16).all(axis=0).sum() == 5
    assert (mag == -4096).all(axis=0).sum() == 5
    # z up, in g, out of scale.
    assert 0.9 < np.nanmean(accel[2, :100]) < 1.1
    # The bias at rest is another one once the sensor is warm.
    first, last = slice(0, 190), slice(-300, None)
    away = np.nanmedian(gyro[:, last], axis=1) - np.nanmedian(gyro[:, first], axis=1)
    assert (np.abs(away) > 0.1).all()
    motor = (log.truth.time >= module.MOTOR[0]) & (log.truth.time < module.MOTOR[1])
    assert np.nanstd(accel[2, motor]) > 0.2
    assert np.nanstd(accel[2, -300:]) < 0.01


def test_it_rests_in_six_positions(log: SimulatedLog) -> None:
    down = chr_notes.matrix_from_euler(log.truth.euler)[..., 2]
    still = ~log.truth.body_rates.any(axis=1)
    rest = down[still & (log.truth.time < 49)].round(6) + 0.0
    assert len(np.unique(rest, axis=0)) == 6


def test_the_file_holds_what_the_columns_do(log: SimulatedLog, tmp_path: Path) -> None:
    log.write_csv(tmp_path / "log.csv")
    back = np.genfromtxt(tmp_path / "log.csv", delimiter=",", names=True)
    assert back.dtype.names == tuple(log.columns)
    for name, values in log.columns.items():
        assert_allclose(back[name], values, rtol=1e-8)
