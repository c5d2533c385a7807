"""Noise that is the same in Python and in JavaScript."""

import math
from collections.abc import Iterator
from typing import Final

__all__ = ["MODULUS", "MULTIPLIER", "noise"]

MULTIPLIER: Final = 48271
MODULUS: Final = 2**31 - 1
"""Park and Miller's source of even chances: its numbers are whole and exact as doubles too."""


def noise(seed: int) -> Iterator[float]:
    """Yield noise of variance 1, each value the sum of four even chances."""
    while True:
        total = 0.0
        for _ in range(4):
            seed = MULTIPLIER * seed % MODULUS
            total += seed / MODULUS
        yield math.sqrt(3) * (total - 2)
