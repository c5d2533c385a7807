"""Units that an answer may have, what is said of answers, and usual mistakes by their names."""

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

__all__ = ["MISCONCEPTIONS", "UNITS", "WORDS"]

_DEGREE: Final = math.pi / 180

UNITS: Final[Mapping[str, tuple[str, float]]] = MappingProxyType(
    {
        "°": ("an angle", _DEGREE),
        "deg": ("an angle", _DEGREE),
        "degrees": ("an angle", _DEGREE),
        "rad": ("an angle", 1.0),
        "°/s": ("a rate of turn", _DEGREE),
        "deg/s": ("a rate of turn", _DEGREE),
        "rad/s": ("a rate of turn", 1.0),
        "°/h": ("a rate of turn", _DEGREE / 3600),
        "m": ("a length", 1.0),
        "mm": ("a length", 1e-3),
        "cm": ("a length", 1e-2),
        "km": ("a length", 1e3),
        "s": ("a time", 1.0),
        "ms": ("a time", 1e-3),
        "min": ("a time", 60.0),
        "h": ("a time", 3600.0),
        "m/s": ("a speed", 1.0),
        "km/h": ("a speed", 1 / 3.6),
        "m/s^2": ("an acceleration", 1.0),
        "g": ("an acceleration", 9.80665),
        "Hz": ("a frequency", 1.0),
        "T": ("a field", 1.0),
        "µT": ("a field", 1e-6),
        "uT": ("a field", 1e-6),
        "": ("a number", 1.0),
        "%": ("a number", 0.01),
    }
)
"""What a unit is of, and what a number has to be multiplied by to be in the first of its kind."""

WORDS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "empty": "Put a number into the box.",
        "unread": "This cannot be read from “{0}” on. Write it like 0.5, 3*pi/4 or 12 m/s.",
        "ends": "Something is missing at the end.",
        "unknown": "The unit “{0}” is not known here. The answer is read in {1}.",
        "kind": "That is {0}; what is asked for is {1}.",
        "one": "One number is asked for. Commas stand between numbers; decimals follow a point.",
        "several": "{0} numbers are asked for, with commas between; the count of yours is {1}.",
        "no value": "That has no value, such as a division by zero.",
        "right": "Right.",
        "other unit": "Right in {0}. A number without a unit is read in {1} here.",
        "sign": "The size is right, the sign is not.",
        "not yet": "Not yet. The way there is folded in below.",
        "close": "Well guessed: it is {0}.",
        "under": "It is {0}: {1} times your guess.",
        "over": "It is {0}: your guess is {1} times that.",
        "far": "It is {0}.",
        "other way": "It is {0}: the sign is the other one.",
    }
)
"""All replies; what stands in braces is filled in."""

MISCONCEPTIONS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "transposed": "That is the matrix the other way round: the way back for the way there.",
        "degrees for radians": "Degrees went into a function that takes radians.",
        "radians for degrees": "That is in radians; degrees are asked for.",
        "wrong quadrant": "Arctangents of quotients take opposite quadrants for one: use atan2.",
        "sign of gravity": "Gravity has the other sign here: what is felt at rest points up.",
        "sign": "A sign is the other way round on the way.",
        "order of turns": "That is what the turns give in the other order.",
        "half angle": "A quaternion has half the angle in it.",
        "scalar last": "That takes the scalar for the last of the four; here it is the first.",
        "conjugate": "That is the other reading of the quaternion: its conjugate.",
        "lost factor": "A factor was lost on the way.",
        "as printed": "That is what the note has: its card says when it holds.",
        "small angle": "The formula for small angles is not good enough here.",
        "per sample": "That is for another time between samples.",
        "wrong axis": "The right idea about another axis.",
        "half done": "One of the steps is still missing.",
        "upside down": "That is the quotient upside down.",
        "nearly": "That is an approximation, and not a good one here.",
        "arcsine": "The arcsine takes the length for known; an arctangent does without.",
        "squares": "A square or a root is not in its place.",
    }
)
"""Usual mistakes by name, and what to say to someone who made one."""
