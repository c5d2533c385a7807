"""Each of the 24 sequences, proved by SymPy; and that the one form computes all of them."""

from collections.abc import Iterable

import mpmath
import pytest
from sympy import (
    QQ,
    Expr,
    ImmutableMatrix,
    Integer,
    Matrix,
    Rational,
    atan2,
    cos,
    diff,
    expand_func,
    eye,
    lambdify,
    pi,
    ring,
    sin,
    tan,
)
from sympy.sets import FiniteSet

from chr_notes.derivations import euler, hamilton, quaternions, sequences
from chr_notes.derivations.computation import Computation
from chr_notes.derivations.forms import sequences as forms
from chr_notes.symbols import phi, psi, theta

ANGLES = sequences.ANGLES
# Polynomials in sine and cosine of the half angles, of which the sum of squares is 1.
_RING, *_PARTS = ring("s_1 c_1 s_2 c_2 s_3 c_3", QQ)
_CIRCLES = [s**2 + c**2 - 1 for s, c in zip(_PARTS[::2], _PARTS[1::2], strict=True)]
_HALVES = {
    function: value
    for angle, s, c in zip(ANGLES, _RING.symbols[::2], _RING.symbols[1::2], strict=True)
    for function, value in (
        (sin(angle / 2), s),
        (cos(angle / 2), c),
        (sin(angle), 2 * s * c),
        (cos(angle), c**2 - s**2),
        (tan(angle), 2 * s * c / (c**2 - s**2)),
    )
}
# One of each kind: about rotating or fixed axes, of two axes or three, in either sense. The others,
# which differ in the names of the axes alone, are proved with `--full`.
KINDS = ("ZYX", "XYZ", "ZXZ", "XZX", "zyx", "xyz", "zxz", "xzx")


def each(names: Iterable[str]) -> pytest.MarkDecorator:
    """Try what holds for each sequence."""
    marked = [pytest.param(n, marks=() if n in KINDS else pytest.mark.full) for n in names]
    return pytest.mark.parametrize("name", marked)


EACH = each([*sequences.ROTATING, *sequences.FIXED])
ROTATING = each(sequences.ROTATING)
SWAPPED = {psi: phi, phi: psi}


def vanishes(value: Matrix | Expr) -> bool:
    """Whether each element is zero for all angles: as a polynomial in sines and cosines."""
    parts = list(value) if isinstance(value, Matrix | ImmutableMatrix) else [value]
    return all(not _RING.from_expr(part.xreplace(_HALVES).expand()).rem(_CIRCLES) for part in parts)


def test_there_are_twelve_and_twelve() -> None:
    assert len(set(sequences.ROTATING)) == len(set(sequences.FIXED)) == 12
    assert sequences.matrix("ZYX") == euler.rotation("I", "B")
    first = [sequences.is_proper(name) for name in sequences.ROTATING]
    assert sum(first) == 6


@ROTATING
def test_fixed_axes_are_rotating_ones_in_the_reversed_order(name: str) -> None:
    fixed = sequences.reversed_order(name)
    assert fixed in sequences.FIXED
    assert vanishes(sequences.matrix(fixed).xreplace(SWAPPED) - sequences.matrix(name))
    assert not vanishes(sequences.matrix(fixed) - sequences.matrix(name))


@EACH
def test_the_product_of_quaternions_is_the_same_turn(name: str) -> None:
    whole = ImmutableMatrix([1, 0, 0, 0])
    for turn in sequences.quaternion(name):
        whole = hamilton.multiply(whole, turn)
    known = dict(zip(quaternions.ATTITUDE, whole, strict=True))
    assert vanishes(quaternions.matrix_from_quaternion().xreplace(known) - sequences.matrix(name))


@EACH
def test_rates_follow_from_the_derivative_of_the_matrix(name: str) -> None:
    matrix, rates = sequences.matrix(name), sequences.body_rates_matrix(name)
    for column, angle in enumerate(ANGLES):
        # The matrix with its derivative is that of a vector product; of the nine three tell.
        change = diff(matrix, angle)
        for row, other, element in ((2, 1, 0), (0, 2, 1), (1, 0, 2)):
            assert vanishes(matrix.row(row).dot(change.row(other)) - rates[element, column])


@EACH
def test_angle_rates_undo_them_off_the_lock(name: str) -> None:
    determinant = sequences.determinant(name)
    # Times the determinant there is no quotient left.
    over = (sequences.angle_rates_matrix(name) * determinant).applyfunc(whole)
    assert vanishes(over * sequences.body_rates_matrix(name) - eye(3) * determinant)
    assert vanishes(sequences.body_rates_matrix(name).det() - determinant)


def whole(value: Expr) -> Expr:
    """Let a divisor that is sine or cosine of the second angle cancel."""
    return value.replace(tan, lambda angle: sin(angle) / cos(angle)).expand()


@EACH
def test_where_it_locks(name: str) -> None:
    proper = sequences.is_proper(name)
    assert sequences.locks(name) == (FiniteSet(0, pi) if proper else FiniteSet(pi / 2))
    # There the derivatives of the matrix by the first and the third angle are equal or opposite.
    for place in sequences.locks(name):
        first, third = (
            diff(sequences.matrix(name), angle).subs(theta, place) for angle in (psi, phi)
        )
        assert vanishes(first - third) or vanishes(first + third)


def at(values: ImmutableMatrix, matrix: ImmutableMatrix) -> ImmutableMatrix:
    return values.xreplace(dict(zip(quaternions.MATRIX, matrix, strict=True)))


@EACH
def test_the_way_back(name: str) -> None:
    """Sine and cosine of each angle come with one common factor, positive off the lock."""
    back = at(sequences.angles_from_matrix(name), sequences.matrix(name))
    proper = sequences.is_proper(name)
    common = sin(theta) if proper else cos(theta)
    for place, angle in ((0, psi), (2, phi)):
        assert back[place].func == atan2
        sine, cosine = back[place].args
        assert vanishes(sine - common * sin(angle))
        assert vanishes(cosine - common * cos(angle))
    sine, cosine = back[1].args
    root, other = (sine, cosine) if proper else (cosine, sine)
    assert vanishes(root**2 - common**2)
    assert vanishes(other - (cos(theta) if proper else sin(theta)))


def of_sequence(computation: Computation, name: str, *branches: int) -> ImmutableMatrix:
    """The results of a form for the axes of a sequence."""
    axes = [1 + axis for axis in sequences.axes(name)]
    choices = [axis - 1 for axis in axes]
    known = dict(zip(forms.AXES, map(Integer, axes), strict=True))
    known |= dict(zip(forms.ANGLES, ANGLES, strict=True))
    return expand_func(computation.inlined(*choices, *branches).xreplace(known))


@ROTATING
def test_the_form_of_the_matrix_and_of_the_rates(name: str) -> None:
    matrix = of_sequence(forms.matrix_from_angles(), name)
    assert vanishes(matrix - sequences.matrix(name))
    rates = of_sequence(forms.angle_rates_matrix(), name, 0)
    determinant = sequences.determinant(name)
    wanted = sequences.angle_rates_matrix(name)
    assert vanishes(((rates - wanted) * determinant).applyfunc(whole))


@ROTATING
def test_the_form_of_the_quaternion(name: str) -> None:
    whole = ImmutableMatrix([1, 0, 0, 0])
    for turn in sequences.quaternion(name):
        whole = hamilton.multiply(whole, turn)
    assert vanishes(of_sequence(forms.quaternion_from_angles(), name, 0) - whole)


@ROTATING
def test_the_forms_of_the_way_back(name: str) -> None:
    proper = sequences.is_proper(name)
    common = sin(theta) if proper else cos(theta)
    turns = ImmutableMatrix([1, 0, 0, 0])
    for turn in sequences.quaternion(name):
        turns = hamilton.multiply(turns, turn)
    from_quaternion = of_sequence(forms.angles_from_quaternion(), name, 0).xreplace(
        dict(zip(quaternions.ATTITUDE, turns, strict=True))
    )
    from_matrix = at(of_sequence(forms.angles_from_matrix(), name, 0), sequences.matrix(name))
    # Each pair is sine and cosine, times a factor that is positive off the lock.
    for found, factor in (
        (from_matrix, common),
        (from_quaternion, common / 2 if proper else common),
    ):
        for place, angle in ((0, psi), (2, phi)):
            sine, cosine = found[place].args
            assert vanishes(sine - factor * sin(angle))
            assert vanishes(cosine - factor * cos(angle))
    for found, factor in ((from_matrix, 1), (from_quaternion, Rational(1, 1 + proper))):
        sine, cosine = found[1].args
        root, other = (sine, cosine) if proper else (cosine, sine)
        assert vanishes(root**2 - (factor * common) ** 2)
        assert vanishes(other - factor * (cos(theta) if proper else sin(theta)))
    at_lock_forms(name, turns)


def at_lock_forms(name: str, turns: ImmutableMatrix) -> None:
    """With the third angle zero the first is what the branch at the lock says."""
    for place in sequences.locks(name):
        given = {phi: 0, theta: place}
        whole = at(of_sequence(forms.angles_from_matrix(), name, 1), sequences.matrix(name))
        sine, cosine = whole[0].subs(given).args
        assert vanishes(sine - sin(psi))
        assert vanishes(cosine - cos(psi))
        whole = of_sequence(forms.angles_from_quaternion(), name, 1).xreplace(
            dict(zip(quaternions.ATTITUDE, turns, strict=True))
        )
        sine, cosine = whole[0].subs(given).args
        assert vanishes(sine - sin(psi))
        assert vanishes(cosine - cos(psi))
        assert whole[2] == 0


@EACH
def test_rates_agree_with_differences_in_50_digits(name: str) -> None:
    with mpmath.workdps(50):
        angles = [mpmath.mpf(n) / 10 for n in (7, 11, -13)]
        speeds = [mpmath.mpf(n) / 7 for n in (3, -2, 5)]
        matrix = lambdify(ANGLES, sequences.matrix(name), "mpmath")
        step = mpmath.mpf(10) ** -16
        ahead, behind = (
            matrix(*(a + s * sign * step for a, s in zip(angles, speeds, strict=True)))
            for sign in (1, -1)
        )
        # Off by the third derivative times the square of the step: 1e-31.
        skew = matrix(*angles) * ((ahead - behind) / (2 * step)).T
        rates = mpmath.matrix([skew[2, 1], skew[0, 2], skew[1, 0]])
        d = lambdify(ANGLES, sequences.angle_rates_matrix(name), "mpmath")(*angles)
        found = d * rates
        assert max(abs(found[i] - speeds[i]) for i in range(3)) < mpmath.mpf(10) ** -20


def test_yaw_roll_yaw_is_far_from_its_lock_upright() -> None:
    assert sequences.yaw_roll_yaw_upright() == 1
    assert vanishes(sequences.determinant("xyz") - euler.body_rates_matrix().det())
