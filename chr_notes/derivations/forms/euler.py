"""Forms of the Euler-angle formulas."""

from functools import cache

from sympy import (
    Abs,
    Expr,
    ImmutableMatrix,
    Not,
    Symbol,
    atan2,
    collect,
    cos,
    expand,
    pi,
    tan,
)
from sympy.codegen.cfunctions import hypot

from chr_notes.derivations import euler, quaternions
from chr_notes.derivations.computation import (
    LOCK_MARGIN,
    Choice,
    Computation,
    Let,
    Remainder,
    otherwise,
)
from chr_notes.symbols import theta

ROLL, PITCH, YAW, LOCKED = (Symbol(name, real=True) for name in ("roll", "pitch", "yaw", "locked"))
ANGLE = Symbol("angle", real=True)


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
    roll = atan2(
        east * matrix[2, 0] - north * matrix[2, 1], north * matrix[1, 1] - east * matrix[1, 0]
    )
    angles = ImmutableMatrix([roll, atan2(pitch.args[0], hypot(north, east)), yaw])
    return with_lock((), angles, quaternions.yaw_without_roll(matrix))


@cache
def wrap_angle() -> Computation:
    """Angle less whole turns, in [-pi, pi); one that is there already stays as it is."""
    rest = Symbol("rest", real=True)
    wrapped = Symbol("wrapped", real=True)
    return Computation(
        (
            Let(rest, Remainder(ANGLE, 2 * pi)),
            Choice(
                (wrapped,),
                (
                    (rest >= pi, (rest - 2 * pi,)),
                    (rest < -pi, (rest + 2 * pi,)),
                    otherwise(rest),
                ),
            ),
        ),
        wrapped,
    )
