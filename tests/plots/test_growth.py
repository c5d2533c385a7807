"""Errors over time."""

import numpy as np
import pytest
from matplotlib import pyplot as plt
from numpy.testing import assert_allclose

from chr_notes import plots

TIME = np.linspace(1.0, 10.0, 20)


def test_magnitudes_are_drawn_with_names_and_unit() -> None:
    axes = plots.draw_growth(TIME, {"north": -(TIME**2), "east": TIME}, "m", expected=TIME**2)
    expected, north, east = axes.lines
    assert_allclose(north.get_ydata(), TIME**2)
    assert_allclose(expected.get_ydata(), TIME**2)
    assert north.get_linestyle() != east.get_linestyle()
    assert axes.get_ylabel() == "error (m)"
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        "expected", "north", "east",
    ]  # fmt: skip
    plt.close(axes.figure)


def test_powers_of_time_can_be_straight() -> None:
    given = plt.subplots(subplot_kw={"xscale": "log", "yscale": "log"})[1]
    axes = plots.draw_growth(TIME, {"position": TIME**2}, "m", axes=given)
    assert axes is given
    assert axes.get_xscale() == axes.get_yscale() == "log"
    plt.close(axes.figure)


def test_too_many_errors_are_refused() -> None:
    with pytest.raises(ValueError, match="errors: expected at most 4, got 5"):
        plots.draw_growth(TIME, {str(number): TIME for number in range(5)}, "m")
