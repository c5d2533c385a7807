"""Calibration of a magnetometer from readings taken while it was turned about.

An undisturbed field has one strength whichever way the sensor points. What the readings lack of
that is soft and hard iron; what a few of them lack more than all others is something else.
"""

import warnings

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats, floats
from chr_notes._samples import complete, positive
from chr_notes._samples import samples as recording
from chr_notes.errors import CalibrationWarning
from chr_notes.sensors.coverage import thinned
from chr_notes.sensors.ellipsoid import WILD_FIELD, fit_ellipsoid
from chr_notes.sensors.models import MagnetometerCalibration
from chr_notes.sensors.norms import ONE_SCALE, far_off, norms_less_one, refined

_FEWEST = 6  # rows, for three unknowns
_TOLD_APART = 1.5  # a misfit over that of the other side, from which the sides are told apart
_LEAST_ARC = np.radians(180.0)  # of headings
_APART = 0.5  # a step between sorted misfits that ends what goes on evenly, over the largest kept
_BOX = 3.0  # in widths that hold four fifths of the cells, outside of which nothing is near


def fit_magnetometer(samples: ArrayLike, field: float | None = None) -> MagnetometerCalibration:
    """Find the soft and hard iron from readings taken while the sensor was turned about.

    Undisturbed readings lie on a sphere about zero; iron makes it an ellipsoid about another
    centre. The calibration takes that ellipsoid back to a sphere. A rotation of the sphere cannot
    be seen in such data, so the soft-iron matrix comes out symmetric.
    `fit_ellipsoid` gives the same ellipsoid and says how far to trust it.

    Parameters
    ----------
    samples
        Readings of the magnetometer in any unit, shape (N, 3), at least 10 without NaN.
    field
        Strength of the field, the norm that corrected readings are to have, in any unit. Without
        it that is the geometric mean of the ellipsoid's semi-axes, and the unit stays.

    Returns
    -------
    MagnetometerCalibration

    Raises
    ------
    ValueError
        If the samples are fewer than 10, come from fewer than 9 directions, lie in one plane, or
        cover too little of the sphere for an ellipsoid to be found: it says what is missing. If
        more than a quarter of them lie far off. If the field is not positive.

    Warns
    -----
    CalibrationWarning
        If rows lie far off and were left out. It names those that stand apart as faults, and says
        of the others how far off they are: a field that is not the same everywhere has such.

    See Also
    --------
    fit_hard_iron : For a vehicle that has to stay level.

    Notes
    -----
    Ledger: sensors.4.2, sensors.4.c.

    Examples
    --------
    >>> import numpy as np
    >>> actual = np.random.default_rng(0).normal(size=(500, 3))
    >>> actual *= 50 / np.linalg.norm(actual, axis=1, keepdims=True)
    >>> found = fit_magnetometer(actual * [1.1, 1.0, 0.9] + [12, -4, 30], field=50)
    >>> found.correct([12 + 55, -4, 30]).round(6).tolist()
    [50.0, 0.0, 0.0]
    """
    strength = None if field is None else positive("field", field)
    ellipsoid = fit_ellipsoid(samples)
    array = recording("samples", samples)
    with np.errstate(all="ignore"):  # of a row without end
        corrected = (array - ellipsoid.centre) @ ellipsoid.to_sphere
    _name_rows(array, ellipsoid.outliers, corrected)
    scale = 1.0 if strength is None else strength / ellipsoid.radius
    soft_iron = scale * ellipsoid.to_sphere
    return MagnetometerCalibration(soft_iron=soft_iron, hard_iron=soft_iron @ ellipsoid.centre)


def fit_hard_iron(
    samples: ArrayLike, field: ArrayLike | float | None = None
) -> MagnetometerCalibration:
    """Find the hard iron of a vehicle that can be turned round but not over.

    Readings of such a vehicle lie near a circle, which many spheres share. What it takes to choose
    among them has to be known: the strength of the field, or both of its parts. With neither only
    x and y are corrected, which is what the heading of a level vehicle needs. Soft iron is not
    looked for.

    Parameters
    ----------
    samples
        Readings of a magnetometer in axes forward, right, down, shape (N, 3), at least 6 without
        NaN, over at least half a turn of heading.
    field
        What is known of the field in the unit of the samples: its strength, or (horizontal, down),
        with down negative on the southern hemisphere. With None the vehicle was level.

    Returns
    -------
    MagnetometerCalibration
        With the identity for soft iron. Without a field the hard iron along z is 0: it is not
        known.

    Raises
    ------
    ValueError
        If the samples are too few, or leave more than half of the headings out. If they do not
        tell on which side of the circle the centre lies: then both parts of the field are needed.
        If the field is not positive, or is weaker than the circle is wide.

    Warns
    -----
    CalibrationWarning
        If rows lie far off and were left out; it names them.

    See Also
    --------
    fit_magnetometer

    Notes
    -----
    Ledger: sensors.4.2.

    Examples
    --------
    >>> import numpy as np
    >>> turn = np.linspace(0, 2 * np.pi, 200)
    >>> level = np.stack([20 * np.cos(turn), -20 * np.sin(turn), 0 * turn + 45], axis=1)
    >>> fit_hard_iron(level + [12, -4, 30], field=(20, 45)).hard_iron.round(6).tolist()
    [12.0, -4.0, 30.0]
    """
    array = recording("samples", samples)
    rows = np.flatnonzero(complete(array, WILD_FIELD))
    points = array[rows]
    if len(points) < _FEWEST:
        msg = f"samples: expected at least {_FEWEST} rows without NaN, got {len(points)}"
        raise ValueError(msg)
    cells = thinned(points)
    middle = np.median(cells, axis=0)
    width = float(np.ptp(np.quantile(cells, [0.1, 0.9], axis=0), axis=0).max())
    near = np.asarray(np.abs(points - middle).max(axis=1) <= _BOX * width)
    if field is None:
        flat = points * [1.0, 1.0, 0.0]
        centre, radius = _circle(flat[near])
        centre, off = _trimmed(flat, near, centre, None, radius)
    else:
        level, down = _parts(field)
        strength = float(np.hypot(level, down)) if down is not None else level
        centre, off = _sphere(points, near, strength, down)
    outward = (points - centre)[~off]
    headings = np.sort(np.arctan2(outward[:, 1], outward[:, 0]))
    gap = float(np.diff(np.r_[headings, headings[0] + 2 * np.pi]).max())
    if gap > _LEAST_ARC:
        msg = (
            f"samples: expected at least half a turn of heading, got {360 - np.degrees(gap):.0f}°: "
            "drive a whole circle"
        )
        raise ValueError(msg)
    _name_rows(array, rows[off], (array - centre)[:, : 2 if field is None else 3])
    return MagnetometerCalibration(soft_iron=np.eye(3), hard_iron=centre)


def _circle(points: Floats) -> tuple[Floats, float]:
    """Circle in the level plane nearest to points, by linear least squares; z stays 0."""
    middle = points.mean(axis=0)
    x, y, _ = (points - middle).T
    unknowns = np.column_stack([2 * x, 2 * y, np.ones(len(points))])
    found = np.linalg.lstsq(unknowns, x**2 + y**2, rcond=None)[0]
    centre = middle + np.array([found[0], found[1], 0.0]) * [1.0, 1.0, 0.0]
    return centre, float(np.sqrt(max(found[2] + found[0] ** 2 + found[1] ** 2, 0.0)))


def _sphere(
    points: Floats, near: NDArray[np.bool_], strength: float, down: float | None
) -> tuple[Floats, NDArray[np.bool_]]:
    """Centre of a sphere of known radius, on the side where it fits, or where it has to be."""
    ring, radius = _circle(points[near])
    height = float(np.sqrt(max(strength**2 - radius**2, (0.1 * strength) ** 2)))
    sides = []
    for way in (1.0, -1.0) if down is None else (1.0 if down > 0 else -1.0,):
        start = np.array([ring[0], ring[1], np.median(points[near, 2]) - way * height])
        centre, off = _trimmed(points, near, start, strength, strength)
        misfit = np.linalg.norm(points[~off] - centre, axis=1) / strength - 1
        sides.append((float(np.sqrt(np.mean(misfit**2))), centre, off))
    sides.sort(key=lambda side: side[0])
    if len(sides) > 1 and sides[1][0] < _TOLD_APART * sides[0][0]:
        msg = (
            "samples: expected tilts that tell whether the field points up or down, got a circle "
            "that is too flat; give both parts, field=(horizontal, down)"
        )
        raise ValueError(msg)
    return sides[0][1], sides[0][2]


def _trimmed(
    points: Floats,
    near: NDArray[np.bool_],
    centre: Floats,
    strength: float | None,
    radius: float,
) -> tuple[Floats, NDArray[np.bool_]]:
    """Fit the centre to the points, again without those that turn out to lie far off."""
    off = ~near
    for _ in range(10):
        kept = points[~off]
        if strength is None:
            centre, radius = _circle(kept)
        else:
            fitted = refined(kept / strength, np.eye(3), centre / strength, ONE_SCALE)
            if fitted is None:
                msg = f"samples: no sphere of radius {strength:.4g} comes out of them"
                raise ValueError(msg)
            centre = fitted[1] * strength
        if not radius > 0:
            msg = f"samples: expected readings around a circle, got {len(kept)} equal ones"
            raise ValueError(msg)
        misfit, _ = norms_less_one(points / radius, np.eye(3), centre / radius)
        before, off = off, far_off(misfit, misfit[~off])
        if (before == off).all():
            break
    return centre, off


def _parts(field: ArrayLike | float) -> tuple[float, float | None]:
    """Strength alone, or the horizontal part and the one down."""
    known = floats("field", field)
    if known.shape == ():
        return positive("field", known), None
    if known.shape != (2,) or not np.isfinite(known).all() or not known[0] > 0 or not known[1]:
        msg = (
            "field: expected a strength, or (horizontal, down) with a positive first part and a "
            f"second that is not zero, got {known.tolist()}"
        )
        raise ValueError(msg)
    return float(known[0]), float(known[1])


def _name_rows(samples: Floats, outliers: NDArray[np.intp], corrected: Floats) -> None:
    """Warn of the rows that were left out, and say what they look like."""
    if not len(outliers):
        return
    with np.errstate(all="ignore"):  # a spike is as large as it likes
        strengths = np.linalg.norm(corrected, axis=1)
    kept = np.delete(strengths, outliers)
    kept = kept[np.isfinite(kept)]
    usual = float(np.median(kept))
    off = np.abs(strengths[outliers] / usual - 1)
    within = float(np.abs(kept / usual - 1).max())
    outliers, off = outliers[off > within], off[off > within]  # what agrees after all is no news
    if not len(outliers):
        return
    order = np.argsort(off)
    # Faults of single readings lie apart; a field that varies from place to place does so evenly.
    apart = np.flatnonzero(np.diff(np.r_[within, off[order]]) > _APART * within)
    faults = np.sort(outliers[order[apart[0] :]]) if len(apart) else outliers[:0]
    others = len(outliers) - len(faults)
    shown = faults if len(faults) else outliers
    named = ", ".join(f"{row} {np.round(samples[row], 6).tolist()}" for row in shown[:3])
    more = f" and {len(shown) - 3} more" if len(shown) > 3 else ""  # noqa: PLR2004 (named)
    why = [f"{named}{more}: spikes, dropped reads or overflow codes"] if len(faults) else []
    if others:
        least, most = off[order[0]], off[order[others - 1]]
        which = f"{others} of them" if len(faults) else f"{named}{more}:"
        why.append(
            f"{which} of a strength {least:.1%} to {most:.1%} off, where the rest is within "
            f"{within:.1%}: not faults, but a field that differs from place to place, as near iron"
        )
    warnings.warn(
        f"samples: left out {len(outliers)} of {len(samples)} rows that lie far off, "
        + "; and ".join(why),
        CalibrationWarning,
        stacklevel=3,
    )
