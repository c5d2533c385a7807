"""From the numbers of a log to a recording: units, times, axes, and what is to be said of them."""

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.sensors import log_axes, log_checks, log_time, log_turning, log_units
from chr_notes.sensors.column_names import SENSORS
from chr_notes.sensors.log_settings import Rest, Said, Settings, known_unit
from chr_notes.sensors.log_table import Table
from chr_notes.sensors.log_time import Times
from chr_notes.sensors.recording import Recording, Report

_UNUSUAL = 0.05  # of gravity


def recorded(table: Table, settings: Settings) -> Recording:
    """Bring the columns of a log to units and axes, and report.

    Raises
    ------
    ValueError
        If a unit or the times cannot be told, or what is told contradicts the readings.
    """
    values, said = table.values, Said(settings.refuse)
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
    relations = log_turning.pairs(table, settings, said, times.dt, rest)
    axes = log_turning.axes(values, settings, said, rest, place)
    if "mag" in values:
        unit = known_unit(table, settings, "mag")
        said.units["mag"] = unit.name if unit else "unknown"
    usual = 1 / times.rate if times.rate else np.nan
    saturated, stuck, faults = log_checks.faults(values, settings.full_range, usual, place)
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
        rests=log_checks.stretches("accel", rest.blocks, rest.width, usual, place) if rest else (),
        columns={
            quantity: tuple(table.names[at] for at in each.places)
            for quantity, each in table.selected.items()
        },
        units=said.units,
        axes=log_axes.named(axes),
        relations=relations,
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


def _times(table: Table, settings: Settings, said: Said, count: int) -> Times:
    if settings.rate is not None:
        times = log_time.even(count, settings.rate, had_times="time" in table.values)
        if not log_time.is_possible(settings.rate):
            said.contradiction(
                f"rate: expected one of a sensor, from {log_time.RATES[0]:g} to "
                f"{log_time.RATES[1]:g} Hz, got {settings.rate:g}; pass on_contradiction='warn' "
                "if it is so"
            )
    elif "time" in table.values:
        unit = known_unit(table, settings, "time")
        if unit is not None and unit.name not in log_time.SECONDS:
            msg = f"units['time']: expected one of {[*log_time.SECONDS]}, got {unit.name!r}"
            raise ValueError(msg)
        name = unit.name if unit else None
        times = log_time.timed(table.values["time"][:, 0], name, table.place, said.contradiction)
        said.units["time"] = str(times.unit)
    else:
        times = Times(warnings=["there are no times, and so no dt: pass rate= to read_log, in Hz"])
    said.assumed += times.assumed
    said.warnings += times.warnings
    return times


def _accelerometer(table: Table, settings: Settings, said: Said) -> Rest | None:
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
        msg = (
            f"accel: expected readings of gravity, got a median norm of {norm:g}; pass readings "
            "that still have gravity, or columns={'accel': None} to leave them out"
        )
        raise ValueError(msg)
    known = known_unit(table, settings, "accel")
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
    return Rest(means * factor, blocks.tolist(), width)


def _temperature(table: Table, settings: Settings, said: Said) -> Floats | None:
    """Bring temperatures to degrees Celsius."""
    if "temperature" not in table.values:
        return None
    readings = table.values["temperature"][:, 0].copy()
    unit = known_unit(table, settings, "temperature")
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
