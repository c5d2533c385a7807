"""Logs of sensors as a whole: what is read, what is refused, what the report says."""

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes import Recording, read_log
from chr_notes.sensors.simulated_log import SimulatedLog

from .columns_of_logs import ACCEL, GYRO, G, still


def test_a_log_with_all_vices(simulated: SimulatedLog, tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    simulated.write_csv(path)
    found = read_log(path)
    report = found.report()
    assert report.units == {
        "time": "ms",
        "gyro": "deg/s",
        "accel": "g",
        "mag": "uT",
        "temperature": "degC",
    }
    assert report.axes == "x -y -z"
    assert "flu" in report.assumed[0]
    assert not any("same axes" in said for said in report.cannot_tell)
    assert report.rate == pytest.approx(100)
    assert [gap.seconds for gap in report.gaps] == [pytest.approx(0.5, abs=0.02)]
    assert {stretch.what for stretch in report.saturated} >= {"gyro z"}
    assert 0 < report.missing["gyro"] < 0.001
    assert found.body_rates is not None
    assert found.accel is not None
    assert_allclose(
        found.body_rates[100], np.radians([simulated.columns[n][100] for n in GYRO]) * [1, -1, -1]
    )
    assert_allclose(
        found.accel[100], G * np.array([simulated.columns[n][100] for n in ACCEL]) * [1, -1, -1]
    )
    error = np.abs(found.body_rates - simulated.truth.body_rates)
    assert np.nanmedian(error) < 0.04  # its bias
    text = str(report)
    for said in (*report.assumed, *report.warnings, *report.cannot_tell, "rate: 100 Hz", "gaps: 1"):
        assert said in text


@pytest.mark.parametrize("source", [5, None, [[1, 2, 3]], np.zeros((4, 3))])
def test_sources_of_another_kind(source: object) -> None:
    with pytest.raises(TypeError, match="expected a path, an open file, a DataFrame or a mapping"):
        read_log(source)  # type: ignore[arg-type]


def test_arrays_of_three_and_names_of_this_package() -> None:
    force = np.tile([0.0, 0.0, -G], (100, 1))
    source = {
        "time": np.arange(100) * 0.01,
        "body_rates": 0 * force + [1.0, 2.0, 3.0],
        "accel": force,
    }
    found = read_log(source, units={"gyro": "deg/s"})
    assert found.body_rates is not None
    assert_allclose(found.body_rates[0], np.radians([1, 2, 3]))
    assert_array_equal(source["accel"], force)
    assert isinstance(found, Recording)
    with pytest.raises(ValueError, match="read-only"):
        found.body_rates[0] = 0


class Series:
    """A column as pandas has it."""

    def __init__(self, values: list[object]) -> None:
        self.values = np.array(values, dtype=object)

    def __array__(self, dtype: object = None, copy: object = None) -> NDArray[np.object_]:
        return self.values


class Frame:
    """A table of columns, with what is missing as pandas.NA prints."""

    columns = ("ax", "ay", "az")

    def __getitem__(self, name: str) -> Series:
        class Missing:
            def __str__(self) -> str:
                return "<NA>"

        return Series([9.8 * (name == "az")] * 60 + [Missing(), None, "1.5"])


def test_a_data_frame_with_missing_values() -> None:
    found = read_log(Frame(), rate=50)
    assert found.accel is not None
    assert np.isnan(found.accel[60:62]).all()
    assert_array_equal(found.accel[62], [1.5, -1.5, -1.5])
    assert found.report().missing["accel"] == pytest.approx(2 / 63)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (["1", "x"], r"row 1, column 'ax': expected a number, got 'x'"),
        ([1.0, np.inf], r"row 1, column 'ax': expected a reading, got inf"),
        ([1j, 2j], r"row 0, column 'ax': expected a number"),
        ([[1.0], [2.0]], r"column 'ax': expected shape \(N,\) or \(N, 3\), got \(2, 1\)"),
        ([1.0, 2.0, 3.0], r"column 'az': expected as many rows|column 'ax': expected as many rows"),
    ],
)
def test_columns_of_arrays_that_hold_no_numbers(values: list[object], message: str) -> None:
    columns = {"ax": np.array(values), "ay": np.ones(2), "az": np.ones(2)}
    with pytest.raises(ValueError, match=message):
        read_log(columns, rate=1)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"rate": 0.0}, "rate: expected a positive number"),
        ({"rate": 1e9}, "rate: expected one of a sensor"),
        ({"gravity": -9.8}, "gravity: expected a positive number"),
        ({"units": {"gyro": "knots"}}, r"units\['gyro'\]: expected one of"),
        ({"units": {"gyro": -1.0}}, r"units\['gyro'\]: expected a unit or a positive number"),
        ({"units": {"speed": "m/s"}}, "units: expected quantities of"),
        ({"full_range": {"gyro": 0.0}}, "full_range: expected positive ends"),
        ({"on_contradiction": "ignore"}, "on_contradiction: expected 'raise' or 'warn'"),
        ({"gravity": 1.62}, "expected a norm of 1.62 m/s"),
    ],
)
def test_settings_that_cannot_be(settings: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        read_log(still(), **settings)  # type: ignore[arg-type]


def test_readings_at_the_end_of_a_range_and_readings_that_stick() -> None:
    log = still(1000)
    log["gy_rad_s"][500:510] = np.radians(2000)
    log["gx_rad_s"][700:900] = 0.3
    for axis in "yz":
        log[f"g{axis}_rad_s"][700:900] = 0.1
    report = read_log(log).report()
    ends = [(each.what, each.start, each.stop) for each in report.saturated]
    assert ends == [("gyro y", 500, 510)]
    assert [(each.what, each.start, each.stop) for each in report.stuck] == [("gyro", 700, 900)]
    assert len([said for said in report.warnings if said.startswith("gyro")]) == 2
    given = read_log(log, full_range={"accel": 9.81}).report().saturated
    assert {each.what for each in given} == {"gyro y", "accel z"}


def test_a_wild_reading_moves_nothing_and_is_told() -> None:
    log = still(1000)
    log["gx_rad_s"][400] = 1e7
    found = read_log(log)
    assert found.report().warnings == ("gyro: 1 reading of no sensor, from row 400 on",)
    assert found.body_rates is not None
    assert found.body_rates[400, 0] == 1e7


def test_a_sensor_on_its_side_leaves_the_axes_open() -> None:
    report = read_log(still(up=(G, 0, 0))).report()
    assert any("the axes of the log: they are" in said for said in report.cannot_tell)
    assert any("+x points up" in said and "'z y -x'" in said for said in report.warnings)
    given = read_log(still(up=(G, 0, 0)), axes="frd").report()
    assert any("does not lie level" in said for said in given.warnings)


def test_temperatures() -> None:
    for name, value in (
        ("temp_C", 20.0),
        ("temp_K", 293.15),
        ("temp_F", 68.0),
        ("temperature", 20),
    ):
        found = read_log(still() | {name: np.full(300, value)}).temperature
        assert found is not None
        assert_allclose(found, 20.0)


def test_a_log_without_times_says_so() -> None:
    found = read_log({name: values for name, values in still().items() if name != "t_s"})
    assert found.time is None
    assert found.dt is None
    assert (
        "there are no times, and so no dt: pass rate= to read_log, in Hz" in found.report().warnings
    )
    assert "rate" not in str(found.report()).split("\n")[1]
