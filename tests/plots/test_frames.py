"""What the figures show is where the numbers say."""

import numpy as np
import pytest
from matplotlib import pyplot as plt
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.proj3d import proj_transform
from numpy.typing import ArrayLike, NDArray

import chr_notes
from chr_notes import plots

ORIGIN_AND_UNITS = np.vstack([np.zeros(3), np.eye(3)])


def on_sheet(axes: Axes3D, places: ArrayLike) -> NDArray[np.float64]:
    """Where projected places are on the sheet from the origin, in the unit of the axes."""
    origin, *units = ([*proj_transform(*each, axes.get_proj())[:2]] for each in ORIGIN_AND_UNITS)
    scale = np.sqrt(((np.array(units) - origin) ** 2).sum() / 2)
    return np.asarray((np.asarray(places) - origin) / scale)


def seen(axes: Axes3D, point: ArrayLike) -> NDArray[np.float64]:
    """Where a point is on the sheet."""
    x, y, z = np.asarray(point)
    return on_sheet(axes, proj_transform(x, y, z, axes.get_proj())[:2])


def beyond(place: NDArray[np.float64], end: NDArray[np.float64]) -> float:
    """How far beyond an end, as seen from the origin, a place is; it must be in line with both."""
    assert np.linalg.det([place, end]) == pytest.approx(0, abs=1e-12)
    return float((place - end) @ end / np.linalg.norm(end))


def test_a_figure_is_the_same_each_time_and_has_words() -> None:
    def picture() -> plots.Picture:
        axes = plots.draw_frame(plots.world(), np.eye(3), "I")
        return plots.show(plots.draw_aircraft(axes, np.eye(3)).figure, 'a "frame"', "A frame.")

    first, second = picture(), picture()
    assert first == second
    assert first._repr_html_().count('alt="a &quot;frame&quot;"') == 1
    assert "Date" not in first.svg
    assert not plt.get_fignums()


def test_a_lower_figure_cuts_off_white_and_keeps_its_size() -> None:
    sizes = []
    for height in (3.6, 2.8):
        axes = plots.world(height=height)
        axes.figure.canvas.draw()
        sizes.append(axes.get_window_extent().height)
        svg = plots.show(axes.figure, "nothing", "Nothing.").svg
    assert sizes[0] == pytest.approx(sizes[1])
    assert f'height="{2.8 * 72:g}pt"' in svg


def test_letters_stand_beyond_the_ends_of_the_axes() -> None:
    matrix = chr_notes.matrix_from_euler([0.1, 0.2, 0.3])
    axes = plots.draw_frame(plots.world(), matrix, "B")
    placed = np.array([text.get_position_3d() for text in axes.texts])
    # East and down are drawn towards the reader's negative axes.
    for place, end in zip(placed, matrix * [1, -1, -1], strict=True):
        assert beyond(seen(axes, place), seen(axes, end)) == pytest.approx(0.2)
    plt.close(axes.figure)


def test_an_arrow_has_a_head_as_wide_from_each_side() -> None:
    for vector in ([1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, -0.5, 0.7]):
        axes = plots.draw_vector(plots.world(), vector, "it")
        axes.figure.canvas.draw()
        shaft, head = (on_sheet(axes, line.get_segments()[0]) for line in axes.collections)
        one, tip, other = head
        np.testing.assert_allclose(shaft, [[0, 0], tip], atol=1e-12)
        np.testing.assert_allclose(tip, seen(axes, np.multiply(vector, [1, -1, -1])), atol=1e-12)
        assert np.linalg.norm(one - other) == pytest.approx(0.24 * np.tan(np.radians(20)))
        assert beyond((one + other) / 2, tip) == pytest.approx(-0.12)
        plt.close(axes.figure)


def test_an_arrow_towards_the_reader_is_a_point() -> None:
    axes = plots.world()
    axes.view_init(elev=0, azim=0)
    plots.draw_vector(axes, [1, 0, 0], "it")
    np.testing.assert_allclose(axes.texts[0].get_position_3d(), [1, 0, 0], atol=1e-12)
    plt.close(axes.figure)


def test_an_arc_runs_from_one_axis_to_the_other() -> None:
    start, end = np.array([1.0, 0, 0]), np.array([0, 1.0, 0])
    axes = plots.draw_arc(plots.world(), start, end, "angle")
    line = np.array(axes.lines[0].get_data_3d()).T * [1, -1, -1]
    radius = np.linalg.norm(line, axis=1)
    np.testing.assert_allclose(radius, radius[0])
    np.testing.assert_allclose(line[[0, -1]] / radius[0], [start, end], atol=1e-12)
    plt.close(axes.figure)


def test_the_label_of_a_vector_stands_beyond_its_tip() -> None:
    vector = np.array([0.3, -0.2, -0.9])
    axes = plots.draw_vector(plots.world(), vector, "reading", align="left")
    (text,) = axes.texts
    place, tip = text.get_position_3d(), vector * [1, -1, -1]
    assert beyond(seen(axes, place), seen(axes, tip)) == pytest.approx(0.12)
    assert text.get_horizontalalignment() == "left"
    plt.close(axes.figure)


@pytest.mark.parametrize(("letter", "along", "to"), [("x", 1, 2), ("y", 2, 0), ("z", 0, 1)])
def test_a_turn_goes_by_the_right_hand(letter: str, along: int, to: int) -> None:
    matrix = chr_notes.matrix_from_euler([0.1, 0.2, 0.3])
    axes = plots.draw_turn(plots.world(), matrix, letter, "roll")
    drawn = np.array(axes.lines[0].get_data_3d()).T * [1, -1, -1]
    axis = matrix["xyz".index(letter)]
    around = drawn - np.outer(drawn @ axis, axis)
    # From each point of the arc to the next about the axis, and within the frame as printed.
    assert (np.cross(around[:-1], around[1:]) @ axis > 0).all()
    angle = np.unwrap(np.arctan2(around @ matrix[to], around @ matrix[along]))
    assert (np.diff(angle) > 0).all()
    (text,) = axes.texts
    np.testing.assert_allclose(np.array(text.get_position_3d()) * [1, -1, -1] / 1.35, axis)
    plt.close(axes.figure)


def test_a_path_is_drawn_in_the_same_frame_as_the_axes() -> None:
    points = np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])
    axes = plots.draw_path(plots.world(), points)
    drawn = np.array(axes.lines[0].get_data_3d()).T * [1, -1, -1]
    np.testing.assert_allclose(drawn, points)
    plt.close(axes.figure)


def test_a_caption_stands_below_a_picture_for_all_to_see() -> None:
    drawn = plots.show(plt.figure(), "A < B", "Simulated & the robot's.")
    assert drawn._repr_html_().startswith('<figure><img class="chr-figure" alt="A &lt; B"')
    caption = "Simulated &amp; the robot\u2019s."
    assert drawn._repr_html_().endswith(f"<figcaption>{caption}</figcaption></figure>")
