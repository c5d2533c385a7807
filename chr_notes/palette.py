"""The colours of the project, in one place for figures, demos and pages.

Hues follow Okabe and Ito's set of 2008, which stays apart under the common forms of colour
blindness, darkened or lightened until each reaches a contrast of 3:1 on its background. An axis
has the same colour everywhere, and a letter or a dash pattern beside it, so that colour is never
the only cue.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

__all__ = ["DASHES", "PALETTE", "Colour", "css"]


@dataclass(frozen=True)
class Colour:
    """One colour in the two themes, each as ``#rrggbb``."""

    light: str
    dark: str


PALETTE: Final[Mapping[str, Colour]] = MappingProxyType(
    {
        # What is drawn on.
        "page": Colour("#ffffff", "#14181e"),
        "surface": Colour("#f5f7fa", "#1c222b"),
        "raised": Colour("#ffffff", "#252c37"),
        "line": Colour("#d5dbe3", "#3a4452"),
        "shade": Colour("#b4bdc9", "#66758a"),
        # What is written.
        "ink": Colour("#17202b", "#e8edf3"),
        "muted": Colour("#566274", "#a3afbf"),
        "accent": Colour("#0b5c91", "#6cbcf2"),
        # Axes: x, y, z of whichever frame is drawn.
        "x": Colour("#c84e00", "#ff9155"),
        "y": Colour("#00805c", "#3ccf9f"),
        "z": Colour("#0067a8", "#5fb4f5"),
        # A body, a warning, and the five verdicts.
        "body": Colour("#c2ccd8", "#c5cfdb"),
        "glass": Colour("#33455a", "#3b4f66"),
        "alert": Colour("#a8327e", "#ee8cc8"),
        "definition": Colour("#566274", "#a3afbf"),
        "proved": Colour("#00744f", "#3ccf9f"),
        "qualified": Colour("#8a5a00", "#f0bb4c"),
        "corrected": Colour("#a8327e", "#ee8cc8"),
        "reported": Colour("#0b5c91", "#6cbcf2"),
    }
)
"""Colour by what it is for."""

DASHES: Final[Mapping[str, tuple[float, ...]]] = MappingProxyType(
    {"x": (), "y": (7.0, 3.0), "z": (2.0, 2.0), "alert": (7.0, 2.0, 2.0, 2.0)}
)
"""The second cue of an axis or a line: dash pattern, empty for a solid line.

Demos count in pixels, figures in widths of the line.
"""

_DARK_HOSTS: Final = (
    ':root[data-theme="dark"] > body',
    'body[data-jp-theme-light="false"]',
    'body[data-vscode-theme-kind="vscode-dark"]',
)
"""How the book, JupyterLab and VS Code say that their theme is dark."""

_SILENT_HOST: Final = (
    ":root:not([data-theme]) > body:not([data-jp-theme-light]):not([data-vscode-theme-kind])"
)
"""A page that says nothing about themes, where the reader's system decides."""


def css() -> str:
    """Return the palette as CSS variables ``--chr-<name>`` on ``body``, for both themes."""
    light = _block("light", {name: colour.light for name, colour in PALETTE.items()})
    dark = _block("dark", {name: colour.dark for name, colour in PALETTE.items()})
    return (
        f"body {light}\n"
        f"@media (prefers-color-scheme: dark) {{ {_SILENT_HOST} {dark} }}\n"
        f"{', '.join(_DARK_HOSTS)} {dark}\n"
    )


def _block(scheme: str, colours: Mapping[str, str]) -> str:
    variables = " ".join(f"--chr-{name}: {value};" for name, value in colours.items())
    return f"{{ --chr-scheme: {scheme}; {variables} }}"
