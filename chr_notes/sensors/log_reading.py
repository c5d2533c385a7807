"""From the numbers of a log to a recording: units, times, axes, and what is to be said of them."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.sensors import log_axes, log_checks, log_time, log_units
from chr_notes.sensors.axes import AxesRelation
from chr_notes.sensors.columns import SENSORS
from chr_notes.sensors.log_table import Table
from chr_notes.sensors.log_time import Times
from chr_notes.sensors.log_units import Unit
from chr_notes.sensors.recording import Recording, Report

_UNUSUAL = 0.05  # of gravity
_QUIET_BLOCKS = 40


@dataclass(frozen=True)
class Settings:
    """What the caller of `read_log` gives, checked."""

    units: dict[str, Unit]
    axes: dict[str, Floats]
    rate: float | None
    full_range: dict[str, float]
    gravity: float
    level: bool
    refuse: bool


@dataclass
class _Said:
    """What there is to say, while a log is read."""

    refuse: bool
    units: dict[str, str] = field(default_factory=dict)
    assumed: list[str] = field(default_factory=list)
    cannot_tell: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    def contradiction(self, what: str) -> None:
        """Refuse, or warn if that is wanted."""
        if self.refuse:
            raise ValueError(what) from None
        self.warnings.append(what)


@dataclass(frozen=True)
class _Rest:
    """Where the accelerometer hardly varies: mean readings of blocks, and which they are."""

    means: Floats
    blocks: list[int]
    width: int


def recorded(table: Table, settings: Settings) -> Recording:
    """Bring the columns of a log to units and axes, and report.

    Raises
    ------
    ValueError
        If a unit or the times cannot be told, or what is told contradicts the readings.
    """
    values, said = table.values, _Said(settings.refuse)
    said.assumed += table.notes
    said.warnings += table.warnings
    count = len(next(iter(values.values())))
    times = _times(table, settings, said, count)
    rows = np.arange(count) if times.kept is None else np.flatnonzero(times.kept)
    if times.kept is not None:
        for quantity in values:
            values[quantity] = values[quantity][rows]

    def place(row: int) -> str:
        return table.place(int(rows[row]))

    for name in SENSORS:
        if name in values and name in settings.axes:
            log_axes.turn(values[name], settings.axes[name])
    rest = _accelerometer(table, settings, said)
    relations = _gyro(table, settings, said, times.dt, rest)
    axes = _axes(values, settings, said, rest, place)
    if "mag" in values:
        unit = _known(table, settings, "mag")
        said.units["mag"] = unit.name if unit else "unknown"
    saturated, stuck, faults = log_checks.faults(values, settings.full_range, times.dt, place)
    said.warnings += faults
    temperature = _temperature(table, settings, said)
    at_rest = None
    if rest is not None and rest.blocks:
        at_rest = float(np.median(np.sqrt((rest.means**2).sum(axis=1))))
    found = Report(
        samples=len(rows),
        left_out=count - len(rows),
        rate=times.rate,
        jitter=times.jitter,
        gaps=tuple(times.gaps),
        clock_jumps=tuple(times.clock_jumps),
        repeated=times.repeated,
        backward=times.backward,
        saturated=saturated,
        stuck=stuck,
        missing={name: log_checks.missing(values[name]) for name in SENSORS if name in values},
        norm_at_rest=at_rest,
        norm_of_field=log_checks.median_norm(values["mag"]) if "mag" in values else None,
        rests=log_checks.stretches("accel", rest.blocks, rest.width, times.dt, place)
        if rest
        else (),
        columns={
            quantity: tuple(table.names[at] for at in each.places)
            for quantity, each in table.selected.items()
        },
        units=said.units,
        axes=log_axes.named(axes),
        relations={sensor: str(each) for sensor, each in relations.items()},
        assumed=tuple(said.assumed),
        cannot_tell=tuple(said.cannot_tell),
        warnings=tuple(said.warnings),
    )
    return Recording(
        time=times.time,
        body_rates=values.get("gyro"),
        accel=values.get("accel"),
        mag=values.get("mag"),
        temperature=temperature,
        dt=times.dt,
        found=found,
    )


def _known(table: Table, settings: Settings, quantity: str) -> Unit | None:
    """Give the unit that is given, or else told by the names."""
    if quantity in settings.units:
        return settings.units[quantity]
    name = table.selected[quantity].unit
    if name is None:
        return None
    return Unit(name, log_units.FACTORS.get(quantity, {}).get(name), "told")


def _times(table: Table, settings: Settings, said: _Said, count: int) -> Times:
    if settings.rate is not None:
        times = log_time.even(count, settings.rate, had_times="time" in table.values)
        if not log_time.is_possible(settings.rate):
            said.contradiction(
                f"rate: expected one of a sensor, from {log_time.RATES[0]:g} to "
                f"{log_time.RATES[1]:g} Hz, got {settings.rate:g}; pass on_contradiction='warn' "
                "if it is so"
            )
    elif "time" in table.values:
        unit = _known(table, settings, "time")
        if unit is not None and unit.name not in log_time.SECONDS:
            msg = f"units['time']: expected one of {[*log_time.SECONDS]}, got {unit.name!r}"
            raise ValueError(msg)
        name = unit.name if unit else None
        times = log_time.timed(table.values["time"][:, 0], name, table.place, said.contradiction)
        said.units["time"] = str(times.unit)
    else:
        times = Times(warnings=["there are no times; pass rate=, in Hz"])
    said.assumed += times.assumed
    said.warnings += times.warnings
    return times


def _accelerometer(table: Table, settings: Settings, said: _Said) -> _Rest | None:
    """Bring specific force to m/s², and find where it rests."""
    if "accel" not in table.values:
        return None
    accel = table.values["accel"]
    means, blocks, width = log_checks.still_blocks(accel)
    rested = len(blocks) > 0
    norm = (
        float(np.median(np.sqrt((means**2).sum(axis=1))))
        if rested
        else log_checks.median_norm(accel)
    )
    if not norm > 0:
        msg = f"accel: expected readings of gravity, got a median norm of {norm:g}"
        raise ValueError(msg)
    known = _known(table, settings, "accel")
    some = accel[:: max(1, len(accel) // log_checks.LOOKED_AT)]
    whole = bool((some[np.isfinite(some)] % 1 == 0).all())
    try:
        unit = log_units.unit_of_accelerometer(
            known, norm, settings.gravity, rested=rested, whole=whole
        )
    except ValueError as error:
        said.contradiction(str(error))
        if known is None or known.factor is None:
            raise
        unit = known
    factor = float(unit.factor or 1.0)
    if unit.how == "found":
        said.assumed.append(f"accel is in {unit.name}, by a median norm of {norm:.4g}")
    said.units["accel"] = unit.name
    accel *= factor
    norm *= factor
    if rested and abs(norm / settings.gravity - 1) > _UNUSUAL:
        said.warnings.append(
            f"accel: its norm at rest is {norm:.3f} m/s², and gravity {settings.gravity:.3f}: "
            "calibrate it"
        )
    return _Rest(means * factor, blocks.tolist(), width)


def _gyro(
    table: Table, settings: Settings, said: _Said, dt: Floats | None, rest: _Rest | None
) -> dict[str, AxesRelation]:
    """Bring body rates to rad/s, and see whether they turn as other sensors do."""
    if "gyro" not in table.values:
        return {}
    gyro = table.values["gyro"]
    relations: dict[str, AxesRelation] = {}
    if dt is not None:
        for name in sorted({"mag", "accel"} & table.values.keys(), reverse=True):
            relations[name] = log_axes.relation(gyro, table.values[name], dt)
    factors = [each.factors for each in relations.values() if np.isfinite(each.factors).all()]
    certain = [each.factors for each in relations.values() if each.known]
    allowed = np.concatenate(certain or factors) if factors else None
    unit = _unit_of_gyro(_known(table, settings, "gyro"), gyro, allowed, rest, said)
    gyro *= float(unit.factor or 1.0)
    wrong = log_axes.disagreement(relations)
    if wrong:
        said.contradiction(wrong)
    for name, each in relations.items():
        if not each.known:
            said.cannot_tell.append(f"whether {name} and gyro have the same axes and signs")
    if not relations:
        said.cannot_tell.append("whether the gyro turns as the log says, without times or another")
    if allowed is None and unit.how in ("given", "told"):
        said.cannot_tell.append(f"whether the gyro is in {unit.name}, as it is {unit.how}")
    return relations


def _unit_of_gyro(
    known: Unit | None, gyro: Floats, allowed: Floats | None, rest: _Rest | None, said: _Said
) -> Unit:
    some = np.abs(gyro[:: max(1, len(gyro) // log_checks.LOOKED_AT)])
    fastest = float(np.nanquantile(some, 0.999)) if np.isfinite(some).any() else 0.0
    try:
        unit, reason = log_units.unit_of_gyro(known, allowed, fastest, _noise(gyro, rest))
    except ValueError as error:
        if known is None or known.factor is None:
            raise
        said.contradiction(str(error))
        unit, reason = known, None
    if reason:
        said.assumed.append(f"gyro is in {unit.name}, by {reason}")
    if unit.how == "assumed":
        said.cannot_tell.append(f"for certain whether the gyro is in {unit.name}")
        said.warnings.append(f"{said.assumed[-1]}; pass units= if it is not")
    said.units["gyro"] = unit.name
    return unit


def _noise(gyro: Floats, rest: _Rest | None) -> float | None:
    """Take the standard deviation of a gyro where the accelerometer rests; None without rest."""
    if rest is None or not rest.blocks:
        return None
    every = max(1, len(rest.blocks) // _QUIET_BLOCKS)
    parts = [gyro[b * rest.width : (b + 1) * rest.width] for b in rest.blocks[::every]]
    spread = [float(part.std(axis=0).max()) for part in parts]
    finite = [each for each in spread if np.isfinite(each)]
    return float(np.median(finite)) if finite else None


def _axes(
    values: dict[str, Floats],
    settings: Settings,
    said: _Said,
    rest: _Rest | None,
    place: Callable[[int], str],
) -> Floats:
    """Bring all sensors to forward-right-down."""
    given = settings.axes.get("all")
    up, where = None, ""
    if rest is not None and rest.blocks:
        up = rest.means[0]
        where = f"at its first rest ({place(rest.blocks[0] * rest.width)})"
    elif "accel" in values:
        up, where = np.nanmean(values["accel"], axis=0), "on the whole, for it never rests"
    matrix = given
    if matrix is None and up is not None and settings.level:
        matrix = _level(up, where, said)
    elif matrix is not None and up is not None and settings.level:
        found, level = log_axes.levelled(matrix @ up)
        if level and found is not None and found[2, 2] < 0:
            said.contradiction(
                f"axes: expected a specific force that points up of a level sensor, got "
                f"{np.array2string(matrix @ up, precision=2)} m/s² {where} in the axes given, "
                f"{log_axes.named(matrix)}; pass axes='flu' for a sensor whose z points up, "
                "axes={'accel': '-x -y -z'} for one that reads gravity, or level=False if it does "
                "not lie level"
            )
        elif not level:
            said.warnings.append(f"the sensor does not lie level {where}")
    elif matrix is None:
        matrix = np.eye(3)
        said.cannot_tell.append("the axes of the log: they are taken for forward, right, down")
    for name in SENSORS:
        if name in values and not np.array_equal(matrix, np.eye(3)):
            log_axes.turn(values[name], matrix)
    return matrix


def _level(up: Floats, where: str, said: _Said) -> Floats:
    """Tell z up from z down by where a level sensor's specific force points."""
    matrix, _ = log_axes.levelled(up)
    if matrix is None:
        said.cannot_tell.append(
            f"the axes of the log, for z is not near the vertical {where}: they are taken for "
            "forward, right, down; pass axes="
        )
        said.warnings.append(said.cannot_tell[-1])
        return np.eye(3)
    name = "flu: z points up" if matrix[2, 2] < 0 else "frd: z points down"
    said.assumed.insert(0, f"axes are {name}, for the sensor is taken to lie level {where}")
    said.cannot_tell.append("whether the accelerometer is negated instead of z turned over")
    return matrix


def _temperature(table: Table, settings: Settings, said: _Said) -> Floats | None:
    """Bring temperatures to degrees Celsius."""
    if "temperature" not in table.values:
        return None
    readings = table.values["temperature"][:, 0].copy()
    unit = _known(table, settings, "temperature")
    name = unit.name if unit else "degC"
    if unit is None:
        said.assumed.append("temperature is in degC, for its name does not tell")
    said.units["temperature"] = name
    if name == "degC":
        return readings
    if name == "K":
        return readings - 273.15
    if name == "degF":
        return (readings - 32) / 1.8
    said.warnings.append("temperature: raw counts of unknown size are left out")
    return None
