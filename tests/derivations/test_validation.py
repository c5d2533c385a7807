"""Yaw and the factor E at random attitudes, and models of the Earth's field."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from sympy import S, lambdify, pi, tan

from chr_notes.derivations import validation as derived
from chr_notes.derivations.euler import rotation
from chr_notes.symbols import EULER, MAGNETOMETER, phi, psi, theta

from .late import computing

angles = st.floats(-3.1, 3.1)
fields = st.tuples(*(st.floats(-1, 1) for _ in range(3))).filter(lambda m: np.hypot(*m[:2]) > 0.05)
MATRIX = computing(EULER, lambda: rotation("I", "B"))
HEADING = computing((phi, theta, *MAGNETOMETER, *derived.REFERENCE[:2]), derived.heading)
FACTOR = computing((phi, theta, *MAGNETOMETER, derived.REFERENCE[2]), derived.factor)
LEVEL_FIELD = computing((phi, theta, *MAGNETOMETER), derived.level_field)
DETERMINANT = computing(derived.LEVEL, derived.determinant)
SINE_AND_COSINE = computing(
    (*derived.LEVEL, *derived.REFERENCE[:2]), derived.sine_and_cosine_of_yaw
)
AFTER_ERROR = computing(
    (*derived.ERROR_AXIS, derived.error_angle, *derived.REFERENCE),
    derived.factor_after_error,
)
SENSITIVITY = computing((*derived.ERROR_AXIS, *derived.REFERENCE), derived.sensitivity)


def test_gravity_tells_nothing_of_yaw() -> None:
    assert derived.yaws_of_gravity() == S.Reals


@given(angles, st.floats(-1.5, 1.5), angles, fields)
def test_heading_finds_yaw_in_any_field(
    roll: float, pitch: float, yaw: float, field: tuple[float, float, float]
) -> None:
    reading = MATRIX(roll, pitch, yaw) @ np.array(field)
    found = HEADING(roll, pitch, *reading, *field[:2])
    assert np.exp(1j * found) == pytest.approx(np.exp(1j * yaw), abs=1e-9)


@given(angles, st.floats(-1.5, 1.5), angles, fields)
def test_sine_and_cosine_of_yaw_and_their_divisor(
    roll: float, pitch: float, yaw: float, field: tuple[float, float, float]
) -> None:
    level = MATRIX(0, 0, yaw) @ np.array(field)
    values = dict(
        zip((*derived.LEVEL, *derived.REFERENCE[:2]), (*level[:2], *field[:2]), strict=True)
    )
    sine, cosine = derived.sine_and_cosine_of_yaw().subs(values)
    assert float(sine) == pytest.approx(np.sin(yaw), abs=1e-9)
    assert float(cosine) == pytest.approx(np.cos(yaw), abs=1e-9)
    assert float(derived.determinant().subs(values)) == pytest.approx(-(np.hypot(*field[:2]) ** 2))
    reading = MATRIX(roll, pitch, yaw) @ np.array(field)
    brought = lambdify((phi, theta, *MAGNETOMETER), derived.level_field())(roll, pitch, *reading)
    np.testing.assert_allclose(brought.ravel(), level, atol=1e-12)


@given(angles, angles, angles, fields, st.sampled_from([1e-3, 1.0, 50.0]))
def test_the_factor_is_zero_at_the_exact_attitude_at_any_scale(
    roll: float, pitch: float, yaw: float, field: tuple[float, float, float], scale: float
) -> None:
    unit = np.array(field) / np.linalg.norm(field)
    reading = scale * MATRIX(roll, pitch, yaw) @ unit
    assert FACTOR(roll, pitch, *reading, unit[2]) == pytest.approx(0, abs=1e-12)


@given(angles, angles, angles, fields, angles)
def test_the_factor_does_not_see_yaw(
    roll: float, pitch: float, yaw: float, field: tuple[float, float, float], other: float
) -> None:
    assume(abs(yaw - other) > 1e-3)
    one, two = (MATRIX(0, 0, turn) @ np.array(field) for turn in (yaw, other))
    one, two = (MATRIX(roll, pitch, 0) @ level for level in (one, two))
    same = FACTOR(roll, pitch, *one, 0.3) - FACTOR(roll, pitch, *two, 0.3)
    assert same == pytest.approx(0, abs=1e-12)


@given(fields, fields)
def test_the_sensitivity_is_the_slope_of_the_factor(
    axis: tuple[float, float, float], field: tuple[float, float, float]
) -> None:
    unit, small = np.array(axis) / np.linalg.norm(axis), 1e-6
    slope = abs(SENSITIVITY(*unit, *field))
    assert AFTER_ERROR(*unit, small, *field) / small == pytest.approx(slope, abs=1e-5)


def test_a_field_with_x_south_is_the_other_way_round_in_its_horizontal_part() -> None:
    seen = derived.field_with_x_south()
    north_east_down = rotation("I", "v1").subs(psi, pi).T * seen
    at = {derived.magnitude: 49, derived.inclination: 1.2, derived.declination: 0.1}
    north, east, down = (float(part.subs(at)) for part in north_east_down)
    assert np.arctan2(east, north) == pytest.approx(0.1)
    assert np.arctan2(down, np.hypot(north, east)) == pytest.approx(1.2)
    assert np.linalg.norm([north, east, down]) == pytest.approx(49)


def test_a_dipole_points_down_by_twice_the_tangent_of_latitude() -> None:
    north, east, down = derived.dipole_field()
    assert (down / north - 2 * tan(derived.latitude)).simplify() == 0
    assert east == 0
    assert derived.dipole_direction().norm().simplify() == 1
    assert not derived.dipole_direction().has(derived.radius)
    ratio = derived.dipole_magnitude().subs(derived.radius, 2) * 8
    assert (ratio - derived.dipole_magnitude().subs(derived.radius, 1)).simplify() == 0
