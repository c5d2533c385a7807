"""Formulas beyond those of the documents, of which generated code alone is made."""

from functools import cache

from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    Poly,
    Symbol,
    atan2,
    cos,
    expand,
    integrate,
    sin,
    solve,
    sqrt,
    symbols,
)

from chr_notes.derivations import hamilton, quaternions
from chr_notes.derivations.dead_reckoning import accel_noise, gyro_noise, t
from chr_notes.derivations.estimation import L
from chr_notes.derivations.euler import Z, rotation
from chr_notes.symbols import ACCELEROMETER, QUATERNION, VECTOR, g, phi, psi

# A vector in the frame that does not turn, which is to point up.
UPWARD = symbols("u_N u_E u_D", real=True)
# What an accelerometer would read at rest, along the body axes, in any unit.
EXPECTED = symbols("e_x e_y e_z", real=True)
_inner, _outer = symbols("tau s", positive=True)


def yaw_without_roll(matrix: ImmutableMatrix) -> Expr:
    """Yaw of a matrix from inertial to body frame whose roll is zero, at any pitch.

    At gimbal lock, where roll may be set to zero, yaw then carries the rest.
    """
    euler = rotation("I", "B").subs(phi, 0)
    return atan2(
        -matrix[quaternions.place(-sin(psi), euler)], matrix[quaternions.place(cos(psi), euler)]
    )


@cache
def yaw_at_lock() -> Expr:
    """Yaw of (a, b, c, d) at gimbal lock with roll set to zero, see `yaw_without_roll`."""
    return yaw_without_roll(quaternions.matrix_from_quaternion())


@cache
def products_from_matrix() -> ImmutableMatrix:
    """4 q qᵀ, four by four, from the elements r_11 ... r_33 of a matrix from inertial to body.

    The nine elements of the matrix and the squared norm, which is one, are linear in the ten
    products of two elements of q, so these follow from a linear system. Row n is q times four
    times its element n: any row that is not zero, normalised, is the quaternion up to sign, and
    the one with the largest element on the diagonal loses no digits.
    """
    unknown = {(m, n): Symbol(f"x_{m}{n}") for m in range(4) for n in range(m, 4)}
    pairs = [
        *zip(quaternions.matrix_from_quaternion(), quaternions.MATRIX, strict=True),
        (hamilton.norm_squared(quaternions.ATTITUDE), 1),
    ]
    equations = [_linear(left, unknown) - right for left, right in pairs]
    found = solve(equations, list(unknown.values()), dict=True)[0]
    return ImmutableMatrix(4, 4, lambda m, n: 4 * found[unknown[min(m, n), max(m, n)]])


def _linear(quadratic: Expr, unknown: dict[tuple[int, int], Symbol]) -> Expr:
    """Write a form of second degree in the elements of q as one of first degree in products."""
    total = Integer(0)
    for powers, coefficient in Poly(quadratic, *QUATERNION).terms():
        places = [place for place, power in enumerate(powers) for _ in range(power)]
        total += coefficient * unknown[places[0], places[1]]
    return total


@cache
def gravity_seen() -> ImmutableMatrix:
    """Direction of the reading at rest, along the body axes: up, by an attitude quaternion."""
    up = dict(zip(VECTOR, -Z, strict=True))
    return ImmutableMatrix(quaternions.rotate_to_body().xreplace(up))


@cache
def turn_towards() -> ImmutableMatrix:
    """Turn of the body after which `EXPECTED` lies nearer the accelerometer's reading.

    Seen from the body, what stands still turns the other way: so the body turns from the reading
    to what was expected, about the axis that is at right angles to both, by the share L of the
    angle between them. It is multiplied to the attitude from the right.
    """
    across = ImmutableMatrix(ACCELEROMETER).cross(ImmutableMatrix(EXPECTED))
    length = sqrt(across.dot(across))
    angle = atan2(length, ImmutableMatrix(ACCELEROMETER).dot(ImmutableMatrix(EXPECTED)))
    return ImmutableMatrix(quaternions.from_axis_angle(ImmutableMatrix(across / length), L * angle))


@cache
def level_turn() -> ImmutableMatrix:
    """Turn the vector `UPWARD` to point up, by the shortest way: a quaternion of some length.

    With the unit vectors u and up, `-up u` is a quaternion whose scalar part is the cosine of the
    angle between them and whose vector part is the sine times the axis: the turn by twice that
    angle. Half way between it and no turn is the turn that is wanted.
    """
    up = -Z
    upward = ImmutableMatrix(UPWARD)
    length = sqrt(upward.dot(upward))
    twice = -hamilton.multiply(ImmutableMatrix([0, *up]), ImmutableMatrix([0, *upward]))
    return ImmutableMatrix(twice + ImmutableMatrix([length, 0, 0, 0]))


@cache
def position_variances() -> ImmutableMatrix:
    """Find the variances of position after a time t from white noise.

    Each instant's noise is independent of all others, and what it adds to the position at t grows
    with the time that is left: linearly for the accelerometer, and for the gyro, which turns the
    vertical, with its square. The squares add up.

    Returns
    -------
    ImmutableMatrix
        From the accelerometer's noise and from the gyro's.
    """
    left = t - _inner
    weights = (accel_noise, left), (gyro_noise, g * integrate(_outer, (_outer, 0, left)))
    return ImmutableMatrix(
        [density**2 * integrate(expand(weight**2), (_inner, 0, t)) for density, weight in weights]
    )
