"""From the log of a sensor to a recording in the units and axes of this package."""

from __future__ import annotations  # so that `help` shows short names of types

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Literal

import numpy as np

from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.sensors.column_names import SENSORS
from chr_notes.sensors.log_arrays import Arrays, names_of, read_arrays
from chr_notes.sensors.log_axes import Axes, given_axes
from chr_notes.sensors.log_header import Columns
from chr_notes.sensors.log_reading import recorded
from chr_notes.sensors.log_settings import Settings
from chr_notes.sensors.log_table import Table, read_text
from chr_notes.sensors.log_text import Readable
from chr_notes.sensors.log_units import given_units
from chr_notes.sensors.recording import Recording

Source = str | PathLike[str] | Readable | Arrays


def read_log(  # noqa: PLR0913 (each may have to be said)
    source: Source,
    *,
    columns: Columns | None = None,
    units: Mapping[str, str | float] | None = None,
    axes: Axes | Mapping[str, Axes] | None = None,
    rate: float | None = None,
    full_range: Mapping[str, float] | None = None,
    gravity: float = STANDARD_GRAVITY,
    level: bool = True,
    on_contradiction: Literal["raise", "warn"] = "raise",
) -> Recording:
    r"""Read the log of a sensor, whatever its columns, units and axes, and say what was assumed.

    What is not given is told by the names of the columns, or found: the unit of the accelerometer
    by its norm at rest, the unit of time by the size of its steps, the unit of the gyro by how the
    other sensors turn, and whether z points up or down by the first rest, at which the sensor is
    taken to lie level. Whether all sensors have the same axes and signs is told by `relate_axes`,
    by where the gyro turns the vertical from one rest to the next, and by the angle between
    vertical and magnetic field, which stays the same. What contradicts this physics is refused.
    What none of it tells is in the report as "cannot tell".

    Parameters
    ----------
    source
        Path of a file or an open one, with comma, semicolon, tab, bar or white space between
        fields; or a DataFrame, a structured array or a mapping from names to arrays of shape (N,)
        or (N, 3).
    columns
        Of quantities "time", "gyro", "accel", "mag" and "temperature", which columns hold them, by
        name or by number from 0, three for a sensor; None leaves one out. Or, for a file without a
        line of names, the names in order.
    units
        Of a quantity: "s", "ms", "us", "ns"; "rad/s", "deg/s"; "m/s^2", "g", "mg"; "uT", "gauss",
        ...; "degC", "K", "degF". Of raw counts so many a unit, as "g/16384" or "16.4 LSB/(deg/s)".
    axes
        Of the log: "frd", "flu" (z up), "rfu" (Android), the three axes forward, right, down out of
        those of the log such as "-y x z", or the matrix to them. A mapping from "gyro", "accel",
        "mag" turns single sensors into the axes of the others first, "all" is for all.
    rate
        Samples a second, in place of a column of times.
    full_range
        Of "gyro" in rad/s and "accel" in m/s², where they saturate.
    gravity
        At the place, m/s².
    level
        Whether the sensor lies level, within 45°, at its first rest.
    on_contradiction
        "raise", or "warn" to have what contradicts the physics as a warning of the report, where
        the sensors are known to be right.

    Returns
    -------
    Recording
        Its `report` says what was found, assumed and left out. Rows at the time of an earlier row,
        or before it, are left out with a warning; where they are more than half, or one in a
        hundred, that is an error. A step of more than an hour is a clock that was set, and counts
        as a usual step. Missing readings are NaN.

    Raises
    ------
    ValueError
        If the source holds anything but numbers where numbers are read, naming line and column; if
        a unit cannot be told; or if what is given or told contradicts the readings.
    TypeError
        If the source, or what is given of its columns, is of another kind.
    OSError
        If there is no such file.

    Notes
    -----
    A vector and its opposite turn alike: an accelerometer that is negated reads like one whose
    z-axis points the other way, and no log tells which it is.

    Examples
    --------
    >>> import io
    >>> import chr_notes
    >>> rows = "".join(f"{10 * n},{n % 2},0.1,-0.2,0.01,0,1\n" for n in range(200))
    >>> log = io.StringIO("t_ms,gx_dps,gy_dps,gz_dps,ax_g,ay_g,az_g\n" + rows)
    >>> recording = chr_notes.read_log(log)
    >>> recording.accel[0].round(3).tolist()
    [0.098, 0.0, -9.807]
    >>> recording.body_rates[1].round(4).tolist()
    [0.0175, -0.0017, 0.0035]
    >>> recording.report().assumed[0]
    'axes are flu: z points up, for the sensor is taken to lie level at its first rest (line 2)'

    A name that says m/s² of what is in g is refused:

    >>> log = {"ax_m_s2": [0.0] * 99, "ay_m_s2": [0.0] * 99, "az_m_s2": [1.0] * 99}
    >>> chr_notes.read_log(log, rate=100)
    Traceback (most recent call last):
    ValueError: accel: expected a norm of 9.807 m/s^2 at rest, got 1; pass units={'accel': 'g'}
    """
    if on_contradiction not in ("raise", "warn"):
        msg = f"on_contradiction: expected 'raise' or 'warn', got {on_contradiction!r}"
        raise ValueError(msg)
    if not (np.isfinite(gravity) and gravity > 0):
        msg = f"gravity: expected a positive number, m/s², got {gravity}"
        raise ValueError(msg)
    for sensor, end in (full_range or {}).items():
        if sensor not in SENSORS or not end > 0:
            msg = f"full_range: expected positive ends of {[*SENSORS]}, got {sensor!r}: {end}"
            raise ValueError(msg)
    given = given_units(units)
    matrices = given_axes(axes)
    table = _table(source, columns)
    settings = Settings(
        units=given,
        axes=matrices,
        rate=rate,
        full_range=dict(full_range or {}),
        gravity=float(gravity),
        level=level,
        refuse=on_contradiction == "raise",
    )
    return recorded(table, settings)


def _table(source: Source, columns: Columns | None) -> Table:
    """Read what the source is."""
    if isinstance(source, str | PathLike | Readable):
        return read_text(source, columns)
    names = names_of(source)
    if names is None:
        msg = (
            f"expected a path, an open file, a DataFrame or a mapping, got {type(source).__name__}"
        )
        raise TypeError(msg)
    if isinstance(columns, Sequence):
        msg = "columns: expected a mapping, for the source has names itself, got a sequence"
        raise TypeError(msg)
    return read_arrays(source, names, columns)
