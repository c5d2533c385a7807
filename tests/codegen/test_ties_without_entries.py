"""A generated function that no entry of the ledger states computes what others compute."""

import math
from itertools import chain

import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from chr_notes.codegen.targets import TARGETS

from .reference import DOUBLE
from .ties_by_numbers import REFERENCES

Row = tuple[float, ...]
BY_NAME = {target.name: target for target in TARGETS}
TURNS = Rotation.from_euler("ZYX", [(0.4, 0.9, -1.9), (-2.6, -0.7, 0.3), (1.2, 0.2, 2.8)])
MATRICES = [tuple(turn.as_matrix().T.ravel().tolist()) for turn in TURNS]
ATTITUDES = [tuple(turn.as_quat(scalar_first=True).tolist()) for turn in TURNS]
QS = [*ATTITUDES[:2], tuple(-3 * part for part in ATTITUDES[2])]  # of any norm, and either sign
RATES, FORCE, MAG = (0.4, -1.1, 0.3), (1.0, -2.0, -9.0), (20.0, -5.0, 40.0)
SEQUENCES = ["321", "312", "231", "213", "132", "123", "313", "323", "131", "121", "212", "232"]
AXES = [tuple(map(float, sequence)) for sequence in SEQUENCES]
ANGLES = (0.4, 0.9, -1.9)


def rows(*columns: list[Row]) -> list[Row]:
    """Put rows of parts of the arguments side by side; what there is once stands in each."""
    count = max(map(len, columns))
    return [tuple(chain.from_iterable(c[n % len(c)] for c in columns)) for n in range(count)]


STEPS = [(0.1, 0.3), (0.02, 1.0), (0.5, 0.05)]  # period and gain
BEGUN, SETTLED = (9.0, 0.0, 0.0, 0.0, 0.8, 0.0), (9.4, 0.3, -0.2, 0.5, 1.8, 1.0)
FIELDS = [(0.5, 44.0, 0.7, 2.0), (0.5, 44.0, 0.7, 2.0), (6.0, 44.0, 0.7, 2.0)]
HEADING = (0.1, 3.0, 1.0, 6.0, 0.9, -0.3)
REST = (0.01, 0.02, -0.01, 0.1, -0.2, 9.8)
READINGS = (0.012, 0.015, -0.02, 0.15, -0.22, 9.7)
WATCH = (0.25, 3.0, 0.02, 0.001, 0.2)
ROWS: dict[str, list[Row]] = {
    "euler_from_matrix": MATRICES,
    "rotation_defect": [*MATRICES, (1.1, 0.2, 0.0, -0.3, 0.9, 0.1, 0.05, -0.2, -1.2)],
    "euler_rates_determinant": [(0.3,), (-1.2,)],
    "euler_rates_condition": [(0.3,), (-1.2,)],
    "wrap_angle": [(0.5,), (4.0,), (-4.0,), (100.0,), (math.pi,), (-math.pi,)],
    "inclination_from_quaternion": QS,
    "quaternion_after_constant_rates": rows(QS, [(*RATES, 0.7), (0.0, 0.0, 0.0, 0.7)]),
    "quaternion_rates": rows(QS, [RATES]),
    "matrix_from_angles": rows([ANGLES], AXES),
    "angles_from_matrix": rows(MATRICES, AXES),
    "quaternion_from_angles": rows([ANGLES, (3.0, 0.9, 2.0)], AXES),
    "angles_from_quaternion": rows(QS, AXES),
    "angle_rates_matrix": rows([ANGLES[1:]], AXES),
    "vector_rate": [(*FORCE, *RATES)],
    "norm_misfit": [(0.9, 0.1, -0.2, 1.1, 0.3, 0.8, 0.5, -0.4, 0.2, 1.5, -0.7, 0.9)],
    "gyro_turn": rows(QS, [RATES], [(0.7,)]),
    "observer_turn": rows(QS, [RATES], [FORCE], STEPS),
    "observer_step": rows([ANGLES, (-0.4, 0.3, 2.0)], [RATES], [FORCE], STEPS),
    "gain_from_time_constant": [(3.0, 0.01), (0.2, 0.5)],
    "time_constant_from_gain": [(0.003, 0.01), (0.9, 0.5)],
    "averaging_turn": rows(ATTITUDES, [BEGUN, SETTLED], [RATES], [FORCE], [HEADING[:3]]),
    "averaging_heading_turn": rows(
        ATTITUDES,
        [BEGUN, SETTLED, SETTLED],
        FIELDS,
        [RATES],
        [FORCE],
        [MAG],
        [HEADING],
        [(1.5, 10.0), (0.01, 10.0), (2.5, 10.0)],  # how much else the field may be, how long
    ),
    "observer_heading_turn": rows(QS, [RATES], [FORCE], [MAG], STEPS, [(0.25, 0.9, -0.3)]),
    "bias_at_rest": [
        (*REST, still, 0.001, 0.002, 0.003, *now, 0.1, 2.0, 1.0)
        for still, now in ((5.0, READINGS), (0.5, READINGS), (5.0, (*RATES, *FORCE)))
    ],
    "averaging_bound": [(1.5, 3.0, 0.4, 0.01), (3.0, 3.0, 0.4, 0.01)],
    "monitor_gain": [(float(above), *WATCH[1:]) for above in (0, 1, 3, 4, 6, 7)],
    "monitor_count": [(2.0, 0.3, 0.2), (2.0, 0.1, 0.2), (2.0, math.nan, 0.2)],
    "monitored_turn": rows(
        QS, [(0.0,), (2.0,), (5.0,)], [RATES], [FORCE], [MAG], [(0.1, 0.5)], [WATCH]
    ),
    "position_errors": [(0.02, 0.05, 0.001, 0.01, 3.0, 0.02, 0.003, 7.0, 9.8)],
    "position_at_last_velocity": [(0.02, 7.0, 9.8)],
}


@pytest.mark.parametrize("name", ROWS)
def test_the_function_computes_the_reference(name: str) -> None:
    for row in ROWS[name]:
        found = [float(element) for element in DOUBLE.results(BY_NAME[name], row)]
        expected = list(REFERENCES[name](*row))
        assert len(found) == len(expected)
        assert_allclose(found, expected, rtol=1e-8, atol=1e-8, err_msg=str(row))


def test_each_function_is_tied_to_an_entry_or_to_a_reference() -> None:
    without = [target.name for target in TARGETS if not target.entries]
    assert sorted(ROWS) == sorted(REFERENCES) == sorted(without)
