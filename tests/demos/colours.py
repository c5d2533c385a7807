"""Contrast of colours as they stand on a page."""

from chr_notes.palette import PALETTE


def channels(colour: str) -> list[float]:
    """The three numbers of `rgb(…)`, or of `#rrggbb`, from 0 to 1."""
    if colour.startswith("#"):
        return [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return [float(part) / 255 for part in colour.strip("rgba()").split(",")[:3]]


def of_palette(name: str, theme: str) -> list[float]:
    return channels(str(getattr(PALETTE[name], theme)))


def contrast(one: list[float], other: list[float]) -> float:
    """As the Web Content Accessibility Guidelines define it."""
    linear = [
        [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour]
        for colour in (one, other)
    ]
    low, high = sorted(0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in linear)
    return (high + 0.05) / (low + 0.05)
