"""Sums of squares: of as many numbers as BLAS adds up alone, and of more."""

import numpy as np
import pytest

import chr_notes
from chr_notes._arrays import sum_of_squares


@pytest.mark.parametrize("count", [0, 1, 9_999, 10_000, 10_001, 20_000, 25_000])
def test_every_number_enters_once(count: int) -> None:
    numbers = np.random.default_rng(count).integers(-9, 10, count).astype(float)
    assert sum_of_squares(numbers) == (numbers**2).sum()  # whole numbers, so exactly


@pytest.mark.parametrize("place", [0, 9_999, 10_000, 19_999, 24_999])
def test_nan_and_what_overflows_are_seen_wherever_they_are(place: int) -> None:
    numbers = np.ones(25_000)
    numbers[place] = np.nan
    assert np.isnan(sum_of_squares(numbers))
    numbers[place] = np.inf
    assert sum_of_squares(numbers) == np.inf


def test_of_ten_million_numbers_too() -> None:
    assert sum_of_squares(np.broadcast_to(2.0, 10_500_001)) == 42_000_004
    none = chr_notes.rotate_to_inertial(np.ones((2_600_000, 1, 4)), np.ones((0, 3)))
    assert none.shape == (2_600_000, 0, 3)
