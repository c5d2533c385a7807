"""Logs of sensors: what is read, in which units and axes."""

from pathlib import Path

import numpy as np
from numpy.testing import assert_allclose

from chr_notes import read_log

HEADER = "Time (s),Gyro X (deg/s),Gyro Y (deg/s),Gyro Z (deg/s),ax_g,ay_g,az_g,mx,my,mz"


def test_a_log_with_units_in_its_names(tmp_path: Path) -> None:
    rows = np.arange(30.0).reshape(3, 10)
    rows[:, 0] = [0.0, 0.01, 0.03]
    path = tmp_path / "log.csv"
    np.savetxt(path, rows, delimiter=",", header=HEADER, comments="")
    recording = read_log(path, axes="flu")
    assert_allclose(recording.time, rows[:, 0])
    assert_allclose(recording.dt, [0.015, 0.01, 0.02])
    assert_allclose(recording.body_rates, np.radians(rows[:, 1:4]) * [1, -1, -1])
    assert_allclose(recording.accel, 9.80665 * rows[:, 4:7] * [1, -1, -1])
    assert_allclose(recording.mag, rows[:, 7:] * [1, -1, -1])
    assert recording.report().samples == 3
