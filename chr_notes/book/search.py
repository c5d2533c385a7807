"""What the search shows before all else: entries of the ledger by id, and the field's words."""

import json
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Final

from chr_notes.ledger import Entry

__all__ = ["PLACES", "found_first"]

_CONVERTER: Final = (
    (
        "book/converter.html#converter-and-detective",
        "Converter: one attitude as two systems write it",
    ),
    ("book/conventions.html#one-attitude-written-by-each", "Conventions: one attitude, by each"),
)
_FILTER: Final = "book/api_estimation.html#chr_notes.estimation"
PLACES: Final[Mapping[str, tuple[tuple[str, str], ...]]] = MappingProxyType(
    {
        **dict.fromkeys(
            ("enu", "geometry_msgs", "ros", "um6", "um7", "unity", "unreal"), _CONVERTER
        ),
        "ahrs": (
            ("notebooks/own_sensor.html#the-attitude", "Your own sensor: the attitude from a log"),
            (f"{_FILTER}.averaging.averaged_attitude", "averaged_attitude(), with heading"),
        ),
        "complementary filter": (
            ("notebooks/estimation.html#both-together", "Attitude estimation: both together"),
            (f"{_FILTER}.fixed_gain.fixed_gain_observer", "fixed_gain_observer()"),
        ),
        "dcm": (
            (
                "notebooks/euler.html#roll-and-the-whole-matrix",
                "Euler angles: roll, and the whole matrix of direction cosines",
            ),
            ("book/api.html#chr_notes.euler.matrix_from_euler", "matrix_from_euler()"),
        ),
        "g-sensitivity": (
            ("notebooks/sensors.html#rate-gyros", "What sensors measure: rate gyros"),
            (
                "book/api_sensors.html#chr_notes.sensors.models.RateGyroCalibration",
                "RateGyroCalibration, with the coupling to acceleration",
            ),
        ),
        "ned": (
            ("book/conventions.html#frames", "Conventions: frames"),
            ("book/api.html#chr_notes.frames.change_axes", "change_axes(), to and from other axes"),
        ),
    }
)
"""Where words lead that the field uses and titles do not: page with anchor, and what to show."""


def found_first(ledger: Iterable[Entry]) -> str:
    """Return the script of the search page's first lines: by what is asked for, page and words.

    Parameters
    ----------
    ledger
        All entries.

    Returns
    -------
    str
        JavaScript that gives the table a name, `FIRST`.
    """
    table: dict[str, list[tuple[str, str]]] = {word: [*places] for word, places in PLACES.items()}
    for entry in ledger:
        page = f"book/ledger/{entry.document}.html#{entry.id}"
        table[entry.id] = [(page, f"{entry.id}: {entry.says}")]
    return f"const FIRST = {json.dumps(table, ensure_ascii=False)};\n"
