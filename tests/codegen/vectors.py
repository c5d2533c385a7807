"""The file of vectors that every language must meet: arguments, and results by mpmath."""

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import mpmath

from chr_notes.codegen.target import Target
from chr_notes.codegen.targets import TARGETS

from .reference import Reference

RANDOM_VECTORS = 12
POSITIVE = (
    "dt",
    "gravity",
    "time",
    "gain",
    "time_constant",
    "heading_time_constant",
    "longest_step",
    "averaged",
    "heading_averaged",
    "settled",
    "mean_length",
    "field_length",
    "field_known",
    "still",
)
ANGLE_NAMES = ("roll", "pitch", "yaw", "angle", "angle_error", "first", "second", "third")
# Any two of the ends make a sequence with this middle; other numbers are tried one by one.
AXES = {"first_axis": (1.0, 3.0), "second_axis": (2.0,), "third_axis": (1.0, 3.0)}


@dataclass(frozen=True)
class Vector:
    """Arguments of a target and the results for them.

    Parameters
    ----------
    target
        Which function.
    arguments
        Numbers of the type that computes.
    results
        With 50 digits; a flag is 0 or 1.
    """

    target: Target
    arguments: tuple[float, ...]
    results: tuple[mpmath.mpf, ...]


def special_values(name: str, rounded: Callable[[float], float], epsilon: float) -> list[float]:
    """Values at which something may go wrong, for an argument of that name."""
    if name in AXES:
        return [0.0, 1.0, 1.5, 2.0, 3.0, 4.0, math.nan]
    values = [0.0, -0.0, 1.0, -1.0, math.nan, math.inf, -math.inf]
    if name in ANGLE_NAMES:
        for pole in (rounded(math.pi), rounded(math.pi / 2)):
            for value in (pole, pole * (1 - epsilon), pole * (1 + epsilon)):
                values += [rounded(value), -rounded(value)]
    return values


def arguments(
    target: Target, rounded: Callable[[float], float], epsilon: float
) -> Iterator[tuple[float, ...]]:
    """Random arguments, and random ones of which one has a special value."""
    names = [argument.name for argument in target.arguments]
    source = random.Random(target.name)  # noqa: S311 (no secret)
    for _ in range(RANDOM_VECTORS):
        yield tuple(rounded(_draw(name, source)) for name in names)
    yield (0.0,) * len(names)
    many = len(names) > 9
    for place, name in enumerate(names):
        few = (0.0, math.nan, math.inf)
        for value in few if many and name not in AXES else special_values(name, rounded, epsilon):
            drawn = [rounded(_draw(other, source)) for other in names]
            drawn[place] = value
            yield tuple(drawn)
    if names[:4] == ["a", "b", "c", "d"]:
        # Gimbal lock upwards and downwards, and as near to it as numbers go.
        for c in (1.0, -1.0):
            rest = [rounded(_draw(name, source)) for name in names[4:]]
            yield (1.0, 0.0, c, 0.0, *rest)
            yield (0.5, c, 0.5 * c, -1.0, *rest)
            yield (1.0, 0.25, rounded(c + 1e-3), -0.25 * c, *rest)


def _draw(name: str, source: random.Random) -> float:
    if name in AXES:
        return source.choice(AXES[name])
    if name in ANGLE_NAMES:
        return source.uniform(-3.0, 3.0)
    if name in POSITIVE:
        return source.uniform(0.1, 1.0)
    # Off zero, so that a quotient is as exact as its parts.
    return source.choice((-1, 1)) * source.uniform(0.3, 1.2)


@cache
def vectors(reference: Reference) -> list[Vector]:
    """Make all vectors of one precision."""
    return [
        Vector(target, values, tuple(map(_number, reference.results(target, values))))
        for target in TARGETS
        for values in arguments(target, reference.rounded, reference.epsilon)
    ]


def _number(value: object) -> mpmath.mpf:
    return mpmath.mpf(int(value)) if isinstance(value, bool) else value


def write(path: Path, made: list[Vector]) -> None:
    """Write the file: a line a vector, the name, then arguments, then results."""
    lines = []
    for vector in made:
        numbers = [*vector.arguments, *map(float, vector.results)]
        lines.append(" ".join([vector.target.name, *(text(number) for number in numbers)]))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def text(number: float) -> str:
    """Write a number as C's strtod and JavaScript's Number read it."""
    if math.isinf(number):
        return "Infinity" if number > 0 else "-Infinity"
    return "NaN" if math.isnan(number) else repr(number)
