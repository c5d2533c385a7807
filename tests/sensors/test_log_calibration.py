"""Calibration of a recording from itself."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import chr_notes
from chr_notes import CalibrationWarning, Recording, calibrate_recording
from chr_notes.sensors import simulated_log
from chr_notes.sensors.recording import counted

Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def desk() -> tuple[Recording, Floats]:
    """The log of the chapter, and the attitudes that it was simulated with."""
    simulated = simulated_log.simulated_log()
    attitudes = chr_notes.quaternion_from_euler(simulated.truth.euler)
    return chr_notes.read_log(simulated.columns), attitudes


def errors(euler: Floats, truth: Floats) -> tuple[float, float]:
    """Tilt, root mean square, and the median of heading, degrees."""
    known = np.isfinite(euler).all(axis=1)
    found, true = chr_notes.quaternion_from_euler(euler[known]), truth[known]
    tilt = chr_notes.angle_between_verticals(found, true)
    yaw = chr_notes.euler_from_quaternion(true, on_gimbal_lock="ignore")[:, 2]
    heading = chr_notes.wrap_angle(euler[known, 2] - yaw)
    return float(np.degrees(np.sqrt(np.mean(tilt**2)))), float(np.degrees(np.median(abs(heading))))


def test_a_raw_log_gives_angles_that_hold(desk: tuple[Recording, Floats]) -> None:
    log, truth = desk
    with pytest.warns(CalibrationWarning) as said:
        raw = chr_notes.averaged_attitude(log.body_rates, log.accel, log.dt, mag=log.mag)
    texts = [str(each.message) for each in said]
    assert any(text.startswith("accel: expected one norm at rest") for text in texts)
    assert any(text.startswith("mag: expected a field of one strength") for text in texts)
    tilt, heading = errors(raw.euler, truth)
    assert tilt > 2
    assert heading > 30
    found = calibrate_recording(log)
    mine = found.recording
    after = chr_notes.averaged_attitude(
        mine.body_rates, mine.accel, mine.dt, mag=mine.mag, bias=found.bias
    )
    tilt, heading = errors(after.euler, truth)
    assert tilt < 0.6
    assert heading < 4
    known = np.isfinite(after.euler).all(axis=1)
    attitudes = chr_notes.quaternion_from_euler(after.euler[known])
    assert (
        chr_notes.angle_between_verticals(attitudes, truth[known]) < after.tilt_bound[known]
    ).all()
    assert not found.left
    assert np.nanmax(raw.tilt_bound) <= np.pi


def test_what_a_log_lacks_is_said(desk: tuple[Recording, Floats]) -> None:
    log, _ = desk
    cool = calibrate_recording(replace(log, temperature=None))
    assert any("one bias for all temperatures" in each for each in cool.done)
    timeless = calibrate_recording(replace(log, dt=None, time=None))
    assert any("pass rate= to read_log, in Hz" in each for each in timeless.left)
    assert timeless.bias == "stillest"
    still = calibrate_recording(replace(log, mag=np.tile([20.0, 0.0, 40.0], (len(log.mag), 1))))
    assert still.left[0].startswith("magnetometer: samples: expected readings from many")
    short = slice(0, 2000)
    part = {name: getattr(log, name)[short] for name in ("body_rates", "accel", "dt")}
    few = calibrate_recording(replace(log, mag=None, temperature=None, time=None, **part))
    assert "expected at least 6" in few.left[0]
    assert (
        few.left[1] == "magnetometer: there is none in the log, and yaw comes from the gyro alone"
    )


def test_a_fit_that_makes_a_recording_worse_is_not_taken(recordings: Path) -> None:
    log = chr_notes.read_log(recordings / "broad_06_fast_rotation_A_95hz_ned.csv", axes="frd")
    found = calibrate_recording(log)
    assert "magnetometer: the fit is not taken" in found.left[-1]
    assert found.recording.mag is log.mag


def test_one_and_several_are_told_apart() -> None:
    assert counted(1, "gap") == "1 gap"
    assert counted(2, "gap") == "2 gaps"
    assert counted(1, "row has", "rows have") == "1 row has"
    assert counted(0, "row has", "rows have") == "0 rows have"
