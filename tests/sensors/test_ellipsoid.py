"""Ellipsoids from clouds of points."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from scipy.optimize import least_squares

from chr_notes.sensors.ellipsoid import fit_ellipsoid
from tests.sampling import few

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)


def directions(generator: np.random.Generator, count: int, reach_deg: float = 180.0) -> Floats:
    """Unit vectors that are spread evenly over a cap about z of the given half-angle."""
    height = generator.uniform(np.cos(np.radians(reach_deg)), 1.0, count)
    turn = generator.uniform(0.0, 2 * np.pi, count)
    radius = np.sqrt(1 - height**2)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=1)


def to_sphere(generator: np.random.Generator) -> Floats:
    """A symmetric matrix of determinant 1, whose semi-axes differ by a factor of up to 3."""
    turn = np.linalg.qr(generator.normal(size=(3, 3)))[0]
    axes = np.exp(generator.uniform(-0.5, 0.5, 3))
    return turn * (axes / np.cbrt(axes.prod())) @ turn.T


@given(seeds)
@few(25)
def test_a_clean_ellipsoid_is_found_exactly(seed: int) -> None:
    generator = np.random.default_rng(seed)
    matrix, centre = to_sphere(generator), generator.uniform(-200, 200, 3)
    points = 50 * directions(generator, 300) @ np.linalg.inv(matrix) + centre
    found = fit_ellipsoid(points)
    assert_allclose(found.centre, centre, atol=1e-6)
    assert_allclose(found.to_sphere, matrix, atol=1e-8)
    assert_allclose(found.radius, 50, rtol=1e-8)
    assert found.spread < 1e-9


@given(seeds, st.floats(1e-6, 1e6))
@few(25)
def test_the_unit_of_the_samples_does_not_matter(seed: int, unit: float) -> None:
    generator = np.random.default_rng(seed)
    points = directions(generator, 200) @ to_sphere(generator) + generator.normal(0, 0.02, (200, 3))
    one, other = fit_ellipsoid(points), fit_ellipsoid(unit * points)
    assert_allclose(other.centre, unit * one.centre, atol=1e-7 * unit)
    assert_allclose(other.to_sphere, one.to_sphere, atol=1e-7)
    assert_allclose(other.radius, unit * one.radius, rtol=1e-7)
    assert_allclose(
        [other.spread, other.gap, other.standard_error], [one.spread, one.gap, one.standard_error],
        atol=1e-7,
    )  # fmt: skip


def test_no_other_ellipsoid_makes_the_norms_more_equal() -> None:
    generator = np.random.default_rng(4)
    points = directions(generator, 400) @ to_sphere(generator) + generator.normal(0, 0.03, (400, 3))

    def residuals(unknowns: Floats) -> Floats:
        matrix = np.zeros((3, 3))
        matrix[np.triu_indices(3)] = unknowns[:6]
        return np.linalg.norm((points - unknowns[6:]) @ matrix, axis=1) - 1

    # SciPy's optimiser, over triangular matrices, which make the same ellipsoids
    best = least_squares(residuals, [1, 0, 0, 1, 0, 1, 0, 0, 0], xtol=1e-14, ftol=1e-14).cost
    found = fit_ellipsoid(points)
    norms = np.linalg.norm((points - found.centre) @ found.to_sphere, axis=1) / found.radius
    assert_allclose(np.sum((norms - 1) ** 2) / 2, best, rtol=1e-9)


def test_the_standard_error_is_what_repetition_shows(
    samples: Callable[[int, int], int],
) -> None:
    generator = np.random.default_rng(5)
    true = directions(generator, 200, 120.0)
    worst = -np.array([0.0, 0.0, 1.0])
    claims, norms = [], []
    for _ in range(samples(60, 120)):
        found = fit_ellipsoid(true + generator.normal(0, 0.01, true.shape))
        claims.append(found.standard_error)
        norms.append(np.linalg.norm((worst - found.centre) @ found.to_sphere) / found.radius)
    # A standard deviation from 120 repetitions is itself known to 6.5 %, from 60 to 9 %, and the
    # claims vary by 10 %.
    assert_allclose(np.std(norms), np.mean(claims), rtol=0.2)


def test_rows_with_nan_are_left_out() -> None:
    generator = np.random.default_rng(6)
    points = directions(generator, 50) + generator.normal(0, 0.01, (50, 3))
    holed = np.insert(points, [3, 20], np.nan, axis=0)
    assert_allclose(fit_ellipsoid(holed).centre, fit_ellipsoid(points).centre)


def test_samples_are_not_modified() -> None:
    points = directions(np.random.default_rng(7), 50)
    before = points.copy()
    fit_ellipsoid(points)
    assert_allclose(points, before, rtol=0, atol=0)


SPHERE = directions(np.random.default_rng(8), 200)
TURN = np.linspace(0, 2 * np.pi, 200)
RING = np.stack([np.cos(TURN), np.sin(TURN), 0 * TURN], axis=1)
NOISE = np.random.default_rng(9).normal(0, 0.01, (200, 3))
REFUSED = {
    "one number a row": (np.zeros(9), r"samples: expected shape \(\.\.\., 3\), got \(9,\)"),
    "one sample": (np.zeros(3), r"samples: expected shape \(N, 3\), got \(3,\)"),
    "few": (SPHERE[:9], "samples: expected at least 10 rows without NaN, .* got 9"),
    "few without NaN": (
        np.where(np.arange(200)[:, np.newaxis] < 195, np.nan, SPHERE),
        "samples: expected at least 10 rows without NaN, .* got 5",
    ),
    "all equal": (np.full((200, 3), 7.3), "samples: expected .* directions, got 200 equal rows"),
    "flat": (RING + 5, r"samples: expected readings all around, got points in one plane"),
    "a ring with noise": (
        RING + NOISE,
        r"one ellipsoid from many; .* near one plane, as of turns about z alone: lean that to all",
    ),
    "a ring that soft iron makes an ellipse": (
        RING * [1.0, 0.6, 1.0] + NOISE,
        r"near one plane, as of turns about z alone: .*, or fit_hard_iron where it has to",
    ),
    "a very noisy half": (
        directions(np.random.default_rng(11), 150, 90.0) + 4 * NOISE[:150],
        r"within 8\d° of -z of the sensor, which would do if they were less noisy: .* many more",
    ),
    "a cap of 60°": (
        directions(np.random.default_rng(10), 500, 60.0),
        r"too little of the sphere: they leave a gap of 11\d° around one direction \(at most 100°",
    ),
    "a noisy cap of 45°": (
        directions(np.random.default_rng(11), 200, 45.0) + 3 * NOISE,
        "samples cover too little of the sphere",
    ),
}


@pytest.mark.parametrize(("samples", "message"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_fitted_is_refused(samples: Floats, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        fit_ellipsoid(samples)


@pytest.mark.parametrize(
    ("file", "columns", "largest"),
    [("bazhin_mag_cloud.csv", (0, 1, 2), 0.022), ("ckexplorer_acc_mag_log.csv", (3, 4, 5), 0.014)],
)
def test_recorded_fields_have_one_norm(
    recordings: Path, file: str, columns: tuple[int, ...], largest: float
) -> None:
    samples = np.loadtxt(recordings / file, delimiter=",", skiprows=1, usecols=columns)
    found = fit_ellipsoid(samples)
    norms = np.linalg.norm((samples - found.centre) @ found.to_sphere, axis=1)
    assert np.std(norms) / np.mean(norms) <= largest
    assert_allclose(np.std(norms) / np.mean(norms), found.spread)


def test_a_recording_that_covers_too_little_is_refused(recordings: Path) -> None:
    file = recordings / "xio_fusion_sensor_data.csv"
    samples = np.loadtxt(file, delimiter=",", skiprows=1, usecols=(7, 8, 9))
    with pytest.raises(ValueError, match="too little of the sphere"):
        fit_ellipsoid(samples)
