"""Units of a log: given, told by names, or found by what a sensor can read."""

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.sensors.column_names import UNITS, unit_of
from chr_notes.sensors.log_time import SECONDS

FACTORS: dict[str, dict[str, float]] = {
    "time": SECONDS,
    "gyro": {"rad/s": 1.0, "deg/s": np.pi / 180, "mdeg/s": np.pi / 180e3},
    "accel": {"m/s^2": 1.0, "g": STANDARD_GRAVITY, "mg": STANDARD_GRAVITY / 1e3},
}
"""What turns a reading into rad/s or m/s²; the one of raw counts has to be given or found."""

NEAR = 1.33
"""By what factor the accelerometer may differ from gravity at rest."""

_ANYHOW = 4.0  # and where it never rests
_SAME = 5.0  # two factors between rates; 57 lie between radians and degrees
_FASTEST = 80.0  # rad/s, 4600 deg/s: more than gyros on a chip measure
_NOISE = (0.004, 0.03)  # at rest: a chip's in rad/s is below the first, in deg/s above the second
_TAKEN_AWAY = 0.3  # of gravity, is left at most where a phone or a chip takes it away
_COUNTS = 200.0  # the least raw counts of one gravity


@dataclass(frozen=True)
class Unit:
    """Unit of a quantity in a log.

    Parameters
    ----------
    name
        As it is known, such as "deg/s", or as it was given.
    factor
        What turns a reading into SI units; None for raw counts of unknown size.
    how
        "given", "told" by the names of the columns, "found", or "assumed".
    """

    name: str
    factor: float | None
    how: str


def given_units(units: Mapping[str, str | float] | None) -> dict[str, Unit]:
    """Read the units that the caller gives.

    Raises
    ------
    ValueError
        If a quantity or a unit is not known.
    """
    result = {}
    for quantity, text in (units or {}).items():
        if quantity not in UNITS:
            msg = f"units: expected quantities of {[*UNITS]}, got {quantity!r}"
            raise ValueError(msg)
        result[quantity] = _given(quantity, text)
    return result


def _given(quantity: str, text: str | float) -> Unit:
    if not isinstance(text, str):
        if not (np.isfinite(text) and text > 0):
            msg = f"units[{quantity!r}]: expected a unit or a positive number, got {text!r}"
            raise ValueError(msg)
        return Unit(f"{text:g} SI units", float(text), "given")
    many = re.fullmatch(r"\s*([\d.]+)\s*(?:LSB|counts?)?\s*(?:/|per)\s*\(?([^()]+)\)?\s*", text)
    part = re.fullmatch(r"\s*(.+?)\s*/\s*([\d.]+)\s*", text)
    number, base = (many[1], many[2]) if many else (part[2], part[1]) if part else ("1", text)
    name = unit_of(quantity, base)
    try:
        count = float(number)
    except ValueError:
        count = 0.0
    if name is None or not count > 0:
        known = [*UNITS[quantity]]
        msg = (
            f"units[{quantity!r}]: expected one of {known}, or counts of one such as "
            f"'{known[0]}/131', got {text!r}"
        )
        raise ValueError(msg)
    factor = FACTORS.get(quantity, {}).get(name)
    return Unit(text if number != "1" else name, factor and factor / count, "given")


def unit_of_accelerometer(
    known: Unit | None, norm: float, gravity: float, *, rested: bool, whole: bool
) -> Unit:
    """Find the unit of an accelerometer by its norm, or see whether the one that is known can be.

    Parameters
    ----------
    known
        Given or told.
    norm
        Median norm of the readings, at rest where it rests.
    gravity
        At the place, m/s².
    rested
        Whether the norm is one at rest.
    whole
        Whether the readings are whole numbers.

    Raises
    ------
    ValueError
        If the norm at rest is far from gravity, or no unit brings it near.
    """
    ratios = {name: norm * factor / gravity for name, factor in FACTORS["accel"].items()}
    like = next((name for name, ratio in ratios.items() if 1 / NEAR < ratio < NEAR), None)
    if known is None and like is None and whole and norm >= _COUNTS:
        known = Unit("counts", None, "found")
    if known is None:
        if like is None:
            msg = (
                f"accel: cannot tell its unit: expected a median norm of about {gravity:.4g} "
                f"(m/s^2), 1 (g) or 1000 (mg), got {norm:.4g}; pass units={{'accel': 'g'}}, or "
                "where gravity has been taken away the readings that still have it"
            )
            raise ValueError(msg)
        return Unit(like, FACTORS["accel"][like], "found")
    if known.factor is None:
        if norm < _COUNTS:
            msg = f"accel: expected raw counts, {_COUNTS:g} or more for gravity, got {norm:.4g}"
            raise ValueError(msg)
        # Ranges of chips are powers of two.
        count = 2 ** round(np.log2(norm))
        return Unit(f"g/{count}", STANDARD_GRAVITY / count, "found")
    ratio = norm * known.factor / gravity
    limit = NEAR if rested else _ANYHOW
    if 1 / limit < ratio < limit:
        return known
    if like:
        advice = f"units={{'accel': {like!r}}}"
    elif ratio < _TAKEN_AWAY:
        advice = "readings that still have gravity, for it seems to have been taken away, or units="
    else:
        advice = "units=, or gravity= for another gravity"
    msg = (
        f"accel: expected a norm of {gravity / known.factor:.4g} {known.name} "
        f"{'at rest' if rested else 'at the median'}, got {norm:.4g}; pass {advice}"
    )
    raise ValueError(msg)


def suits(factor: float, factors: Floats) -> bool:
    """Say whether one of the factors that a log allows is near this one."""
    return bool((np.abs(np.log(np.maximum(factors, 1e-30) / factor)) < np.log(_SAME)).any())


def unit_of_gyro(
    known: Unit | None, allowed: Floats | None, fastest: float, noise: float | None
) -> tuple[Unit, str | None]:
    """Find the unit of a gyro, or see whether the one that is known can be.

    Parameters
    ----------
    known
        Given or told.
    allowed
        Factors to rad/s that the other sensors allow, or None where they cannot tell.
    fastest
        Largest rate but for glitches.
    noise
        Standard deviation at rest, or None.

    Returns
    -------
    unit, reason : Unit, str or None
        By what it was found, or None.

    Raises
    ------
    ValueError
        If the unit cannot be told, or cannot be.
    """
    names = FACTORS["gyro"]
    like = [name for name in names if allowed is not None and suits(names[name], allowed)]
    if allowed is not None and known is not None and known.factor is not None:
        if suits(known.factor, allowed):
            return known, None
        advice = f"units={{'gyro': {like[0]!r}}}" if like else "units= or the unit of time"
        msg = (
            f"gyro: expected rates in {known.name}, by the unit {known.how}, got readings of which "
            f"one is {allowed[0]:.3g} rad/s by how the other sensors turn; pass {advice}"
        )
        raise ValueError(msg)
    if known is None and len(like) == 1:
        return Unit(like[0], names[like[0]], "found"), "how the sensors turn"
    if known is not None and known.factor is not None:
        if fastest * known.factor > _FASTEST:
            msg = (
                f"gyro: expected at most {_FASTEST:g} rad/s, got {fastest:.4g} {known.name}, by "
                f"the unit {known.how}; pass units={{'gyro': 'deg/s'}}"
            )
            raise ValueError(msg)
        return known, None
    told = known is None and (allowed is None or bool(like))  # else no unit fits the others
    if told and fastest > _FASTEST:
        return Unit("deg/s", names["deg/s"], "found"), f"rates of {fastest:.4g}"
    if told and noise is not None and (0 < noise < _NOISE[0] or noise > _NOISE[1]):
        name = "rad/s" if noise < _NOISE[0] else "deg/s"
        return Unit(name, names[name], "assumed"), f"a noise of {noise:.2g} at rest"
    seen = "" if allowed is None else f"; by how the others turn, {1 / allowed[0]:.4g} a rad/s"
    msg = (
        f"gyro: cannot tell its unit{' from raw counts' * (known is not None)}{seen}; pass "
        "units={'gyro': 'deg/s'}, 'rad/s', or counts such as 'deg/s/131'"
    )
    raise ValueError(msg)
