"""The page on notation: what each symbol stands for, and where it comes first."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from sympy import Basic, preorder_traversal

from chr_notes import symbols as ours
from chr_notes.derivations import estimation as observer
from chr_notes.ledger.case import Case
from chr_notes.ledger.cases import CASES
from chr_notes.printed import dead_reckoning, estimation, euler, sensors, validation
from chr_notes.printed import quaternions as quaternion
from chr_notes.typeset import latex

__all__ = ["NOTATION", "Notation", "notation"]


@dataclass(frozen=True)
class Notation:
    """One line of the table.

    Parameters
    ----------
    symbols
        The SymPy objects that the line is about.
    means
        What they stand for, Markdown.
    unit
        Their unit, empty for a pure number.
    within
        Frame or range, Markdown, empty where there is nothing to say.
    """

    symbols: tuple[Basic, ...]
    means: str
    unit: str = ""
    within: str = ""


_TURN = r"$-\pi$ to $\pi$"

NOTATION: Final[dict[str, tuple[Notation, ...]]] = {
    "euler": (
        Notation((ours.phi,), "roll", "rad", f"about x of vehicle-2, {_TURN}"),
        Notation((ours.theta,), "pitch", "rad", r"about y of vehicle-1, $-\pi/2$ to $\pi/2$"),
        Notation((ours.psi,), "yaw", "rad", f"about z of the inertial frame, {_TURN}"),
        Notation(ours.EULER_RATES, "rates of roll, pitch and yaw", "rad/s"),
        Notation(ours.BODY_RATES, "body rates, which gyros read", "rad/s", "about body x, y, z"),
        Notation(
            (euler.R_YAW, euler.R_PITCH, euler.R_ROLL),
            "matrices of yaw, pitch and roll, each to the next frame",
        ),
        Notation((euler.R_IB,), "matrix from the inertial frame to the body"),
        Notation((euler.R_BI,), "its transpose, from the body to the inertial frame"),
        Notation((euler.D,), "matrix that makes Euler rates of body rates"),
        Notation((euler.V_I, euler.V_B), "one vector", "", "in the inertial, in the body frame"),
    ),
    "quaternions": (
        Notation((quaternion.Q,), "attitude quaternion of the note, of length one"),
        Notation(ours.QUATERNION, "its elements, scalar first"),
        Notation(ours.FIRST, "elements of the first quaternion in a product"),
        Notation(ours.SECOND, "elements of the second one"),
        Notation(ours.AXIS, "unit vector along the axis of a turn", "", "inertial frame"),
        Notation((ours.alpha,), "angle of a turn; in validation, inclination of the field", "rad"),
        Notation(ours.VECTOR, "components of a vector that is turned"),
    ),
    "sensors": (
        Notation((ours.g,), "magnitude of gravity", "m/s²"),
        Notation((ours.m,), "mass of the body", "kg"),
        Notation((estimation.F, estimation.F_G), "all forces on the body, and its weight", "N"),
        Notation((estimation.A_M,), "reading of an accelerometer", "m/s²", "body frame"),
        Notation(ours.ACCELEROMETER, "its components in the derivations", "m/s²", "body x, y, z"),
        Notation(
            (estimation.A_MX, estimation.A_MY, estimation.A_MZ),
            "its components as the note writes them",
            "m/s²",
            "body x, y, z",
        ),
        Notation((sensors.A_MC,), "the reading with the sensor's faults taken out", "m/s²"),
        Notation((sensors.P, sensors.P_M), "body rates, true and as a gyro reads them", "rad/s"),
        Notation(
            (sensors.M_A, sensors.M_G, sensors.M_B),
            "misalignment of accelerometer, gyro, magnetometer",
        ),
        Notation(
            (sensors.S_A, sensors.S_G, sensors.S_B),
            "their sensitivities, which depend on the temperature",
            "",
            "diagonal",
        ),
        Notation(
            (sensors.BETA_A, sensors.BETA_G, sensors.BETA_B),
            "their biases, which depend on the temperature",
            "of the sensor",
        ),
        Notation((sensors.C_GA,), "what a gyro reads of an acceleration", "rad s/m"),
        Notation((sensors.B, sensors.B_M), "magnetic field, and the reading of it", "any"),
        Notation((sensors.B_C,), "the field without the iron nearby", "any", "body frame"),
        Notation(ours.MAGNETOMETER, "its components in the derivations", "any", "body x, y, z"),
        Notation((sensors.D_S, sensors.BETA_H), "soft and hard iron"),
        Notation((sensors.FIELD,), "field of the Earth", "any", "inertial frame"),
    ),
    "estimation": (
        Notation((ours.T,), "time between two samples", "s"),
        Notation((estimation.ROLL, estimation.PITCH), "estimates of roll and pitch", "rad"),
        Notation(
            (estimation.ROLL_PLUS, estimation.PITCH_PLUS), "the same, as the gyro predicts", "rad"
        ),
        Notation(
            (estimation.ROLL_ACCEL, estimation.PITCH_ACCEL), "as the accelerometer has it", "rad"
        ),
        Notation((estimation.n,), "number of samples taken", "", "1, 2, 3, …"),
        Notation((estimation.L,), "gain: how far to move towards the accelerometer", "", "0 to 1"),
        Notation((observer.bias,), "bias of a gyro", "rad/s"),
        Notation(
            (observer.gyro_noise, observer.accel_noise),
            "standard deviation of one gyro reading, of one tilt",
            "rad/s, rad",
        ),
    ),
    "dead_reckoning": (
        Notation(
            (dead_reckoning.A_B, dead_reckoning.A_I),
            "acceleration of the body",
            "m/s²",
            "in the body, in the inertial frame",
        ),
        Notation((dead_reckoning.V_I,), "its velocity", "m/s", "inertial frame"),
        Notation((dead_reckoning.R_I,), "its position", "m", "inertial frame"),
        Notation((dead_reckoning.IN_GRAVITIES,), "reading in gravities", "g", "body frame"),
    ),
    "validation": (
        Notation((validation.R_IB,), "the paper's matrix; its label says inertial to body"),
        Notation(validation.GRAVITY, "gravity", "m/s²", "body x, y, z"),
        Notation(validation.FIELD_B, "magnetic field of length one", "", "body x, y, z"),
        Notation(validation.FIELD_I, "the same field", "", "north, east, down"),
        Notation((validation.ALPHA,), "gain of the paper's filter, its $L$", "", "0 to 1"),
        Notation((validation.DT,), "the paper's time between two samples", "s"),
        Notation(
            (validation.ROLL_ACCEL, validation.PITCH_ACCEL),
            "roll and pitch by the accelerometer",
            "rad",
        ),
        Notation((validation.ROLL_COMP, validation.PITCH_COMP), "by the paper's filter", "rad"),
        Notation((validation.A,), "minus the square of the horizontal field", "", "0 or less"),
        Notation(
            (validation.E,), "factor by which the paper judges roll and pitch", "", "0 or more"
        ),
    ),
}
"""The symbols by the topic that brings them, in the order of the chapters."""

TITLES: Final = {
    "euler": "Attitude",
    "quaternions": "Quaternions",
    "sensors": "Forces and sensors",
    "estimation": "Estimation",
    "dead_reckoning": "Dead reckoning",
    "validation": "Validation",
}


def notation() -> str:
    """Return the tables of the page."""
    return "\n".join(_tables())


def _tables() -> Iterator[str]:
    for topic, lines in NOTATION.items():
        yield f"## {TITLES[topic]}\n"
        yield ":::{div} notation\n| symbol | stands for | unit | frame or range | first in |"
        yield "|---|---|---|---|---|"
        for line in lines:
            written = ", ".join(f"${latex(symbol)}$" for symbol in line.symbols)
            first = first_entry(line, topic)
            link = f"[{first}](#{first})" if first else ""
            yield f"| {written} | {line.means} | {line.unit} | {line.within} | {link} |"
        yield ":::\n"


def first_entry(line: Notation, topic: str) -> str | None:
    """Find the first entry of the ledger, from a topic on, that has one of the symbols on its card.

    What is printed goes before what the derivations bring.
    """
    later = list(NOTATION)[list(NOTATION).index(topic) :]
    for on_card in (_printed, _brought):
        for name, case in CASES.items():
            if case.printed.document in later and any(
                not set(line.symbols).isdisjoint(preorder_traversal(statement))
                for statement in on_card(case)
            ):
                return name
    return None


def _printed(case: Case) -> tuple[Basic, ...]:
    return (case.printed.statement,)


def _brought(case: Case) -> tuple[Basic, ...]:
    found = [*case.witness, *(step.statement for step in case.steps)]
    if case.right is not None:
        found.append(case.right)
    if case.condition is not None:
        found.append(case.condition.holds)
    return tuple(found)
