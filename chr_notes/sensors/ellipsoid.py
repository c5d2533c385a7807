"""The ellipsoid nearest to a cloud of points, and how far to trust it.

First a direct fit of a quadric that is constrained to be an ellipsoid (Li and Griffiths, Least
squares ellipsoid specific fitting, 2004), then a few Gauss-Newton steps on what counts in the
end: that every point, brought to the sphere, has the same norm. Of a long recording each place
on the sphere counts once, however long the sensor rested there.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from chr_notes._arrays import Floats
from chr_notes._samples import complete
from chr_notes._samples import samples as recording
from chr_notes.sensors.coverage import (
    WIDEST_GAP,
    count_directions,
    evened,
    evenly_spread,
    off_plane,
    outward,
    sphere_centre,
    thinned,
    what_is_missing,
    widest_gap,
)
from chr_notes.sensors.norms import deviation, far_off, norms_less_one, refined, resistant

WILD_FIELD = 1e100
"""No magnetometer reads as much in any unit, and its square is still a number."""
_UNKNOWNS = 9
_FEWEST = _UNKNOWNS + 1  # with one to spare, the residuals say something of the quality
_FLATTEST = 1e-3  # thickness of the cloud over its extent; a sensor's axes never differ by so much
LARGEST_ERROR = 0.1  # of the norm, where it is worst
_HARDLY = 0.05  # of their size, that readings at rest may vary by
_MOST_OUTLIERS = 0.25  # of the rows
_ALL_AROUND = np.radians(60.0)  # a gap that no far point can pretend to close
_NOISY = 0.05  # deviation of the norm that outliers may explain
_FARTHEST = 20.0  # from the middle, over the usual distance; on a sphere hardly above 2
_MANY = 40  # points, of which few can be told from the others by an ellipsoid
_SUBSET = 12  # points, few enough to be free of outliers, enough for an ellipsoid


@dataclass(frozen=True, eq=False)
class Ellipsoid:
    """An ellipsoid and the quality of its fit.

    Parameters
    ----------
    centre
        In the unit of the samples, shape (3,).
    to_sphere
        Symmetric matrix of determinant 1 that takes what is left after subtracting the centre to
        a sphere, shape (3, 3).
    radius
        Of that sphere, in the unit of the samples: the geometric mean of the semi-axes.
    spread
        Standard deviation of the norm of the corrected samples, over its mean.
    gap
        Largest angle between any direction and the nearest sample, seen from the centre, radians;
        90° where the samples cover half of the sphere, little where they cover all of it.
    standard_error
        Of the corrected norm, relative, in the direction where it is worst; it takes the residuals
        of the samples as independent of each other.
    outliers
        Rows of the samples that were left out, because they lie more than 2 % of the norm and
        more than 5 standard deviations off.

    See Also
    --------
    fit_ellipsoid
    """

    centre: Floats
    to_sphere: Floats
    radius: float
    spread: float
    gap: float
    standard_error: float
    outliers: NDArray[np.intp] = field(default_factory=lambda: np.empty(0, dtype=np.intp))


def fit_ellipsoid(samples: ArrayLike) -> Ellipsoid:
    """Fit an ellipsoid to points, up to a quarter of which may be outliers.

    Parameters
    ----------
    samples
        Shape (N, 3), at least 10 rows without NaN; others are left out.

    Returns
    -------
    Ellipsoid

    Raises
    ------
    ValueError
        If the samples are fewer than 10, come from fewer than 9 directions, lie in one plane, or
        cover too little of the sphere for an ellipsoid to be found: it says where the largest gap
        is. If more than a quarter of the rows lie far off.

    See Also
    --------
    chr_notes.sensors.magnetometer.fit_magnetometer

    Examples
    --------
    >>> import numpy as np
    >>> field = np.random.default_rng(0).normal(size=(500, 3))
    >>> field *= 50 / np.linalg.norm(field, axis=1, keepdims=True)
    >>> field[7] = -4096  # what an overflow looks like
    >>> found = fit_ellipsoid(field + [10, 20, 30])
    >>> found.centre.round(6).tolist(), round(found.radius, 6), found.outliers.tolist()
    ([10.0, 20.0, 30.0], 50.0, [7])
    """
    array = recording("samples", samples)
    rows = np.flatnonzero(complete(array, WILD_FIELD))
    points = array[rows]
    if len(points) < _FEWEST:
        msg = (
            f"samples: expected at least {_FEWEST} rows without NaN, one more than an ellipsoid "
            f"has unknowns, got {len(points)}"
        )
        raise ValueError(msg)
    off = _outliers(points)
    if off.mean() > _MOST_OUTLIERS:
        first = points[np.argmax(off)]
        msg = (
            f"samples: {off.sum()} of {len(points)} rows lie far off any one ellipsoid, more than "
            f"a quarter; the first is row {rows[np.argmax(off)]}: {first.tolist()}"
        )
        raise ValueError(msg)
    points = points[~off]
    middle = points.mean(axis=0)
    extent = _extent(points, middle)
    every = (points - middle) / extent
    scaled = evened(every)
    start = _direct_fit(scaled)
    fitted = None if start is None else refined(scaled, *start)
    if fitted is None:
        centre = sphere_centre(scaled)
        if extent < _HARDLY * np.linalg.norm(middle):
            msg = (
                f"samples: expected readings from many directions, got readings that vary by "
                f"{extent / np.linalg.norm(middle):.1%} of their size: was the sensor turned?"
            )
            raise ValueError(msg)
        if widest_gap(outward(scaled, centre, np.eye(3)))[0] < _ALL_AROUND:
            msg = (
                "samples: expected readings on one ellipsoid, got readings from all around of "
                "which more than a quarter lie off; is there iron that moves, or an other column?"
            )
            raise ValueError(msg)
        msg = (
            "samples cover too little of the sphere to tell one ellipsoid from many; "
            f"{what_is_missing(scaled, centre, np.eye(3))}"
        )
        raise ValueError(msg)
    ellipsoid = _judge(scaled, every, *fitted)
    if ellipsoid.gap > WIDEST_GAP or ellipsoid.standard_error > LARGEST_ERROR:
        msg = (
            "samples cover too little of the sphere: they leave a gap of "
            f"{np.degrees(ellipsoid.gap):.0f}° around one direction (at most "
            f"{np.degrees(WIDEST_GAP):.0f}° allowed), and the norm is known to "
            f"{ellipsoid.standard_error:.1%} where it is worst (at most {LARGEST_ERROR:.0%}); "
            f"{what_is_missing(scaled, fitted[1], fitted[0])}"
        )
        raise ValueError(msg)
    return replace(
        ellipsoid,
        centre=ellipsoid.centre * extent + middle,
        radius=ellipsoid.radius * extent,
        outliers=rows[off],
    )


def _extent(points: Floats, middle: Floats) -> float:
    """Size of a cloud; refuse one that has too few directions, or no thickness."""
    extents = np.linalg.svd(points - middle, full_matrices=False)
    extent = float(extents.S[0] / np.sqrt(len(points)))
    if extent <= 1e-12 * np.linalg.norm(middle):
        msg = f"samples: expected readings from many directions, got {len(points)} equal rows"
        raise ValueError(msg)
    if extents.S[2] < _FLATTEST * extents.S[0]:
        msg = (
            "samples: expected readings all around, got points in one plane "
            f"(thickness {extents.S[2] / extents.S[0]:.1e} of the extent), "
            f"{off_plane(extents.Vh[2])}"
        )
        raise ValueError(msg)
    directions = count_directions(points, _UNKNOWNS)
    if directions < _UNKNOWNS:
        msg = (
            f"samples: expected readings from at least {_UNKNOWNS} directions, as many as an "
            f"ellipsoid has unknowns, got {directions}, each read many times ({len(points)} rows)"
        )
        raise ValueError(msg)
    return extent


def _outliers(points: Floats) -> NDArray[np.bool_]:
    """Say which points are off the ellipsoid on which most others lie."""
    cells = thinned(points)
    middle = np.median(cells, axis=0)
    extent = float(np.median(np.linalg.norm(cells - middle, axis=1)))
    if not extent > 0:
        return np.zeros(len(points), dtype=np.bool_)
    scaled, thin = (points - middle) / extent, (cells - middle) / extent
    far = np.asarray(np.linalg.norm(scaled, axis=1) > _FARTHEST)
    thin = thin[np.linalg.norm(thin, axis=1) <= _FARTHEST]
    if len(thin) < _MANY:
        return far
    fitted = _direct_fit(thin)
    if fitted is not None and _all_agree(thin, scaled[~far], *fitted):
        return far
    fitted = resistant(thin, _direct_fit, _SUBSET)
    for _ in range(2):  # what agrees with three quarters belongs to them
        if fitted is None:
            return far
        usual = _misfit(thin, *fitted)
        off = far_off(_misfit(scaled, *fitted), usual)
        fitted = _direct_fit(thin[~far_off(usual, usual)])
    return off


def _all_agree(thin: Floats, points: Floats, matrix: Floats, centre: Floats) -> bool:
    """Say whether an ellipsoid is one that all points lie all around."""
    usual = _misfit(thin, matrix, centre)
    if deviation(usual) > _NOISY or far_off(_misfit(points, matrix, centre), usual).any():
        return False
    return bool(widest_gap(outward(thin, centre, matrix))[0] < _ALL_AROUND)


def _misfit(points: Floats, matrix: Floats, centre: Floats) -> Floats:
    return np.asarray(np.linalg.norm((points - centre) @ matrix, axis=1) - 1)


def _direct_fit(points: Floats) -> tuple[Floats, Floats] | None:
    """Fit a quadric under Li and Griffiths' constraint; None where it is no ellipsoid.

    Returns the symmetric matrix that takes the ellipsoid to the unit sphere, and its centre.
    """
    x, y, z = points.T
    squares = np.stack([x * x, y * y, z * z, 2 * y * z, 2 * x * z, 2 * x * y], axis=1)
    others = np.stack([2 * x, 2 * y, 2 * z, np.ones_like(x)], axis=1)
    # 4 J - I², with I and J the linear and the quadratic invariant of the quadric's matrix
    constraint = np.zeros((6, 6))
    constraint[:3, :3] = 1 - 2 * np.eye(3)
    constraint[3:, 3:] = -4 * np.eye(3)
    try:
        from_squares = np.linalg.lstsq(others, squares, rcond=None)[0]
        left = squares - others @ from_squares
        values, vectors = np.linalg.eig(np.linalg.solve(constraint, left.T @ left))
    except np.linalg.LinAlgError:
        return None
    quadric = vectors[:, np.argmax(values.real)].real
    linear = -from_squares @ quadric
    xx, yy, zz, yz, xz, xy = quadric
    matrix = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    try:
        centre = -np.linalg.solve(matrix, linear[:3])
    except np.linalg.LinAlgError:
        return None
    scaled = matrix / (centre @ matrix @ centre - linear[3])
    values, vectors = np.linalg.eigh(scaled)
    if not values[0] > 0:
        return None
    return vectors * np.sqrt(values) @ vectors.T, centre


def _judge(points: Floats, every: Floats, matrix: Floats, centre: Floats) -> Ellipsoid:
    norms = _misfit(every, matrix, centre) + 1
    residual, slopes = norms_less_one(points, matrix, centre)
    around = centre + evenly_spread(500) @ np.linalg.inv(matrix)
    _, on_sphere = norms_less_one(around, matrix, centre)
    variance = residual @ residual / (len(points) - _UNKNOWNS)
    # With slopes = Q R the covariance of the unknowns is the variance times (Rᵀ R)⁻¹.
    triangle = np.linalg.qr(slopes).R
    errors = np.linalg.norm(np.linalg.solve(triangle.T, on_sphere.T), axis=0)
    radius = float(np.linalg.det(matrix)) ** (-1 / 3)
    return Ellipsoid(
        centre=centre,
        to_sphere=radius * matrix,
        radius=radius,
        spread=float(norms.std() / norms.mean()),
        gap=widest_gap(outward(points, centre, matrix))[0],
        standard_error=float(np.sqrt(variance) * errors.max()),
    )
