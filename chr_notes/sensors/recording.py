"""A recording of inertial sensors as the functions of this package take it, and what it is like."""

from collections.abc import Mapping
from dataclasses import dataclass

from chr_notes._arrays import Floats


@dataclass(frozen=True)
class Report:
    """What reading a log found and assumed.

    Parameters
    ----------
    samples
        How many there are.
    rate
        Of the samples, Hz, or None without times.
    jitter
        Standard deviation of the steps between samples over their median, or None.
    units
        Unit in the log of each quantity that was found.
    assumed
        A sentence for each thing that was taken for granted.
    warnings
        A sentence for each thing that is not as it should be.
    """

    samples: int
    rate: float | None
    jitter: float | None
    units: Mapping[str, str]
    assumed: tuple[str, ...]
    warnings: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Recording:
    """Samples of inertial sensors in the units and axes of this package.

    Axes are forward-right-down. What a log does not hold is None.

    Parameters
    ----------
    time
        Seconds, rising, shape (N,).
    body_rates
        Readings of the gyro, rad/s, shape (N, 3).
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
    """

    time: Floats | None
    body_rates: Floats | None
    accel: Floats | None
    mag: Floats | None
    temperature: Floats | None
    dt: Floats | None
    found: Report

    def report(self) -> Report:
        """Say what was found and assumed when the log was read.

        Returns
        -------
        Report
            Data, and readable as text by `print`.
        """
        return self.found
