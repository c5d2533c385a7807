"""Least squares on what counts of calibrated readings: that all have the same norm."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes.generated.arrays import sensors as generated

_norm_misfit = Rows(generated.norm_misfit)

ALL = np.arange(9)
"""Unknowns: six elements of the symmetric matrix by rows of its upper triangle, the centre."""
SCALES = np.array([0, 3, 5, 6, 7, 8])
"""A scale for each axis, and the centre."""
ONE_SCALE = np.array([6, 7, 8])
"""The centre alone, of a sphere whose radius is known."""

_TRIANGLE = np.triu_indices(3)
_STEPS = 30
_CONVERGED = 1e-9
_SIGMAS = 5.0  # of the residuals, beyond which a row is taken for an outlier
_NEAR = 0.02  # of the norm, within which no row is
_MOST = 1000  # points that tell as much as more would
_SUBSETS = 60  # of 12 with a tenth of outliers, 28 in 100 are free of them
_SHARE = 0.75  # of the points that have to agree
_DEVIATION = 1.4826  # standard deviation over median absolute deviation, of noise


def norms_less_one(points: Floats, matrix: Floats, centre: Floats) -> tuple[Floats, Floats]:
    """Norms of the corrected points less 1, and their derivatives by the nine unknowns."""
    found = _norm_misfit(matrix[_TRIANGLE], centre, points)
    return found[:, 0], found[:, 1:]


def refined(
    points: Floats, matrix: Floats, centre: Floats, free: NDArray[np.int64] = ALL
) -> tuple[Floats, Floats] | None:
    """Make the norms of the corrected points as equal to 1 as they get, by Gauss and Newton.

    Parameters
    ----------
    points
        Shape (N, 3), of a size near 1.
    matrix, centre
        To start from: symmetric, shape (3, 3), and shape (3,).
    free
        Which unknowns to find; the others stay as they are.

    Returns
    -------
    tuple of ndarray or None
        Matrix and centre; None where that diverges.
    """
    for _ in range(_STEPS):
        residual, slopes = norms_less_one(points, matrix, centre)
        slopes = slopes[:, free]
        size = np.linalg.norm(slopes, axis=0)
        if not (np.isfinite(slopes).all() and (size > 0).all()):
            return None
        step = np.zeros(9)
        step[free] = np.linalg.lstsq(slopes / size, -residual, rcond=None)[0] / size
        matrix = matrix.copy()
        matrix[_TRIANGLE] += step[:6]
        matrix.T[_TRIANGLE] = matrix[_TRIANGLE]
        centre = centre + step[6:]
        if not (np.isfinite(step).all() and np.linalg.eigvalsh(matrix)[0] > 0):
            return None
        if np.abs(step).max() < _CONVERGED:
            return matrix, centre
    return None


def far_off(residual: Floats, usual: Floats) -> NDArray[np.bool_]:
    """Say which residuals are no noise, by the median size of those that tell what is usual."""
    return np.asarray(np.abs(residual) > max(_SIGMAS * deviation(usual), _NEAR))


def deviation(residual: Floats) -> float:
    """Take the standard deviation of residuals as most of them show it."""
    return _DEVIATION * float(np.median(np.abs(residual)))


Fit = Callable[[Floats], tuple[Floats, Floats] | None]


def resistant(points: Floats, fit: Fit, fewest: int) -> tuple[Floats, Floats] | None:
    """Fit to the three quarters of the points that agree best, whatever the others are.

    All points and small random subsets are fitted; from each the points that fit best are taken
    and fitted again, and those with the least residuals win: the fast least trimmed squares of
    Rousseeuw and Van Driessen (Computing LTS regression for large data sets, 2006). The random
    numbers are the same in each call.

    Parameters
    ----------
    points
        Shape (N, 3), of a size near 1.
    fit
        From points to matrix and centre, or None where that fails.
    fewest
        Points of a subset.

    Returns
    -------
    tuple of ndarray or None
        Matrix and centre, or None if no subset can be fitted.
    """
    generator = np.random.default_rng(0)
    if len(points) > _MOST:
        points = points[generator.permutation(len(points))[:_MOST]]
    share = max(fewest, int(np.ceil(_SHARE * len(points))))
    best, least = None, np.inf
    for subset in range(_SUBSETS):
        found = fit(generator.permutation(points)[:fewest] if subset else points)
        for _ in range(3):
            if found is None:
                break
            misfit = np.abs(np.linalg.norm((points - found[1]) @ found[0], axis=1) - 1)
            order = np.argsort(misfit)[:share]
            total = float(np.sum(misfit[order] ** 2))
            if total < least:
                best, least = found, total
            found = fit(points[order])
    return best
