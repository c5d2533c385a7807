"""Forms of the quaternion formulas."""

from dataclasses import replace
from functools import cache

from sympy import (
    Abs,
    Add,
    And,
    Expr,
    ImmutableMatrix,
    Symbol,
    atan2,
    expand,
    sin,
    sinc,
    sqrt,
    symbols,
)

from chr_notes.derivations import further, hamilton, quaternions
from chr_notes.derivations.computation import Choice, Computation, Let, otherwise
from chr_notes.derivations.forms.euler import of_a_rotation, with_lock
from chr_notes.symbols import AXIS, QUATERNION, VECTOR, a, alpha, b, c, d

NORM_SQUARED = Symbol("norm_squared", real=True)
SIGN = Symbol("sign", real=True)
Q = ImmutableMatrix(QUATERNION)


def _norm() -> Let:
    return Let(NORM_SQUARED, hamilton.norm_squared(Q))


def positive(first: Expr) -> Choice:
    """Sign that makes the first element of a quaternion positive: q and -q are one attitude."""
    return Choice((SIGN,), ((first >= 0, (first**0,)), otherwise(-(first**0))))


@cache
def euler_from_quaternion() -> Computation:
    """Euler angles of a quaternion of any norm but zero, at gimbal lock too."""
    names = symbols("a_minus_c b_plus_d a_plus_c d_minus_b", real=True)
    values = (a - c, b + d, a + c, d - b)
    angles = quaternions.euler_from_quaternion().xreplace(dict(zip(values, names, strict=True)))
    one, two, three, four = names
    below, above, squares = symbols("below above sum_of_squares", real=True)
    sums = {one**2 + two**2: below, three**2 + four**2: above}
    products = {
        product: Symbol(f"product_{number}", real=True)
        for number, product in enumerate((two * three, one * four, one * three, two * four), 1)
    }
    named = {**dict(zip(values, names, strict=True)), **sums, **products}
    steps = [Let(name, value) for value, name in named.items()]
    # Half the sine of pitch times the squared norm; SymPy would share out the factor two.
    half_sine = Symbol("half_sine", real=True)
    sine, cosine = angles[1].args
    steps.append(Let(half_sine, sine / 2))
    roll, _, yaw = angles.subs(products)
    pitch = atan2(2 * half_sine, cosine.subs(sums))
    return replace(
        with_lock(
            (*steps, Let(squares, below + above)),
            ImmutableMatrix([roll, pitch, yaw]),
            further.yaw_at_lock(),
        ),
        guard=squares,
    )


@cache
def matrix_from_quaternion() -> Computation:
    """Matrix `R_I^B` of a quaternion of any norm but zero.

    On the diagonal one sum of two squares is taken from another, and both together are the squared
    norm: nothing is lost to 1, from which each could be taken too.
    """
    matrix = quaternions.matrix_from_quaternion()
    sums: list[Let] = []
    for axis, element in zip("xyz", matrix.diagonal(), strict=True):
        terms = element.as_ordered_terms()
        for name, sign in (("along", 1), ("across", -1)):
            squares = [term for term in terms if term.as_coeff_Mul()[0] == sign]
            sums.append(Let(Symbol(f"{name}_{axis}", real=True), sign * Add(*squares)))
    pairs = list(zip(sums[::2], sums[1::2], strict=True))
    scale, twice = symbols("scale twice_scale", real=True)
    return Computation(
        (
            *sums,
            Let(NORM_SQUARED, pairs[0][0].name + pairs[0][1].name),
            Let(scale, 1 / NORM_SQUARED),
            Let(twice, 2 * scale),
        ),
        ImmutableMatrix(
            3,
            3,
            lambda i, j: (
                scale * (pairs[i][0].name - pairs[i][1].name)
                if i == j
                else twice * expand(matrix[i, j] / 2)
            ),
        ),
        guard=NORM_SQUARED,
    )


@cache
def quaternion_from_euler() -> Computation:
    """Turn Euler angles into a unit quaternion with a >= 0."""
    names = symbols("a b c d", real=True)
    elements = quaternions.from_euler()
    steps = tuple(Let(name, element) for name, element in zip(names, elements, strict=True))
    return Computation((*steps, positive(names[0])), ImmutableMatrix(names) * SIGN)


@cache
def quaternion_from_matrix() -> Computation:
    """Turn a matrix `R_I^B` into a unit quaternion with a >= 0.

    Each row of 4 q qᵀ is the quaternion times four times one of its elements. The conditions pick
    a row whose element on the diagonal is at least one: it and another one add up to at least two.
    """
    products = further.products_from_matrix()
    r_11, r_22, r_33 = quaternions.MATRIX.diagonal()
    names = symbols("a b c d", real=True)
    conditions = {1: And(r_33 < 0, r_11 > r_22), 2: r_33 < 0, 3: r_11 < -r_22}
    branches = [(conditions[row], tuple(products.row(row))) for row in conditions]
    square = sum(name**2 for name in names)
    return of_a_rotation(
        Computation(
            (
                Choice(names, (*branches, otherwise(*products.row(0)))),
                Let(NORM_SQUARED, square),
                positive(names[0]),
            ),
            ImmutableMatrix(names) * (SIGN / sqrt(NORM_SQUARED)),
        )
    )


@cache
def quaternion_from_axis_angle() -> Computation:
    """Turn axis, of any length but zero, and angle into a unit quaternion with a >= 0."""
    length_squared = Symbol("length_squared", real=True)
    axis = ImmutableMatrix(AXIS)
    quaternion = quaternions.from_axis_angle(axis / sqrt(length_squared), alpha)
    return Computation(
        (
            Let(length_squared, axis.dot(axis)),
            positive(quaternion[0]),
        ),
        SIGN * quaternion,
        guard=length_squared,
    )


@cache
def axis_angle_from_quaternion() -> Computation:
    """Find unit axis and angle in [0, pi] of a quaternion of any norm but zero.

    Where there is no turn, any axis does, and x is returned. Of the smallest turns too the axis is
    right: no square vanishes once the vector part counts in units of its size.
    """
    axis, _ = quaternions.axis_angle_from_quaternion()
    size, extent, length = symbols("size extent length", real=True)
    vector = hamilton.vector_part(Q)
    parts = symbols("part_b part_c part_d", real=True)
    in_parts = dict(zip(vector, parts, strict=True))
    names = symbols("x y z", real=True)
    values = axis.subs(sqrt(vector.dot(vector)), extent).xreplace(in_parts) * SIGN
    one = size**0
    # NaN is not zero, and comes out as NaN.
    none = size <= 0
    scaled = tuple(element / size for element in vector)
    return Computation(
        (
            _norm(),
            Let(size, sum(map(Abs, vector))),
            Choice(parts, ((none, (one, 0 * one, 0 * one)), otherwise(*scaled))),
            Let(extent, sqrt(sum(part**2 for part in parts))),
            Let(length, size * extent),
            positive(a),
            Choice(names, ((none, (one, 0 * one, 0 * one)), otherwise(*values))),
        ),
        ImmutableMatrix([*names, 2 * atan2(length, Abs(a))]),
        guard=NORM_SQUARED,
    )


@cache
def inclination() -> Computation:
    """Angle between the body's z-axis and the vertical, for a quaternion of any norm but zero."""
    across, along = symbols("across along", real=True)
    sine, cosine = quaternions.inclination().args[1].args
    steps = (Let(across, sine), Let(along, cosine))
    return Computation(
        (*steps, Let(NORM_SQUARED, across**2 + along**2)),
        2 * atan2(across, along),
        guard=NORM_SQUARED,
    )


@cache
def quaternion_inverse() -> Computation:
    """Inverse of a quaternion of any norm but zero."""
    norm = _norm()
    return Computation(
        (norm,), hamilton.inverse(Q).xreplace({norm.value: norm.name}), guard=NORM_SQUARED
    )


def _rotate(vector_part: ImmutableMatrix) -> Computation:
    """Turn a vector: a product with the vector part, a second one, and a sum.

    With u the vector part and t = u × v, `q v q*` is `v + 2 (a t + u × t) / q q*`.
    """
    norm = _norm()
    vector = ImmutableMatrix(VECTOR)
    names = symbols("across_x across_y across_z", real=True)
    across = ImmutableMatrix(names)
    factor = Symbol("factor", real=True)
    steps = zip(names, vector_part.cross(vector), strict=True)
    return Computation(
        (norm, Let(factor, 2 / NORM_SQUARED), *(Let(name, value) for name, value in steps)),
        ImmutableMatrix(vector + factor * (a * across + vector_part.cross(across))),
        guard=NORM_SQUARED,
    )


@cache
def rotate_to_inertial() -> Computation:
    """Vector of the body frame in the inertial frame."""
    return _rotate(hamilton.vector_part(Q))


@cache
def rotate_to_body() -> Computation:
    """Vector of the inertial frame in the body frame."""
    return _rotate(-hamilton.vector_part(Q))


@cache
def constant_rate_step() -> Computation:
    """Attitude after a time at constant body rates, exactly; the rates may be zero."""
    half, ratio = symbols("half_turn ratio", real=True)
    turn = quaternions.turn_of_one_step()
    half_value = turn[0].args[0]
    turn = turn.xreplace({sinc(half_value): ratio, half_value: half})
    names = symbols("turn_a turn_b turn_c turn_d", real=True)
    return Computation(
        (
            Let(half, half_value),
            Choice((ratio,), ((half > 0, (sin(half) / half,)), otherwise(half**0))),
            *(Let(name, value) for name, value in zip(names, turn, strict=True)),
        ),
        hamilton.multiply(Q, ImmutableMatrix(names)),
    )
