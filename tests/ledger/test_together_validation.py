"""All that the validation paper says, corrected, is applied together: see `test_together`."""

import functools
from collections.abc import Callable, Mapping
from typing import Any, ClassVar

import numpy as np
import pytest
from sympy import Basic, MatAdd, MatMul, Transpose

import chr_notes
from chr_notes.ledger import entry
from chr_notes.ledger.cases import CASES
from chr_notes.printed import validation as printed
from chr_notes.printed import validation_claims as claims
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, g

from .test_together import ATTITUDES, Known, apply, equations

# Of sets, limits, shares, the dipole, and of an x-axis to the south: see below.
OTHERS = (*(f"validation.{letter}" for letter in "bcefgimp"),)
NORTH, EAST, DOWN = np.eye(3)


class Numbers(Known):
    """Numbers for matrices that need no angles, and for vectors times numbers."""

    def _direction(self, symbol: Rotation) -> np.ndarray:
        return self[Rotation(*symbol.frames[::-1])].T

    def _times(self, product: MatMul) -> Any:  # noqa: ANN401 (a number or an array)
        factors = [np.asarray(self.value(factor)) for factor in product.args]
        numbers = [factor for factor in factors if factor.ndim == 0]
        arrays = [factor for factor in factors if factor.ndim]
        return np.prod(numbers) * functools.reduce(np.matmul, arrays)

    KINDS: ClassVar[Mapping[type, Callable[[Any, Any], Any]]] = {
        **Known.KINDS,
        Rotation: _direction,
        MatMul: _times,
        MatAdd: lambda self, total: sum(self.value(term) for term in total.args),
        Transpose: lambda self, matrix: self.value(matrix.arg).T,
    }


def named(names: Any, values: Any) -> dict[Basic, float]:  # noqa: ANN401 (any sequences)
    return dict(zip(names, map(float, values), strict=True))


@pytest.mark.parametrize("seed", range(ATTITUDES))
def test_validation_paper(seed: int) -> None:
    rng = np.random.default_rng(seed)
    # Within the conditions: roll short of 90°, a field that nothing disturbs, steady angles.
    euler = rng.uniform([-1.5, -1.5, -3.1], [1.5, 1.5, 3.1])
    rates, field, vector = rng.normal(size=(3, 3))
    field /= np.linalg.norm(field)
    matrix = chr_notes.matrix_from_euler(euler)
    roll, pitch, yaw = (
        chr_notes.matrix_from_euler(np.where(np.arange(3) == axis, euler, 0)).T for axis in range(3)
    )
    tilt = named((printed.ROLL_BEFORE, printed.PITCH_BEFORE), euler[:2])
    reading = chr_notes.accelerometer_at_rest(euler, 9.8)
    numbers = Numbers(
        {
            **named(EULER, euler),
            **named(EULER_RATES, rates),
            **named(BODY_RATES, chr_notes.body_rates_from_euler_rates(euler, rates)),
            **named(printed.GRAVITY, matrix @ [0.0, 0.0, 9.8]),
            **named(printed.FIELD_I, field),
            **named(printed.FIELD_B, matrix @ field),
            **named((printed.ROLL_COMP, printed.PITCH_COMP), euler[:2]),
            **tilt,
            **named((printed.ROLL_RATE, printed.PITCH_RATE), rates[:2]),
            g: 9.8,
            printed.ALPHA: 0.02,
            printed.DT: 0.01,
            printed.YAW_ACCEL: float(rng.uniform(-1.5, 1.5)),  # any yaw will do
            printed.R_IB: matrix,
            printed.R_X: roll,
            printed.R_Y: pitch,
            printed.R_Z: yaw,
            printed.R_Y_IN_8: pitch,
            printed.R_Z_IN_8: yaw,
            printed.YAW_AXIS: DOWN,
            printed.PITCH_AXIS: yaw @ EAST,
            printed.ROLL_AXIS: yaw @ pitch @ NORTH,
            printed.V_I: vector,
            claims.READING_AT_YAW: reading,
            claims.READING_AT_ZERO: field,
            claims.READING_WITHOUT_YAW: chr_notes.accelerometer_at_rest([*euler[:2], 0.0], 9.8),
        }
    )
    statements = sorted(
        equations("validation", *OTHERS),
        # What is defined counts wherever it is used.
        key=lambda each: entry(each[0]).verdict != "definition",
    )
    assert apply(statements, numbers) == []
    np.testing.assert_allclose(numbers.value(printed.R_BI), matrix.T)
    np.testing.assert_allclose(numbers[printed.V_B], matrix @ vector)
    np.testing.assert_allclose(numbers[claims.READING], reading)
    roll_and_pitch = chr_notes.tilt_from_accelerometer(reading)
    found = [numbers[angle] for angle in (printed.ROLL_ACCEL, printed.PITCH_ACCEL)]
    np.testing.assert_allclose(found, roll_and_pitch, atol=1e-9)
    heading = chr_notes.heading_from_magnetometer(matrix @ field, euler[:2], field[:2])
    assert numbers[printed.YAW] == pytest.approx(heading)
    factor = chr_notes.validation_factor(matrix @ field, euler[:2], field[2])
    assert numbers[printed.E] == pytest.approx(factor, abs=1e-12)


def test_the_filter_goes_to_the_accelerometer_by_its_share() -> None:
    """Equations 10 and 11 and the shares of claim i, in numbers."""
    accel = {printed.ROLL_ACCEL: 0.3, printed.PITCH_ACCEL: 0.3}
    before = {printed.ROLL_BEFORE: 0.1, printed.PITCH_BEFORE: 0.1}
    for name in ("validation.10", "validation.11"):
        statement = CASES[name].printed.statement
        at = {**before, printed.ROLL_RATE: 0, printed.PITCH_RATE: 0, **accel}
        assert statement.rhs.subs({**at, printed.ALPHA: 0.07}) == pytest.approx(0.114)


def test_a_field_with_x_south_points_away_from_x() -> None:
    statement = CASES["validation.e"].right
    assert statement is not None
    seen = statement.rhs.subs({printed.M_E: 49, printed.INCLINATION: np.radians(68)})
    down, north = 49 * np.sin(np.radians(68)), 49 * np.cos(np.radians(68))
    half_turn = chr_notes.matrix_from_euler([0.0, 0.0, np.pi])
    assert [float(part) for part in seen] == pytest.approx(half_turn @ [north, 0.0, down], abs=1e-9)


def test_the_factor_at_exact_angles_is_what_the_package_computes() -> None:
    """The witness of claim d: the iron there, and what the ledger and the package make of it."""
    reference, iron = np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.0, 0.05])
    euler = np.radians([30.0, 20.0, 60.0])
    reading = chr_notes.matrix_from_euler(euler) @ (reference + iron)
    factor = chr_notes.validation_factor(reading, euler[:2], reference[2])
    found = entry("validation.d").witness
    assert found is not None
    assert found.right.endswith(f"{factor:.4g}") or found.printed.endswith(f"{factor:.4g}")
