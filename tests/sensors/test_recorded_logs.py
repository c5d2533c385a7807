"""Logs that others recorded: what is found in them, and what becomes of faults planted there."""

from pathlib import Path
from typing import Any

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


ORDERS = {"swapped": [1, 0, 2], "also swapped": [0, 2, 1]}
SIGNS = {f"{axis} flipped": np.where(np.arange(3) == n, -1, 1) for n, axis in enumerate("xyz")}
FILES = {
    "xio_fusion_sensor_data.csv": ("gyro", "accel", "mag"),
    "imucal_ferraris_session.csv": ("gyro", "accel"),
    "ckexplorer_acc_mag_log.csv": ("accel", "mag"),
}


@pytest.mark.parametrize(
    ("name", "sensor"), [(n, s) for n, all_of in FILES.items() for s in all_of]
)
def test_faults_planted_in_recordings(recordings: Path, name: str, sensor: str) -> None:
    table = read_text(recordings / name, None)
    columns = {quantity: values for quantity, values in table.values.items() if quantity != "time"}
    settings: dict[str, Any] = {"rate": 102.4}
    if "gyro" in columns:
        settings["units"] = {"gyro": "deg/s"}
    right = read_log(columns, **settings).report()
    assert not any("same axes" in said for said in right.cannot_tell)
    turned = [columns[sensor][:, order] for order in ORDERS.values()]
    turned += [columns[sensor] * sign for sign in SIGNS.values()]
    for wrong in turned:
        with pytest.raises(ValueError, match=f"axes: expected the same of .*{sensor}"):
            read_log(columns | {sensor: wrong}, **settings)
    if sensor == "gyro":
        with pytest.raises(ValueError, match=r"axes: expected the same of .*'-x -y -z'"):
            read_log(columns | {"gyro": -columns["gyro"]}, **settings)
        with pytest.raises(ValueError, match="gyro: expected rates in rad/s"):
            read_log(columns, rate=102.4, units={"gyro": "rad/s"})
    if sensor == "accel":
        other = "m/s^2" if right.units["accel"] == "g" else "g"
        with pytest.raises(ValueError, match="accel: expected a norm of"):
            read_log(columns, **settings | {"units": settings.get("units", {}) | {"accel": other}})
    with pytest.raises(ValueError, match="rate: expected one of a sensor"):
        read_log(columns, **settings | {"rate": 0.1024})


@pytest.mark.parametrize("name", FILES)
def test_what_no_log_tells_is_said(recordings: Path, name: str) -> None:
    """Faults that obey all equations: read, and named as what cannot be told."""
    table = read_text(recordings / name, None)
    columns = {quantity: values for quantity, values in table.values.items() if quantity != "time"}
    settings: dict[str, Any] = {"rate": 102.4}
    if "gyro" in columns:
        settings["units"] = {"gyro": "deg/s"}
    for faulty in (columns, columns | {"accel": -columns["accel"]}):
        said = read_log(faulty, **settings).report().cannot_tell
        assert any("whether the accelerometer is negated" in each for each in said)
        assert ("whether the magnetometer is negated" in said) == ("mag" in columns)
    if "mag" in columns:
        negated = read_log(columns | {"mag": -columns["mag"]}, **settings).report()
        assert "whether the magnetometer is negated" in negated.cannot_tell
    # All sensors in other axes alike: found by the first rest, where the axes are said.
    alike = {sensor: columns[sensor][:, [2, 0, 1]] for sensor in FILES[name]}
    report = read_log(columns | alike, **settings).report()
    assert any("z is not near the vertical" in each for each in report.warnings)


# Of z up given as z down, and the other way round, the first rest tells if it is level.
UPSIDE_DOWN = {
    "xio_fusion_sensor_data.csv": "frd",
    "ckexplorer_acc_mag_log.csv": "flu",
    "imucal_ferraris_session.csv": None,
}


@pytest.mark.parametrize("name", UPSIDE_DOWN)
def test_axes_given_upside_down(recordings: Path, name: str) -> None:
    wrong = UPSIDE_DOWN[name]
    if wrong is None:
        for axes in ("frd", "flu"):
            report = read_log(recordings / name, axes=axes).report()
            assert "whether the accelerometer is negated" in report.cannot_tell
            assert any("does not lie level" in each for each in report.warnings)
    else:
        with pytest.raises(ValueError, match="axes: expected a specific force that points up"):
            read_log(recordings / name, axes=wrong)


def test_a_rest_without_times_is_told_in_rows(recordings: Path) -> None:
    text = str(read_log(recordings / "imucal_ferraris_session.csv").report())
    assert "rests: 13, the first at line 2 (accel, 300 rows)" in text
    assert "nan" not in text
