"""Forms of the formulas for any sequence of three turns: one for all twelve.

The axes of the turns come as numbers, 1, 2 or 3 for x, y or z, in the order of the turns, as in
"3-2-1"; the turns are about rotating axes. Numbers become unit vectors u, v, w, whose elements are
0 or 1, and all formulas are written in these. What is multiplied by 0 or 1 stays exact.

With x = v × u, the frame x, v, u is right-handed. Either the last axis w is x or -x, and the
angles are yaw, pitch and roll about the axes of that frame, up to the sign of roll; or it is u
again, and they are Euler's own.
"""

from functools import cache
from itertools import chain

from sympy import (
    Abs,
    And,
    Eq,
    Expr,
    ImmutableMatrix,
    Ne,
    Symbol,
    atan2,
    cos,
    eye,
    sin,
    sqrt,
    symbols,
)
from sympy.codegen.cfunctions import hypot

from chr_notes.derivations import hamilton, quaternions
from chr_notes.derivations.computation import (
    LOCK_MARGIN,
    NOTHING,
    Choice,
    Computation,
    Let,
    otherwise,
)
from chr_notes.derivations.forms.euler import LOCKED, of_a_rotation
from chr_notes.derivations.forms.quaternions import Q, positive
from chr_notes.symbols import a

ANGLES = symbols("first second third", real=True)
AXES = symbols("first_axis second_axis third_axis", real=True)
U, V, W = (
    ImmutableMatrix(symbols(f"{which}_x {which}_y {which}_z", real=True))
    for which in ("first", "second", "third")
)
X = ImmutableMatrix(symbols("across_x across_y across_z", real=True))
SIGN, AGAIN, OTHER = symbols("sign_of_roll axis_again axis_other", real=True)
UNLOCKED = Symbol("unlocked")
FIRST, SECOND, THIRD = symbols("first_angle second_angle third_angle", real=True)


def _lets(names: ImmutableMatrix, values: ImmutableMatrix) -> tuple[Let, ...]:
    return tuple(Let(name, value) for name, value in zip(names, values, strict=True))


def _unit_vectors() -> tuple[Let | Choice, ...]:
    """Choose the unit vectors of the axes; numbers that are no sequence give none."""
    first, second, third = AXES
    nothing = otherwise(NOTHING, NOTHING, NOTHING)

    def unit(number: int) -> tuple[Expr, ...]:
        return tuple(eye(3).row(number - 1))

    ends = [
        Choice(tuple(vector), (*((Eq(axis, n), unit(n)) for n in (1, 2, 3)), nothing))
        for vector, axis in ((U, first), (W, third))
    ]
    # An axis twice in a row would be one turn.
    middle = Choice(
        tuple(V),
        (
            *((And(Eq(second, n), Ne(first, n), Ne(third, n)), unit(n)) for n in (1, 2, 3)),
            nothing,
        ),
    )
    return ends[0], middle, ends[1]


def _frame() -> tuple[Let | Choice, ...]:
    """Find unit vectors, the axis x across the first two, and which kind of sequence it is."""
    return (
        *_unit_vectors(),
        *_lets(X, V.cross(U)),
        Let(SIGN, X.dot(W)),  # 0 where the last axis is the first again
        Let(AGAIN, U.dot(W)),
        Let(OTHER, 1 - AGAIN),
    )


def _turn(axis: ImmutableMatrix, angle: Expr) -> tuple[tuple[Let, ...], ImmutableMatrix]:
    """Matrix of a frame turned about one of its own axes, and the steps to its elements."""
    stays, off = (
        ImmutableMatrix(symbols(f"{angle}_{what}_x {angle}_{what}_y {angle}_{what}_z", real=True))
        for what in ("stays", "sine")
    )
    x, y, z = off
    steps = (
        *_lets(stays, axis.applyfunc(lambda part: part + (1 - part) * cos(angle))),
        *_lets(off, axis * sin(angle)),
    )
    return steps, ImmutableMatrix(
        [[stays[0], z, -y], [-z, stays[1], x], [y, -x, stays[2]]],
    )


@cache
def matrix_from_angles() -> Computation:
    """Matrix to the turned frame: the product of the three turns."""
    names = ImmutableMatrix(3, 3, symbols("turned_1(1:4) turned_2(1:4) turned_3(1:4)", real=True))
    turns = [_turn(axis, angle) for axis, angle in zip((U, V, W), ANGLES, strict=True)]
    lets, (first, second, third) = zip(*turns, strict=True)
    return Computation(
        (*_unit_vectors(), *chain(*lets), *_lets(names, second * first)),
        ImmutableMatrix(third * names),
    )


@cache
def quaternion_from_angles() -> Computation:
    """Find the unit quaternion with a >= 0: the product of those of the three turns."""
    turns = [
        quaternions.from_axis_angle(axis, angle)
        for axis, angle in zip((U, V, W), ANGLES, strict=True)
    ]
    twice = ImmutableMatrix(symbols("twice_a twice_b twice_c twice_d", real=True))
    whole = ImmutableMatrix(symbols("a b c d", real=True))
    sign = positive(whole[0])
    return Computation(
        (
            *_unit_vectors(),
            *_lets(twice, hamilton.multiply(turns[0], turns[1])),
            *_lets(whole, hamilton.multiply(twice, turns[2])),
            sign,
        ),
        ImmutableMatrix(whole * sign.names[0]),
    )


def _with_lock(
    steps: tuple[Let | Choice, ...], angles: ImmutableMatrix, locked: Expr, first_at_lock: Expr
) -> Computation:
    """Choose between the angles and what stands for them where the third is set to zero."""
    first, second, third = angles
    return Computation(
        (
            *steps,
            Let(SECOND, second),
            Let(LOCKED, locked),
            Choice(
                (FIRST, THIRD),
                ((~LOCKED, (first, third)), otherwise(first_at_lock, third * 0)),
            ),
        ),
        ImmutableMatrix([FIRST, SECOND, THIRD]),
        flag=LOCKED,
    )


@cache
def angles_from_matrix() -> Computation:
    """Angles of a matrix to the turned frame, at the lock too.

    The last turn leaves its axis where it is, so that w as the first frame sees it, a row of the
    matrix, tells the first two angles. Near the lock its parts along x and v are small, and
    rounding turns the first angle; so the third is not read off elements of its own: it is the
    angle left over, between the second axis where these two angles say that it is, and where the
    matrix puts it.
    """
    rows = quaternions.MATRIX
    seen = ImmutableMatrix(symbols("seen_1 seen_2 seen_3", real=True))
    along = symbols("along_across along_second along_first", real=True)
    level = ImmutableMatrix(symbols("level_1 level_2 level_3", real=True))
    moved = ImmutableMatrix(symbols("moved_1 moved_2 moved_3", real=True))
    size, sign = symbols("size sign", real=True)
    steps = (
        *_frame(),
        *_lets(seen, rows.T * W),
        Let(sign, SIGN + AGAIN),
        *(Let(name, sign * seen.dot(axis)) for name, axis in zip(along[:2], (X, V), strict=True)),
        Let(along[2], seen.dot(U)),
        Let(size, hypot(along[0], along[1])),
        # The second axis after the first turn, times the size.
        *_lets(level, along[0] * V - along[1] * X),
        *_lets(moved, rows * level),
    )
    angles = ImmutableMatrix(
        [
            atan2(along[1], along[0]),
            atan2(AGAIN * size - SIGN * along[2], OTHER * size + AGAIN * along[2]),
            atan2((AGAIN * X - SIGN * U).dot(moved), V.dot(moved)),
        ]
    )
    locked = size < LOCK_MARGIN * Abs(along[2])
    # Where the third angle is zero, the second row is the second axis after the first turn.
    row = ImmutableMatrix(symbols("row_1 row_2 row_3", real=True))
    steps = (*steps, *_lets(row, rows.T * V))
    return of_a_rotation(_with_lock(steps, angles, locked, atan2(-row.dot(X), row.dot(V))))


@cache
def angles_from_quaternion() -> Computation:
    """Angles of a quaternion of any norm but zero, at the lock too.

    In the frame x, v, u Euler's own angles are, in halves, sum and difference of the directions of
    (a, part along u) and (part along v, part along x). For yaw, pitch and roll these four are taken
    together in pairs first, which makes of the pitch an angle between 0° and 180°.
    """
    along = symbols("along_across along_second along_first", real=True)
    four = symbols("part_1 part_2 part_3 part_4", real=True)
    products = symbols("product_1 product_2 product_3 product_4", real=True)
    one, two, three, other = four
    low, high, squares, half, root, rest, sign = symbols(
        "below above sum_of_squares half_sine root rest sign", real=True
    )
    across, second, first = along
    steps = (
        *_frame(),
        Let(sign, SIGN + AGAIN),
        *(
            Let(name, hamilton.vector_part(Q).dot(axis))
            for name, axis in zip(along, (X, V, U), strict=True)
        ),
        Let(one, a - OTHER * second),
        Let(two, across - OTHER * first),
        Let(three, second + OTHER * a),
        Let(other, first + OTHER * across),
        Let(low, one**2 + other**2),
        Let(high, two**2 + three**2),
        Let(squares, low + high),
        *(
            Let(name, value)
            for name, value in zip(
                products, (three * other, one * two, one * three, two * other), strict=True
            )
        ),
        Let(half, a * second - across * first),
        Let(root, sqrt(low) * sqrt(high)),
        Let(rest, OTHER * 2 * half + AGAIN * (low - high) / 2),
    )
    angles = ImmutableMatrix(
        [
            atan2(products[0] - products[1], products[2] + products[3]),
            atan2(AGAIN * root + OTHER * rest, OTHER * root + AGAIN * rest),
            atan2(sign * (products[0] + products[1]), products[2] - products[3]),
        ]
    )
    at_lock = atan2(2 * a * first - 2 * across * second, a**2 - across**2 + second**2 - first**2)
    computation = _with_lock(steps, angles, root < LOCK_MARGIN * Abs(rest), at_lock)
    return Computation(computation.steps, computation.results, flag=computation.flag, guard=squares)


@cache
def angle_rates_matrix() -> Computation:
    """D: matrix from rates about the axes of the turned frame to rates of the angles.

    Before the last turn the first axis lies, turned by the second angle about v, between u and x.
    So the rows of the inverse are the vector products of the axes over their volume, which is
    none at the lock.
    """
    _, second, third = ANGLES
    volume, over = symbols("volume over_volume", real=True)
    rows = ImmutableMatrix.vstack(
        over * (SIGN * U - AGAIN * X).T, V.T, over * (cos(second) * X + sin(second) * U).T
    )
    names = ImmutableMatrix(3, 3, symbols("before_1(1:4) before_2(1:4) before_3(1:4)", real=True))
    steps, last = _turn(W, third)
    return Computation(
        (
            *_frame(),
            Let(volume, SIGN * cos(second) + AGAIN * sin(second)),
            Let(UNLOCKED, Ne(volume, 0)),
            Choice((over,), ((Ne(volume, 0), (1 / volume,)), otherwise(NOTHING))),
            *_lets(names, rows),
            *steps,
        ),
        ImmutableMatrix(names * last.T),
        valid=UNLOCKED,
    )
