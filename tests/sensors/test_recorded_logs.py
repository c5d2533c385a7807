"""Logs that others recorded: what is found in them, and what becomes of faults planted there."""

from pathlib import Path

import numpy as np
import pytest

from chr_notes import read_log
from chr_notes.sensors.columns import select
from chr_notes.sensors.log_table import read_text

# Units of gyro and accelerometer, axes, rate.
FOUND = {
    "broad_01_slow_rotation_A_95hz_ned.csv": ("rad/s", "m/s^2", "x y z", 95.2),
    "broad_06_fast_rotation_A_95hz_ned.csv": ("rad/s", "m/s^2", "x y z", 95.2),
    "broad_15_fast_translation_A_95hz_ned.csv": ("rad/s", "m/s^2", "x y z", 95.2),
    "xio_fusion_sensor_data.csv": ("deg/s", "g", "x -y -z", 99.2),
    "xio_gait_short_walk.csv": ("deg/s", "g", "x -y -z", 398.3),
    "ckexplorer_acc_mag_log.csv": (None, "g", "x y z", None),
    "imucal_ferraris_session.csv": ("deg/s", "m/s^2", "x y z", None),
}


@pytest.mark.parametrize("name", FOUND)
def test_each_recording_is_read(recordings: Path, name: str) -> None:
    found = read_log(recordings / name)
    report = found.report()
    gyro, accel, axes, rate = FOUND[name]
    assert (report.units.get("gyro"), report.units["accel"]) == (gyro, accel)
    assert report.axes == axes
    assert report.rate == (rate and pytest.approx(rate, abs=0.05))
    values = np.genfromtxt(recordings / name, delimiter=",", skip_header=1)
    raw = values[:, list(select(report_names(recordings / name))["accel"].places)]
    assert found.accel is not None
    signs = [1, -1, -1] if "-" in axes else [1, 1, 1]
    factor = 9.80665 if accel == "g" else 1.0
    np.testing.assert_allclose(found.accel[0], raw[0] * factor * signs, rtol=1e-14)


def report_names(path: Path) -> tuple[str, ...]:
    return read_text(path, None).names


SWAPPED, FLIPPED = ([1, 0, 2], [1, 1, 1]), ([0, 1, 2], [1, -1, 1])
NEGATED = ([0, 1, 2], [-1, -1, -1])
# What the physics decides in these files; in others it says that it cannot tell.
DECIDED = {
    ("xio_fusion_sensor_data.csv", "gyro"): [SWAPPED, FLIPPED, NEGATED],
    ("xio_fusion_sensor_data.csv", "mag"): [SWAPPED, FLIPPED],
    ("imucal_ferraris_session.csv", "gyro"): [SWAPPED, NEGATED],
    ("imucal_ferraris_session.csv", "accel"): [SWAPPED, FLIPPED],
}


@pytest.mark.parametrize(("name", "sensor"), DECIDED)
def test_faults_planted_in_recordings(recordings: Path, name: str, sensor: str) -> None:
    table = read_text(recordings / name, None)
    columns = {
        f"{quantity}.{axis}": values[:, place]
        for quantity, values in table.values.items()
        if quantity != "time"
        for place, axis in enumerate("xyz")
    }
    units = {"gyro": "deg/s"}
    right = read_log(columns, units=units, rate=102.4).report()
    for order, signs in DECIDED[name, sensor]:
        wrong = dict(columns)
        for place, axis in enumerate("xyz"):
            wrong[f"{sensor}.{axis}"] = signs[place] * columns[f"{sensor}.{'xyz'[order[place]]}"]
        with pytest.raises(ValueError, match="in the same axes"):
            read_log(wrong, units=units, rate=102.4)
    with pytest.raises(ValueError, match="gyro: expected rates in rad/s"):
        read_log(columns, units={"gyro": "rad/s"}, rate=102.4)
    assert not any("in the same axes" in said for said in right.warnings)
