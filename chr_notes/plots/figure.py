"""A figure as a page shows it: an SVG image with a text alternative, the same each time."""

import base64
import html
import io
import re
from dataclasses import dataclass
from typing import Any, Final

import matplotlib as mpl
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from chr_notes.palette import DASHES, PALETTE

_NOT_SEEN: Final = re.compile(r"<metadata>.*?</metadata>|\b([1-9]\d*\.\d\d)\d+", re.DOTALL)
"""What only makes a page heavy: metadata, and digits beyond a hundredth of a point."""
_COLOUR: Final = re.compile(r"(fill|stroke): (#[0-9a-f]{6})")
_NAMES: Final = {colour.light: name for name, colour in reversed([*PALETTE.items()])} | {
    "#000000": "ink",  # what matplotlib draws by itself: letters and frames,
    "#cccccc": "line",  # a legend's edge,
    "#b0b0b0": "line",  # a grid
}


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
        caption = self.caption.replace("'", "\u2019")  # as Markdown sets it in the text around
        return (
            f'<figure><img class="chr-figure" alt="{html.escape(self.alt)}" '
            f'src="data:image/svg+xml;base64,{data}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>"
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
    return Picture(_in_both_themes(_NOT_SEEN.sub(r"\1", buffer.getvalue())), alt, caption)


def _in_both_themes(svg: str) -> str:
    """Let the page's theme choose between the two shades that the palette has of a colour."""
    used = {"ink"}

    def variable(found: re.Match[str]) -> str:
        name = _NAMES.get(found[2])
        if name is None:
            return found[0]
        used.add(name)
        return f"{found[1]}: var(--{name})"

    drawn = _COLOUR.sub(variable, svg)
    names = [name for name in PALETTE if name in used]
    light = "".join(f"--{name}:{PALETTE[name].light};" for name in names)
    dark = "".join(f"--{name}:{PALETTE[name].dark};" for name in names)
    # Black letters say nothing of their colour, and have the drawing's.
    style = (
        f"svg{{fill:var(--ink);{light}}}@media(prefers-color-scheme:dark){{svg{{{dark}}}}}</style>"
    )
    return drawn.replace("</style>", style, 1)


def line_style(name: str) -> Any:  # noqa: ANN401 (matplotlib's line styles are untyped)
    """Give the dash pattern of a name of the palette as matplotlib takes it."""
    return (0, DASHES[name]) if DASHES[name] else "solid"
