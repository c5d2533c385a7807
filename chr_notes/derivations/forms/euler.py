"""Forms of the Euler-angle formulas."""

from dataclasses import replace
from functools import cache

from sympy import (
    Abs,
    And,
    Expr,
    Float,
    ImmutableMatrix,
    Not,
    Symbol,
    atan2,
    collect,
    cos,
    expand,
    eye,
    pi,
    sin,
    sqrt,
    symbols,
    tan,
)
from sympy.codegen.cfunctions import hypot

from chr_notes.derivations import euler, further, quaternions
from chr_notes.derivations.computation import (
    LOCK_MARGIN,
    Choice,
    Computation,
    Let,
    otherwise,
)
from chr_notes.symbols import theta

ROLL, PITCH, YAW, LOCKED = (Symbol(name, real=True) for name in ("roll", "pitch", "yaw", "locked"))
ANGLE = Symbol("angle", real=True)
ROTATION = Symbol("rotation", real=True)
ROTATION_TOLERANCE = Float("1e-4")
"""How far `R Rᵀ` may be off the identity, as the root mean square over its elements.

Matrices that are printed with four digits still pass.
"""


@cache
def euler_rates() -> Computation:
    """Euler rates: the rate that roll and yaw have in common is worked out once."""
    roll_rate, pitch_rate, yaw_rate = euler.euler_rates()
    across = Symbol("rate_across", real=True)
    value = expand(yaw_rate * cos(theta))
    return Computation(
        (Let(across, value),),
        ImmutableMatrix(
            [
                collect(roll_rate, tan(theta)).subs(value, across),
                pitch_rate,
                across / cos(theta),
            ]
        ),
    )


def with_lock(steps: tuple[Let, ...], angles: ImmutableMatrix, yaw_at_lock: Expr) -> Computation:
    """Choose between the Euler angles and what stands for them at gimbal lock.

    Parameters
    ----------
    steps
        What the angles are computed from.
    angles
        Roll, pitch and yaw off the lock.
    yaw_at_lock
        Yaw when roll is set to zero.
    """
    roll, pitch, yaw = angles
    return Computation(
        (
            *steps,
            Let(PITCH, pitch),
            Let(LOCKED, Abs(PITCH) > pi / 2 - LOCK_MARGIN),
            Choice((ROLL, YAW), ((Not(LOCKED), (roll, yaw)), otherwise(roll * 0, yaw_at_lock))),
        ),
        ImmutableMatrix([ROLL, PITCH, YAW]),
        flag=LOCKED,
    )


def _defect() -> tuple[tuple[Let, ...], Expr, Expr]:
    """Elements of `R Rᵀ - 1`, their mean square, and the determinant of R."""
    matrix = quaternions.MATRIX
    off = matrix * matrix.T - eye(3)
    # The matrix is symmetric: each element off its diagonal counts twice.
    places = [(row, column) for row in range(3) for column in range(row + 1)]
    lets = [Let(Symbol(f"off_{i + 1}{j + 1}", real=True), off[i, j]) for i, j in places]
    squares = [(1 + (i != j)) * let.name**2 for (i, j), let in zip(places, lets, strict=True)]
    # By columns, because Euler angles are made of parts of the same products.
    first, second, third = (matrix.col(column) for column in range(3))
    return tuple(lets), sum(squares) / 9, third.dot(first.cross(second))


@cache
def rotation_defect() -> Computation:
    """By how much a matrix is not a rotation: root mean square of `R Rᵀ - 1`, and determinant."""
    lets, square, determinant = _defect()
    return Computation(lets, ImmutableMatrix([sqrt(square), determinant]))


def of_a_rotation(computation: Computation) -> Computation:
    """Add to a computation from a matrix whether that is a rotation."""
    square, determinant = symbols("squared_defect determinant", real=True)
    lets, *values = _defect()
    close = And(square <= ROTATION_TOLERANCE**2, determinant >= 0)
    told = (*map(Let, (square, determinant), values), Let(ROTATION, close))
    steps = (*computation.steps, *lets, *told)
    return replace(computation, steps=steps, guard=determinant, valid=ROTATION)


@cache
def euler_from_matrix() -> Computation:
    """Euler angles of a matrix `R_I^B`, at gimbal lock too.

    Near the lock the elements that hold the sine and cosine of roll and of yaw times the cosine of
    pitch are small, so rounding turns them: roll and yaw, each read off its own two, would not
    belong to one attitude. So only yaw is read off the first row. Roll is the angle from the
    vehicle-2 frame of that yaw to the body: the first row by the third and by the second, as in a
    vector product, are sine and cosine of roll times the cosine of pitch, to full precision.
    """
    matrix = quaternions.MATRIX
    _, pitch, yaw = quaternions.euler_from_matrix(matrix)
    east, north = yaw.args
    parts = symbols("roll_sine roll_cosine", real=True)
    lets = (
        Let(parts[0], east * matrix[2, 0] - north * matrix[2, 1]),
        Let(parts[1], north * matrix[1, 1] - east * matrix[1, 0]),
    )
    angles = ImmutableMatrix([atan2(*parts), atan2(pitch.args[0], hypot(north, east)), yaw])
    return of_a_rotation(with_lock(lets, angles, further.yaw_without_roll(matrix)))


@cache
def wrap_angle() -> Computation:
    """Angle less whole turns, in [-pi, pi); one that is there already stays as it is.

    The angle whose sine and cosine are these is right at every size, where taking multiples of a
    rounded 2 pi away is not.
    """
    there, wrapped = symbols("turned_back wrapped", real=True)
    within = And(ANGLE >= -pi, ANGLE < pi)  # noqa: SIM300 (an angle, no constant)
    return Computation(
        (
            Let(there, atan2(sin(ANGLE), cos(ANGLE))),
            # Rounded, pi is less than it is.
            Choice((wrapped,), ((within, (ANGLE,)), (there >= pi, (-pi,)), otherwise(there))),
        ),
        wrapped,
    )
