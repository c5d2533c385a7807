"""One attitude in the conventions of two systems: a converter."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final, get_args

import numpy as np
import traitlets

from chr_notes.demos.base import Demo, entry
from chr_notes.sequences import SEQUENCES
from chr_notes.systems.convention import DOCUMENTED, PRESETS, Convention
from chr_notes.systems.converting import Kind, convert

__all__ = ["CONVENTIONS", "ConverterDemo"]

SYSTEMS: Final = PRESETS | DOCUMENTED
KINDS: Final = get_args(Kind)[:4]
UNITS: Final = ("", "degrees", "radians")
LABELS: Final = {"CHR": "CH Robotics (UM6, UM7)"}
"""What readers call a system, where its name says too little."""
_SIZES: Final = {"angles": 3, "matrix": 9, "quaternion": 4, "axis angle": 4}
_WORDS: Final = {
    "n": "north", "s": "south", "e": "east", "w": "west", "u": "up", "d": "down",
    "f": "forward", "b": "back", "l": "left", "r": "right",
}  # fmt: skip


def _table(name: str, convention: Convention) -> dict[str, Any]:
    """Return what the page's script needs to know of a convention."""
    return {
        "name": name,
        "label": LABELS.get(name, name),
        "documented": name in DOCUMENTED,
        "sequence": convention.sequence,
        "order": convention.order,
        "signs": convention.signs,
        "degrees": convention.degrees,
        "transposed": convention.matrix_is_transposed,
        "scalarFirst": convention.scalar_first,
        "conjugated": convention.quaternion_is_conjugated,
        "navigation": convention.axes("navigation").ravel().tolist(),
        "body": convention.axes("body").ravel().tolist(),
        "axes": (convention.navigation, convention.body),
        "room": [_WORDS[letter] for letter in convention.navigation],
        "along": [_WORDS[letter] for letter in convention.body],
    }


CONVENTIONS: Final = {
    "systems": {name: _table(name, each) for name, each in SYSTEMS.items()},
    "sequences": SEQUENCES,
}
"""What the page's script has of the tables of conventions."""


class ConverterDemo(Demo):
    """An attitude as one system writes it, and as another does, in full precision.

    Angles, a quaternion, an axis with its angle, or a matrix are typed or pasted in any notation;
    the angles have sliders too. The numbers are those of `chr_notes.convert`.

    Parameters
    ----------
    kind : str, optional
        What is given: "angles", "quaternion", "axis angle" or "matrix"; "angles" unless told. Each
        value follows what the reader does while a kernel runs.
    value : list of float, optional
        Its numbers as the source writes them, a matrix row by row: three, four or nine, angles in
        the source's unit; 10, 20 and 30 unless told.
    source, target : str, optional
        Names of systems in `PRESETS` or `DOCUMENTED` of `chr_notes.systems.convention`; "CHR" and
        "ROS" unless told.
    source_sequence, target_sequence : str, optional
        One of `chr_notes.sequences.SEQUENCES`, or the system's own if empty.
    source_unit, target_unit : str, optional
        "degrees" or "radians", or the system's own if empty; degrees for the target unless told.

    Raises
    ------
    traitlets.TraitError
        For a name that is unknown, or a value that stands for no attitude.
    """

    element = "converter"
    bundle = "converter"
    controls = ()

    kind = traitlets.Enum(KINDS, "angles").tag(sync=True)
    value = traitlets.List(traitlets.Float(), [10.0, 20.0, 30.0]).tag(sync=True)
    source = traitlets.Enum(tuple(SYSTEMS), "CHR").tag(sync=True)
    source_sequence = traitlets.Enum(("", *SEQUENCES), "").tag(sync=True)
    source_unit = traitlets.Enum(UNITS, "").tag(sync=True)
    target = traitlets.Enum(tuple(SYSTEMS), "ROS").tag(sync=True)
    target_sequence = traitlets.Enum(("", *SEQUENCES), "").tag(sync=True)
    target_unit = traitlets.Enum(UNITS, "degrees").tag(sync=True)

    @traitlets.validate("kind", "value")
    def _check(self, proposal: dict[str, Any]) -> Any:  # noqa: ANN401 - traitlets' signature
        """Refuse what stands for no attitude."""
        given = {"kind": self.kind, "value": self.value, proposal["trait"].name: proposal["value"]}
        try:
            self._converted(given["kind"], given["value"], given["kind"])
        except ValueError as error:
            msg = f"The '{proposal['trait'].name}' trait: {error}"
            raise traitlets.TraitError(msg) from None
        return proposal["value"]

    def state(self) -> dict[str, Any]:
        """Return what is given and in which conventions."""
        names = ("source", "source_sequence", "source_unit")
        others = ("target", "target_sequence", "target_unit")
        return {name: getattr(self, name) for name in ("kind", "value", *names, *others)}

    def readouts(self) -> dict[str, list[float]]:
        """Return what the target says, by kind; a matrix row by row."""
        return {kind: self._converted(self.kind, self.value, kind) for kind in KINDS}

    def fallback(self) -> str:
        """Return what is given, and what the target makes of it, in two sentences."""
        found = {kind: _row(values) for kind, values in self.readouts().items()}
        unit = "degrees" if convention(self.target, unit=self.target_unit).degrees else "radians"
        return (
            f"Given the {self.kind} {_row(self.value)} of {self.source}. For {self.target} it is "
            f"the angles {found['angles']} in {unit}, the quaternion {found['quaternion']}, and "
            f"the matrix {found['matrix']}, row by row."
        )

    def still_name(self) -> str:
        """Return the name of the file with the still picture of this state."""
        parts = (self.element, *self.value, *list(self.state().values())[2:])
        return "_".join(f"{part:g}" if isinstance(part, float) else part for part in parts) + ".svg"

    def __repr__(self) -> str:
        """Return the call that makes this demo."""
        given = ", ".join(f"{name}={value!r}" for name, value in self.state().items())
        return f"ConverterDemo({given})"

    def _converted(self, kind: Any, value: Sequence[float], to: Any) -> list[float]:  # noqa: ANN401
        if len(value) != _SIZES[kind]:
            msg = f"expected {_SIZES[kind]} numbers of kind {kind!r}, got {len(value)}"
            raise ValueError(msg)
        shaped = np.reshape(value, (3, 3)) if kind == "matrix" else np.asarray(value)
        source = convention(self.source, self.source_sequence, self.source_unit)
        target = convention(self.target, self.target_sequence, self.target_unit)
        made = convert(shaped, source, target, kind=kind, to=to)
        return [float(each) for each in made.ravel()]


def convention(name: str, sequence: str = "", unit: str = "") -> Convention:
    """Find a system's convention, with another sequence or unit where they are given."""
    own = SYSTEMS[name]
    if sequence not in ("", own.sequence):
        own = replace(own, sequence=sequence, written="", negated="")
    return replace(own, degrees=unit == "degrees") if unit else own


def _row(values: Sequence[float]) -> str:
    return ", ".join(entry(each) for each in values)
