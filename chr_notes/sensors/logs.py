"""From the log of a sensor to a recording in the units and axes of this package."""

from os import PathLike
from pathlib import Path

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.sensors.columns import columns_of
from chr_notes.sensors.recording import Recording, Report

_FACTORS = {
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9},
    "gyro": {"rad/s": 1.0, "deg/s": np.pi / 180, "mdeg/s": np.pi / 180e3},
    "accel": {"m/s^2": 1.0, "g": STANDARD_GRAVITY, "mg": STANDARD_GRAVITY / 1e3},
}
_AXES = {"frd": np.diag([1.0, 1, 1]), "flu": np.diag([1.0, -1, -1])}


def read_log(
    source: str | PathLike[str], *, units: dict[str, str] | None = None, axes: str = "frd"
) -> Recording:
    """Read a log with a line of names that tell what the columns hold and in which unit.

    Parameters
    ----------
    source
        Path of a file of comma-separated values.
    units
        Unit of each quantity ("time", "gyro", "accel") whose columns do not say it.
    axes
        Of the sensor: "frd" or "flu".

    Returns
    -------
    Recording
        In SI units and forward-right-down axes.

    Raises
    ------
    ValueError
        If a unit is neither given nor in the names.
    """
    names = Path(source).read_text(encoding="utf-8").partition("\n")[0].split(",")
    values = np.loadtxt(source, delimiter=",", skiprows=1, ndmin=2)
    told = columns_of(names)
    known = dict(units or {})

    def scaled(quantity: str, axes_of: tuple[int | None, ...]) -> Floats | None:
        if (quantity, axes_of[0]) not in told:
            return None
        columns = [told[quantity, axis][0] for axis in axes_of]
        unit = known.setdefault(quantity, columns[0][1] or "")
        if unit not in _FACTORS[quantity]:
            msg = f"{quantity}: expected a unit of {[*_FACTORS[quantity]]}, got {unit!r}"
            raise ValueError(msg)
        return np.asarray(values[:, [place for place, _ in columns]] * _FACTORS[quantity][unit])

    time, turn = scaled("time", (None,)), _AXES[axes]
    rates, accel = scaled("gyro", (0, 1, 2)), scaled("accel", (0, 1, 2))
    field = [told["mag", axis][0][0] for axis in range(3)] if ("mag", 0) in told else None
    steps = None if time is None else np.diff(time[:, 0])
    typical = None if steps is None else float(np.median(steps))
    return Recording(
        time=None if time is None else time[:, 0],
        body_rates=None if rates is None else rates @ turn,
        accel=None if accel is None else accel @ turn,
        mag=None if field is None else values[:, field] @ turn,
        temperature=None,
        dt=None if steps is None else np.concatenate([[typical], steps]),
        found=Report(
            samples=len(values),
            rate=1 / typical if typical else None,
            jitter=float(steps.std() / typical) if steps is not None and typical else None,
            units=known,
            assumed=(f"axes {axes}",),
            warnings=(),
        ),
    )
