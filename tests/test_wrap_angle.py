"""Angles brought into one turn."""

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_array_equal

import chr_notes

from .sampling import few


@few(50)
@given(st.floats(-1e3, 1e3))
def test_wrapped_angle_is_the_same_direction_in_range(angle: float) -> None:
    wrapped = float(chr_notes.wrap_angle(angle))
    assert -np.pi <= wrapped < np.pi
    assert abs(np.exp(1j * (wrapped - angle)) - 1) < 1e-12
    assert chr_notes.wrap_angle(wrapped) == wrapped


@pytest.mark.parametrize(
    "angle",
    [
        *(np.pi, -np.pi, 3 * np.pi, np.nextafter(-np.pi, -4), np.nextafter(np.pi, 4)),
        *(7.0, -1e3, 999_999.9, 1e6, 1e12, -1e15, 1e300),
    ],
)
def test_whole_turns_are_those_of_pi_itself(angle: float) -> None:
    wrapped = float(chr_notes.wrap_angle(angle))
    assert -np.pi <= wrapped < np.pi
    with mpmath.workdps(400):
        turns = (mpmath.mpf(wrapped) - mpmath.mpf(angle)) / (2 * mpmath.pi)
        assert abs(turns - mpmath.nint(turns)) * 2 * mpmath.pi < 5e-16


@pytest.mark.usefixtures("each_way")
@pytest.mark.parametrize("angle", [-np.pi, 1e-300, -1e-300, 0.0, -0.0, np.nextafter(np.pi, 0)])
def test_an_angle_in_the_range_stays_as_it_is(angle: float) -> None:
    wrapped = chr_notes.wrap_angle([angle])  # alone: one at the end has all turned a second time
    assert_array_equal(wrapped, angle)
    assert_array_equal(np.signbit(wrapped), np.signbit(angle))
