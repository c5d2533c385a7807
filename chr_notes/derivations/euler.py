"""Euler angles 3-2-1: frame rotations, their composition, and the rates.

Everything starts from one definition: to turn a frame about one of its own axes. Conventions
are those of `chr_notes.conventions`: passive matrices, `v_new = R v_old`, north-east-down.
"""

from functools import cache

from sympy import (
    Abs,
    Expr,
    ImmutableMatrix,
    Interval,
    Matrix,
    Set,
    cos,
    expand,
    eye,
    pi,
    simplify,
    sin,
    solveset,
    sqrt,
    trigsimp,
)
from sympy.simplify.fu import TR8

from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, phi, psi, theta

# The frames in the order in which the turns reach them, and each turn: (axis, angle).
FRAMES = ("I", "v1", "v2", "B")
TURNS = {"v1": (2, psi), "v2": (1, theta), "B": (0, phi)}
X, Y, Z = (ImmutableMatrix(eye(3).col(axis)) for axis in range(3))


def turned_axes(axis: int, angle: Expr) -> tuple[ImmutableMatrix, ImmutableMatrix, ImmutableMatrix]:
    """Turn a frame by the right-hand rule about one of its own axes; its axes in the old frame.

    The axis stays, the axis after it turns towards the one after that.

    Parameters
    ----------
    axis
        0, 1 or 2 for x, y or z.
    angle
        Angle of the turn, radians.
    """
    after, last = (axis + 1) % 3, (axis + 2) % 3
    old = (X, Y, Z)
    turned = list(old)
    turned[after] = ImmutableMatrix(cos(angle) * old[after] + sin(angle) * old[last])
    turned[last] = ImmutableMatrix(-sin(angle) * old[after] + cos(angle) * old[last])
    return turned[0], turned[1], turned[2]


def frame_rotation(axis: int, angle: Expr) -> ImmutableMatrix:
    """Matrix of a frame turned as in `turned_axes`.

    Component i in the new frame is the projection on its basis vector i, which makes row i of the
    matrix.

    Parameters
    ----------
    axis
        0, 1 or 2 for x, y or z.
    angle
        Angle of the turn, radians.

    Returns
    -------
    ImmutableMatrix
        3 by 3, `v_new = R v_old`.
    """
    old, turned = (X, Y, Z), turned_axes(axis, angle)
    return ImmutableMatrix(3, 3, lambda row, column: turned[row].dot(old[column]))


def yaw_last() -> ImmutableMatrix:
    """Matrix from inertial to body frame when the same three turns come as roll, pitch, yaw."""
    matrices = [frame_rotation(axis, angle) for axis, angle in TURNS.values()]
    return ImmutableMatrix(matrices[0] * matrices[1] * matrices[2])


@cache
def rotation(source: str, target: str) -> ImmutableMatrix:
    """Compose the frame rotations that lead from one frame to another.

    Parameters
    ----------
    source, target
        Two of `FRAMES`; the way back turns each frame by the negative angle, last turn first.

    Returns
    -------
    ImmutableMatrix
        3 by 3 in phi, theta, psi, `v_target = R v_source`.
    """
    start, end = FRAMES.index(source), FRAMES.index(target)
    product = eye(3)
    for frame in FRAMES[start + 1 : end + 1]:
        axis, angle = TURNS[frame]
        product = frame_rotation(axis, angle) * product
    for frame in FRAMES[start:end:-1]:
        axis, angle = TURNS[frame]
        product = frame_rotation(axis, -angle) * product
    return ImmutableMatrix(product)


@cache
def body_rates_matrix() -> ImmutableMatrix:
    """Matrix from Euler rates to body rates: three angular velocities brought to the body.

    Each Euler angle turns about an axis that the frame before and the frame after share, so its
    rate is a vector along that axis; the matrix has these three vectors, in the body frame, as
    columns.
    """
    columns = [
        rotation("v2", "B") * X,  # roll turns about the x-axis of vehicle-2
        rotation("v1", "B") * Y,  # pitch about the y-axis of vehicle-1
        rotation("I", "B") * Z,  # yaw about the inertial z-axis
    ]
    return ImmutableMatrix(Matrix.hstack(*columns).applyfunc(trigsimp))


@cache
def euler_rates_matrix() -> ImmutableMatrix:
    """D, from body rates to Euler rates: the inverse of `body_rates_matrix`."""
    matrix = body_rates_matrix()
    return ImmutableMatrix((matrix.adjugate() / trigsimp(matrix.det())).applyfunc(trigsimp))


def body_rates() -> ImmutableMatrix:
    """Body rates p, q, r in terms of the Euler rates."""
    return ImmutableMatrix(body_rates_matrix() * Matrix(EULER_RATES))


def euler_rates() -> ImmutableMatrix:
    """Euler rates in terms of the body rates p, q, r."""
    return ImmutableMatrix(euler_rates_matrix() * Matrix(BODY_RATES))


@cache
def euler_rates_determinant() -> Expr:
    """Take the determinant of D: the factor by which D enlarges a volume of body rates."""
    return simplify(euler_rates_matrix().det())


@cache
def euler_rates_condition() -> Expr:
    """Condition number of D in the 2-norm: its largest singular value over its smallest.

    The singular values of D are the inverses of those of the matrix that it inverts, whose
    squares are 1 and 1 ± sin(theta): the sign of sin(theta) says which of the two is larger.
    """
    gram = (body_rates_matrix().T * body_rates_matrix()).applyfunc(simplify)
    low, high = sorted(
        (v for v in gram.eigenvals() if v.has(theta)), key=lambda v: v.subs(theta, 1)
    )
    # sqrt(high / low), written so that nothing cancels near the pole
    return high.subs(sin(theta), Abs(sin(theta))) / sqrt(simplify(high * low))


def any_axes() -> ImmutableMatrix:
    """Axes of any right-handed frame at all, as rows.

    The x-axis has some heading psi and some climb theta. The y-axis is at right angles to it: it
    has turned by some phi about it from where it would be level. The z-axis then has no choice.
    """
    forward = ImmutableMatrix([cos(theta) * cos(psi), cos(theta) * sin(psi), -sin(theta)])
    level = ImmutableMatrix([-sin(psi), cos(psi), 0])
    right = cos(phi) * level + sin(phi) * forward.cross(level)
    return ImmutableMatrix([row.T for row in (forward, right, forward.cross(right))])


def lock_pitches(domain: Set | None = None) -> Set:
    """Pitch angles, from -90° to 90°, at which other angles give the same attitude.

    There the angles can change while the matrix does not: its derivatives by the three angles are
    linearly dependent, and the determinant of their products vanishes.
    """
    domain = Interval(-pi / 2, pi / 2) if domain is None else domain
    derivatives = ImmutableMatrix(rotation("I", "B").reshape(9, 1).jacobian(EULER))
    # Products of sines and cosines are sums of those of other angles, of which most cancel.
    products = ImmutableMatrix(derivatives.T * derivatives).applyfunc(lambda e: TR8(expand(e)))
    return solveset(simplify(products.det()), theta, domain)
