"""A log as sensors on a desk write it, with all their vices, and the truth beside it.

Nothing in it was recorded. A sensor with z up writes milliseconds, degrees per second, g and
microtesla; its clock jitters and once stops; its gyro's bias drifts with temperature, and reaches
the end of its range; its accelerometer is out of scale, and feels a motor; iron sits beside its
magnetometer, more iron comes by, and single readings are nonsense or missing.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.frames import change_axes
from chr_notes.sensors.models import (
    MagnetometerCalibration,
    RateGyroCalibration,
    ThreeAxisCalibration,
)
from chr_notes.sensors.simulated import SensorErrors, add_errors, passing_iron
from chr_notes.simulation import Trajectory, ideal_readings, minimum_jerk, trajectory

RANGE_DEG = 500.0
"""Of the gyro, deg/s."""
FIELD = (20.0, 1.0, 44.0)
"""Of the Earth in that room, to the north, east and down, microtesla."""
_STEP = 0.01
_WARM_UP = 60.0  # seconds in which the temperature makes 63 % of its way
_COLD, _WARM = 21.0, 43.0
_DEG = np.pi / 180

# What happens: seconds, then roll, pitch, yaw in degrees at that time.
_SIX_POSITIONS = (
    (8, 0, 0, 30), (10, 90, 0, 30), (14, 90, 0, 30), (16, 180, 0, 30), (20, 180, 0, 30),
    (22, 270, 0, 30), (26, 270, 0, 30), (28, 360, 0, 30), (30, 360, 0, 30), (32, 360, 90, 30),
    (36, 360, 90, 30), (39, 360, -90, 30), (43, 360, -90, 30), (45, 360, 0, 30), (49, 360, 0, 30),
)  # fmt: skip
_FLICK = ((49.25, 360, 0, 120), (53, 360, 0, 120), (54, 360, 0, 30), (57, 360, 0, 30))
_BY_HAND = np.arange(58.0, 98.0, 2.0)
_END = ((100, 360, 0, 30), (150, 360, 0, 30))
MOTOR = (105.0, 115.0)
"""Seconds from and to which a motor runs."""
CARRIED = (117.0, 137.0)
"""Seconds from and to which the sensor is carried about, its angles held."""
MAGNET = (140.0, 146.0)
"""Seconds from and to which iron passes by."""


@dataclass(frozen=True, eq=False)
class SimulatedLog:
    """What a sensor wrote, and what was there.

    Parameters
    ----------
    columns
        Name and values, a row for each sample that was written, shape (N,) each.
    truth
        The motion at these samples, in the axes of this package.
    temperature
        Degrees Celsius, shape (N,).
    gyro, accel, mag
        The sensors, in the axes and units of this package; the gyro's bias is a polynomial in
        temperature.
    """

    columns: Mapping[str, Floats]
    truth: Trajectory
    temperature: Floats
    gyro: RateGyroCalibration
    accel: ThreeAxisCalibration
    mag: MagnetometerCalibration

    def write_csv(self, path: str | PathLike[str]) -> None:
        """Write the log as comma-separated values with a line of names; what is missing is empty.

        Parameters
        ----------
        path
            Of the file; one that is there is replaced.
        """
        rows = zip(*(values.tolist() for values in self.columns.values()), strict=True)
        lines = [",".join("" if v != v else f"{v:.9g}" for v in row) for row in rows]  # noqa: PLR0124 (NaN)
        text = "\n".join([",".join(self.columns), *lines, ""])
        Path(path).write_text(text, encoding="utf-8")


def simulated_log(seed: int = 0) -> SimulatedLog:
    """Simulate two and a half minutes of a sensor that is calibrated, turned, carried and disturbed.

    It rests, takes six positions, is flicked about the vertical faster than its gyro's range, is
    turned by hand in all directions, rests beside a motor, is carried about, and rests while iron
    passes.

    Parameters
    ----------
    seed
        Of everything random.

    Returns
    -------
    SimulatedLog
        Columns and truth.

    Examples
    --------
    >>> from chr_notes.sensors.simulated_log import simulated_log
    >>> log = simulated_log()
    >>> print(*log.columns, sep=", ")
    time_ms, gyro_x_dps, gyro_y_dps, gyro_z_dps, acc_x_g, acc_y_g, acc_z_g, mag_x_uT, mag_y_uT, mag_z_uT, temperature_C
    >>> print(f"{log.columns['acc_z_g'][:100].mean():.2f}")
    0.99
    """  # noqa: E501 (what is printed is one line)
    generator = np.random.default_rng(seed)
    written = _clock(generator)
    time = written / 1000
    truth = _motion(time, generator)
    field = np.asarray(FIELD) + passing_iron(time, *MAGNET, (25.0, -15.0, 10.0))
    ideal = ideal_readings(truth, field)
    warmth = _COLD + (_WARM - _COLD) * (1 - np.exp(-time / _WARM_UP))
    gyro, accel, mag = _sensors(generator)
    force = accel.measure(ideal.accel)
    motor = (time >= MOTOR[0]) & (time < MOTOR[1])
    shaken = add_errors(force, time, SensorErrors(vibration=4.0, vibration_frequency=37.0), seed)
    force = np.where(motor[:, np.newaxis], shaken, force)
    rates = gyro.measure(ideal.body_rates, ideal.accel, warmth)
    read = {
        "gyro": add_errors(rates, time, SensorErrors(noise_density=2e-4), seed + 1) / _DEG,
        "acc": add_errors(force, time, SensorErrors(noise_density=2e-3), seed + 2)
        / STANDARD_GRAVITY,
        "mag": add_errors(mag.measure(ideal.mag), time, SensorErrors(noise_density=0.05), seed + 3),
    }
    columns = {"time_ms": written}
    for name, unit in (("gyro", "dps"), ("acc", "g"), ("mag", "uT")):
        values = change_axes(read[name], "frd", "flu").round(4)
        if name == "gyro":
            values = values.clip(-RANGE_DEG, RANGE_DEG)
        _damage(values, name, generator)
        columns |= {f"{name}_{axis}_{unit}": values[:, n] for n, axis in enumerate("xyz")}
    columns["temperature_C"] = warmth.round(2)
    return SimulatedLog(columns, truth, warmth, gyro, accel, mag)


def _clock(generator: np.random.Generator) -> Floats:
    """Give times in whole milliseconds, with jitter, and half a second lost while it rests."""
    count = round(_END[-1][0] / _STEP)
    time = np.arange(count) * _STEP + generator.normal(0, 0.0008, count)
    lost = (time > 2.0) & (time < 2.5)  # noqa: PLR2004 (seconds)
    milliseconds = np.unique((1000 * (time[~lost] + _STEP)).round())
    return np.asarray(milliseconds, dtype=np.float64)


def _motion(time: Floats, generator: np.random.Generator) -> Trajectory:
    """Go through the positions, and be carried about at the end."""
    stops = [np.array(part, dtype=np.float64) for part in (_SIX_POSITIONS, _FLICK, _END)]
    turned = generator.uniform([200, -75, -180], [520, 75, 180], (len(_BY_HAND), 3))
    by_hand = np.column_stack([_BY_HAND, turned])
    plan = np.concatenate([*stops[:2], by_hand, stops[2]])
    attitude = minimum_jerk(time, plan[:, 0], plan[:, 1:] * _DEG)
    places = generator.uniform(-0.5, 0.5, (int(CARRIED[1] - CARRIED[0]) + 1, 3))
    places[[0, -1]] = 0.0
    motion = minimum_jerk(time, np.arange(CARRIED[0], CARRIED[1] + 1), places)
    return trajectory(time, attitude, motion)


def _sensors(
    generator: np.random.Generator,
) -> tuple[RateGyroCalibration, ThreeAxisCalibration, MagnetometerCalibration]:
    """Make the three sensors, each a little different from what it should be."""
    bias = generator.uniform(0.3, 1.0, 3) * generator.choice([-1, 1], 3)
    slope = generator.uniform(0.01, 0.03, 3) * generator.choice([-1, 1], 3)
    by_temperature = np.stack([bias, slope]) * _DEG
    scales = 1 + generator.normal(0, 0.005, 3)
    gyro = RateGyroCalibration(np.eye(3), scales, by_temperature, np.zeros((3, 3)))
    slant = np.eye(3) + generator.normal(0, 0.004, (3, 3))
    scales, offsets = 1 + generator.normal(0, 0.02, 3), generator.normal(0, 0.15, 3)
    accel = ThreeAxisCalibration(slant, scales, offsets)
    spread = generator.normal(0, 0.08, (3, 3))
    soft, hard = np.eye(3) + (spread + spread.T) / 2, generator.uniform(-25, 25, 3)
    return gyro, accel, MagnetometerCalibration(soft, hard)


def _damage(values: Floats, name: str, generator: np.random.Generator) -> None:
    """Put a few missing rows, and codes that are no readings, where they fall."""
    places = generator.choice(np.arange(700, len(values) - 700), 9, replace=False)
    values[places[:4]] = np.nan
    values[places[4:]] = {"gyro": RANGE_DEG, "acc": 16.0, "mag": -4096.0}[name]
