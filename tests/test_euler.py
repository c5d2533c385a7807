"""Euler angles as numbers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

import chr_notes

angle = st.floats(-10.0, 10.0)
rate = st.floats(-100.0, 100.0)
eulers = st.tuples(angle, angle, angle)
off_the_pole = st.tuples(angle, st.floats(-1.5, 1.5), angle)
rates = st.tuples(rate, rate, rate)


@given(eulers)
def test_matrix_is_scipys_transposed(euler: tuple[float, float, float]) -> None:
    roll, pitch, yaw = euler
    expected = Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_matrix().T
    assert_allclose(chr_notes.matrix_from_euler(euler), expected, atol=1e-14)


@given(off_the_pole, rates)
def test_rates_there_and_back(
    euler: tuple[float, float, float], body_rates: tuple[float, float, float]
) -> None:
    euler_rates = chr_notes.euler_rates_from_body_rates(euler, body_rates)
    back = chr_notes.body_rates_from_euler_rates(euler, euler_rates)
    assert_allclose(back, body_rates, atol=1e-10)


@given(off_the_pole, rates)
def test_rates_are_the_matrix_times_the_body_rates(
    euler: tuple[float, float, float], body_rates: tuple[float, float, float]
) -> None:
    product = chr_notes.euler_rates_matrix(euler) @ np.array(body_rates)
    assert_allclose(
        chr_notes.euler_rates_from_body_rates(euler, body_rates), product, rtol=1e-12, atol=1e-9
    )


@given(off_the_pole, rates)
def test_rates_are_the_derivative_of_the_attitude(
    euler: tuple[float, float, float], body_rates: tuple[float, float, float]
) -> None:
    step = 1e-6
    turned = Rotation.from_matrix(chr_notes.matrix_from_euler(euler).T) * Rotation.from_rotvec(
        step * np.array(body_rates)
    )
    expected = np.array(euler) + step * chr_notes.euler_rates_from_body_rates(euler, body_rates)
    off = Rotation.from_matrix(chr_notes.matrix_from_euler(expected).T).inv() * turned
    # What is left is of second order in the step, times the square of the largest rate involved.
    largest = 1 + np.abs(chr_notes.euler_rates_from_body_rates(euler, body_rates)).max()
    assert off.magnitude() < (step * largest) ** 2 * 4 + 1e-14


@pytest.mark.parametrize("shape", [(), (1,), (5,), (2, 3), (0,), (4, 0, 2)])
def test_leading_axes_are_kept(shape: tuple[int, ...]) -> None:
    euler = np.zeros((*shape, 3))
    assert chr_notes.matrix_from_euler(euler).shape == (*shape, 3, 3)
    assert chr_notes.euler_rates_matrix(euler).shape == (*shape, 3, 3)
    assert chr_notes.euler_rates_from_body_rates(euler, euler).shape == (*shape, 3)
    assert chr_notes.body_rates_from_euler_rates(euler, euler).shape == (*shape, 3)


def test_leading_axes_broadcast() -> None:
    euler = np.zeros((4, 1, 3))
    body_rates = np.ones((5, 3))
    assert chr_notes.euler_rates_from_body_rates(euler, body_rates).shape == (4, 5, 3)


def test_a_wrong_shape_states_both() -> None:
    with pytest.raises(ValueError, match=r"euler: expected shape \(\.\.\., 3\), got \(2, 4\)"):
        chr_notes.matrix_from_euler(np.zeros((2, 4)))
    with pytest.raises(ValueError, match=r"body_rates: expected shape \(\.\.\., 3\), got \(\)"):
        chr_notes.euler_rates_from_body_rates([0, 0, 0], 1.0)
    with pytest.raises(ValueError, match=r"got shapes \(2, 3\) and \(4, 3\)"):
        chr_notes.body_rates_from_euler_rates(np.zeros((2, 3)), np.zeros((4, 3)))


def test_nan_stays_in_its_row() -> None:
    euler = np.zeros((3, 3))
    euler[1, 0] = np.nan
    finite = np.isfinite(chr_notes.matrix_from_euler(euler)).all(axis=(-2, -1))
    assert finite.tolist() == [True, False, True]
