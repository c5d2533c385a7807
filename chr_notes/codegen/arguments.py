"""Arguments of the generated functions: name, symbol in the derivation, meaning and unit."""

from chr_notes.codegen.target import Argument
from chr_notes.derivations.forms.euler import ANGLE as WRAPPED
from chr_notes.derivations.quaternions import MATRIX as ELEMENTS
from chr_notes.symbols import (
    AXIS,
    BODY_RATES,
    EULER,
    EULER_RATES,
    FIRST,
    QUATERNION,
    SECOND,
    VECTOR,
    T,
    alpha,
)

_ANGLES = (
    ("roll", "roll about the body x-axis, radians"),
    ("pitch", "pitch about the vehicle-1 y-axis, radians"),
    ("yaw", "yaw about the inertial z-axis, radians"),
)
ROLL, PITCH, YAW = ANGLES = tuple(
    Argument(name, symbol, says) for symbol, (name, says) in zip(EULER, _ANGLES, strict=True)
)
RATES = tuple(
    Argument(name, symbol, f"body rate about {axis}, rad/s")
    for symbol, name, axis in zip(BODY_RATES, "pqr", "xyz", strict=True)
)
ANGLE_RATES = tuple(
    Argument(f"{name}_rate", symbol, f"derivative of {name}, rad/s")
    for symbol, name in zip(EULER_RATES, ("roll", "pitch", "yaw"), strict=True)
)
MATRIX = tuple(
    Argument(
        f"r{row + 1}{column + 1}",
        ELEMENTS[row, column],
        f"row {row + 1}, column {column + 1} of the matrix from the inertial to the body frame",
    )
    for row in range(3)
    for column in range(3)
)
_ELEMENTS = ("scalar part", "factor of i", "factor of j", "factor of k")
QUATERNION_ARGUMENTS = tuple(
    Argument(name, symbol, f"{says} of the attitude quaternion")
    for symbol, name, says in zip(QUATERNION, "abcd", _ELEMENTS, strict=True)
)
PRODUCT = tuple(
    Argument(f"{name}{number}", symbol, f"{says} of the {which} factor")
    for number, which, symbols in ((1, "first", FIRST), (2, "second", SECOND))
    for symbol, name, says in zip(symbols, "abcd", _ELEMENTS, strict=True)
)
AXIS_ARGUMENTS = tuple(
    Argument(name, symbol, f"{name} of the axis, any length")
    for symbol, name in zip(AXIS, "xyz", strict=True)
)
TURN = Argument("angle", alpha, "angle of the turn about the axis, radians")
ANGLE = Argument("angle", WRAPPED, "angle, radians")
PERIOD = Argument("dt", T, "time, s")


def vector(says: str) -> tuple[Argument, ...]:
    """Components x, y, z of a vector.

    Parameters
    ----------
    says
        What it is and in which unit.
    """
    return tuple(
        Argument(name, symbol, f"{name} of {says}")
        for symbol, name in zip(VECTOR, "xyz", strict=True)
    )
