"""What a vector at rest does in the axes of a body that turns."""

import mpmath
import pytest
from sympy import ImmutableMatrix

from chr_notes.derivations.sensors import vector_rate
from chr_notes.symbols import BODY_RATES, VECTOR


def test_it_turns_the_other_way() -> None:
    assert vector_rate() == ImmutableMatrix(VECTOR).cross(ImmutableMatrix(BODY_RATES))


def test_it_is_the_slope_of_what_a_turned_body_sees() -> None:
    rates, vector = mpmath.matrix([0.3, -0.7, 1.1]), mpmath.matrix([2.0, 5.0, -1.0])
    skew = mpmath.matrix(
        [[0, -rates[2], rates[1]], [rates[2], 0, -rates[0]], [-rates[1], rates[0], 0]]
    )
    step = mpmath.mpf(10) ** -6
    # The body turns by +rates, so what it sees turns back.
    slope = (mpmath.expm(-step * skew) * vector - mpmath.expm(step * skew) * vector) / (2 * step)
    known = dict(zip((*VECTOR, *BODY_RATES), (*vector, *rates), strict=True))
    for found, expected in zip(vector_rate(), slope, strict=True):
        assert float(found.subs(known)) == pytest.approx(float(expected), abs=1e-9)
