"""All that the note on dead reckoning says, corrected, is applied together: see `test_together`."""

import math

import numpy as np
import pytest

import chr_notes
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.evaluation import parts
from chr_notes.ledger.table_1 import PRINTED_G
from chr_notes.printed import dead_reckoning as printed
from chr_notes.printed import dead_reckoning_claims as claims
from chr_notes.printed.statement import Approximately
from chr_notes.printed.table_1 import COLUMNS, ROWS, error
from chr_notes.symbols import EULER, T, g, m

from .test_together import ATTITUDES, apply, equations
from .test_together_validation import Numbers, named

MASS, PERIOD = 0.05, 0.01


@pytest.mark.parametrize("seed", range(ATTITUDES))
def test_dead_reckoning(seed: int) -> None:
    rng = np.random.default_rng(seed)
    euler = rng.uniform([-3.1, -1.5, -3.1], [3.1, 1.5, 3.1])
    acceleration, velocity, position, own_error = rng.normal(size=(4, 3))
    matrix = chr_notes.matrix_from_euler(euler)
    gravity = np.array([0.0, 0.0, 9.8])
    reading = matrix @ (acceleration - gravity)
    spoilt = reading + own_error
    steps = chr_notes.dead_reckon([reading], [euler], PERIOD, gravity=9.8)[0]
    numbers = Numbers(
        {
            **named(EULER, euler),
            g: 9.8,
            m: MASS,
            T: PERIOD,
            printed.R_IB: matrix,
            printed.A_B: matrix @ acceleration,
            claims.NORMAL: -MASS * (matrix @ gravity),
            printed.IN_GRAVITIES: reading / 9.8,
            printed.OWN_ERROR: own_error,
            printed.ESTIMATED: chr_notes.inertial_acceleration(spoilt, euler, gravity=9.8),
            # Integrals have their constants.
            printed.INTEGRAL: velocity + acceleration * PERIOD,
            printed.DOUBLE_INTEGRAL: position + velocity * PERIOD,
            printed.A_K: acceleration,
            printed.V_K: velocity,
            printed.R_K: position,
        }
    )
    assert apply(equations("dead_reckoning"), numbers) == []
    np.testing.assert_allclose(numbers[printed.A_M], reading)
    np.testing.assert_allclose(numbers[printed.A_I], acceleration)
    np.testing.assert_allclose(numbers[printed.V_NEXT] - velocity, np.ravel(steps))
    np.testing.assert_allclose(numbers[printed.R_NEXT], position + PERIOD * velocity)


def test_table_and_sentences_agree_with_each_other_and_the_package() -> None:
    right: dict[object, list[Approximately]] = {}
    for case in CASES.values():
        if case.printed.document == "dead_reckoning":
            statement = case.right if case.right is not None else case.printed.statement
            for part in parts(statement):
                if isinstance(part, Approximately):
                    right.setdefault(part.lhs, []).append(part)
    for degrees in ROWS:
        for column, of in COLUMNS.items():
            drift = chr_notes.drift_from_tilt_error(
                math.radians(float(degrees)), float(of.seconds), gravity=float(PRINTED_G)
            )
            value = drift["avr".index(of.quantity)]
            for given in right.pop(error(column, degrees)):
                assert abs(float(given.rhs) - value) <= float(given.unit) / 2
    assert not right
