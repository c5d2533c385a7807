"""Axes and signs of a log: given or found, and held against what the sensors felt."""

import re
from collections.abc import Callable

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from chr_notes import read_log

from .columns_of_logs import ACCEL, GYRO, MAG, G, Log, renamed, still


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
