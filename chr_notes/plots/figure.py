"""A figure as a page shows it: an SVG image with a text alternative, the same each time."""

import base64
import html
import io
from dataclasses import dataclass
from typing import Any

import matplotlib as mpl
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from chr_notes.palette import DASHES


@dataclass(frozen=True)
class Picture:
    """A drawn figure with the words that stand in for it.

    Parameters
    ----------
    svg
        The drawing.
    alt
        What it shows, for those who do not see it.
    caption
        What stands below it, for all: the point of the figure.
    """

    svg: str
    alt: str
    caption: str

    def __repr__(self) -> str:
        """Give the words, where no image can be shown."""
        return f"Figure: {self.alt}"

    def _repr_html_(self) -> str:
        data = base64.b64encode(self.svg.encode()).decode()
        return (
            f'<figure><img class="chr-figure" alt="{html.escape(self.alt)}" '
            f'src="data:image/svg+xml;base64,{data}">'
            f"<figcaption>{html.escape(self.caption)}</figcaption></figure>"
        )


def show(figure: Figure, alt: str, caption: str) -> Picture:
    """Turn a figure into a picture for a notebook cell, and close it.

    Parameters
    ----------
    figure
        The matplotlib figure.
    alt
        What the figure shows, one or two sentences.
    caption
        What stands below it: the point of the figure, in one sentence or two.
    """
    buffer = io.StringIO()
    # Axes that are larger than their figure, and so not in its layout, are cut off at its edges.
    whole = all(axes.get_in_layout() for axes in figure.axes)
    # Without a date and with a fixed salt the same figure gives the same file.
    with mpl.rc_context({"svg.hashsalt": "chr_notes", "svg.fonttype": "path"}):
        figure.savefig(
            buffer, format="svg", metadata={"Date": None}, bbox_inches="tight" if whole else None
        )
    plt.close(figure)
    return Picture(buffer.getvalue(), alt, caption)


def line_style(name: str) -> Any:  # noqa: ANN401 (matplotlib's line styles are untyped)
    """Give the dash pattern of a name of the palette as matplotlib takes it."""
    return (0, DASHES[name]) if DASHES[name] else "solid"
