"""Which conventions explain what two programs say of one rotation."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import combinations, product
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes.systems.axes import ONE, Axes, other_axes
from chr_notes.systems.candidates import FIELDS, KEPT, NAMED, PLAIN, REORDERED, SIGNED, Fields
from chr_notes.systems.convention import Convention
from chr_notes.systems.converting import to_body
from chr_notes.systems.examples import ATTITUDES, Examples, examples, the_example, turned_apart
from chr_notes.systems.matches import Match, told_apart

_Units = tuple[bool, ...]


def find_conventions(  # noqa: PLR0913 (what programs can say)
    *,
    angles: ArrayLike | None = None,
    matrix: ArrayLike | None = None,
    quaternion: ArrayLike | None = None,
    vectors: tuple[ArrayLike, ArrayLike] | None = None,
    accel: ArrayLike | None = None,
    degrees: bool | None = None,
) -> list[Match]:
    """Find the conventions under which programs that seem to disagree say the same.

    Numbers may be rounded, as printed; quaternions, matrices and vectors may have any scale. Where
    no convention explains all in one pair of frames, the axes of known systems are tried too, such
    as one program in north-east-down and the other in east-north-up, and angles that are written in
    another order than that of their turns.

    Parameters
    ----------
    angles
        Three angles as written, shape (3,), or (N, 3) for several examples.
    matrix
        Shape (3, 3) or (N, 3, 3).
    quaternion
        Shape (4,) or (N, 4).
    vectors
        A vector before and after, each of shape (3,) or (N, 3).
    accel
        Readings of an accelerometer at rest, shape (3,) or (N, 3).
    degrees
        Whether the angles are in degrees; both are tried if it is None.

    Returns
    -------
    list of Match
        Best first: the smallest error, and among equals the simplest description.

    Raises
    ------
    ValueError
        If fewer than two are given, a shape is wrong, or no convention explains all: it names the
        pair, or the example, that does not fit.

    See Also
    --------
    chr_notes.systems.converting.convert : From one convention to another.
    chr_notes.sensors.axes.relate_axes : Which axis of one sensor is which of another, from a log.

    Examples
    --------
    >>> import chr_notes
    >>> (match,) = chr_notes.find_conventions(
    ...     angles=[17.19, 11.46, 5.73], quaternion=[0.0343, 0.106, 0.1436, 0.9833]
    ... )
    >>> match.convention.sequence, match.convention.degrees, match.convention.scalar_first
    ('ZYX', True, False)

    What a UM7 and ROS say of one attitude, each in its own axes:

    >>> match = chr_notes.find_conventions(
    ...     angles=[10, 20, 30], quaternion=[0.1608, -0.1069, 0.5036, 0.8421]
    ... )[0]
    >>> match.convention.sequence, *match.axes.values()
    ('xyz', ('ned', 'frd'), ('enu', 'flu'))
    """
    given = examples(
        {"angles": angles, "matrix": matrix, "quaternion": quaternion, "accel": accel}
        | {"vectors": vectors}
    )
    units = (False, True) if degrees is None else (degrees,)
    for wide in (False, True):
        found = [
            (_convention(choices, place), float(error[place]), float(allowed[place]), axes)
            for choices, error, allowed, axes in _judged(given, units, wide=wide)
            for place in map(tuple, np.argwhere(error <= allowed))
        ]
        if found:
            found.sort(key=_rank)
            matches = [
                (_match(convention, error, given, axes), axes)
                for convention, error, _, axes in found
            ]
            return told_apart(matches, given)
    raise ValueError(_what_does_not_fit(given, units))


def _convention(choices: list[list[Fields]], place: tuple[int, ...]) -> Convention:
    """Make a convention of what was chosen of each kind."""
    chosen = (each[number] for each, number in zip(choices, place, strict=True))
    return Convention(**{name: value for fields in chosen for name, value in fields.items()})


def _rank(found: tuple[Convention, float, float, Axes]) -> tuple[float, bool, bool, bool, int]:
    """Order by the error, as far as rounding tells, and then by how plain a convention is."""
    convention, error, allowed, axes = found
    error = round(max(error, KEPT * allowed), 9)
    plain = PLAIN.index(convention.sequence)
    return error, axes is not ONE, bool(convention.negated), bool(convention.written), plain


def _match(convention: Convention, error: float, given: Examples, axes: Axes) -> Match:
    """Make a match of what was found."""
    if axes is ONE:
        return Match(convention, error, tuple(_others(convention, given)))
    first: dict[str, Any] = dict(zip(("navigation", "body"), axes.usual, strict=True))
    own = replace(convention, **first)
    named = MappingProxyType({kind: axes.of(kind) for kind in given.values})
    return Match(own, error, tuple(_others(own, given)), axes=named)


def _judged(
    given: Examples, units: _Units, *, wide: bool
) -> Iterator[tuple[list[list[Fields]], Floats, Floats, Axes]]:
    """Give the choices of each kind, simplest first, with the errors of all combinations.

    All in one pair of frames; or, wide, in others too, and angles in any written order. Errors, and
    how large each may be, have an axis for each kind.
    """
    readings = {kind: _readings(given, kind, units, wide=wide) for kind in given.values}
    for axes in (ONE, *other_axes(given)) if wide else (ONE,):
        # Where nothing says which frame is the body, the first one's direction is but a name.
        free = None if _knows_the_body(given) or axes is not ONE else next(iter(readings))
        tried = {
            kind: [
                (fields, attitude if attitude is None else axes.to_usual(attitude, kind))
                for fields, attitude in each
                if kind != free or fields in NAMED
            ]
            for kind, each in readings.items()
        }
        choices = [[fields for fields, _ in each] for each in tried.values()]
        yield choices, *turned_apart(given, tried), axes


def _readings(
    given: Examples, kind: str, units: _Units, *, wide: bool
) -> list[tuple[Fields, Floats | None]]:
    """Read what is said of a kind in each way, as matrices to the body if it is an attitude."""
    ways = (*FIELDS[kind], *((*REORDERED, *SIGNED) if wide and kind == "angles" else ()))
    return [
        (f, to_body(given.values[kind], Convention(**f), kind) if kind in ATTITUDES else None)
        for f in ways
        if kind != "angles" or f["degrees"] in units
    ]


def _what_does_not_fit(given: Examples, units: _Units) -> str:
    """Name the two that no convention brings together, or the example."""
    for number in range(given.count) if given.count > 1 else ():
        judged = _judged(given.one(number), units, wide=True)
        if not any((error <= allowed).any() for _, error, allowed, _ in judged):
            return (
                "expected examples of one rotation each, but no convention explains "
                f"{the_example(number)}"
            )
    for pair in combinations(given.values, 2):
        if "accel" in pair and "vectors" in pair:
            continue
        judged = _judged(given.of(pair), units, wide=True)
        places = ((error, np.argmin(error - allowed), allowed) for _, error, allowed, _ in judged)
        least = min((e.flat[n] - a.flat[n], e.flat[n]) for e, n, a in places)
        if least[0] > 0:
            return (
                f"expected {pair[0]} and {pair[1]} of one rotation, but under every convention "
                f"they are at least {np.degrees(least[1]):.3g}° apart"
            )
    return "expected one convention for all examples; each pair by itself has some, but not all one"


def _others(convention: Convention, given: Examples) -> Iterator[Convention]:
    """Give the descriptions with the same numbers."""
    swap = {"to body": "to navigation", "to navigation": "to body"}
    ways: list[tuple[Callable[[Convention], Convention], ...]] = []
    if "matrix" in given.values:
        ways.append(
            (lambda c: c, lambda c: replace(c, matrix=swap[c.matrix], row_vectors=True))  # type: ignore[arg-type]
        )
    if "quaternion" in given.values:
        ways.append(
            (lambda c: c, lambda c: replace(c, quaternion=swap[c.quaternion], product="JPL"))  # type: ignore[arg-type]
        )
    if not _knows_the_body(given):
        ways.append((lambda c: c, _other_way))
    for number, each in enumerate(product(*ways)):
        changed = convention
        for way in each:
            changed = way(changed)
        if number:
            yield changed


def _knows_the_body(given: Examples) -> bool:
    """Say whether something is of the body: angles lead to it, an accelerometer is in it."""
    return "angles" in given.values or "accel" in given.values


def _other_way(c: Convention) -> Convention:
    """Call the body's frame that of navigation, and the other way round."""
    swap: dict[str, Any] = {"to body": "to navigation", "to navigation": "to body"}
    return replace(c, matrix=swap[c.matrix], quaternion=swap[c.quaternion], vectors=swap[c.vectors])
