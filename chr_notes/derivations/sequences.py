"""Every sequence of three turns about the axes: matrix, rates, lock, and the way back.

A sequence is written as its three axes in the order of the turns: "ZYX" turns about axes of the
frame as it has turned so far (rotating axes), "zyx" about axes that stay where they are (fixed
axes). The angles are psi, theta and phi in the order of the turns; matrices are passive, as
everywhere here: they take components to the turned frame.
"""

from functools import cache
from itertools import product

from sympy import (
    Expr,
    ImmutableMatrix,
    Interval,
    Matrix,
    Set,
    acos,
    atan2,
    cos,
    eye,
    pi,
    simplify,
    sin,
    solveset,
    sqrt,
)

from chr_notes.derivations.euler import X, Y, Z, frame_rotation, rotation
from chr_notes.derivations.quaternions import MATRIX, from_axis_angle, turned
from chr_notes.symbols import phi, psi, theta

ANGLES = (psi, theta, phi)
ROTATING = tuple(
    "".join(axes) for axes in product("XYZ", repeat=3) if axes[0] != axes[1] != axes[2]
)
"""The twelve sequences about rotating axes; two turns about one axis in a row would be one."""
FIXED = tuple(name.lower() for name in ROTATING)
"""The twelve about fixed axes."""


def axes(sequence: str) -> tuple[int, int, int]:
    """Give the axes of a sequence as 0, 1 or 2 for x, y or z, in the order of its letters."""
    first, second, third = ("XYZ".index(letter) for letter in sequence.upper())
    return first, second, third


def reversed_order(sequence: str) -> str:
    """Name the sequence about the other kind of axes, in the reversed order.

    With its angles reversed too it is the same turn.
    """
    return sequence[::-1].swapcase()


def matrix(sequence: str) -> ImmutableMatrix:
    """Matrix of three turns, from the first frame to the last.

    About rotating axes each turn is a `frame_rotation` more. About fixed axes, each turn carries
    the frame's axes, the rows of the matrix, about an axis that stays.
    """
    whole = ImmutableMatrix(eye(3))
    for axis, angle in zip(axes(sequence), ANGLES, strict=True):
        if sequence.isupper():
            whole = ImmutableMatrix(frame_rotation(axis, angle) * whole)
        else:
            rows = [turned((X, Y, Z)[axis], angle, whole.row(row).T).T for row in range(3)]
            whole = ImmutableMatrix(Matrix.vstack(*rows))
    return whole


def quaternion(sequence: str) -> tuple[ImmutableMatrix, ...]:
    """Give the quaternions of the turns as they stand in the product, from left to right.

    A turn about an axis that has turned stands to the right of the turns before it, one about a
    fixed axis to the left.
    """
    turns = [
        from_axis_angle((X, Y, Z)[axis], angle)
        for axis, angle in zip(axes(sequence), ANGLES, strict=True)
    ]
    return tuple(turns if sequence.isupper() else turns[::-1])


def _before_the_last(sequence: str) -> ImmutableMatrix:
    """Axes of the three turns, as columns, in the frame that has only the last turn to come.

    The last turn leaves its own axis where it is and the second turn its own; so only the first
    one's axis has moved, by the second angle.
    """
    first, second, third = axes(sequence)
    moved = frame_rotation(second, theta) * (X, Y, Z)[first]
    return ImmutableMatrix(Matrix.hstack(moved, (X, Y, Z)[second], (X, Y, Z)[third]))


@cache
def body_rates_matrix(sequence: str) -> ImmutableMatrix:
    """Matrix from the rates of the three angles to the rates about the axes of the turned frame.

    Each angle's rate is a vector along the axis of its turn. For fixed axes it is that of the
    reversed order, with the columns reversed.
    """
    if sequence.islower():
        other = body_rates_matrix(reversed_order(sequence)).xreplace({psi: phi, phi: psi})
        return ImmutableMatrix(other[:, ::-1])
    last = frame_rotation(axes(sequence)[2], phi)
    return ImmutableMatrix(last * _before_the_last(sequence))


@cache
def angle_rates_matrix(sequence: str) -> ImmutableMatrix:
    """D: matrix from the rates about the axes of the turned frame to the rates of the angles.

    The last turn is undone by its transpose, and what remains depends on the second angle alone.
    """
    if sequence.islower():
        other = angle_rates_matrix(reversed_order(sequence)).xreplace({psi: phi, phi: psi})
        return ImmutableMatrix(other[::-1, :])
    inverse = _before_the_last(sequence).inv().applyfunc(simplify)
    return ImmutableMatrix(inverse * frame_rotation(axes(sequence)[2], phi).T)


def determinant(sequence: str) -> Expr:
    """Take the determinant of `body_rates_matrix`; where it is zero, the angles lock.

    It is the volume of the three turns' axes: zero where they lie in one plane, which happens when
    the second turn brings the first axis into the plane, or onto the line, of the other two.
    """
    if sequence.islower():
        return -determinant(reversed_order(sequence))  # the columns are reversed
    return simplify(_before_the_last(sequence).det())


def locks(sequence: str) -> Set:
    """Second angles from 0° to 180° at which three turns lock."""
    return solveset(determinant(sequence), theta, Interval(0, pi))


def is_proper(sequence: str) -> bool:
    """Say whether the last axis is the first again: Euler's own angles, which lock at 0°."""
    return sequence[0] == sequence[2]


def angles_from_matrix(sequence: str) -> ImmutableMatrix:
    """Read the three angles off a matrix to the turned frame, off the lock.

    One element holds the second angle alone. Four others are sine and cosine of the first and of
    the third angle, each times the same function of the second, which is positive in the second
    angle's range: the cosine from -90° to 90°, or, where the last axis is the first again, the
    sine from 0° to 180°. It drops out of atan2, and the root of two squares gives it.
    """
    whole = matrix(sequence if sequence.isupper() else reversed_order(sequence))

    def element(part: Expr) -> Expr:
        (found,) = [
            sign * given
            for given, derived in zip(MATRIX, whole, strict=True)
            for sign in (1, -1)
            if derived == sign * part
        ]
        return found

    proper = is_proper(sequence)
    common = sin(theta) if proper else cos(theta)
    first = [element(common * part(psi)) for part in (sin, cos)]
    third = [element(common * part(phi)) for part in (sin, cos)]
    root = sqrt(first[0] ** 2 + first[1] ** 2)
    second = atan2(root, element(cos(theta))) if proper else atan2(element(sin(theta)), root)
    angles = [atan2(*first), second, atan2(*third)]
    return ImmutableMatrix(angles if sequence.isupper() else angles[::-1])


def yaw_roll_yaw_upright() -> Expr:
    """Take the `determinant` of turns about z, x, z where the nose points straight up.

    The middle one of these three turns leads from the old z-axis to the new one, so its angle is
    the one between the two. The rates stand in the order roll, pitch, yaw here: last turn first.
    """
    upright = rotation("I", "B").subs(theta, pi / 2)
    return determinant("zxz").subs(theta, acos(upright[2, 2]))
