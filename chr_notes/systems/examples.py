"""Examples of what programs say of rotations: read, rounded as they are, and compared."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from chr_notes._arrays import Floats, floats
from chr_notes._odd_rows import ROTATION_TOLERANCE
from chr_notes.systems.convention import Convention

TRIED = ((30.0, 0.0, 0.0), (0.0, 30.0, 0.0), (0.0, 0.0, 30.0), (10.0, 20.0, 30.0), (1.0, 0.5, 0.25))
"""Angles to try for an example that decides: the simplest that does is taken."""
ATTITUDES = ("angles", "matrix", "quaternion")
"""Kinds that say a whole attitude, in this order."""
_SHAPES = {"angles": (3,), "matrix": (3, 3), "quaternion": (4,), "accel": (3,)}
MOST_DECIMALS = 12
LEAST_ERROR = 1e-9
MOST_ERROR = 0.03
"""Radians; whole degrees may be off by as much. Numbers with fewer digits count as exact."""
# Elements off by half of the last digit each; a quaternion has half the angle.
ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth")
"""Readers count from one."""
SIZES = {"matrix": 3.0, "quaternion": 2.0, "vectors": 4.0, "accel": 1.0}
"""How far off a value may be, in units of its last digit."""


@dataclass(frozen=True)
class Examples:
    """What programs say, one example a row.

    Parameters
    ----------
    values
        By kind; of `vectors` before and after along the second axis.
    rounding
        How far each may be off in attitude, radians; of angles as if they were in radians.
    """

    values: Mapping[str, Floats]
    rounding: Mapping[str, float]

    @property
    def count(self) -> int:
        """How many examples there are."""
        return len(next(iter(self.values.values())))

    def one(self, number: int) -> "Examples":
        """Keep one example alone."""
        return Examples({k: v[number : number + 1] for k, v in self.values.items()}, self.rounding)

    def of(self, kinds: Iterable[str]) -> "Examples":
        """Keep some kinds alone."""
        return Examples({kind: self.values[kind] for kind in kinds}, self.rounding)

    def first_is_to_body(self, convention: Convention) -> bool:
        """Whether the first kind is taken for what leads to the body."""
        kind = next(iter(self.values))
        return bool(
            convention.matrix == "to body"
            if kind == "matrix"
            else convention.quaternion == "to navigation"
        )


def examples(given: Mapping[str, Any]) -> Examples:
    """Check what is given, and bring it to unit length.

    Raises
    ------
    ValueError
        If fewer than two kinds are given, shapes do not fit, or there is a row without numbers.
    """
    kinds = [kind for kind, value in given.items() if value is not None]
    if len(kinds) < 2 or set(kinds) == {"accel", "vectors"}:  # noqa: PLR2004 (a pair)
        msg = f"expected two or more of {', '.join(given)}, one of them an attitude, got {kinds}"
        raise ValueError(msg)
    values = {kind: _rows(kind, given[kind]) for kind in kinds}
    counts = {kind: len(value) for kind, value in values.items()}
    if len(set(counts.values())) > 1 or 0 in counts.values():
        msg = f"expected as many examples of each, got {counts}"
        raise ValueError(msg)
    for kind, value in values.items():
        if not np.isfinite(value).all():
            msg = f"{kind}: expected numbers, got NaN or infinity"
            raise ValueError(msg)
    rounding = {kind: _rounding(kind, value) for kind, value in values.items()}
    unit = {kind: _unit(kind, value, rounding[kind]) for kind, value in values.items()}
    return Examples(unit, rounding)


def _rows(kind: str, value: Any) -> Floats:  # noqa: ANN401 (an array or a pair)
    if kind == "vectors":
        before, after = (floats(f"vectors[{place}]", value[place], 3) for place in (0, 1))
        return np.stack([before.reshape(-1, 3), after.reshape(-1, 3)], axis=1)
    shape = _SHAPES[kind]
    return floats(kind, value, *shape).reshape(-1, *shape)


def _rounding(kind: str, values: Floats) -> float:
    """Find how far a value may be off, from the number of decimals that are printed."""
    unit = 10.0**-MOST_DECIMALS
    for decimals in range(MOST_DECIMALS):
        if np.abs(values - values.round(decimals)).max() < 1e-9 * 10.0**-decimals:
            unit = 10.0**-decimals
            break
    if kind == "angles":
        return 1.5 * unit  # half of the last digit in each of three turns
    length = np.sqrt((values.reshape(len(values), -1) ** 2).sum(axis=1)).min()
    return float(SIZES[kind] * unit / max(length, unit))


def _unit(kind: str, values: Floats, rounding: float) -> Floats:
    """Give quaternions and directions unit length, and matrices right angles."""
    if kind == "angles":
        return values
    if kind == "matrix":
        left, _, right = np.linalg.svd(values)
        rotations = left @ right
        flipped = np.flatnonzero(np.linalg.det(rotations) < 0)
        if flipped.size:
            msg = f"matrix: expected rotations, got a reflection in {the_example(flipped[0])}"
            raise ValueError(msg)
        _refuse_misprints(values, rotations, rounding)
        return np.asarray(rotations)
    lengths = np.linalg.norm(values, axis=-1, keepdims=True)
    if not lengths.all():
        msg = f"{kind}: expected no row of zeros, got one"
        raise ValueError(msg)
    return np.asarray(values / lengths)


def _refuse_misprints(values: Floats, rotations: Floats, rounding: float) -> None:
    """Raise for a matrix that is farther from a rotation than its digits allow."""
    size = (values * rotations).sum(axis=(1, 2)) / 3  # by least squares
    off = np.abs(values / size[:, np.newaxis, np.newaxis] - rotations)
    # Digits may be cut off instead of rounded.
    wrong = np.flatnonzero(np.linalg.norm(off, axis=(1, 2)) > 2 * rounding + ROTATION_TOLERANCE)
    if wrong.size:
        number = wrong[0]
        msg = (
            f"matrix: expected rotations, but {the_example(number)} is none: its elements are off "
            f"the nearest one by up to {off[number].max():.4f}, more than by its digits"
        )
        raise ValueError(msg)


def the_example(number: int) -> str:
    """Name an example by its place, in words."""
    return f"the {ORDINALS[number]} example" if number < len(ORDINALS) else f"example {number + 1}"


Reading = tuple[dict[str, Any], Floats | None]


def turned_apart(given: Examples, readings: Mapping[str, list[Reading]]) -> tuple[Floats, Floats]:
    """Find the largest angle between what programs say, and how large it may be.

    Parameters
    ----------
    given
        What they say.
    readings
        By kind the ways to read it: fields of a convention, and for each kind of `ATTITUDES`, of
        which the first is one, the matrices to the body.

    Returns
    -------
    error, allowed
        Radians, an axis for each kind: for each combination of readings.
    """
    kinds = list(readings)
    first = _attitudes(readings[kinds[0]])[:, np.newaxis]
    error = np.zeros(len(first))
    for place, kind in enumerate(kinds[1:], 1):
        table = _apart(given, first, kind, readings[kind]).max(axis=-1)
        error = np.maximum(error[..., np.newaxis], np.expand_dims(table, tuple(range(1, place))))
    allowed = np.array([_allowed(given, fields) for fields, _ in readings[kinds[0]]])
    allowed = np.expand_dims(allowed, tuple(range(1, len(kinds))))
    return error, np.broadcast_to(allowed, error.shape)


def _attitudes(readings: list[Reading]) -> Floats:
    return np.stack([attitude for _, attitude in readings if attitude is not None])


def _apart(given: Examples, first: Floats, kind: str, readings: list[Reading]) -> Floats:
    """Angles between the first kind (K, 1, N, 3, 3) and another one, shape (K, L, N)."""
    if kind in ATTITUDES:
        return _angle(first, _attitudes(readings))
    if kind == "accel":
        signs = np.array([[[fields["accelerometer"]]] for fields, _ in readings])
        return _between(signs * first[..., 2], given.values["accel"])
    before, after = np.moveaxis(given.values["vectors"], 1, 0)
    turns = [
        first if fields["vectors"] == "to body" else np.swapaxes(first, -1, -2)
        for fields, _ in readings
    ]
    turned = np.concatenate(turns, axis=1) @ before[..., np.newaxis]
    return _between(turned[..., 0], after)


def _allowed(given: Examples, fields: Mapping[str, Any]) -> float:
    """How far off all may be together: of angles in degrees it is so many degrees."""
    turn = {kind: given.rounding[kind] for kind in given.values}
    if fields.get("degrees"):
        turn["angles"] = float(np.radians(turn["angles"]))
    return sum(min(each, MOST_ERROR) for each in turn.values()) + LEAST_ERROR


def _angle(one: Floats, other: Floats) -> Floats:
    """Angle of the turn between two matrices; the sine of half of it is exact where small."""
    off = np.linalg.norm(one - other, axis=(-2, -1)) / np.sqrt(8)
    return np.asarray(2 * np.arcsin(np.minimum(off, 1)))


def _between(one: Floats, other: Floats) -> Floats:
    """Angle between two unit vectors."""
    return np.asarray(2 * np.arcsin(np.minimum(np.linalg.norm(one - other, axis=-1) / 2, 1)))
