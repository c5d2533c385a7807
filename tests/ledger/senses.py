"""Words whose sense is turned round on purpose, as `misprints` does with formulas."""

import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType

TURNED: Mapping[str, str] = MappingProxyType(
    {
        "negative": "positive",
        "never measures": "measures",
        "not ": "",
        "cannot": "can",
        "Yaw": "Roll",
        "yaw": "roll",
        "Roll": "Yaw",
        "roll": "yaw",
        "Pitch": "Yaw",
        "pitch": "roll",
        "z-axis": "x-axis",
        "inertial": "body",
        "vehicle-1": "vehicle-3",
        "larger": "smaller",
        "fewer": "more",
        "less": "more",
        "more": "less",
        "diverge": "converge",
        "drifts": "stays",
        "can differ": "agree",
        "depends": "rests",
        "upwards": "downwards",
        "zero": "one",
        "One": "Two",
        "Two": "One",
        "ten minutes": "five minutes",
    }
)
"""Words of sense, and others that turn the sense round."""


def wrong_senses(says: str) -> Iterator[tuple[str, str]]:
    """Yield (kind, our words with one of them turned round, or with a number that is another)."""
    for word, other in TURNED.items():
        if word in says:
            yield f"{word!r} to {other!r}", says.replace(word, other, 1)
    for place, number in enumerate(re.finditer(r"(?<![\w.-])\d+", says), 1):
        wrong = f"{says[: number.start()]}{int(number[0]) + 1}{says[number.end() :]}"
        yield f"number {place}", wrong


_OPPOSITES = """
more less, larger smaller, before after, always never, body inertial, up down, upwards downwards,
positive negative, first last, left right, x y, y z, x-axis y-axis, y-axis z-axis,
roll pitch, pitch yaw, accelerometer gyro, gyros magnetometers, magnetometer accelerometer,
velocity position, acceleration velocity, sine cosine, product sum, one two, two three, three four,
ten five, all some, every no, any no, only also, exactly roughly, cannot can, without with,
from to, into out, same opposite, equal unequal, differ agree, converges diverges, zero one,
nothing everything, minus plus, reverse same, inverse transpose, conjugate inverse, real imaginary,
soft hard, sphere cube, ellipsoid sphere, gravity friction, bias noise, drift settle, drifts stays,
external internal, normal tangential, free bound, rest motion, constant varying, south north,
flat upright, minute hour, degrees radians, km m, percent degrees, s min, above below, away towards,
unique ambiguous, once twice, combined separated, add subtract, added removed, matrix vector,
quaternion matrix, measured actual, integral derivative, derivatives integrals, sensitive immune,
correction distortion, short long, depends rests, leaves moves, optimally badly, because although,
and or, inertial vehicle-1, vehicle-2 vehicle-1, clockwise anticlockwise
"""


def turned_by_a_stranger(says: str) -> Iterator[str]:
    """Yield our words with one of them, the first of its kind, turned into its opposite."""
    for one, other in (pair.split() for pair in _OPPOSITES.split(",")):
        for word, instead in ((one, other), (other, one)):
            found = re.search(rf"(?<![\w'-]){word}(?![\w'-])", says, re.IGNORECASE)
            if found is not None:
                yield f"{says[: found.start()]}{instead}{says[found.end() :]}"
