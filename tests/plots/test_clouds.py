"""Points and ellipsoids in space."""

import numpy as np
from matplotlib import pyplot as plt
from numpy.testing import assert_allclose

from chr_notes import plots


def test_points_stand_where_they_are() -> None:
    points = np.random.default_rng(0).normal(size=(30, 3))
    axes = plots.draw_cloud(points, "raw")
    _origin, cloud = axes.collections
    assert_allclose(np.array(cloud._offsets3d).T, points)  # noqa: SLF001 (no public way)
    assert axes.get_legend().get_texts()[0].get_text() == "raw"
    plt.close(axes.figure)


def test_the_net_of_an_ellipsoid_lies_on_it() -> None:
    centre, matrix = np.array([1.0, 2, 3]), np.array([[1.0, 0.1, 0], [0.1, 0.5, 0], [0, 0, 2]])
    axes = plots.draw_ellipsoid(plots.draw_cloud(np.zeros((1, 3))), centre, matrix, 4.0)
    segments = axes.collections[-1]._segments3d  # noqa: SLF001 (no public way)
    lines = np.concatenate([np.array(segment) for segment in segments])
    assert_allclose(np.linalg.norm((lines - centre) @ matrix.T, axis=1), 4.0)
    plt.close(axes.figure)
