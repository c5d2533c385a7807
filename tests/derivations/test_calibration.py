"""Models of calibration, against numbers."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from chr_notes.derivations import calibration
from chr_notes.generated.scalar.sensors import norm_misfit

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
TRIANGLE = np.triu_indices(3)


def misfit(elements: Floats, centre: Floats, point: Floats) -> float:
    matrix = np.zeros((3, 3))
    matrix[TRIANGLE] = elements
    matrix.T[TRIANGLE] = elements
    return float(np.linalg.norm(matrix @ (point - centre)) - 1)


@given(seeds)
def test_slopes_of_the_norm_are_those_of_differences(seed: int) -> None:
    generator = np.random.default_rng(seed)
    elements, centre, point = (generator.normal(size=size) for size in (6, 3, 3))
    found = norm_misfit(*elements, *centre, *point)
    assert_allclose(found[0], misfit(elements, centre, point), atol=1e-12)
    near = 1e-6
    for place, step in enumerate(near * np.eye(9)):
        sides = (
            misfit(elements + way * step[:6], centre + way * step[6:], point) for way in (1, -1)
        )
        slope = (next(sides) - next(sides)) / (2 * near)
        assert_allclose(found[1 + place], slope, rtol=1e-4, atol=1e-6)


def test_a_turned_reading_has_no_bias() -> None:
    turned = calibration.turned_reading()
    assert not turned.free_symbols & set(calibration.BIAS)
    offset = calibration.measured() - turned
    assert not offset.expand().free_symbols & set(calibration.INPUT)
