"""All that the note on estimation says, corrected, is applied together: see `test_together`."""

from collections.abc import Callable, Mapping
from typing import Any, ClassVar

import numpy as np
import pytest
from sympy import ZeroMatrix
from sympy.matrices.expressions import Inverse

import chr_notes
from chr_notes.ledger.estimation_reading import SUPPORT
from chr_notes.printed import estimation as printed
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, T, g, m

from .test_together import ATTITUDES, apply, equations
from .test_together_validation import Numbers, named

MASS, PERIOD, GAIN = 0.05, 0.01, 0.02
FRAMES = {"I": (0, 0, 0), "v1": (0, 0, 1), "v2": (0, 1, 1), "B": (1, 1, 1)}
# Of limits, sets, the settled filter, and what is the same at rest and not.
OTHERS = ("3.a", "3.b", "3.d", "4.a", "4.b", "4.c", "4.d", "4.e", "4.f", "5.a")
UPDATES = ("4.3", "4.4")


class Turned(Numbers):
    """Numbers with the matrices between all frames of three turns."""

    euler: np.ndarray

    def _turned(self, symbol: Rotation) -> np.ndarray:
        before, after = (
            chr_notes.matrix_from_euler(np.multiply(FRAMES[frame], self.euler))
            for frame in symbol.frames
        )
        return after @ before.T

    KINDS: ClassVar[Mapping[type, Callable[[Any, Any], Any]]] = {
        **Numbers.KINDS,
        Rotation: _turned,
        ZeroMatrix: lambda _, matrix: np.zeros(int(matrix.rows)),
        Inverse: lambda self, matrix: np.linalg.inv(self.value(matrix.arg)),
    }


@pytest.mark.parametrize("seed", range(ATTITUDES))
def test_estimation(seed: int) -> None:
    rng = np.random.default_rng(seed)
    # Within the conditions: at rest, roll short of 90°, no more than half a turn to go.
    euler = rng.uniform([-1.5, -1.5, -3.1], [1.5, 1.5, 3.1])
    rates = rng.normal(size=3)
    weight = MASS * (chr_notes.matrix_from_euler(euler) @ [0.0, 0.0, 9.8])
    reading = chr_notes.accelerometer_at_rest(euler, 9.8)
    numbers = Turned(
        {
            **named(EULER, euler),
            **named(BODY_RATES, rates),
            **named(EULER_RATES, chr_notes.euler_rates_from_body_rates(euler, rates)),
            **named((printed.A_MX, printed.A_MY, printed.A_MZ), reading),
            **named((printed.ROLL, printed.PITCH), euler[:2] + 0.1),
            g: 9.8,
            m: MASS,
            T: PERIOD,
            printed.L: GAIN,
            printed.F: np.zeros(3),
            printed.F_G: weight,
            SUPPORT: -weight,
        }
    )
    numbers.euler = euler
    left_out = [f"estimation.{each}" for each in (*OTHERS, *UPDATES)]
    statements = list(equations("estimation", *left_out))
    assert apply(statements, numbers) == []
    np.testing.assert_allclose(numbers[printed.A_M], reading)
    tilt = [numbers[angle] for angle in (printed.ROLL_ACCEL, printed.PITCH_ACCEL)]
    np.testing.assert_allclose(tilt, chr_notes.tilt_from_accelerometer(reading), atol=1e-9)
    # One letter stands for the estimate before and after the update.
    del numbers[printed.ROLL], numbers[printed.PITCH]
    updates = [each for each in equations("estimation") if each[0][-3:] in UPDATES]
    assert apply(updates, numbers) == []
    found = [numbers[angle] for angle in (printed.ROLL, printed.PITCH)]
    before = [*(euler[:2] + 0.1), 0.0]
    stepped = np.add(before, PERIOD * chr_notes.euler_rates_from_body_rates(euler, rates))
    np.testing.assert_allclose(found, (1 - GAIN) * stepped[:2] + GAIN * euler[:2])
