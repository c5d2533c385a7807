"""Small pictures for exercises, as SVG in both themes, each with its numbers in words.

They are flat and light: a dozen of them stand on a page.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes.aircraft import FIN, SECTIONS, TAIL, WING
from chr_notes.palette import DASHES, PALETTE

__all__ = ["Drawing", "from_above", "outline", "path"]

_SIZE: Final = 200  # of a picture, in its own units
_LARGE: Final = 1.25  # the aircraft, whose axes reach beyond it
_USED: Final = ("page", "line", "muted", "ink", "shade", "x", "y", "z")
_CROSS: Final = '<path class="line" stroke-width="1" d="M3 100L197 100M100 3L100 197"/>'
Points = NDArray[np.float64]


@dataclass(frozen=True)
class Drawing:
    """A picture to choose.

    Attributes
    ----------
    svg
        The drawing.
    alt
        What it shows, in numbers, so that who does not see it can choose as well.
    """

    svg: str
    alt: str


def from_above(matrix: ArrayLike) -> Drawing:
    """Draw the aircraft as it is seen from above, north at the top.

    Parameters
    ----------
    matrix
        Its attitude, the matrix from inertial to body, shape (3, 3).

    Examples
    --------
    >>> from_above([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]).alt
    'Nose: north 0.00, east 1.00, down 0.00. Right wing: north -1.00, east 0.00, down 0.00.'
    """
    rows = np.asarray(matrix, dtype=float)
    # The highest ones last: they cover the others.
    plates = sorted((plate @ rows for plate in _plates()), key=_depth, reverse=True)
    shapes = [
        _CROSS,
        *(
            f'<path class="shade" fill="currentColor" d="{_data(_LARGE * _seen(each))}z"/>'
            for each in plates
        ),
        *(_axis(name, rows[row]) for row, name in enumerate("xy")),
        _named("north", "east"),
    ]
    words = (
        f"{name}: north {north:.2f}, east {east:.2f}, down {down:.2f}."
        for name, (north, east, down) in zip(
            ("Nose", "Right wing"), rows.round(2) + 0.0, strict=False
        )
    )
    return Drawing(_svg(shapes), " ".join(words))


def path(
    points: ArrayLike,
    reach: float,
    *,
    beside: ArrayLike | None = None,
    axes: tuple[str, str] = ("north", "east"),
    every: int = 1,
) -> Drawing:
    """Draw a line in a plane, about the origin, and a dashed one beside it.

    Parameters
    ----------
    points
        Shape (N, 2): along the axis that points up, and along the one to the right.
    reach
        What is seen of either axis, to both sides of the origin.
    beside
        The dashed line, the same in all pictures.
    axes
        The names of the two axes.
    every
        Each how many-th point is told in words.
    """
    line = np.asarray(points, dtype=float)
    shapes = [
        _CROSS,
        _named(*axes),
    ]
    if beside is not None:
        other = np.asarray(beside, dtype=float) / reach
        shapes.append(f'<path class="muted" stroke-dasharray="6 5" d="{_data(other[:, ::-1])}"/>')
    shapes.append(f'<path class="ink" stroke-width="4" d="{_data(line[:, ::-1] / reach)}"/>')
    told = ", ".join(f"({up:.3g}, {right:.3g})" for up, right in line[::every].round(2) + 0.0)
    return Drawing(_svg(shapes), f"Through ({axes[0]}, {axes[1]}) = {told}.")


def outline(right: ArrayLike, up: ArrayLike) -> str:
    """Give the aircraft as the data of an SVG path, from a side where its axes point so.

    Parameters
    ----------
    right, up
        What of x, y, z leads to the right and up in the picture.
    """
    seen = np.array([right, up], dtype=float).T
    return "".join(f"{_data(0.8 * each @ seen)}z" for each in _plates())


def _plates() -> Iterable[Points]:
    """Give the aircraft as flat pieces, in its own axes."""
    above = [(x, half, middle) for x, half, _, middle in SECTIONS]
    aside = [(x, 0.0, middle + half) for x, _, half, middle in SECTIONS]
    yield _closed(above, [(x, -y, z) for x, y, z in above])
    yield _closed(aside, [(x, 0.0, middle - half) for x, _, half, middle in SECTIONS])
    yield _closed([(a, y, z) for a, _, y, z, _ in FIN], [(b, y, z) for _, b, y, z, _ in FIN])
    for side in (1.0, -1.0):
        for plate in (WING, TAIL):
            front = [(a, side * y, z) for a, _, y, z, _ in plate]
            yield _closed(front, [(b, side * y, z) for _, b, y, z, _ in plate])


def _closed(there: Iterable[tuple[float, ...]], back: Iterable[tuple[float, ...]]) -> Points:
    return np.array([*there, *reversed([*back])])


def _seen(points: Points) -> Points:
    """Take inertial points to the picture: east to the right, north up."""
    return points[..., [1, 0]]


def _axis(name: str, direction: Points) -> str:
    tip = 0.76 * _seen(direction)
    dashes = " ".join(f"{length:g}" for length in DASHES[name])
    dash = f' stroke-dasharray="{dashes}"' if dashes else ""
    line = f'<path class="{name}" stroke-width="3"{dash} d="{_data(np.array([[0, 0], tip]))}"/>'
    x, y = _units(1.17 * tip)
    return (
        f'{line}<text class="{name}" fill="currentColor" stroke="none" x="{x}" y="{y + 6}" '
        f'text-anchor="middle">{name}</text>'
    )


def _named(up: str, right: str) -> str:
    """Write in two corners what the plane's axes are."""
    ends = (
        f'<text x="4" y="18">↑ {up}</text><text x="196" y="194" text-anchor="end">{right} →</text>'
    )
    return f'<g class="muted" fill="currentColor" stroke="none" font-size="18">{ends}</g>'


def _depth(points: Points) -> float:
    return round(float(points[:, 2].mean()), 6)


def _units(point: ArrayLike) -> tuple[int, int]:
    # Rounded twice, so that a half is a half on any processor.
    right, up = (_SIZE / 2 * (1 + 0.97 * np.array([1, -1]) * np.asarray(point))).round(6)
    return round(right), round(up)


def _data(points: ArrayLike) -> str:
    """Write points of the square from -1 to 1 as the data of an SVG path."""
    pairs = (f"{x} {y}" for x, y in map(_units, np.asarray(points, dtype=float)))
    return "M" + "L".join(pairs)


def _svg(shapes: Iterable[str]) -> str:
    light = "".join(f".{name}{{color:{PALETTE[name].light}}}" for name in _USED)
    dark = "".join(f".{name}{{color:{PALETTE[name].dark}}}" for name in _USED)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_SIZE} {_SIZE}" width="180" '
        'height="180" fill="none" stroke="currentColor" stroke-width="2" stroke-linejoin="round" '
        'font-family="system-ui,sans-serif" font-size="20">'
        f"<style>{light}@media(prefers-color-scheme:dark){{{dark}}}</style>"
        f'<path class="page" fill="currentColor" stroke="none" d="M0 0h{_SIZE}v{_SIZE}H0z"/>'
        f"{''.join(shapes)}</svg>"
    )
