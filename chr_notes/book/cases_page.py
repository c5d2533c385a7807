"""Two contradictions of the documents, solved by asking which conventions explain the numbers."""

from collections.abc import Iterator, Mapping, Sequence
from math import acos, degrees
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from sympy import ImmutableMatrix, Symbol

from chr_notes.printed import PRINTED, quaternions, validation
from chr_notes.quaternions.algebra import quaternion_conjugate, quaternion_multiply
from chr_notes.quaternions.conversions import quaternion_from_euler
from chr_notes.symbols import a, b, c, d, g, phi, psi, theta
from chr_notes.systems.convention import Convention
from chr_notes.systems.detective import find_conventions

__all__ = ["generated"]

EULER: Final = (10.0, 20.0, 30.0)
"""Roll, pitch and yaw of the cases, degrees."""
NORTH: Final = np.array([1.0, 0.0, 0.0])
_SIGNS: Final = {1: "gravity itself", -1: "minus gravity, as an accelerometer reads"}


def generated() -> dict[str, str]:
    """Return the text of the part by its file name."""
    return {"cases.md": "\n".join((*quaternion_note(), *validation_paper()))}


def quaternion_note() -> Iterator[str]:
    """Yield what the quaternion note prints of one attitude, and the conventions it is in."""
    q = quaternion_from_euler(np.radians(EULER))
    known = dict(zip((a, b, c, d), q, strict=True))
    told = (_printed(f"quaternions.4.{number}").rhs for number in (1, 2, 3))
    angles = np.degrees([float(angle.subs(known).evalf()) for angle in told])
    matrix = _numbers(quaternions.MATRIX, known)
    half = quaternion_multiply(q, [0.0, *NORTH])
    turned = quaternion_multiply(half, quaternion_conjugate(q))[1:]
    found = _only(angles=angles.round(2), matrix=matrix.round(4), quaternion=q.round(4),
                  vectors=(NORTH, turned.round(4)))  # fmt: skip
    yield "### The quaternion note\n"
    yield (
        f"Take the quaternion from which [quaternions.4.1](#quaternions.4.1) to 4.3 find roll, "
        f"pitch and yaw of {_row(angles, 0)}°. Put it into the formulas of section 3, as printed, "
        "and give all numbers to `find_conventions`. The frame to which each leads, as its symbol "
        "names it and as it is found:\n"
    )
    yield from _table(
        ("the quaternion $q_i^b$", _row(q, 4), "to body", found.quaternion),
        ("[its matrix](#quaternions.3.3), first row", _row(matrix[0], 4), "to body", found.matrix),
        ("[a vector to the north](#quaternions.3.1)", _row(turned, 4), "to body", found.vectors),
    )
    yield (
        "With column vectors and Hamilton's product, as the note has them, one convention explains "
        "all, so the formulas agree; the names do not. Each leads from the body to the inertial "
        "frame, where its symbol, and [quaternions.3.4](#quaternions.3.4), "
        "say the opposite. Who trusts the symbol is off by twice the turn, here "
        f"{degrees(4 * acos(q[0])):.1f}°.\n"
    )


def validation_paper() -> Iterator[str]:
    """Yield what the validation paper prints of one attitude, and the conventions it is in."""
    known = dict(zip((phi, theta, psi), np.radians(EULER), strict=True)) | {g: 9.8}
    matrix = _numbers(validation.MATRIX, known)
    gravity = _numbers(_printed("validation.2").args[1].rhs, known).ravel()
    room = matrix @ gravity  # equation 5, with the matrix of equation 1
    found = _only(angles=EULER, matrix=matrix.round(4), vectors=(room.round(4), gravity.round(4)))
    back = _only(angles=EULER, matrix=matrix.round(4), vectors=(gravity.round(4), room.round(4)))
    yield "### The validation paper\n"
    yield f"Roll, pitch and yaw of {_row(EULER, 0)}° again, and what the paper makes of them:\n"
    yield from _table(
        ("[the matrix](#validation.1), first row", _row(matrix[0], 4), "to body", found.matrix),
        ("[gravity, equation 2](#validation.2)", _row(gravity, 4), "to body", found.vectors),
        ("[gravity back, equation 5](#validation.5)", _row(room, 1), "to body", back.vectors),
    )
    yield (
        "One symbol, $R_i^b$, stands for all three, and the second and third lines go opposite "
        "ways. The elements of equation 1 fit the third: they are the matrix to the inertial "
        "frame.\n"
    )
    pitch = _printed("validation.4").rhs
    yield "Then pitch from the accelerometer, [equation 4](#validation.4), from two readings:\n"
    yield "| reading | equation 4 gives | the detective takes it for |\n|---|--:|---|"
    for reading in (gravity, -gravity):
        told = degrees(float(pitch.subs(dict(zip(validation.GRAVITY, reading, strict=True)))))
        sign = _only(angles=EULER, accel=reading.round(4)).accelerometer
        yield f"| {_row(reading, 4)} | {told:.1f}° | {_SIGNS[sign]} |"
    yield (
        "\nThe formula wants minus gravity, and its symbol is that of equation 2, which is "
        "gravity: with that, pitch has the wrong sign.\n"
    )


def _printed(name: str) -> Any:  # noqa: ANN401 (SymPy's sides of an equation are untyped)
    """Take a statement as printed, by its id."""
    (found,) = (each for each in PRINTED[name.split(".", maxsplit=1)[0]] if each.id == name)
    return found.statement


def _numbers(formula: ImmutableMatrix, known: Mapping[Symbol, float]) -> NDArray[np.float64]:
    return np.array(formula.subs(known).evalf().tolist(), dtype=np.float64)


def _only(**given: Any) -> Convention:  # noqa: ANN401 (as find_conventions takes them)
    """Ask the detective, whose answer must be the only one."""
    (match,) = find_conventions(degrees=True, **given)
    return match.convention


def _table(*rows: tuple[str, str, str, str]) -> Iterator[str]:
    yield "| what | numbers | named | found |\n|---|---|---|---|"
    words = {"to body": "body", "to navigation": "inertial"}  # short, for a phone
    for what, numbers, named, found in rows:
        yield f"| {what} | {numbers} | {words[named]} | {words[found]} |"
    yield ""


def _row(values: Sequence[float] | NDArray[np.float64], digits: int) -> str:
    return ", ".join(f"{value:.{digits}f}" for value in np.round(values, digits) + 0.0)
