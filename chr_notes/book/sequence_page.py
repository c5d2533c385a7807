"""Parts of pages on conventions: the twelve sequences, and one attitude in each preset."""

from collections.abc import Iterator
from math import degrees, radians

import numpy as np
from sympy import ImmutableMatrix, Symbol

from chr_notes.demos.converter import LABELS
from chr_notes.derivations import sequences
from chr_notes.euler import matrix_from_euler
from chr_notes.quaternions.conversions import quaternion_from_euler
from chr_notes.symbols import theta
from chr_notes.systems.convention import DOCUMENTED, PRESETS, Convention
from chr_notes.systems.converting import convert
from chr_notes.typeset import formula, latex

__all__ = ["generated"]

ROLL, PITCH, YAW = 10.0, 20.0, 30.0
"""The worked attitude, degrees."""
_R, _D = Symbol("R"), Symbol("D")
_NUMBERS = {"X": 1, "Y": 2, "Z": 3}


def generated() -> dict[str, str]:
    """Return the text of each part by its file name."""
    return {
        "sequences.md": "\n".join(line for name in sequences.ROTATING for line in _card(name)),
        "presets.md": "\n".join(_table(PRESETS)),
        "documented.md": "\n".join(_table(DOCUMENTED)),
    }


def _card(name: str) -> Iterator[str]:
    """Yield all that is derived of a sequence."""
    numbers = "-".join(str(_NUMBERS[letter]) for letter in name)
    turns = ", then ".join(
        f"${latex(angle)}$ about {letter.lower()}"
        for letter, angle in zip(name, sequences.ANGLES, strict=True)
    )
    kind = "Euler's own kind" if sequences.is_proper(name) else "yaw, pitch and roll's kind"
    yield f"## {name}, or {numbers}\n"
    yield (
        f"{turns[0].upper() + turns[1:]}, each about an axis as turned so far; {kind}. About fixed "
        f"axes it is `{sequences.reversed_order(name)}`, with the angles in the reversed order.\n"
    )
    yield _display(formula(_R, sequences.matrix(name)).latex)
    yield _display(formula(_D, sequences.angle_rates_matrix(name)).latex)
    places = sequences.locks(name)
    at = " and ".join(
        f"{'±' if not sequences.is_proper(name) else ''}{degrees(float(place)):.0f}°"
        for place in places
    )
    yield (
        f"It locks where ${latex(theta)}$ is {at}: the volume of the three axes of the turns is "
        f"${latex(sequences.determinant(name))}$. The way back from the elements of a matrix:\n"
    )
    angles = ImmutableMatrix(sequences.ANGLES)
    yield _display(formula(angles, sequences.angles_from_matrix(name)).latex)


def _display(text: str) -> str:
    return f"$$\n{text}\n$$\n"


def _table(systems: dict[str, Convention]) -> Iterator[str]:
    """Yield one attitude as each system writes it; on a phone its cells stand below one another."""
    yield ":::{div} by-system"
    yield "| system | axes of room and body | angles | quaternion | first row of the matrix |"
    yield "|---|---|---|---|---|"
    attitude = [radians(each) for each in (ROLL, PITCH, YAW)]
    for name, system in systems.items():
        angles = convert(attitude, "this book", system, kind="angles")
        matrix = convert(matrix_from_euler(attitude), "this book", system, kind="matrix")
        q = convert(quaternion_from_euler(attitude), "this book", system, kind="quaternion")
        unit = "°" if system.degrees else " rad"
        turns = f"`{system.sequence}`"
        turns += f", written `{system.written}`" if system.written else ""
        against = " and ".join(f"`{letter}`" for letter in system.negated)
        turns += f", {against} the other way" if against else ""
        yield (
            f"| {LABELS.get(name, name)} | {system.navigation}, {system.body} | "
            f"{_row(angles, 2 if system.degrees else 4)}{unit} ({turns}) | {_row(q, 4)} | "
            f"{_row(matrix[0], 4)} |"
        )
    yield ":::"


def _row(values: np.ndarray, digits: int) -> str:
    return ", ".join(f"{value:.{digits}f}" for value in np.asarray(values).round(digits) + 0.0)
