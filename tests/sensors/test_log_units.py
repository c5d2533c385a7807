"""Units of a log: by names, by a line of their own, by the physics, or asked for."""

import io

import numpy as np
import pytest
from numpy.testing import assert_allclose

from chr_notes import read_log

from .columns_of_logs import ACCEL, GYRO, G, Log, renamed, still


def test_units_that_no_name_tells_are_found(log: Log) -> None:
    plain = renamed(log, ms="", dps="", g="")
    report = read_log(plain).report()
    assert (report.units["time"], report.units["gyro"], report.units["accel"]) == (
        "ms",
        "deg/s",
        "g",
    )
    assert "gyro is in deg/s, by how the sensors turn" in report.assumed


def test_the_unit_of_a_gyro_at_rest_is_assumed_or_asked_for() -> None:
    quiet = {name.replace("_rad_s", ""): values for name, values in still().items()}
    report = read_log(quiet).report()
    assert report.units["gyro"] == "rad/s"
    assert "for certain whether the gyro is in rad/s" in report.cannot_tell
    assert "a noise of 0.0011 at rest; pass units= if it is not" in report.warnings[-1]
    loud = quiet | {name: 10 * quiet[name] for name in ("gx", "gy", "gz")}
    with pytest.raises(ValueError, match="gyro: cannot tell its unit; pass units="):
        read_log(loud)
    assert read_log(loud, units={"gyro": "deg/s"}).report().units["gyro"] == "deg/s"


@pytest.mark.parametrize("count", [16.4, 32.8, 131.0])
def test_counts_of_a_gyro_that_no_name_tells_are_asked_for(log: Log, count: float) -> None:
    """They are too fast for rad/s; the accelerometer says that they are no degrees either."""
    names = [name for name in log if name.startswith("gyro")]
    raw = {"gyro_" + name[5]: np.round(log[name] * count) for name in names}
    rest = {name: values for name, values in log.items() if name not in names}
    with pytest.raises(ValueError, match=r"gyro: cannot tell its unit; by how the others turn"):
        read_log(rest | raw)


def test_raw_counts(log: Log) -> None:
    counts = {f"{name[:5]}_raw": (16384 * log[name]).round() for name in ACCEL}
    counts = {name: np.nan_to_num(values) for name, values in counts.items()}
    found = read_log(counts, rate=100)
    assert found.report().units == {"accel": "g/16384"}
    assert found.accel is not None
    assert_allclose(found.accel[50, 2], -G * log["acc_z_g"][50], atol=1e-3)
    gyro = {f"{name[:6]}_raw": np.nan_to_num(16.4 * log[name]).round() for name in GYRO}
    with pytest.raises(
        ValueError, match=r"gyro: cannot tell its unit from raw counts; .*deg/s/131"
    ):
        read_log(gyro, rate=100)
    for unit in ("deg/s/16.4", "16.4 LSB/(deg/s)", np.pi / 180 / 16.4):
        rates = read_log(gyro, rate=100, units={"gyro": unit}).body_rates
        assert rates is not None
        assert_allclose(rates[6000], np.radians([log[n][6000] for n in GYRO]), atol=6e-4)


def test_units_stand_in_a_line_below_the_names() -> None:
    rows = "".join(f"{n},0,0,1\n" for n in range(0, 1000, 10))
    found = read_log(io.StringIO("time,acc_x,acc_y,acc_z\nms,g,g,g\n" + rows))
    assert found.accel is not None
    assert_allclose(found.accel[0, 2], -G)
    assert found.report().rate == pytest.approx(100)
