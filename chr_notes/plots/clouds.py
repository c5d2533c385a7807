"""Readings of a magnetometer as points in space: a sphere, or what iron has made of it."""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from numpy.typing import ArrayLike

from chr_notes.palette import PALETTE


def draw_cloud(
    points: ArrayLike,
    label: str = "",
    *,
    colour: str = "z",
    marker: str = "o",
    axes: Any = None,  # noqa: ANN401 (matplotlib's 3D axes are untyped)
) -> Any:  # noqa: ANN401
    """Draw readings as points about the origin, which is marked.

    Parameters
    ----------
    points
        Shape (N, 3).
    label
        For the legend.
    colour
        Name in the palette.
    marker
        matplotlib's sign for a point; the second cue beside the colour.
    axes
        Three-dimensional matplotlib axes; new ones are made without it.

    Returns
    -------
    Axes3D
    """
    if axes is None:
        axes = plt.figure(figsize=(4.6, 4.4)).add_subplot(projection="3d")
        axes.set_proj_type("ortho")
        axes.scatter(0, 0, 0, color=PALETTE["ink"].light, marker="+", s=60)
        for name in "xyz":
            getattr(axes, f"set_{name}label")(name)
    x, y, z = np.asarray(points, dtype=np.float64).T
    axes.scatter(x, y, z, s=5, color=PALETTE[colour].light, marker=marker, label=label, alpha=0.7)
    axes.set_aspect("equal")
    if label:
        axes.legend(fontsize="small")
    return axes


def draw_ellipsoid(
    axes: Any,  # noqa: ANN401
    centre: ArrayLike,
    to_sphere: ArrayLike,
    radius: float,
    *,
    colour: str = "muted",
) -> Any:  # noqa: ANN401
    """Draw an ellipsoid as a net of lines; a sphere, if the matrix is the identity.

    Parameters
    ----------
    axes
        From `draw_cloud`.
    centre
        Shape (3,).
    to_sphere
        Matrix that takes the ellipsoid, moved to the origin, to a sphere, shape (3, 3).
    radius
        Of that sphere.
    colour
        Name in the palette.
    """
    height = np.linspace(-np.pi / 2, np.pi / 2, 19)[:, np.newaxis]
    turn = np.linspace(0, 2 * np.pi, 25)
    unit = np.stack(
        np.broadcast_arrays(
            np.cos(height) * np.cos(turn), np.cos(height) * np.sin(turn), np.sin(height)
        ),
        axis=-1,
    )
    from_sphere = np.linalg.inv(np.asarray(to_sphere, dtype=np.float64))
    surface = radius * unit @ from_sphere.T + np.asarray(centre, dtype=np.float64)
    axes.plot_wireframe(
        *np.moveaxis(surface, -1, 0),
        color=PALETTE[colour].light,
        linewidth=0.5,
        rstride=2,
        cstride=2,
    )
    axes.set_aspect("equal")
    return axes
