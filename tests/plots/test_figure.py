"""A figure in both themes."""

import re

import pytest
from matplotlib import pyplot as plt

from chr_notes import plots
from chr_notes.palette import PALETTE


@pytest.fixture(scope="module")
def svg() -> str:
    figure, axes = plt.subplots(figsize=(2, 2))
    axes.plot([0, 1], color=PALETTE["x"].light, label="a line")
    axes.plot([1, 0], color="#123456")
    axes.grid()
    axes.legend()
    return plots.show(figure, "A line.", "A line.").svg


def test_each_colour_of_the_palette_has_its_shade_in_either_theme(svg: str) -> None:
    light, dark = re.findall(r"svg\{([^{}]*)\}", svg)
    for name, shades in PALETTE.items():
        assert (f"var(--{name})" in svg) == (f"--{name}:{shades.light};" in light)
        assert (f"var(--{name})" in svg) == (f"--{name}:{shades.dark};" in dark)
    assert "@media(prefers-color-scheme:dark){svg{--" in svg
    assert "stroke: var(--x)" in svg


def test_what_matplotlib_draws_by_itself_is_in_the_palette_too(svg: str) -> None:
    assert {*re.findall(r"(?:fill|stroke): (#\w+)", svg)} == {"#123456"}
    assert "svg{fill:var(--ink);" in svg  # letters say no colour


def test_no_digit_stands_that_is_not_seen(svg: str) -> None:
    assert "metadata" not in svg
    assert not re.search(r"\b[1-9]\d*\.\d{3}", svg)
