"""Logs of sensors: units, axes and times are found, or given, and contradictions refused."""

import io
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from chr_notes import Recording, read_log
from chr_notes.sensors.simulated_log import SimulatedLog, simulated_log

Log = dict[str, NDArray[np.float64]]
G = 9.80665
GYRO = ("gyro_x_dps", "gyro_y_dps", "gyro_z_dps")
ACCEL = ("acc_x_g", "acc_y_g", "acc_z_g")
MAG = ("mag_x_uT", "mag_y_uT", "mag_z_uT")


@pytest.fixture(scope="module")
def simulated() -> SimulatedLog:
    return simulated_log()


@pytest.fixture
def log(simulated: SimulatedLog) -> Log:
    return dict(simulated.columns)


def renamed(log: Log, **names: str) -> Log:
    """Replace parts of names."""
    result = {}
    for name, values in log.items():
        for old, new in names.items():
            name = name.replace(f"_{old}", new)  # noqa: PLW2901
        result[name] = values
    return result


def still(count: int = 300, up: tuple[float, float, float] = (0.0, 0.0, -G)) -> Log:
    """A sensor that lies still, in SI units, with a little noise."""
    generator = np.random.default_rng(3)
    rates, force = generator.normal(0, 0.001, (count, 3)), generator.normal(up, 0.01, (count, 3))
    columns = {"t_s": np.arange(count) * 0.01}
    columns |= {f"g{axis}_rad_s": rates[:, n] for n, axis in enumerate("xyz")}
    return columns | {f"a{axis}_m_s2": force[:, n] for n, axis in enumerate("xyz")}


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


def planted(change: Callable[[Log], None]) -> Callable[[Log], Log]:
    def planting(log: Log) -> Log:
        change(log)
        return log

    return planting


def swapped(names: tuple[str, ...]) -> Callable[[Log], Log]:
    return lambda log: log | {names[0]: log[names[1]], names[1]: log[names[0]]}


def negated(*names: str) -> Callable[[Log], Log]:
    return lambda log: log | {name: -log[name] for name in names}


FAULTS: dict[str, tuple[Callable[[Log], Log], str]] = {
    "deg/s as rad/s": (
        lambda log: renamed(log, dps="_rad_s"),
        r"gyro: expected rates in rad/s, .*pass units=\{'gyro': 'deg/s'\}",
    ),
    "rad/s as deg/s": (
        lambda log: log | {name: np.radians(log[name]) for name in GYRO},
        r"gyro: expected rates in deg/s, .*pass units=\{'gyro': 'rad/s'\}",
    ),
    "g as m/s²": (
        lambda log: renamed(log, g="_m_s2"),
        r"accel: expected a norm of 9.807 m/s\^2 at rest, got 0.989; pass units=\{'accel': 'g'\}",
    ),
    "m/s² as g": (
        lambda log: log | {name: G * log[name] for name in ACCEL},
        r"accel: expected a norm of 1 g at rest, got 9.* pass units=\{'accel': 'm/s\^2'\}",
    ),
    "ms as s": (
        lambda log: renamed(log, ms="_s"),
        r"time: expected a sensor's rate, .* steps of 10 s, 0.1 Hz; pass units=\{'time': 'ms'\}",
    ),
    "gyro axes swapped": (swapped(GYRO), r"pass axes=\{'gyro': 'y x z'\}"),
    "accelerometer axes swapped": (
        swapped(ACCEL),
        r"pass axes=\{'accel': '-y -x -z'\} or \{'accel': 'y x z'\}",
    ),
    "magnetometer axes swapped": (
        swapped(MAG),
        r"pass axes=\{'mag': '-y -x -z'\} or \{'mag': 'y x z'\}",
    ),
    "all axes swapped": (
        lambda log: swapped(MAG)(swapped(ACCEL)(swapped(GYRO)(log))),
        r"expected the same of mag and gyro, accel and gyro, got .*\{'gyro': '-x -y -z'\}",
    ),
    "one gyro axis flipped": (negated(GYRO[1]), r"pass axes=\{'gyro': 'x -y z'\}"),
    "one accelerometer axis flipped": (negated(ACCEL[0]), r"pass axes=\{'accel': 'x -y -z'\}"),
    "one magnetometer axis flipped": (negated(MAG[2]), r"pass axes=\{'mag': '-x -y z'\}"),
    "gyro negated": (negated(*GYRO), r"pass axes=\{'gyro': '-x -y -z'\}"),
}


@pytest.mark.parametrize(("fault", "message"), FAULTS.values(), ids=FAULTS)
def test_what_the_physics_contradicts_is_refused(
    log: Log, fault: Callable[[Log], Log], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        read_log(fault(log))
    warned = read_log(fault(log), on_contradiction="warn").report()
    assert re.search(message, "; ".join(warned.warnings))


@pytest.mark.parametrize(
    ("sensor", "advised"),
    [("gyro", "y x z"), *((s, a) for s in ("accel", "mag") for a in ("y x z", "-y -x -z"))],
)
def test_what_is_advised_mends_it(log: Log, sensor: str, advised: str) -> None:
    names = {"gyro": GYRO, "accel": ACCEL, "mag": MAG}[sensor]
    report = read_log(swapped(names)(log), axes={sensor: advised}).report()
    assert not any("same axes" in said for said in report.cannot_tell)


def test_a_negated_accelerometer_looks_like_z_turned_over(log: Log) -> None:
    report = read_log(negated(*ACCEL)(log)).report()
    assert report.axes == "x y z"
    assert "whether the accelerometer is negated instead of z turned over" in report.cannot_tell
    assert "taken to lie level" in report.assumed[0]


def test_axes_that_are_given_are_held_against_the_first_rest(log: Log) -> None:
    with pytest.raises(ValueError, match=r"axes: expected a specific force that points up .*'flu'"):
        read_log(log, axes="frd")
    turned = read_log(log, axes="frd", level=False)
    assert turned.accel is not None
    assert turned.accel[50, 2] > 9
    assert read_log(log, axes="rfu").report().axes == "y x -z"


@pytest.mark.parametrize(
    ("axes", "forward"),
    [("flu", (1, -2, -3)), ("rfu", (2, 1, -3)), ("-y x z", (-2, 1, 3)), (np.eye(3), (1, 2, 3))],
)
def test_axes(axes: str, forward: tuple[int, ...]) -> None:
    log = {name: np.full(50, float(n)) for n, name in enumerate(("mx", "my", "mz"), start=1)}
    found = read_log(log, axes=axes, rate=10)
    assert found.mag is not None
    assert_array_equal(found.mag[0], forward)


@pytest.mark.parametrize(
    ("axes", "message"),
    [
        ("xyz", "expected one of"),
        ("x y y", "expected one of"),
        ("x y -z", "expected right-handed ones"),
        (np.ones((3, 3)), "expected one of"),
        ({"mag": "x y -z", "nose": "frd"}, "expected sensors of"),
    ],
)
def test_axes_that_are_none(axes: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        read_log(still(), axes=axes)


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
    assert found.report().warnings == ("gyro: 1 readings of no sensor, from row 400 on",)
    assert found.body_rates is not None
    assert found.body_rates[400, 0] == 1e7


def test_a_sensor_on_its_side_leaves_the_axes_open() -> None:
    report = read_log(still(up=(G, 0, 0))).report()
    assert any("z is not near the vertical" in said for said in report.cannot_tell)
    assert any("z is not near the vertical" in said for said in report.warnings)
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
    assert "there are no times; pass rate=, in Hz" in found.report().warnings
    assert "rate" not in str(found.report()).split("\n")[1]


def test_units_stand_in_a_line_below_the_names() -> None:
    rows = "".join(f"{n},0,0,1\n" for n in range(0, 1000, 10))
    found = read_log(io.StringIO("time,acc_x,acc_y,acc_z\nms,g,g,g\n" + rows))
    assert found.accel is not None
    assert_allclose(found.accel[0, 2], -G)
    assert found.report().rate == pytest.approx(100)
