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
        "grows": "shrinks",
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
