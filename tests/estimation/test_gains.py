"""Gains and time constants: against the decay that they stand for, and one undoes the other."""

import math
from fractions import Fraction

import numpy as np
import pytest
import scipy
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from chr_notes import fixed_gain_observer, gain_from_time_constant, time_constant_from_gain


def test_what_is_left_after_a_time_constant_is_one_part_in_e() -> None:
    gain = gain_from_time_constant(0.5, 0.01)
    left = scipy.signal.lfilter([1.0], [1.0, gain - 1.0], [1.0, *np.zeros(50)])
    assert left[50] == pytest.approx(math.exp(-1))


def test_the_observer_forgets_a_wrong_start_by_it() -> None:
    gain = float(gain_from_time_constant(0.5, 0.01))
    rest = [0.0, 0.0, -9.8]
    euler = fixed_gain_observer(np.zeros((100, 3)), [rest] * 100, 0.01, gain, [0.2, 0.0, 0.0])
    assert_allclose(euler[[49, 99], 0], 0.2 * np.exp([-1.0, -2.0]))


@given(st.floats(1e-9, 20), st.floats(1e-6, 1e3))
def test_one_undoes_the_other(periods: float, time_constant: float) -> None:
    gain = gain_from_time_constant(time_constant, periods * time_constant)
    again = time_constant_from_gain(gain, periods * time_constant)
    # Near 1 a gain has lost the digits of what is kept.
    assert_allclose(again, time_constant, rtol=1e-14 * math.exp(periods))


def test_small_gains_keep_their_digits() -> None:
    ratio = Fraction(1, 10**12)
    expected = float(ratio - ratio**2 / 2)
    assert gain_from_time_constant(1.0, 1e-12) == pytest.approx(expected, rel=1e-15)
    assert time_constant_from_gain(1e-12, 1.0) == pytest.approx(1e12 - 0.5, rel=1e-15)


def test_shapes_and_nan() -> None:
    assert gain_from_time_constant([[1.0], [2.0]], [0.1, 0.2, 0.3]).shape == (2, 3)
    assert np.isnan(gain_from_time_constant([1.0, np.nan], 0.1)).tolist() == [False, True]
    assert np.isnan(time_constant_from_gain([0.5, np.nan], 0.1)).tolist() == [False, True]
    assert isinstance(gain_from_time_constant(1.0, 0.1), float)
    assert gain_from_time_constant(1.0, 0.0) == 0


def test_what_has_no_meaning_is_refused() -> None:
    with pytest.raises(ValueError, match=r"time_constant: expected positive seconds, got 0.0"):
        gain_from_time_constant(0.0, 0.1)
    with pytest.raises(ValueError, match=r"dt: .*not negative, got -0.1 at index \(1,\)"):
        gain_from_time_constant(1.0, [0.1, -0.1])
    for gain in (0.0, 1.0, -0.5, 1.5):
        with pytest.raises(ValueError, match=rf"gain: expected .* between 0 and 1, got {gain}"):
            time_constant_from_gain(gain, 0.1)
