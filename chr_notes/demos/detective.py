"""Which conventions explain what two programs say of one rotation: the detective on a page."""

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, ClassVar, Final

import numpy as np
import traitlets

from chr_notes._odd_rows import ROTATION_TOLERANCE
from chr_notes.demos.base import Demo, entry
from chr_notes.systems.axes import KNOWN
from chr_notes.systems.candidates import FIELDS, KEPT, NAMED, PLAIN, REORDERED, SIGNED
from chr_notes.systems.convention import Convention
from chr_notes.systems.detective import find_conventions
from chr_notes.systems.examples import (
    LEAST_ERROR,
    MOST_DECIMALS,
    MOST_ERROR,
    ORDINALS,
    SIZES,
    TRIED,
)
from chr_notes.systems.matches import GENERIC, Match

__all__ = ["DETECTIVE", "DetectiveDemo"]

SHAPES: Final = {
    "angles": (3,), "matrix": (3, 3), "quaternion": (4,), "accel": (3,), "vectors": (2, 3),
}  # fmt: skip
UNITS: Final = {"": None, "degrees": True, "radians": False}

DETECTIVE: Final = {
    "fields": {kind: each for kind, each in FIELDS.items() if kind != "angles"},
    "plain": PLAIN,
    "reordered": [
        {"sequence": each["sequence"], "written": each["written"]}
        for each in REORDERED
        if each["degrees"]
    ],
    "signed": [
        {name: each[name] for name in ("sequence", "written", "negated")}
        for each in SIGNED
        if each["degrees"]
    ],
    "named": NAMED,
    "kept": KEPT,
    "axes": [
        {
            "name": (navigation, body),
            "navigation": own.axes("navigation").ravel().tolist(),
            "body": own.axes("body").ravel().tolist(),
        }
        for navigation, body in KNOWN
        for own in (Convention(navigation=navigation, body=body),)
    ],
    "tried": TRIED,
    "generic": GENERIC,
    "own": asdict(Convention()),
    "rounds": {
        "most_decimals": MOST_DECIMALS,
        "least_error": LEAST_ERROR,
        "most_error": MOST_ERROR,
        "sizes": SIZES,
    },
    "shapes": SHAPES,
    "ordinals": ORDINALS,
    "tolerance": ROTATION_TOLERANCE,
}
"""What the page's script has of the tables of the search."""


class DetectiveDemo(Demo):
    """What two programs say of one rotation, and the conventions under which they agree.

    Two or more kinds of numbers are typed or pasted, one example each or several. What is found is
    that of `chr_notes.find_conventions`.

    Parameters
    ----------
    angles, matrix, quaternion, accel, vectors : list of float, optional
        Numbers as printed, in a row: of an example three angles, the nine of a matrix row by row,
        four of a quaternion, three of an accelerometer at rest in any unit, and three of a vector
        before with three after the turn; empty for what is not known. Angles of 17.19, 11.46 and
        5.73 with a quaternion unless told. Each value follows its field while a kernel runs.
    unit : str, optional
        "degrees" or "radians" if that is known of the angles.

    Raises
    ------
    traitlets.TraitError
        For numbers that are no number of whole examples.
    """

    element = "detective"
    bundle = "converter"
    pictured = False
    controls: ClassVar[tuple[str, ...]] = ()

    angles = traitlets.List(traitlets.Float(), [17.19, 11.46, 5.73]).tag(sync=True)
    matrix = traitlets.List(traitlets.Float()).tag(sync=True)
    quaternion = traitlets.List(traitlets.Float(), [0.0343, 0.106, 0.1436, 0.9833]).tag(sync=True)
    accel = traitlets.List(traitlets.Float()).tag(sync=True)
    vectors = traitlets.List(traitlets.Float()).tag(sync=True)
    unit = traitlets.Enum(tuple(UNITS), "").tag(sync=True)

    @traitlets.validate(*SHAPES)
    def _check(self, proposal: dict[str, Any]) -> list[float]:
        """Refuse a part of an example."""
        value: list[float] = proposal["value"]
        name = proposal["trait"].name
        size = int(np.prod(SHAPES[name]))
        if len(value) % size or not np.isfinite(value).all():
            msg = f"The '{name}' trait: expected {size} numbers an example, got {len(value)}"
            raise traitlets.TraitError(msg)
        return value

    def state(self) -> dict[str, Any]:
        """Return what is given."""
        return {name: getattr(self, name) for name in (*SHAPES, "unit")}

    def readouts(self) -> list[Match]:
        """Return what is found.

        Raises
        ------
        ValueError
            If too little is given, or no convention explains it.
        """
        given: dict[str, Any] = {
            name: np.reshape(getattr(self, name), (-1, *shape))
            for name, shape in SHAPES.items()
            if getattr(self, name)
        }
        if "vectors" in given:
            given["vectors"] = np.moveaxis(given["vectors"], 1, 0)
        return find_conventions(**given, degrees=UNITS[self.unit])

    def fallback(self) -> str:
        """Return what is given, and what is found, in two sentences."""
        given = " and ".join(
            f"the {name} {_row(getattr(self, name))}" for name in SHAPES if getattr(self, name)
        )
        try:
            found = self.readouts()
        except ValueError as error:
            return f"Given {given}. Found nothing: {error}."
        first = found[0].convention
        unit = "degrees" if first.degrees else "radians"
        return (
            f"Given {given}. Found {len(found)}, first: angles {first.sequence} in {unit}, a "
            f"matrix {first.matrix}, a quaternion {first.quaternion} with its scalar part "
            f"{'first' if first.scalar_first else 'last'}."
        )

    def __repr__(self) -> str:
        """Return the call that makes this demo."""
        given = ", ".join(f"{name}={value!r}" for name, value in self.state().items())
        return f"DetectiveDemo({given})"


def _row(values: Sequence[float]) -> str:
    return ", ".join(entry(each) for each in values)
