"""A recording of inertial sensors as the functions of this package take it, and what it is like."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields

import numpy as np

from chr_notes._arrays import Floats

_EVEN = 1e-6  # of a step: what is left of times that are printed in decimals


def counted(count: int, one: str, several: str = "") -> str:
    """Say how many: "1 gap in time", "3 gaps in time"; `several` where not "s" alone is added."""
    return f"{count} {one if count == 1 else several or one + 's'}"


@dataclass(frozen=True)
class Stretch:
    """A part of a recording at which something is to be said.

    Parameters
    ----------
    what
        "time", "gyro", "accel" or "mag", with the axis where it is one: "gyro z".
    start, stop
        Its samples, as of a slice.
    seconds
        How long it lasts, or the length of a gap; NaN without times.
    place
        Where it begins in the log, such as "line 12".
    """

    what: str
    start: int
    stop: int
    seconds: float
    place: str


@dataclass(frozen=True)
class Report:
    """What reading a log found and assumed. `print` makes text of it.

    Parameters
    ----------
    samples
        How many there are.
    left_out
        How many rows of the log are none of them.
    rate
        The median, Hz, or None without times.
    jitter
        Standard deviation of the steps over the median one, gaps apart, or None.
    gaps
        Where samples are missing: a step of more than two and a half usual ones.
    clock_jumps
        Where the clock was set, forward or back by more than an hour; counted as one usual step.
    repeated, backward
        How many rows came at the time of an earlier one, and before it; they are left out.
    saturated
        Where an axis stands at the end of its range, given or found.
    stuck
        Where a sensor repeats one reading for a second or longer.
    missing
        Share of rows without a whole reading, of each sensor.
    norm_at_rest
        Median norm of the accelerometer at rest, m/s², or None where it never rests.
    norm_of_field
        Median norm of the magnetometer in its unit, or None.
    rests
        Where the sensor lay still.
    columns
        Of each quantity, the names of its columns.
    units
        Of each quantity, its unit in the log.
    axes
        The three axes of the package out of those of the log, such as "x -y -z".
    relations
        What each two sensors, such as "mag and gyro", tell of whether they have the same axes.
    assumed
        A sentence for each thing that was taken for granted.
    cannot_tell
        A sentence for each thing that the log does not tell.
    warnings
        A sentence for each thing that is not as it should be.

    See Also
    --------
    chr_notes.sensors.logs.read_log
    """

    samples: int
    left_out: int = 0
    rate: float | None = None
    jitter: float | None = None
    gaps: tuple[Stretch, ...] = ()
    clock_jumps: tuple[Stretch, ...] = ()
    repeated: int = 0
    backward: int = 0
    saturated: tuple[Stretch, ...] = ()
    stuck: tuple[Stretch, ...] = ()
    missing: Mapping[str, float] = field(default_factory=dict)
    norm_at_rest: float | None = None
    norm_of_field: float | None = None
    rests: tuple[Stretch, ...] = ()
    columns: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    axes: str = "x y z"
    relations: Mapping[str, str] = field(default_factory=dict)
    assumed: tuple[str, ...] = ()
    cannot_tell: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()

    def __str__(self) -> str:
        """Say it in lines."""
        lines = [f"samples: {self.samples}" + (f", {self.left_out} left out" * bool(self.left_out))]
        if self.rate is not None:
            uneven = self.jitter is not None and self.jitter > _EVEN
            steps = f"steps vary by {self.jitter:.2g} of one" if uneven else "even steps"
            lines.append(f"rate: {self.rate:.4g} Hz, {steps}")
        for quantity, names in self.columns.items():
            unit = self.units.get(quantity, "of unknown unit")
            lines.append(f"{quantity}: {', '.join(names)} ({unit})")
        lines.append(f"axes, forward, right, down: {self.axes}")
        if self.norm_at_rest is not None:
            lines.append(f"accelerometer at rest: {self.norm_at_rest:.3f} m/s²")
        for name in ("gaps", "clock_jumps", "saturated", "stuck", "rests"):
            found = getattr(self, name)
            if found:
                first = found[0]
                timed = np.isfinite(first.seconds)
                length = f"{first.seconds:.3g} s" if timed else f"{first.stop - first.start} rows"
                lines.append(
                    f"{name.replace('_', ' ')}: {len(found)}, the first at {first.place} "
                    f"({first.what}, {length})"
                )
        lines += [f"{sensors}: {said}" for sensors, said in self.relations.items()]
        for name in ("assumed", "cannot_tell", "warnings"):
            lines += [f"{name.replace('_', ' ')}: {each}" for each in getattr(self, name)]
        return "\n".join(lines)


@dataclass(frozen=True, eq=False)
class Recording:
    """Samples of inertial sensors in the units and axes of this package.

    Axes are forward-right-down. What a log does not hold is None. Arrays cannot be written to.

    Parameters
    ----------
    time
        Seconds from the first sample on, rising, shape (N,).
    body_rates
        Readings of the gyro, rad/s, shape (N, 3); missing ones are NaN.
    accel
        Specific force, m/s², shape (N, 3).
    mag
        Magnetic field in the unit of the log, shape (N, 3).
    temperature
        Degrees Celsius, shape (N,).
    dt
        Step before each sample, seconds, shape (N,); the first is as long as the median one.
    found
        What `report` returns.

    See Also
    --------
    chr_notes.sensors.logs.read_log

    Examples
    --------
    >>> import chr_notes
    >>> log = {"ax_g": [0.0] * 200, "ay_g": [0.0] * 200, "az_g": [1.0, 1.002] * 100}
    >>> recording = chr_notes.read_log(log, rate=100)
    >>> recording.accel[0].round(2).tolist()
    [0.0, 0.0, -9.81]
    >>> recording.body_rates is None
    True
    """

    time: Floats | None
    body_rates: Floats | None
    accel: Floats | None
    mag: Floats | None
    temperature: Floats | None
    dt: Floats | None
    found: Report

    def __post_init__(self) -> None:
        """Guard the arrays."""
        for each in fields(self):
            array = getattr(self, each.name)
            if each.name != "found" and array is not None:
                array.flags.writeable = False

    def report(self) -> Report:
        """Say what was found and assumed when the log was read.

        Returns
        -------
        Report
            Data, and readable as text by `print`.
        """
        return self.found
