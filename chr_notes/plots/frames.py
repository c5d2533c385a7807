"""Frames and attitudes in three dimensions.

North-east-down is drawn with north to the right, east towards the reader and down below: half a
turn about north away from matplotlib's axes, so that nothing is mirrored.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection
from numpy.typing import ArrayLike, NDArray

from chr_notes.aircraft import FIN, SECTIONS, TAIL, WING
from chr_notes.palette import PALETTE
from chr_notes.plots.figure import line_style

AXES = ("x", "y", "z")
HEIGHT = 3.6
_DRAWN_FROM_NED = np.diag([1.0, -1.0, -1.0])


def world(axes: Any = None, *, height: float = HEIGHT) -> Any:  # noqa: ANN401 (3D axes are untyped)
    """Prepare axes to draw frames in.

    Parameters
    ----------
    axes
        Three-dimensional matplotlib axes; new ones are made without it.
    height
        Of a new figure, in inches. The axes need a square; a lower figure cuts off white above
        and below it.

    Returns
    -------
    Axes3D
        Cleared, equal in all directions, without box.
    """
    if axes is None:
        room = HEIGHT / height
        # A lower figure is narrower, too, so that its letters are read on a phone.
        figure = plt.figure(figsize=(5.4 if room <= 1 else 4.8, height))
        axes = figure.add_axes((0, 0.4 * (1 - room), 1, room), projection="3d")
        axes.set_in_layout(height >= HEIGHT)
    axes.set_axis_off()
    axes.patch.set_visible(False)  # it reaches beyond a lower figure
    axes.set_proj_type("ortho")
    # Room for the axes, which point north, east and down, and a little for wings and fin.
    axes.set(xlim=(-0.8, 1.2), ylim=(-1.15, 0.85), zlim=(-1.15, 0.85))
    axes.set_box_aspect((1, 1, 1), zoom=1.5)
    axes.view_init(elev=30, azim=-85)
    return axes


def draw_frame(
    axes: Any,  # noqa: ANN401
    matrix: ArrayLike,
    name: str = "",
    *,
    faded: bool = False,
    unlabelled: str = "",
) -> Any:  # noqa: ANN401
    """Draw the three axes of a frame, each with its letter, colour and dash pattern.

    Parameters
    ----------
    axes
        From `world`.
    matrix
        From the inertial to the frame, shape (3, 3): its rows are the axes of the frame.
    name
        Written as an index to the letters.
    faded
        Whether the frame is there for reference only, drawn in grey.
    unlabelled
        Letters of the axes that get no label, because another frame's stands there.
    """
    ends = np.asarray(matrix, dtype=np.float64) @ _DRAWN_FROM_NED
    for letter, end in zip(AXES, ends, strict=True):
        colour = PALETTE["muted" if faded else letter].light
        _draw_arrow(
            axes, np.zeros(3), end, head=0.08,
            color=colour, linewidth=1.1 if faded else 2.2, linestyle=line_style(letter),
        )  # fmt: skip
        if letter in unlabelled:
            continue
        label = rf"${letter}_{{{name}}}$" if name else f"${letter}$"
        place = end + 0.2 * _as_seen(axes, end)
        axes.text(*place, label, color=colour, ha="center", va="center", fontsize=12)
    return axes


def _to_reader(axes: Any) -> NDArray[np.float64]:  # noqa: ANN401
    """Return the unit vector along the line of sight."""
    up, turned = np.radians([axes.elev, axes.azim])
    return np.array([np.cos(up) * np.cos(turned), np.cos(up) * np.sin(turned), np.sin(up)])


def _as_seen(axes: Any, vector: NDArray[np.float64]) -> NDArray[np.float64]:  # noqa: ANN401
    """Return the unit vector, across the line of sight, along which a vector is seen, or zero."""
    seen = vector - (vector @ _to_reader(axes)) * _to_reader(axes)
    return np.asarray(seen / max(float(np.linalg.norm(seen)), 1e-9))


def _draw_arrow(
    axes: Any,  # noqa: ANN401
    start: NDArray[np.float64],
    end: NDArray[np.float64],
    *,
    head: float,
    linestyle: Any = "-",  # noqa: ANN401
    **style: Any,  # noqa: ANN401
) -> None:
    """Draw an arrow whose head faces the reader: matplotlib's is a bar where seen edgewise."""
    along = _as_seen(axes, end - start)
    across = np.cross(along, _to_reader(axes))
    sides = [end - head * (along + side * np.tan(np.radians(20.0)) * across) for side in (1, -1)]
    for points, dashes in (([start, end], linestyle), ([sides[0], end, sides[1]], "-")):
        axes.add_collection3d(Line3DCollection([points], linestyle=dashes, **style))


def draw_arc(
    axes: Any,  # noqa: ANN401
    start: ArrayLike,
    end: ArrayLike,
    label: str,
) -> Any:  # noqa: ANN401
    """Draw the arc along which one axis of a frame has turned into another.

    Parameters
    ----------
    axes
        From `world`.
    start, end
        Unit vectors in inertial components, shape (3,), not opposite to each other.
    label
        Written at the middle of the arc.
    """
    first, last = (np.asarray(vector, dtype=np.float64) for vector in (start, end))
    share = np.linspace(0.0, 1.0, 40)[:, np.newaxis]
    chord = (1 - share) * first + share * last
    arc = 0.55 * chord / np.linalg.norm(chord, axis=1, keepdims=True) @ _DRAWN_FROM_NED
    axes.plot(*arc.T, color=PALETTE["ink"].light, linewidth=1.2)
    axes.text(*(1.2 * arc[20]), label, color=PALETTE["ink"].light, ha="center", fontsize=12)
    return axes


def draw_turn(
    axes: Any,  # noqa: ANN401
    matrix: ArrayLike,
    letter: str,
    label: str,
    *,
    reach: float = 1.35,
) -> Any:  # noqa: ANN401
    """Draw around an axis of a frame which way a positive turn goes, by the right hand.

    Parameters
    ----------
    axes
        From `world`.
    matrix
        From the inertial to the frame, shape (3, 3).
    letter
        The axis: "x", "y" or "z".
    label
        Written beyond the tip of the axis.
    reach
        How far out that is, in lengths of the axis.
    """
    place = AXES.index(letter)
    # The thumb along the axis; the fingers go from the next axis to the one after it.
    axis, first, then = np.roll(np.asarray(matrix, dtype=np.float64), -place, axis=0)
    angle = np.linspace(np.radians(30.0), np.radians(310.0), 60)[:, np.newaxis]
    circle = np.cos(angle) * first + np.sin(angle) * then
    arc = (0.8 * axis + 0.17 * circle) @ _DRAWN_FROM_NED
    colour = PALETTE[letter].light
    axes.plot(*arc[:-8].T, color=colour, linewidth=1.6)
    _draw_arrow(axes, arc[-9], arc[-1], head=0.1, color=colour, linewidth=1.6)
    return draw_label(axes, reach * axis, label, colour=letter)


def draw_label(
    axes: Any,  # noqa: ANN401
    point: ArrayLike,
    label: str,
    *,
    colour: str = "ink",
) -> Any:  # noqa: ANN401
    """Write a label about a point.

    Parameters
    ----------
    axes
        From `world`.
    point
        In inertial components, shape (3,).
    label
        One line or more.
    colour
        Name in the palette.
    """
    place = np.asarray(point, dtype=np.float64) @ _DRAWN_FROM_NED
    axes.text(*place, label, color=PALETTE[colour].light, ha="center", va="center", fontsize=12)
    return axes


def draw_vector(
    axes: Any,  # noqa: ANN401
    vector: ArrayLike,
    label: str,
    *,
    colour: str = "ink",
    align: str = "center",
) -> Any:  # noqa: ANN401
    """Draw a vector from the origin, with its label beyond its tip.

    Parameters
    ----------
    axes
        From `world`.
    vector
        In inertial components, of about the length of a unit vector, shape (3,).
    label
        Written at the tip.
    colour
        Name in the palette.
    align
        Where the label is fixed to the tip: "left", "center" or "right".
    """
    tip = np.asarray(vector, dtype=np.float64) @ _DRAWN_FROM_NED
    shade = PALETTE[colour].light
    _draw_arrow(axes, np.zeros(3), tip, head=0.12, color=shade, linewidth=2.8)
    axes.text(*(tip + 0.12 * _as_seen(axes, tip)), label, color=shade, ha=align, va="center")
    return axes


def draw_path(
    axes: Any,  # noqa: ANN401
    points: ArrayLike,
    *,
    colour: str = "muted",
) -> Any:  # noqa: ANN401
    """Draw the line along which a point has moved.

    Parameters
    ----------
    axes
        From `world`.
    points
        Its places in inertial components, shape (N, 3).
    colour
        Name in the palette.
    """
    line = np.asarray(points, dtype=np.float64) @ _DRAWN_FROM_NED
    axes.plot(*line.T, color=PALETTE[colour].light, linewidth=1.2)
    return axes


def draw_aircraft(axes: Any, matrix: ArrayLike) -> Any:  # noqa: ANN401
    """Draw a small aircraft.

    Parameters
    ----------
    axes
        From `world`.
    matrix
        From the inertial to the body frame, shape (3, 3).
    """
    to_drawn: NDArray[np.float64] = np.asarray(matrix, dtype=np.float64) @ _DRAWN_FROM_NED
    axes.add_collection3d(
        Poly3DCollection(
            [corners @ to_drawn for corners in _aircraft()],
            facecolor=PALETTE["shade"].light,
            edgecolor=PALETTE["glass"].light,
            linewidth=0.8,
            alpha=0.95,
        )
    )
    return axes


def _aircraft() -> list[NDArray[np.float64]]:
    """Outlines of fuselage, wings, tail and fin in the body frame, each of shape (N, 3)."""
    x, width, _, z = np.array(SECTIONS).T
    fuselage = np.concatenate([np.stack([x, width, z], 1), np.stack([x, -width, z], 1)[::-1]])
    right = [_plate(WING), _plate(TAIL)]
    return [fuselage, *right, *(plate * [1, -1, 1] for plate in right), _plate(FIN)]


def _plate(sections: Sequence[tuple[float, ...]]) -> NDArray[np.float64]:
    """Outline of a plate: along its leading edge out, along its trailing edge back."""
    leading, trailing, y, z, _ = np.array(sections).T
    return np.concatenate([np.stack([leading, y, z], 1), np.stack([trailing, y, z], 1)[::-1]])
