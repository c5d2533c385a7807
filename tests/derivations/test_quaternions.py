"""The derived quaternion formulas, against other ways to reach them."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation as Peer
from sympy import (
    Matrix,
    Rational,
    atan2,
    cos,
    exp,
    expand,
    eye,
    pi,
    simplify,
    sin,
    sqrt,
    symbols,
    zeros,
)
from sympy.algebras.quaternion import Quaternion as SymPyQuaternion

from chr_notes.derivations import further, hamilton
from chr_notes.derivations import quaternions as derived
from chr_notes.derivations.euler import rotation
from chr_notes.symbols import (
    BODY_RATES,
    EULER,
    FIRST,
    QUATERNION,
    SECOND,
    VECTOR,
    T,
    a,
    alpha,
    b,
    c,
    d,
)

from .late import computing

FROM_EULER = computing(EULER, derived.from_euler)
TO_EULER = computing(QUATERNION, derived.euler_from_quaternion)
TO_MATRIX = computing(QUATERNION, derived.matrix_from_quaternion)
EULER_MATRIX = computing(EULER, lambda: rotation("I", "B"))
STEP = computing((*QUATERNION, *BODY_RATES, T), derived.constant_rate_step)
angle = st.floats(-3.1, 3.1)
pitch = st.floats(-1.57, 1.57)
NORM = hamilton.norm_squared(derived.ATTITUDE)
MATRIX = derived.matrix_from_quaternion()


def vanishes(matrix: Matrix) -> bool:
    """Whether all elements are zero; sines and cosines are compared as exponentials."""
    return all(expand(element.rewrite(exp)) == 0 for element in matrix)


def test_units_multiply_as_defined() -> None:
    i, j, k = hamilton.UNITS
    table = hamilton.unit_products()
    assert all(table[unit, unit] == -1 for unit in (i, j, k))
    assert table[i, j] * k == k * k
    assert (table[i, j], table[j, k], table[k, i]) == (k, i, j)
    assert (table[j, i], table[k, j], table[i, k]) == (-k, -i, -j)


def test_product_is_associative_so_the_table_agrees_with_itself() -> None:
    one, two, three = (Matrix(symbols(f"{name}_0:4")) for name in "xyz")
    left = hamilton.multiply(hamilton.multiply(one, two), three)
    assert vanishes(left - hamilton.multiply(one, hamilton.multiply(two, three)))


def test_product_is_that_of_sympy() -> None:
    other = SymPyQuaternion(*FIRST) * SymPyQuaternion(*SECOND)
    assert vanishes(hamilton.product() - Matrix(other.args[:4]))


def test_quaternion_times_inverse_is_one() -> None:
    whole = hamilton.multiply(derived.ATTITUDE, hamilton.inverse(derived.ATTITUDE))
    assert whole.applyfunc(simplify) == Matrix([1, 0, 0, 0])


def test_sandwich_of_axis_and_angle_is_the_turn() -> None:
    tilt, heading = symbols("tilt heading", real=True)
    axis = Matrix([sin(tilt) * cos(heading), sin(tilt) * sin(heading), cos(tilt)])
    by_algebra = hamilton.sandwich(derived.from_axis_angle(axis, alpha), Matrix(VECTOR))
    by_geometry = derived.turned(axis, alpha, Matrix(VECTOR))
    assert vanishes(by_algebra - by_geometry)


def test_turned_keeps_the_axis_and_turns_x_to_y_about_z() -> None:
    x, y, z = (eye(3).col(n) for n in range(3))
    assert derived.turned(z, pi / 2, z) == z
    assert derived.turned(z, pi / 2, x) == y


def test_matrix_rotates_as_the_products_do() -> None:
    vector = Matrix(VECTOR)
    assert vanishes(MATRIX * vector - derived.rotate_to_body())
    assert vanishes(MATRIX.T * vector - derived.rotate_to_inertial())
    assert vanishes(MATRIX * MATRIX.T - NORM**2 * eye(3))
    assert simplify(derived.matrix_from_any_quaternion().det()) == 1


def test_matrix_of_the_quaternion_of_euler_angles_is_their_matrix() -> None:
    elements = dict(zip(QUATERNION, derived.from_euler(), strict=True))
    assert vanishes(MATRIX.subs(elements) - rotation("I", "B"))


def test_factored_euler_angles_are_those_of_the_matrix() -> None:
    """Same arguments of each atan2, but for the root, which is of the same sum of squares."""
    plain, factored = derived.euler_from_matrix(MATRIX), derived.euler_from_quaternion()
    for one, other in zip(plain, factored, strict=True):
        assert isinstance(other, atan2)
        assert all(expand(x**2 - y**2) == 0 for x, y in zip(one.args, other.args, strict=True))
    for place in (0, 2):
        pairs = zip(plain[place].args, factored[place].args, strict=True)
        assert all(expand(x - y) == 0 for x, y in pairs)
    sine, cosine = factored[1].args
    assert expand(sine - plain[1].args[0]) == 0
    # Sine and cosine of pitch together have the norm of the matrix.
    assert expand(sine**2 + cosine**2 - NORM**2) == 0


@given(roll=angle, pitch=pitch, yaw=angle, scale=st.floats(0.01, 100))
def test_euler_angles_come_back(roll: float, pitch: float, yaw: float, scale: float) -> None:
    quaternion = scale * FROM_EULER(roll, pitch, yaw).ravel()
    found = TO_EULER(*quaternion).ravel()
    np.testing.assert_allclose(EULER_MATRIX(*found), EULER_MATRIX(roll, pitch, yaw), atol=1e-13)


@given(roll=angle, pitch=pitch, yaw=angle)
def test_quaternion_of_euler_angles_is_scipys(roll: float, pitch: float, yaw: float) -> None:
    peer = Peer.from_euler("ZYX", [yaw, pitch, roll])
    ours = FROM_EULER(roll, pitch, yaw).ravel()
    x, y, z, w = peer.as_quat()
    assert abs(np.dot(ours, [w, x, y, z])) == pytest.approx(1.0, abs=1e-14)
    # SciPy's matrix takes the turned frame's components to the fixed one: from body to inertial.
    np.testing.assert_allclose(TO_MATRIX(*ours), peer.as_matrix().T, atol=1e-14)


@pytest.mark.parametrize("up", [1, -1])
def test_yaw_at_lock_rebuilds_the_attitude(up: int) -> None:
    roll, yaw = Rational(3, 7), Rational(11, 5)
    elements = derived.from_euler().subs(dict(zip(EULER, (roll, up * pi / 2, yaw), strict=True)))
    found = further.yaw_at_lock().subs(dict(zip(QUATERNION, elements, strict=True)))
    rebuilt = EULER_MATRIX(0.0, up * np.pi / 2, float(found))
    expected = EULER_MATRIX(float(roll), up * np.pi / 2, float(yaw))
    np.testing.assert_allclose(rebuilt, expected, atol=1e-15)
    # At the lock one of the two sums of squares under the root vanishes.
    upwards, downwards = ((a - c) ** 2 + (b + d) ** 2, (a + c) ** 2 + (d - b) ** 2)
    vanishing = upwards if up == 1 else downwards
    assert simplify(vanishing.subs(dict(zip(QUATERNION, elements, strict=True)))) == 0


def test_products_from_matrix_are_those_of_the_quaternion() -> None:
    elements = dict(zip(derived.MATRIX, MATRIX, strict=True))
    found = further.products_from_matrix().subs(elements)
    outer = 4 * derived.ATTITUDE * derived.ATTITUDE.T
    unit = {a: sqrt(1 - b**2 - c**2 - d**2)}
    assert (found - outer).subs(unit).applyfunc(simplify) == zeros(4, 4)
    assert expand(further.products_from_matrix().trace()) == 4


def test_axis_and_angle_come_back() -> None:
    axis, turned_by = derived.axis_angle_from_quaternion()
    rebuilt = derived.from_axis_angle(axis, turned_by).applyfunc(simplify)
    assert (rebuilt - derived.ATTITUDE / sqrt(NORM)).applyfunc(simplify) == zeros(4, 1)


def test_rates_turn_the_matrix_by_the_angular_velocity() -> None:
    """`dR/dt = -[w]x R` for the matrix from inertial to body frame and body rates w."""
    p, q, r = BODY_RATES
    moved = sum(
        (
            MATRIX.diff(element) * rate
            for element, rate in zip(QUATERNION, derived.rates(), strict=True)
        ),
        zeros(3, 3),
    )
    cross = Matrix([[0, -r, q], [r, 0, -p], [-q, p, 0]])
    assert vanishes(moved + cross * MATRIX)


def test_rates_keep_the_norm() -> None:
    assert expand(derived.ATTITUDE.dot(derived.rates())) == 0


def test_step_solves_the_equation_of_the_rates() -> None:
    step = derived.constant_rate_step()
    after = dict(zip(QUATERNION, step, strict=True))
    error = step.diff(T) - derived.rates().subs(after, simultaneous=True)
    # A rate of 3 rad/s, so that the root in the formulas is a number.
    assert vanishes(error.subs(dict(zip(BODY_RATES, (2, -1, 2), strict=True))).rewrite(sin))


def test_step_without_rates_changes_nothing() -> None:
    still = dict.fromkeys(BODY_RATES, 0)
    assert derived.constant_rate_step().subs(still) == derived.ATTITUDE


def test_steps_of_a_constant_rate_add_up() -> None:
    rates = (0.3, -1.1, 0.7)
    once = STEP(0.5, 0.5, -0.5, 0.5, *rates, 2.0).ravel()
    twice = STEP(*STEP(0.5, 0.5, -0.5, 0.5, *rates, 0.8).ravel(), *rates, 1.2).ravel()
    np.testing.assert_allclose(once, twice, atol=1e-15)


def test_other_peoples_numbers() -> None:
    cases = json.loads((Path(__file__).parents[1] / "published.json").read_text(encoding="utf-8"))
    seen = 0
    for case in cases:
        if case["kind"] == "euler_to_quat":
            angles = [case["inputs"][name] for name in ("roll", "pitch", "yaw")]
            found = FROM_EULER(*angles).ravel()
            expected = np.array(case["expected"])
            assert min(abs(found - expected).max(), abs(found + expected).max()) <= case["abs_tol"]
            seen += 1
        elif case["kind"] == "quat_to_R_nav_to_body":
            quaternion = np.array(case["inputs"]["q"], dtype=float)
            quaternion /= np.linalg.norm(quaternion)
            np.testing.assert_allclose(
                TO_MATRIX(*quaternion), case["expected"], rtol=0, atol=case["abs_tol"]
            )
            seen += 1
    assert seen >= 3


def test_cosine_of_the_inclination_is_the_last_element_of_the_matrix() -> None:
    # cos(2 x) of the tangent's sides.
    sine, cosine = derived.inclination().args[1].args
    found = (cosine**2 - sine**2) / (cosine**2 + sine**2)
    assert expand(found * (sine**2 + cosine**2) - derived.matrix_from_quaternion()[2, 2]) == 0
