"""What a column of a log holds, told from its name: quantity, axis and unit."""

import re
from dataclasses import dataclass

SENSORS = ("gyro", "accel", "mag")
"""Quantities of three axes."""

QUANTITIES = {
    "time": "t time timestamp stamp seconds elapsed millis micros clock secs datetime",
    "gyro": "g gyr gyro gyros gyroscope w omega angularrate angularvelocity bodyrates rotationrate",
    "accel": "a acc accel accelerometer acceleration accelerations specificforce",
    "mag": "m b mag magn magnetometer magnetic magneticfield",
    "temperature": "temp temperature",
}
"""Words for each quantity, one of which stands in the name of its columns."""

UNITS = {
    "time": {
        "s": "s sec secs second seconds",
        "ms": "ms msec msecs millis millisecond milliseconds",
        "us": "us usec usecs micros microsecond microseconds",
        "ns": "ns nsec nsecs nanos nanosecond nanoseconds",
    },
    "gyro": {
        "rad/s": "rad rads radps radsec rads1 radianss radianssec radianspersecond",
        "deg/s": "deg degs degps dps degsec degs1 degreess degreessec degreespersecond",
        "mdeg/s": "mdps mdegs",
        "counts": "raw count counts lsb",
    },
    "accel": {
        "m/s^2": "ms2 mps2 mss msec2 metrespersecondsquared meterspersecondsquared",
        "g": "g gs g0 gn",
        "mg": "mg millig",
        "counts": "raw count counts lsb",
    },
    "mag": {
        "uT": "ut microtesla",
        "nT": "nt nanotesla",
        "mT": "mt millitesla",
        "T": "t tesla",
        "gauss": "g ga gs gauss",
        "mgauss": "mg mga mgauss milligauss",
        "counts": "raw count counts lsb",
    },
    "temperature": {
        "degC": "degc c celsius",
        "K": "k kelvin",
        "degF": "degf f fahrenheit",
        "counts": "raw count counts lsb",
    },
}
"""For each quantity its units, and how else they are written once signs are left out."""

_WORDS = {word: kind for kind, words in QUANTITIES.items() for word in words.split()}
_SPELLINGS = {
    kind: {text: unit for unit, texts in units.items() for text in texts.split()}
    for kind, units in UNITS.items()
}
# In names of columns that are no reading, or one from which something has been taken away.
_FOREIGN = (
    "user gravity orientation attitude quat quaternion covariance var std sigma ref bias offset "
    "scale error roll pitch yaw heading setpoint position velocity fine seq index count "
    "saturation clipping norm magnitude total"
)
_NO_READING = frozenset(_FOREIGN.split())
_LETTERS = frozenset("xyz")
_AXES = _LETTERS | frozenset("0123")
_ALONE = {"p": "x", "q": "y", "r": "z"}  # body rates, as flight mechanics calls them
BRACKETS = re.compile(r"[(\[{<]([^)\]}>]*)[)\]}>]")
"""What stands in brackets in a name."""

_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_SIGNS = str.maketrans({"°": "deg", "º": "deg", "µ": "u", "μ": "u", "²": "2", "¹": "1"})


@dataclass(frozen=True)
class Meaning:
    """What a column holds.

    Parameters
    ----------
    quantity
        "time", "gyro", "accel", "mag" or "temperature".
    axis
        "x", "y", "z" or a digit, or None where the name has none.
    unit
        As `UNITS` calls it, or None where the name has none that is known.
    """

    quantity: str
    axis: str | None
    unit: str | None


def unit_of(quantity: str, text: str) -> str | None:
    """Read a unit as people write it: "m/s²", "ms-2", "deg/s", "°/s", "dps".

    Parameters
    ----------
    quantity
        Of which it is the unit, a key of `UNITS`.
    text
        The unit.

    Returns
    -------
    str or None
        Its name in `UNITS`, or None for a unit that is not known.
    """
    plain = re.sub(r"[^a-z0-9]", "", text.translate(_SIGNS).lower())
    return _SPELLINGS[quantity].get(plain)


def meaning(name: str) -> Meaning | None:
    """Tell from the name of a column what it holds.

    Parameters
    ----------
    name
        As "ax", "acc_x", "Accelerometer X (g)", "gyro_rad[0]", "linear_acceleration.x", "t_ms".

    Returns
    -------
    Meaning or None
        None for a column that is none of a sensor's.
    """
    name = name.translate(_SIGNS)
    inside = [text.strip() for text in BRACKETS.findall(name)]
    words = " ".join(_PARTS.findall(BRACKETS.sub(" ", name))).lower()
    parts = words.replace("angular velocity", "angularvelocity").split()
    if not parts or not _NO_READING.isdisjoint(parts):
        return None
    in_brackets = [text.lower() for text in inside if text.lower() in _AXES]
    scalar = _scalar(parts, inside)
    if scalar is not None and not in_brackets:
        return scalar
    vector = _vector(parts, in_brackets)
    if vector is None:
        return None
    quantity, axis, rest = vector
    units = [*inside, *("".join(rest[start:]) for start in range(len(rest)))]
    unit = next(filter(None, (unit_of(quantity, text) for text in units)), None)
    return Meaning(quantity, axis, unit)


def _scalar(parts: list[str], inside: list[str]) -> Meaning | None:
    """Find a time, or a temperature, of a sensor too, as in "gyro_temp"."""
    if not {*parts}.isdisjoint(_LETTERS):
        return None
    merged = re.fullmatch(r"(t|time|timestamp)(ms|us|ns)", parts[0])
    if merged:
        parts = [merged[1], merged[2], *parts[1:]]
    units = [*inside, *parts[1:], "".join(parts[1:])]
    degrees = next(filter(None, (unit_of("temperature", text) for text in units)), None)
    warm = any(len(part) > 1 and _WORDS.get(part) == "temperature" for part in parts)
    if warm or (parts[0] == "t" and degrees):
        return Meaning("temperature", None, degrees)
    if parts[0] == "t" or any(len(part) > 1 and _WORDS.get(part) == "time" for part in parts):
        unit = next(filter(None, (unit_of("time", text) for text in [*units, parts[0]])), None)
        return Meaning("time", None, unit) if len(parts[0]) > 1 or unit or not parts[1:] else None
    return None


def _vector(parts: list[str], given: list[str]) -> tuple[str, str | None, list[str]] | None:
    """Find the word of a sensor, the axis, and what stands behind both."""
    if parts[0] in _ALONE and (len(parts) == 1 or unit_of("gyro", "".join(parts[1:]))):
        return "gyro", _ALONE[parts[0]], parts[1:]
    letters = [part for part in parts if part in _LETTERS]
    for place, part in enumerate(parts):
        rest = parts[place + 1 :]
        if part[:-1] in _WORDS and part[-1] in _LETTERS:
            return _WORDS[part[:-1]], part[-1], rest
        axes = [*given, *letters, *(each for each in rest[:1] if each in _AXES)]
        kind = _WORDS.get(part + "".join(rest[:1]), _WORDS.get(part))
        if kind is not None and (len(part) > 1 or rest[:1] == axes[:1] != []):
            axis = axes[0] if axes else None
            if axis in rest and not given:
                rest = rest[rest.index(axis) + 1 :]
            return kind, axis, rest
    return None
