"""The conventions of the project, stated once: for the code, the book and the reader."""

from dataclasses import dataclass

STANDARD_GRAVITY = 9.80665
"""Standard gravity, m/s² (exact by definition, CGPM 1901)."""

NOTES_GRAVITY = 9.8
"""With which the notes reckon, m/s²."""


@dataclass(frozen=True)
class Statement:
    """One convention, in words.

    Parameters
    ----------
    title
        What it is about.
    statement
        The convention itself, Markdown with LaTeX.
    """

    title: str
    statement: str


CONVENTIONS = (
    Statement(
        "Frames",
        "The navigation frame, which the notes call inertial, is **north-east-down**: x points "
        "north, y east, z down. The body frame is **forward-right-down**: x out of the nose, y "
        "out of the right side, z out of the bottom. Both are right-handed.",
    ),
    Statement(
        "Euler angles",
        r"The sequence is **3-2-1**: yaw $\psi$ about the inertial z-axis, then pitch $\theta$ "
        r"about the y-axis that yaw has turned (vehicle-1), then roll $\phi$ about the x-axis that "
        r"both have turned (vehicle-2). Arrays hold them in the order (roll, pitch, yaw) on the "
        r"last axis.",
    ),
    Statement(
        "Units",
        "Functions take and return radians, rad/s, m/s² and seconds, unless they say that any unit "
        "does. Degrees stand in prose, in what cells print, and in demos.",
    ),
    Statement(
        "Matrices",
        r"A rotation matrix is **passive**: $R_I^B$ takes the components of one and the same "
        r"vector from the inertial frame to the body frame, $\mathbf{v}_B = R_I^B\,\mathbf{v}_I$. "
        r"The other direction is its transpose.",
    ),
    Statement(
        "Quaternions",
        r"Quaternions are **Hamilton's**, scalar first: $(a, b, c, d)$ on the last axis, with "
        r"$i^2 = j^2 = k^2 = ijk = -1$. The attitude quaternion satisfies "
        r"$\mathbf{v}_I = q\,\mathbf{v}_B\,q^*$. What comes from a conversion is a unit quaternion "
        r"with $a \ge 0$; products, conjugates and inverses keep the sign and the length that they "
        r"have.",
    ),
    Statement(
        "Accelerometers",
        r"An accelerometer measures **specific force**: what acts on it besides gravity, per unit "
        r"of mass. Level and at rest it reads $(0, 0, -g)$.",
    ),
    Statement(
        "Gimbal lock",
        r"Exactly at a pitch of ±90° roll and yaw are not determined one by one. A function that "
        r"turns a matrix or a quaternion into Euler angles then sets **roll to 0** and lets yaw "
        r"carry the rest, so that the angles still rebuild the same attitude.",
    ),
    Statement(
        "Names",
        "A function that converts is called `target_from_source`: `matrix_from_euler` takes Euler "
        "angles and gives a matrix.",
    ),
)
