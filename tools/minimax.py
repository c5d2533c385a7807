"""Derive the polynomials of `chr_notes/native/elementary.h` and print them.

Each is the one of its degree whose largest relative error on the interval is least, found by
Remez' exchange in 50 digits: an error that swings evenly between its bounds cannot be made smaller.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

mp.dps = 50
Number = Any
ROUNDS, GRID = 12, 1200
# Of an interval that begins at zero, where the quotients below are 0/0.
NEXT_TO_ZERO = mpf("1e-30")
WIDER = mpf("1.0001")  # an angle that is rounded may lie beyond the end


@dataclass(frozen=True)
class Wanted:
    """A polynomial to find.

    Parameters
    ----------
    name
        The function of C that has it.
    function
        What it is to be, of the square of the function's argument.
    limit
        Its value at zero.
    weight
        By which an error counts.
    end
        Of the interval from zero.
    terms
        How many coefficients it has.
    """

    name: str
    function: Callable[[Number], Number]
    limit: Number
    weight: Callable[[Number], Number]
    end: Number
    terms: int

    def value(self, z: Number) -> Number:
        """Give what it is to be at z."""
        return self.function(z) if z > NEXT_TO_ZERO else self.limit


QUARTER, EIGHTH = (mp.pi / 4) ** 2 * WIDER, mp.tan(mp.pi / 8) ** 2 * WIDER
WANTED = (
    Wanted(
        "sine_tail",
        lambda z: (mp.sin(mp.sqrt(z)) / mp.sqrt(z) - 1) / z,
        mpf(-1) / 6,
        lambda z: z + mpf("1e-9"),
        QUARTER,
        6,
    ),
    Wanted(
        "cosine_of_square",
        lambda z: ((mp.cos(mp.sqrt(z)) - 1) / z + mpf(1) / 2) / z,
        mpf(1) / 24,
        lambda z: z * z + mpf("1e-9"),
        QUARTER,
        6,
    ),
    Wanted(
        "arctangent_tail",
        lambda z: (mp.atan(mp.sqrt(z)) / mp.sqrt(z) - 1) / z,
        mpf(-1) / 3,
        lambda z: z + mpf("1e-9"),
        EIGHTH,
        11,
    ),
)


def remez(wanted: Wanted) -> list[float]:
    """Find the coefficients, the constant one first, rounded to double precision."""
    count = wanted.terms + 1
    middle = wanted.end / 2
    points = [middle - middle * mp.cos(mp.pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    coefficients: list[Number] = []
    grid = [wanted.end * k / GRID for k in range(GRID + 1)]
    weighed = [(z, wanted.weight(z), wanted.value(z)) for z in grid]
    for _ in range(ROUNDS):
        rows, values = mp.matrix(count, count), mp.matrix(count, 1)
        for i, z in enumerate(points):
            for power in range(wanted.terms):
                rows[i, power] = z**power
            rows[i, wanted.terms] = (-1) ** i / wanted.weight(z)
            values[i] = wanted.value(z)
        solved = mp.lu_solve(rows, values)
        coefficients = [solved[power] for power in range(wanted.terms)]
        before, points = points, _extremes(weighed, coefficients, count) or points
        if points == before:
            break
    return [float(coefficient) for coefficient in coefficients]


def _extremes(
    weighed: list[tuple[Number, Number, Number]], coefficients: list[Number], count: int
) -> list[Number]:
    """Find where the error is largest, with alternating signs; nothing if there are too few.

    `weighed` has arguments, by what an error there counts, and what the polynomial is to be.
    """
    found: list[tuple[Number, Number]] = []
    for z, weight, value in weighed:
        error = weight * (value - mp.polyval(coefficients[::-1], z))
        if found and found[-1][1] * error > 0:
            if abs(error) > abs(found[-1][1]):
                found[-1] = z, error
        else:
            found.append((z, error))
    while len(found) > count:
        found.pop(0 if abs(found[0][1]) < abs(found[-1][1]) else -1)
    return [z for z, _ in found] if len(found) == count else []


def parts_of_half_pi() -> list[float]:
    """Three numbers that add up to pi/2; the first two end in zeros, so that products are exact."""
    first = mp.floor(mp.pi / 2 * 2**32) / 2**32
    second = mp.floor((mp.pi / 2 - first) * mpf(2) ** 66) / mpf(2) ** 66
    return [float(first), float(second), float(mp.pi / 2 - first - second)]


def main() -> None:
    """Print all."""
    lines = [f"half pi: {', '.join(part.hex() for part in parts_of_half_pi())}"]
    lines += [f"{w.name}: {', '.join(c.hex() for c in remez(w))}" for w in WANTED]
    print("\n".join(lines))  # noqa: T201 (a command prints)


if __name__ == "__main__":
    main()
