"""Sums of squares: of as many numbers as BLAS adds up alone, and of more."""

import numpy as np
import pytest

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
