"""Forms that compute with two real numbers as one complex number.

NumPy multiplies complex numbers in one pass over memory where the real numbers take six.
"""

from functools import cache

from sympy import (
    Expr,
    I,
    ImmutableMatrix,
    Symbol,
    collect,
    conjugate,
    cos,
    expand,
    im,
    re,
    sin,
    symbols,
    tan,
)

from chr_notes.derivations import euler
from chr_notes.derivations.computation import Computation, Let
from chr_notes.derivations.forms.quaternions import NORM_SQUARED
from chr_notes.symbols import VECTOR, phi, theta

Pair = tuple[Expr, Expr]

# Two quaternions z + w j, where z = a + i b and w = c + i d.
FACTORS = symbols("z_1 w_1 z_2 w_2")
# An attitude z + w j, the y and z of a vector as y + i z, the body rates as q + i r.
ATTITUDE = symbols("z w")
VECTOR_SIDE = Symbol("v")
RATES_SIDE = Symbol("u")


@cache
def euler_rates() -> Computation:
    """Euler rates. Seen along the body x-axis, q and r are a vector, and roll turns it.

    The parts of the turned vector are the pitch rate and what roll and yaw have in common.
    """
    turn, turned = symbols("turn turned")
    roll_rate, pitch_rate, yaw_rate = euler.euler_rates()
    across = expand(yaw_rate * cos(theta))
    parts = {across: im(turned), pitch_rate: re(turned)}
    return Computation(
        (Let(turn, cos(phi) + I * sin(phi)), Let(turned, RATES_SIDE * turn)),
        ImmutableMatrix(
            [
                collect(roll_rate, tan(theta)).subs(parts),
                pitch_rate.subs(parts),
                im(turned) / cos(theta),
            ]
        ),
    )


def _multiply(first: Pair, second: Pair) -> Pair:
    """Multiply two quaternions, each written as z + w j with complex z and w.

    j turns to the other side of a complex number by conjugating it, and `j² = -1`. So
    `(z₁ + w₁ j)(z₂ + w₂ j)` is `z₁ z₂ - w₁ w₂*` and `z₁ w₂ + w₁ z₂*` times j.
    """
    (z_1, w_1), (z_2, w_2) = first, second
    return z_1 * z_2 - w_1 * conjugate(w_2), z_1 * w_2 + w_1 * conjugate(z_2)


@cache
def product() -> ImmutableMatrix:
    """Product of two quaternions."""
    return ImmutableMatrix(_multiply(FACTORS[:2], FACTORS[2:]))


@cache
def rotate_to_inertial() -> Computation:
    """Vector of the body frame in the inertial frame: x, and y and z as a pair."""
    return _rotate(ATTITUDE)


@cache
def rotate_to_body() -> Computation:
    """Vector of the inertial frame in the body frame: x, and y and z as a pair."""
    z, w = ATTITUDE
    return _rotate((conjugate(z), -w))


def _rotate(attitude: Pair) -> Computation:
    """Turn a vector x i + v j by two products: `q v`, and that times `q* = z* - w j`."""
    z, w = attitude
    square_z, square_w = symbols("square_of_z square_of_w")
    along, across = symbols("along across")
    half_way = symbols("half_way_z half_way_w")
    # The number that holds x is imaginary.
    there = [each.subs(conjugate(along), -along) for each in _multiply(attitude, (along, across))]
    first, second = symbols("back_1 back_2")
    _, side = _multiply(half_way, (conjugate(z), -w))
    sign, product_of_w = (half_way[1] * conjugate(w)).as_coeff_Mul()
    return Computation(
        (
            Let(square_z, z * conjugate(z)),
            Let(square_w, w * conjugate(w)),
            Let(NORM_SQUARED, re(square_z) + re(square_w)),
            Let(along, I * VECTOR[0] / NORM_SQUARED),
            Let(across, re(VECTOR_SIDE) / NORM_SQUARED + I * im(VECTOR_SIDE) / NORM_SQUARED),
            *(Let(name, value) for name, value in zip(half_way, there, strict=True)),
            Let(first, half_way[0] * conjugate(z)),
            Let(second, product_of_w),
        ),
        ImmutableMatrix([im(first) + sign * im(second), side]),
        guard=NORM_SQUARED,
    )
