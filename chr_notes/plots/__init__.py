"""Figures: arrays in, matplotlib Axes out."""

from chr_notes.plots.figure import Picture, show
from chr_notes.plots.frames import draw_aircraft, draw_arc, draw_frame, world

__all__ = ["Picture", "draw_aircraft", "draw_arc", "draw_frame", "show", "world"]
