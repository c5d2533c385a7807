"""Which directions a cloud of readings holds, and which it lacks."""

import numpy as np

from chr_notes._arrays import Floats

WIDEST_GAP = np.radians(100.0)  # a hemisphere leaves a gap of 90°
_RING = 0.1  # thickness of a cloud over its extent, that is taken for a ring with noise
_LEVEL = "fit_hard_iron where it has to stay level"
_CELL = 0.03  # of the extent
_FURTHEST = 1_000_000  # cells; three such numbers make one of 63 bits
_ALIKE = 0.05  # of the root mean square distance from the mean, some 3° on a sphere
_CELLS, _ROWS_OF_A_CELL = 500, 3  # at least; fewer do not tell well enough one by one
_AXES = ("x", "y", "z")
_BLOCK = 4096
_ASLANT = 0.4  # part of a unit vector along an axis that is worth naming


def thinned(points: Floats) -> Floats:
    """Keep one point of each small cell, so that what was read long counts no more than the rest.

    Of a cloud with points far off, the extent is that of most others.
    """
    # Equal rows, such as an overflow code, count once; no two others have one such sum.
    _, first = np.unique(points @ [1.0, np.pi, np.e], return_index=True)
    kept = points = points[np.sort(first)]
    for tail in (0.01, 0.05):
        low, high = np.quantile(kept, [tail, 1 - tail], axis=0)
        extent = float((high - low).max())
        if not extent > 0:
            return kept
        cells = np.clip(np.floor((points - low) / (_CELL * extent)), -_FURTHEST, _FURTHEST)
        numbers = cells.astype(np.int64) @ (2 * _FURTHEST + 1) ** np.arange(3)
        kept = points[np.sort(np.unique(numbers, return_index=True)[1])]
    return kept


def evened(points: Floats) -> Floats:
    """Let a place where a sensor rested long count no more than others, where enough are left."""
    cells = thinned(points)
    return cells if len(cells) >= _CELLS and len(points) >= _ROWS_OF_A_CELL * len(cells) else points


def count_directions(points: Floats, most: int) -> int:
    """Count points that are not near another, up to a number that is enough."""
    radius = _ALIKE * float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=1))))
    left, count = points, 0
    while len(left) and count < most:
        left = left[np.linalg.norm(left - left[0], axis=1) > radius]
        count += 1
    return count


def outward(points: Floats, centre: Floats, matrix: Floats) -> Floats:
    """Directions of points on the sphere that an ellipsoid is brought to."""
    corrected = (points - centre) @ matrix
    length = np.linalg.norm(corrected, axis=1, keepdims=True)
    return np.asarray(corrected / np.where(length > 0, length, 1.0))


def widest_gap(directions: Floats) -> tuple[float, Floats]:
    """Find the direction that is furthest from all of these, and how far, radians."""
    sphere = evenly_spread(500)
    # In blocks, or a long log would need five hundred times its memory.
    blocks = np.array_split(directions, len(directions) // _BLOCK + 1)
    nearest = np.max([np.max(sphere @ block.T, axis=1) for block in blocks], axis=0)
    return float(np.arccos(np.clip(nearest.min(), -1, 1))), sphere[int(nearest.argmin())]


def named(direction: Floats) -> str:
    """Say in words where a direction points, such as "-z" or "the direction between +x and -z"."""
    order = np.argsort(-np.abs(direction))
    parts = [
        f"{'+' if direction[axis] > 0 else '-'}{_AXES[axis]}"
        for axis in order
        if abs(direction[axis]) > _ASLANT
    ]
    if len(parts) == 1:
        return parts[0]
    return f"the direction between {', '.join(parts[:-1])} and {parts[-1]}"


def what_is_missing(points: Floats, centre: Floats, matrix: Floats) -> str:
    """Say where the largest gap is, and what to do about it."""
    gap, direction = widest_gap(outward(points, centre, matrix))
    extents = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)
    if extents.S[2] < _RING * extents.S[0]:
        # On a ring the middle is not known, and so not on which side of it the readings lie.
        return f"the readings lie near one plane, {off_plane(extents.Vh[2])}"
    enough = "" if gap > WIDEST_GAP else ", which would do if they were less noisy"
    return (
        f"no reading comes from within {np.degrees(gap):.0f}° of {named(direction)} of the sensor"
        f"{enough}: turn that side along the field too, or "
        f"{'take many more' if enough else _LEVEL}"
    )


def off_plane(normal: Floats) -> str:
    """Say how readings come off a plane, the same whichever way its normal points."""
    axis = named(normal * np.sign(normal[np.abs(normal).argmax()])).removeprefix("+")
    return f"as of turns about {axis} alone: lean that to all sides too, or {_LEVEL}"


def evenly_spread(count: int) -> Floats:
    """Spread directions evenly over the sphere, along a spiral by the golden angle."""
    height = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (3 - np.sqrt(5)) * np.arange(count)
    radius = np.sqrt(1 - height**2)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=1)


def sphere_centre(points: Floats) -> Floats:
    """Centre of the sphere nearest to points, by linear least squares, shape (3,)."""
    middle = points.mean(axis=0)
    left = points - middle
    scale = float(np.sqrt(np.mean(np.sum(left**2, axis=1)))) or 1.0
    scaled = left / scale
    unknowns = np.column_stack([2 * scaled, np.ones(len(points))])
    found = np.linalg.lstsq(unknowns, np.sum(scaled**2, axis=1), rcond=1e-6)[0]
    return np.asarray(middle + scale * found[:3])
