"""Figures: arrays in, matplotlib Axes out."""

try:
    import matplotlib as mpl  # noqa: F401 (before what is made with it)
except ModuleNotFoundError as error:
    MSG = 'plots need matplotlib; run: python -m pip install "chr-notes[notebooks]"'
    raise ModuleNotFoundError(MSG, name="matplotlib") from error

from chr_notes.plots.clouds import draw_cloud, draw_ellipsoid
from chr_notes.plots.figure import Picture, show
from chr_notes.plots.frames import (
    draw_aircraft,
    draw_arc,
    draw_frame,
    draw_label,
    draw_path,
    draw_turn,
    draw_vector,
    world,
)
from chr_notes.plots.growth import draw_growth
from chr_notes.plots.series import draw_angles

__all__ = [
    "Picture",
    "draw_aircraft",
    "draw_angles",
    "draw_arc",
    "draw_cloud",
    "draw_ellipsoid",
    "draw_frame",
    "draw_growth",
    "draw_label",
    "draw_path",
    "draw_turn",
    "draw_vector",
    "show",
    "world",
]
