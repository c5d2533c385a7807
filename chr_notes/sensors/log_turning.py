"""Body rates and axes of a log: what the sensors tell by how they turn, and where up is."""

from collections.abc import Callable

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._turning import in_doubt
from chr_notes.sensors import log_axes, log_checks, log_pairs, log_units
from chr_notes.sensors.column_names import SENSORS
from chr_notes.sensors.log_pairs import Pair
from chr_notes.sensors.log_settings import Rest, Said, Settings, known_unit
from chr_notes.sensors.log_table import Table
from chr_notes.sensors.log_units import Unit

_QUIET_BLOCKS = 40
_TWO = 2  # of three pairs two tell of the third
_NEGATED = "whether the accelerometer is negated"


def pairs(
    table: Table, settings: Settings, said: Said, dt: Floats | None, rest: Rest | None
) -> dict[str, str]:
    """Bring body rates to rad/s, and see whether the sensors have the same axes."""
    values = table.values
    pairs: dict[tuple[str, str], Pair] = {}
    if "gyro" in values:
        pairs |= _gyro(table, settings, said, dt, rest)
    if "accel" in values and "mag" in values:
        pairs["accel", "mag"] = log_pairs.by_angle(values["accel"], values["mag"])
    wrong = log_pairs.disagreement(pairs)
    if wrong:
        said.contradiction(wrong)
    if sum(pair.known for pair in pairs.values()) < len(pairs) - (len(pairs) > _TWO):
        for (one, other), pair in pairs.items():
            if not pair.known:
                said.cannot_tell.append(f"whether {one} and {other} have the same axes and signs")
    if "gyro" not in values:
        said.cannot_tell.append("whether the axes are right-handed, without a gyro")
    if "mag" in values:
        said.cannot_tell.append("whether the magnetometer is negated")
    return {" and ".join(sensors): pair.how for sensors, pair in pairs.items()}


def _gyro(
    table: Table, settings: Settings, said: Said, dt: Floats | None, rest: Rest | None
) -> dict[tuple[str, str], Pair]:
    """Bring body rates to rad/s, and compare the gyro with the other sensors."""
    values, gyro = table.values, table.values["gyro"]
    known = known_unit(table, settings, "gyro")
    factors = [log_units.FACTORS["gyro"][name] for name in ("rad/s", "deg/s")]
    if known is not None and known.factor is not None and known.factor not in factors:
        factors.append(known.factor)
    relations, between = {}, None
    if dt is not None and rest is not None:
        places = log_checks.stretches("accel", rest.blocks, rest.width, np.nan, str)
        stretches = [(each.start, each.stop) for each in places]
        between = log_pairs.between_rests(gyro, values["accel"], dt, stretches, factors)
    if between is not None and not between.tells:
        between = None
    if dt is not None:
        # Rests tell of the accelerometer more surely than its turning does.
        others = [name for name in ("mag", "accel") if name in values]
        others = [name for name in others if name == "mag" or between is None]
        relations = log_pairs.relations(gyro, {name: values[name] for name in others}, dt)
    tells = [each for each in relations.values() if np.isfinite(each.factors).all()]
    certain = [each for each in tells if each.known]
    allowed = np.concatenate([each.factors for each in certain or tells]) if tells else None
    if between is not None:
        allowed = np.array(factors)[between.residuals.min(axis=1) < log_pairs.FITS]
    unit = _unit_of_gyro(known, gyro, allowed, rest, said)
    gyro *= float(unit.factor or 1.0)
    if dt is not None and between is None and not certain:
        _by_turning(values, dt, unit, said)
    if allowed is None and unit.how in ("given", "told"):
        said.cannot_tell.append(f"whether the gyro is in {unit.name}, as it is {unit.how}")
    pairs: dict[tuple[str, str], Pair] = {}
    for name, each in relations.items():
        pairs[name, "gyro"] = log_pairs.by_turning(each, steady=name == "mag")
    if between is not None and unit.factor in factors:
        pairs["accel", "gyro"] = between.pair(factors.index(unit.factor))
    return pairs


def _by_turning(values: dict[str, Floats], dt: Floats, unit: Unit, said: Said) -> None:
    """Refuse a unit that is wrong by 57, of a gyro of which no more than that can be told."""
    for name in ("mag", "accel"):
        doubt = in_doubt(values["gyro"], values[name], dt) if name in values else None
        if doubt is not None:
            right = {"rad/s": "deg/s", "deg/s": "rad/s"}.get(unit.name)
            advice = f"pass units={{'gyro': {right!r}}}" if right else "pass units="
            times = "a 57th of" if "°" in doubt else "57 times"
            said.contradiction(
                f"gyro: expected rates in {unit.name}, by the unit {unit.how}, got readings that "
                f"turn {name} as it does turn if one is {times} that; {advice}"
            )
            return


def _unit_of_gyro(
    known: Unit | None, gyro: Floats, allowed: Floats | None, rest: Rest | None, said: Said
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


def _noise(gyro: Floats, rest: Rest | None) -> float | None:
    """Take the standard deviation of a gyro where the accelerometer rests; None without rest."""
    if rest is None or not rest.blocks:
        return None
    every = max(1, len(rest.blocks) // _QUIET_BLOCKS)
    parts = [gyro[b * rest.width : (b + 1) * rest.width] for b in rest.blocks[::every]]
    spread = [float(part.std(axis=0).max()) for part in parts]
    finite = [each for each in spread if np.isfinite(each)]
    return float(np.median(finite)) if finite else None


def axes(
    values: dict[str, Floats],
    settings: Settings,
    said: Said,
    rest: Rest | None,
    place: Callable[[int], str],
) -> Floats:
    """Bring all sensors to forward-right-down."""
    matrix = settings.axes.get("all")
    up, where = None, ""
    if rest is not None and rest.blocks:
        up = rest.means[0]
        where = f"at its first rest ({place(rest.blocks[0] * rest.width)})"
    elif "accel" in values:
        up, where = np.nanmean(values["accel"], axis=0), "on the whole, for it never rests"
    if up is not None and settings.level:
        matrix = _level(up, where, said) if matrix is None else _agreeing(matrix, up, where, said)
    else:
        if matrix is None:
            matrix = np.eye(3)
            said.cannot_tell.append("the axes of the log: they are taken for forward, right, down")
        if up is not None:
            said.cannot_tell.append(_NEGATED)
    for name in SENSORS:
        if name in values and not np.array_equal(matrix, np.eye(3)):
            log_axes.turn(values[name], matrix)
    return matrix


def _agreeing(matrix: Floats, up: Floats, where: str, said: Said) -> Floats:
    """Compare given axes with where a level sensor's specific force points."""
    found, level = log_axes.levelled(matrix @ up)
    if level and found is not None and found[2, 2] < 0:
        said.contradiction(
            f"axes: expected a specific force that points up of a level sensor, got "
            f"{np.array2string(matrix @ up, precision=2)} m/s² {where} in the axes given, "
            f"{log_axes.named(matrix)}; pass {_right_axes(up)}"
            "axes={'accel': '-x -y -z'} for one that reads gravity, or level=False if it does "
            "not lie level"
        )
    elif not level:
        said.warnings.append(f"the sensor does not lie level {where}")
        said.cannot_tell.append(_NEGATED)
    return matrix


def _right_axes(up: Floats) -> str:
    """Name the axes of a sensor that lies level, if z is its vertical one."""
    found, _ = log_axes.levelled(up)
    if found is None:
        return ""
    above = found[2, 2] < 0
    return f"axes='{'flu' if above else 'frd'}', for its z points {'up' if above else 'down'}, or "


def _upward(up: Floats) -> str:
    """Name the axis of a log that points up."""
    place = int(np.abs(up).argmax())
    return f"{'+' if up[place] > 0 else '-'}{'xyz'[place]}"


def _candidates(up: Floats) -> str:
    """Name the four right-handed readings of the axes that have this one up, by their downs."""
    down = _upward(up).translate(str.maketrans("+-", "-+")).removeprefix("+")
    fitting = [named for named in map(log_axes.named, log_pairs.SIGNED) if named.split()[2] == down]
    proper = [each for each in fitting if np.linalg.det(log_axes.matrix_of("axes", each)) > 0]
    return ", ".join(f"'{each}'" for each in proper)


def _level(up: Floats, where: str, said: Said) -> Floats:
    """Tell z up from z down by where a level sensor's specific force points."""
    matrix, _ = log_axes.levelled(up)
    if matrix is None:
        said.cannot_tell.append("the axes of the log: they are taken for forward, right, down")
        said.warnings.append(
            f"z is not near the vertical {where}, but {_upward(up)} points up: if the sensor lay "
            f"level there, pass axes= with forward, right, down, one of {_candidates(up)}"
        )
        said.cannot_tell.append(_NEGATED)
        return np.eye(3)
    name = "flu: z points up" if matrix[2, 2] < 0 else "frd: z points down"
    said.assumed.insert(0, f"axes are {name}, for the sensor is taken to lie level {where}")
    said.cannot_tell.append(f"{_NEGATED} instead of z turned over")
    return matrix
