"""Which conventions explain what two programs say of one rotation."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes.sequences import SEQUENCES, matrix_from_angles
from chr_notes.systems.convention import Convention
from chr_notes.systems.converting import from_matrix, to_body
from chr_notes.systems.examples import ATTITUDES, TRIED, Examples, examples, turned_apart

# The simplest is named first.
_PLAIN = ("xyz", "ZYX", *(name for name in SEQUENCES if name not in ("xyz", "ZYX")))
_FIELDS: dict[str, tuple[dict[str, Any], ...]] = {
    "angles": tuple({"sequence": s, "degrees": d} for d in (False, True) for s in _PLAIN),
    "matrix": ({"matrix": "to body"}, {"matrix": "to navigation"}),
    "quaternion": tuple(
        {"scalar_first": first, "quaternion": way}
        for first in (True, False)
        for way in ("to navigation", "to body")
    ),
    "vectors": ({"vectors": "to body"}, {"vectors": "to navigation"}),
    "accel": ({"accelerometer": -1}, {"accelerometer": 1}),
}
_KEPT = 0.25
"""Share of the tolerance below which one error is as good as another."""


@dataclass(frozen=True)
class Match:
    """Descriptions that explain the examples, and that no example tells apart.

    Parameters
    ----------
    convention
        The simplest of them. Fields that the examples say nothing of are this package's own.
    error
        Largest angle between what two programs say, radians.
    others
        The other descriptions of the same numbers.
    example
        Only if several matches are left: what programs of this convention would say of one further
        attitude. Each match says something else, so asking one's programs for it decides.
    """

    convention: Convention
    error: float
    others: tuple[Convention, ...]
    example: MappingProxyType[str, Floats] | None = None


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

    Numbers may be rounded, as printed; quaternions, matrices and vectors may have any scale.

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
    """
    given = examples(
        {"angles": angles, "matrix": matrix, "quaternion": quaternion, "accel": accel}
        | {"vectors": vectors}
    )
    fields = (
        _FIELDS
        if degrees is None
        else _FIELDS | {"angles": tuple(f for f in _FIELDS["angles"] if f["degrees"] is degrees)}
    )
    found = [match for match in _judged(given, fields) if match[1] <= match[2]]
    if not found:
        raise ValueError(_what_does_not_fit(given, fields))
    found.sort(key=lambda match: max(match[1], _KEPT * match[2]))
    matches = [
        Match(convention, error, tuple(_others(convention, given)))
        for convention, error, _ in found
    ]
    return _with_example(matches, given)


def _judged(
    given: Examples, fields: dict[str, tuple[dict[str, Any], ...]]
) -> Iterator[tuple[Convention, float, float]]:
    """Give each convention, simplest first, with its error and how large that may be."""
    kinds = list(given.values)
    # Where nothing says which frame is the body, the first one's direction is but a name.
    free = None if _knows_the_body(given) else kinds[0]
    choices = [
        fields[kind][:1] if kind == free == "matrix"
        else fields[kind][::2] if kind == free == "quaternion"
        else fields[kind]
        for kind in kinds
    ]  # fmt: skip
    # What each says under each of its own readings, once.
    said = [
        [(f, to_body(given.values[kind], Convention(**f), kind)) for f in each]
        if kind in ATTITUDES
        else [(f, None) for f in each]
        for kind, each in zip(kinds, choices, strict=True)
    ]
    for chosen in product(*said):
        convention = Convention(**{name: v for f, _ in chosen for name, v in f.items()})
        attitudes = [attitude for _, attitude in chosen if attitude is not None]
        yield convention, *turned_apart(given, convention, attitudes)


def _what_does_not_fit(given: Examples, fields: dict[str, tuple[dict[str, Any], ...]]) -> str:
    """Name the two that no convention brings together, or the example."""
    for number in range(given.count) if given.count > 1 else ():
        if not any(error <= allowed for _, error, allowed in _judged(given.one(number), fields)):
            return (
                f"expected examples of one rotation each, but no convention explains example "
                f"{number}"
            )
    for pair in combinations(given.values, 2):
        if "accel" in pair and "vectors" in pair:
            continue
        least = min(_judged(given.of(pair), fields), key=lambda match: match[1] - match[2])
        if least[1] > least[2]:
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


def _with_example(matches: list[Match], given: Examples) -> list[Match]:
    """Add the attitude that tells all matches apart, where there are several."""
    if len(matches) == 1:
        return matches
    for turns in TRIED:
        said = [_said(match.convention, given, turns) for match in matches]
        flat = np.array([np.concatenate([np.ravel(v) for v in each.values()]) for each in said])
        apart = np.abs(flat[:, np.newaxis] - flat).max(axis=-1) + np.eye(len(flat))
        if apart.min() > 1e-2:  # noqa: PLR2004 (more than any rounding)
            return [
                replace(match, example=MappingProxyType(each))
                for match, each in zip(matches, said, strict=True)
            ]
    return matches


def _said(convention: Convention, given: Examples, turns: Sequence[float]) -> dict[str, Floats]:
    """Say of one attitude what each program would."""
    made: dict[str, Floats] = {}
    if "angles" in given.values:
        # All matches are told the same angles; what the others make of it differs.
        made["angles"] = np.asarray(turns, dtype=float)
        own = to_body(made["angles"], convention, "angles")
    else:
        own = matrix_from_angles(np.radians(turns), "xyz")
        own = own if given.first_is_to_body(convention) else own.T
    for kind in ("matrix", "quaternion"):
        if kind in given.values and kind not in made:
            made[kind] = from_matrix(own, convention, kind)
    if "vectors" in given.values:
        before = np.array([1.0, 2.0, 3.0])
        made["vectors"] = (own if convention.vectors == "to body" else own.T) @ before
    if "accel" in given.values:
        made["accel"] = convention.accelerometer * own[:, 2]
    return made
