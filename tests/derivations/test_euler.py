"""The derived formulas of the Euler-angle note, against other ways to reach them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import (
    Function,
    Matrix,
    Rational,
    Symbol,
    cos,
    diff,
    exp,
    expand,
    eye,
    pi,
    simplify,
    zeros,
)
from sympy.sets import FiniteSet

from chr_notes.derivations import euler
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, phi, psi, theta

from .late import computing

MATRIX = computing(EULER, lambda: euler.rotation("I", "B"))
RATES_MATRIX = computing((phi, theta), euler.euler_rates_matrix)
CONDITION = computing(theta, euler.euler_rates_condition)
angle = st.floats(-3.0, 3.0)
pitch = st.floats(-1.5, 1.5)


@pytest.mark.parametrize("source", euler.FRAMES)
@pytest.mark.parametrize("target", euler.FRAMES)
def test_each_rotation_is_undone_by_its_transpose(source: str, target: str) -> None:
    there, back = euler.rotation(source, target), euler.rotation(target, source)
    assert back == there.T
    assert all(expand(x.rewrite(exp)) == 0 for x in (*(there * back - eye(3)), there.det() - 1))


def test_frame_rotation_brings_the_turned_axis_to_the_old_one_after_it() -> None:
    turned = Symbol("turned", real=True)
    for axis, after in ((0, 1), (1, 2), (2, 0)):
        matrix = euler.frame_rotation(axis, turned)
        # A quarter turn carries the axis after to where the last one was.
        assert matrix.subs(turned, pi / 2).T * eye(3).col(after) == eye(3).col((after + 1) % 3)


def test_yaw_of_90_degrees_puts_east_ahead() -> None:
    east = Matrix([0, 1, 0])
    assert euler.rotation("I", "B").subs({phi: 0, theta: 0, psi: pi / 2}) * east == euler.X


def test_pitch_raises_the_nose() -> None:
    nose = euler.rotation("B", "I") * euler.X
    assert simplify(nose.subs({phi: 0, psi: 0, theta: pi / 6}))[2] == -Rational(1, 2)


def test_rates_follow_from_the_derivative_of_the_matrix() -> None:
    """The angular velocity has the skew-symmetric matrix `R (dRᵀ/dt)` in the body frame."""
    time = Symbol("t", real=True)
    moving = {angle: Function(str(angle), real=True)(time) for angle in EULER}
    matrix = euler.rotation("I", "B").subs(moving)
    skew = matrix * diff(matrix.T, time)
    speeds = {
        diff(moving[angle], time): rate for angle, rate in zip(EULER, EULER_RATES, strict=True)
    }
    still = {moving[angle]: angle for angle in EULER}
    p, q, r = euler.body_rates()
    expected = Matrix([[0, -r, q], [r, 0, -p], [-q, p, 0]])
    error = skew.subs(speeds).subs(still) - expected
    assert all(expand(element.rewrite(exp)) == 0 for element in error)


def test_euler_rates_undo_body_rates() -> None:
    back = euler.euler_rates().subs(dict(zip(BODY_RATES, euler.body_rates(), strict=True)))
    assert (back - Matrix(EULER_RATES)).applyfunc(simplify) == zeros(3, 1)


def test_determinant_is_one_over_cos_pitch() -> None:
    assert simplify(euler.euler_rates_determinant() - 1 / cos(theta)) == 0


@given(roll=angle, pitch=pitch)
def test_condition_number_is_that_of_the_singular_values(roll: float, pitch: float) -> None:
    expected = np.linalg.cond(RATES_MATRIX(roll, pitch))
    assert CONDITION(pitch) == pytest.approx(expected, rel=1e-9)


def test_lock_is_straight_up_and_straight_down() -> None:
    assert euler.lock_pitches() == FiniteSet(-pi / 2, pi / 2)


def test_any_axes_are_those_of_a_right_handed_frame() -> None:
    axes = euler.any_axes()
    errors = (*(axes * axes.T - eye(3)), axes.det() - 1)
    assert all(expand(error.rewrite(exp)) == 0 for error in errors)


@given(roll=angle, pitch=pitch, yaw=angle)
def test_matrix_is_a_rotation(roll: float, pitch: float, yaw: float) -> None:
    matrix = MATRIX(roll, pitch, yaw)
    np.testing.assert_allclose(matrix @ matrix.T, np.eye(3), atol=1e-15)
    assert np.linalg.det(matrix) == pytest.approx(1.0)
