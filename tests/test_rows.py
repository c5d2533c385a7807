"""Functions that take each row by itself: what NaN in one becomes, of every such function."""

import sys
from math import prod

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import chr_notes
from chr_notes._rows import Rows
from chr_notes.generated.arrays.shapes import SHAPES

MODULES = [module for name, module in sys.modules.items() if name.startswith("chr_notes.")]
EVERY = {v.name: v for module in MODULES for v in vars(module).values() if isinstance(v, Rows)}
# Parameters that are checked before.
CHECKED = "axes", "misalignment", "sensitivity", "bias", "g_sensitivity", "soft_iron", "hard_iron"
ROWS, ODD = 5, 3


@pytest.mark.usefixtures("each_way")
def test_nan_in_any_element_is_nan_in_all_of_its_row() -> None:
    assert len(EVERY) > 30
    rng = np.random.default_rng(6)
    for name, function in EVERY.items():
        arrays, _ = SHAPES[name]
        given = [rng.uniform(0.1, 1, (ROWS, *last)) for last in arrays.values()]
        for place, key in enumerate(arrays):
            if key == "matrix":
                given[place] = chr_notes.matrix_from_euler(rng.uniform(0.1, 1, (ROWS, 3)))
            if key == "axes":
                given[place] = np.tile([3.0, 2.0, 1.0], (ROWS, 1))
        clean = function(*given)
        for place, (key, last) in enumerate(arrays.items()):
            for element in range(0 if key in CHECKED else prod(last)):
                holed = [array.copy() for array in given]
                holed[place].reshape(ROWS, -1)[ODD, element] = np.nan
                expected = clean.copy()
                expected[ODD] = np.nan
                assert_array_equal(function(*holed), expected, f"{name}: {key} {element}")
