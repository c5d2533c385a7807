"""The algebra of quaternions, from i² = j² = k² = ijk = -1 alone.

A quaternion is a column of four, scalar first.
"""

from functools import cache

from sympy import Expr, ImmutableMatrix, Integer, expand, symbols

from chr_notes.symbols import FIRST, SECOND

UNITS = symbols("i j k", commutative=False)
BASIS = (Integer(1), *UNITS)


@cache
def unit_products() -> dict[tuple[Expr, Expr], Expr]:
    """Products of two of i, j, k, from i² = j² = k² = ijk = -1 alone.

    A unit that squares to -1 is undone by its negative. With that, `x y z = -1` gives
    `x y = -z⁻¹ = z`, and `y x`, which undoes `x y = z` up to two changes of sign, is `z⁻¹ = -z`.
    Taking x from the front of `x y z = -1` to its end gives `y z x = -1`, and so the rest.
    """
    undone = {unit**-1: -unit for unit in UNITS}
    table: dict[tuple[Expr, Expr], Expr] = {(unit, unit): Integer(-1) for unit in UNITS}
    word, value = UNITS[0] * UNITS[1] * UNITS[2], Integer(-1)
    for _ in UNITS:
        x, y, z = word.args
        table[x, y] = (value * z**-1).subs(undone)
        # (x y)⁻¹ = y⁻¹ x⁻¹ = (-y)(-x) = y x
        table[y, x] = (table[x, y] ** -1).subs(undone)
        word, value = x**-1 * word * x, x**-1 * value * x
    return table


@cache
def basis_products() -> dict[tuple[int, int], tuple[int, int]]:
    """Products of two of 1, i, j, k: from a pair of places in `BASIS` to (sign, place)."""
    table = {}
    for m, x in enumerate(BASIS):
        for n, y in enumerate(BASIS):
            product = unit_products().get((x, y), x * y)
            sign = -1 if product.could_extract_minus_sign() else 1
            table[m, n] = (sign, BASIS.index(sign * product))
    return table


def multiply(first: ImmutableMatrix, second: ImmutableMatrix) -> ImmutableMatrix:
    """Multiply two quaternions: every element with every element, by the table of the units."""
    product = [Integer(0)] * 4
    for (m, n), (sign, place) in basis_products().items():
        product[place] += sign * first[m] * second[n]
    return ImmutableMatrix(product)


@cache
def product() -> ImmutableMatrix:
    """Product of `(a_1, b_1, c_1, d_1)` and `(a_2, b_2, c_2, d_2)`."""
    return multiply(ImmutableMatrix(FIRST), ImmutableMatrix(SECOND))


def conjugate(quaternion: ImmutableMatrix) -> ImmutableMatrix:
    """Negate the vector part."""
    return ImmutableMatrix([quaternion[0], *(-quaternion[1:, 0])])


def norm_squared(quaternion: ImmutableMatrix) -> Expr:
    """Scalar part of `q q*`, whose vector part vanishes: the sum of the squares."""
    return expand(multiply(quaternion, conjugate(quaternion))[0])


def inverse(quaternion: ImmutableMatrix) -> ImmutableMatrix:
    """Divide the conjugate by the squared norm, because `q q*` is that number."""
    return ImmutableMatrix(conjugate(quaternion) / norm_squared(quaternion))


def pure(vector: ImmutableMatrix) -> ImmutableMatrix:
    """Make the quaternion with scalar part zero that stands for a vector."""
    return ImmutableMatrix([0, *vector])


def vector_part(quaternion: ImmutableMatrix) -> ImmutableMatrix:
    """Take the last three elements."""
    return ImmutableMatrix(quaternion[1:, 0])


def sandwich(quaternion: ImmutableMatrix, vector: ImmutableMatrix) -> ImmutableMatrix:
    """Vector part of `q v q*`: for a unit quaternion the vector turned by it, see `turned`."""
    inner = multiply(quaternion, pure(vector))
    return ImmutableMatrix(vector_part(multiply(inner, conjugate(quaternion))).applyfunc(expand))
