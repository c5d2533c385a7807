"""The ellipsoid nearest to a cloud of points, and how far to trust it.

First a direct fit of a quadric that is constrained to be an ellipsoid (Li and Griffiths, Least
squares ellipsoid specific fitting, 2004), then a few Gauss-Newton steps on what counts in the
end: that every point, brought to the sphere, has the same norm.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._samples import whole_samples

_UNKNOWNS = 9
_FEWEST = _UNKNOWNS + 1  # with one to spare, the residuals say something of the quality
_FLATTEST = 1e-3  # thickness of the cloud over its extent; a sensor's axes never differ by so much
_WIDEST_GAP = np.radians(100.0)  # a hemisphere leaves a gap of 90°
_LARGEST_ERROR = 0.1  # of the norm, where it is worst
_STEPS = 30
_CONVERGED = 1e-9
_TRIANGLE = np.triu_indices(3)


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
    """

    centre: Floats
    to_sphere: Floats
    radius: float
    spread: float
    gap: float
    standard_error: float


def fit_ellipsoid(samples: ArrayLike) -> Ellipsoid:
    """Fit an ellipsoid to points.

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
        If the samples are fewer than 10, all equal, in one plane, or cover too little of the
        sphere for an ellipsoid to be found.
    """
    points = whole_samples("samples", samples)
    if len(points) < _FEWEST:
        msg = (
            f"samples: expected at least {_FEWEST} rows without NaN, one more than an ellipsoid "
            f"has unknowns, got {len(points)}"
        )
        raise ValueError(msg)
    middle = points.mean(axis=0)
    extents = np.linalg.svd(points - middle, compute_uv=False)
    extent = float(extents[0]) / np.sqrt(len(points))
    if extent <= 1e-12 * np.linalg.norm(middle):
        msg = f"samples: expected readings from many directions, got {len(points)} equal rows"
        raise ValueError(msg)
    if extents[2] < _FLATTEST * extents[0]:
        msg = (
            "samples: expected readings all around, got points in one plane "
            f"(thickness {extents[2] / extents[0]:.1e} of the extent)"
        )
        raise ValueError(msg)
    scaled = (points - middle) / extent
    start = _direct_fit(scaled)
    fitted = None if start is None else _refine(scaled, *start)
    if fitted is None:
        msg = "samples cover too little of the sphere: no ellipsoid comes out of them"
        raise ValueError(msg)
    ellipsoid = _judge(scaled, *fitted)
    if ellipsoid.gap > _WIDEST_GAP or ellipsoid.standard_error > _LARGEST_ERROR:
        msg = (
            "samples cover too little of the sphere: they leave a gap of "
            f"{np.degrees(ellipsoid.gap):.0f}° around one direction (at most "
            f"{np.degrees(_WIDEST_GAP):.0f}° allowed), and the norm is known to "
            f"{ellipsoid.standard_error:.1%} where it is worst (at most {_LARGEST_ERROR:.0%})"
        )
        raise ValueError(msg)
    return Ellipsoid(
        centre=ellipsoid.centre * extent + middle,
        to_sphere=ellipsoid.to_sphere,
        radius=ellipsoid.radius * extent,
        spread=ellipsoid.spread,
        gap=ellipsoid.gap,
        standard_error=ellipsoid.standard_error,
    )


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


def _refine(points: Floats, matrix: Floats, centre: Floats) -> tuple[Floats, Floats] | None:
    """Make the norms of the corrected points as equal as they get; None where that diverges."""
    for _ in range(_STEPS):
        residual, slopes = _norms_less_one(points, matrix, centre)
        size = np.linalg.norm(slopes, axis=0)
        step = np.linalg.lstsq(slopes / size, -residual, rcond=None)[0] / size
        matrix = matrix.copy()
        matrix[_TRIANGLE] += step[:6]
        matrix.T[_TRIANGLE] = matrix[_TRIANGLE]
        centre = centre + step[6:]
        if not np.linalg.eigvalsh(matrix)[0] > 0:
            return None
        if np.abs(step).max() < _CONVERGED:
            return matrix, centre
    return None


def _norms_less_one(points: Floats, matrix: Floats, centre: Floats) -> tuple[Floats, Floats]:
    """Norms of the corrected points less 1, and their derivatives by the nine unknowns."""
    left = points - centre
    corrected = left @ matrix
    norms = np.linalg.norm(corrected, axis=1)
    outward = corrected / norms[:, np.newaxis]
    row, column = _TRIANGLE
    by_matrix = outward[:, row] * left[:, column] + outward[:, column] * left[:, row]
    by_matrix[:, row == column] /= 2  # an element of the diagonal stands once in the matrix
    return norms - 1, np.concatenate([by_matrix, -outward @ matrix], axis=1)


def _judge(points: Floats, matrix: Floats, centre: Floats) -> Ellipsoid:
    residual, slopes = _norms_less_one(points, matrix, centre)
    corrected = (points - centre) @ matrix
    outward = corrected / np.linalg.norm(corrected, axis=1, keepdims=True)
    sphere = _directions(500)
    nearest = np.array([np.max(outward @ direction) for direction in sphere])
    _, on_sphere = _norms_less_one(centre + sphere @ np.linalg.inv(matrix), matrix, centre)
    variance = residual @ residual / (len(points) - _UNKNOWNS)
    # With slopes = Q R the covariance of the unknowns is the variance times (Rᵀ R)⁻¹.
    triangle = np.linalg.qr(slopes).R
    errors = np.linalg.norm(np.linalg.solve(triangle.T, on_sphere.T), axis=0)
    radius = float(np.linalg.det(matrix)) ** (-1 / 3)
    return Ellipsoid(
        centre=centre,
        to_sphere=radius * matrix,
        radius=radius,
        spread=float(np.std(residual) / np.mean(residual + 1)),
        gap=float(np.arccos(np.clip(nearest.min(), -1, 1))),
        standard_error=float(np.sqrt(variance) * errors.max()),
    )


def _directions(count: int) -> Floats:
    """Spread directions evenly over the sphere, along a spiral by the golden angle."""
    height = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (3 - np.sqrt(5)) * np.arange(count)
    radius = np.sqrt(1 - height**2)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=1)
