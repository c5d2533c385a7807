"""Angles over time."""

import numpy as np
import pytest
from matplotlib import pyplot as plt
from numpy.testing import assert_allclose, assert_array_equal

from chr_notes import plots
from chr_notes.palette import PALETTE

TIME = np.arange(4.0)
EULER = np.radians([[0.0, 10, 170], [1, 20, 179], [2, 30, -179], [3, 40, -170]])


def test_each_angle_has_its_panel_and_colour() -> None:
    panels = plots.draw_angles(TIME, {"gyro": EULER}, EULER)
    assert [panel.get_ylabel() for panel in panels] == ["roll (°)", "pitch (°)", "yaw (°)"]
    for place, (panel, axis) in enumerate(zip(panels, "xyz", strict=True)):
        truth, estimate = panel.lines
        assert truth.get_label() == "truth"
        assert estimate.get_color() == PALETTE[axis].light
        drawn = estimate.get_ydata()
        kept = np.isfinite(drawn)
        assert_allclose(drawn[kept], np.degrees(EULER[kept, place]))
    plt.close(panels[0].figure)


def test_a_line_breaks_where_yaw_jumps() -> None:
    (panel,) = plots.draw_angles(TIME, {"gyro": EULER}, shown=["yaw"])
    assert np.isnan(panel.lines[0].get_ydata()).tolist() == [False, False, True, False]
    plt.close(panel.figure)


def test_a_last_bit_makes_no_other_line() -> None:
    panels = plots.draw_angles(TIME, {"one": EULER, "other": EULER * (1 + 1e-13)})
    for panel in panels:
        one, other = panel.lines
        assert_array_equal(one.get_ydata(), other.get_ydata())
    plt.close(panels[0].figure)


def test_estimates_differ_by_more_than_colour() -> None:
    panels = plots.draw_angles(TIME, {"one": EULER, "other": EULER + 0.1})
    one, other = panels[0].lines
    assert one.get_linestyle() != other.get_linestyle()
    plt.close(panels[0].figure)


def test_too_many_estimates_are_refused() -> None:
    with pytest.raises(ValueError, match="estimates: expected at most 4, got 5"):
        plots.draw_angles(TIME, {str(number): EULER for number in range(5)})
