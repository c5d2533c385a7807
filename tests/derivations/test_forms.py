"""Each form in which a formula is computed is the derived formula again, proved by SymPy."""

import pytest
from sympy import (
    Abs,
    Basic,
    ImmutableMatrix,
    atan2,
    cos,
    expand,
    expand_func,
    lambdify,
    pi,
    sin,
    sqrt,
    symbols,
)

from chr_notes.derivations import (
    calibration,
    dead_reckoning,
    estimation,
    euler,
    further,
    hamilton,
    quaternions,
    validation,
)
from chr_notes.derivations.computation import Choice, Computation, Let, otherwise
from chr_notes.derivations.forms import dead_reckoning as reckoning_forms
from chr_notes.derivations.forms import estimation as filter_forms
from chr_notes.derivations.forms import euler as euler_forms
from chr_notes.derivations.forms import filters
from chr_notes.derivations.forms import quaternions as forms
from chr_notes.derivations.forms import sensors as sensor_forms
from chr_notes.ledger.proof import is_zero
from chr_notes.symbols import (
    ACCELEROMETER,
    AXIS,
    BODY_RATES,
    EULER,
    MAGNETOMETER,
    QUATERNION,
    T,
    a,
    alpha,
    b,
    c,
    d,
    g,
    phi,
    psi,
    theta,
)

NORM = hamilton.norm_squared(quaternions.ATTITUDE)
UNIT = {a**2: 1 - b**2 - c**2 - d**2}


def same(first: Basic, second: Basic) -> bool:
    """Whether two formulas or matrices are equal for all values; hypot is written as a root."""
    left, right = (
        list(side) if isinstance(side, ImmutableMatrix) else [side] for side in (first, second)
    )
    assert len(left) == len(right)
    return all(_equal(one, other) for one, other in zip(left, right, strict=True))


def _equal(one: Basic, other: Basic) -> bool:
    one, other = map(expand_func, (one, other))
    # Calls of the same function are compared by their arguments, which are easier.
    if one.func == other.func and one.func.__name__ in ("atan2", "Abs"):
        return all(_equal(*pair) for pair in zip(one.args, other.args, strict=True))
    return is_zero(one - other)


def test_euler_rates() -> None:
    assert same(euler_forms.euler_rates().inlined(), euler.euler_rates())


def test_euler_from_matrix_off_the_lock() -> None:
    # All that a rotation matrix knows of itself is in its elements as Euler angles.
    elements = dict(zip(quaternions.MATRIX, euler.rotation("I", "B"), strict=True))
    derived = quaternions.euler_from_matrix(quaternions.MATRIX)
    form = euler_forms.euler_from_matrix().inlined(0)
    for value, expected in zip(form, derived, strict=True):
        assert same(value.xreplace(elements), expected.xreplace(elements))


def test_euler_from_quaternion_off_the_lock() -> None:
    form = forms.euler_from_quaternion().inlined(0)
    assert same(form, quaternions.euler_from_quaternion())


@pytest.mark.parametrize("pole", [pi / 2, -pi / 2])
def test_at_the_lock_roll_zero_and_the_yaw_returned_rebuild_the_attitude(pole: Basic) -> None:
    there = euler.rotation("I", "B").subs(theta, pole)
    elements = dict(zip(quaternions.MATRIX, there, strict=True))
    roll, _, yaw = euler_forms.euler_from_matrix().inlined(1)
    sine, cosine = (part.xreplace(elements) for part in yaw.args)
    rebuilt = euler.rotation("I", "B").subs({phi: roll, theta: pole})
    rebuilt = rebuilt.xreplace({sin(psi): sine, cos(psi): cosine})
    assert roll == 0
    assert is_zero(sine**2 + cosine**2 - 1)
    assert same(ImmutableMatrix(rebuilt), ImmutableMatrix(there))


@pytest.mark.parametrize("pole", [pi / 2, -pi / 2])
def test_at_the_lock_matrix_and_quaternion_agree_on_yaw(pole: Basic) -> None:
    attitude = dict(zip(QUATERNION, quaternions.from_euler().subs(theta, pole), strict=True))
    elements = dict(
        zip(quaternions.MATRIX, euler.rotation("I", "B").subs(theta, pole), strict=True)
    )
    by_quaternion = forms.euler_from_quaternion().inlined(1)[2].subs(attitude)
    by_matrix = euler_forms.euler_from_matrix().inlined(1)[2].xreplace(elements)
    assert same(by_quaternion, by_matrix)


def test_matrix_from_quaternion() -> None:
    form = forms.matrix_from_quaternion().inlined()
    assert same(form, quaternions.matrix_from_any_quaternion())


@pytest.mark.parametrize(("branch", "sign"), [(0, 1), (1, -1)])
def test_quaternion_from_euler_up_to_its_sign(branch: int, sign: int) -> None:
    form = forms.quaternion_from_euler().inlined(branch)
    assert same(form, ImmutableMatrix(sign * quaternions.from_euler()))


@pytest.mark.parametrize(("branch", "row"), [(0, 1), (1, 2), (2, 3), (3, 0)])
def test_each_way_to_the_quaternion_of_a_matrix(branch: int, row: int) -> None:
    first, *_ = forms.quaternion_from_matrix().steps
    elements = dict(zip(quaternions.MATRIX, quaternions.matrix_from_quaternion(), strict=True))
    values = ImmutableMatrix([v.xreplace(elements) for v in first.branches[branch][1]])
    expected = 4 * QUATERNION[row] * quaternions.ATTITUDE
    assert all(expand(expand(v - e).subs(UNIT)) == 0 for v, e in zip(values, expected, strict=True))


def test_the_chosen_row_has_a_large_element_on_the_diagonal() -> None:
    # Two elements on the diagonal add up to two at least, by the sign of r_33; the condition
    # picks the larger of the two, so it is one at least.
    diagonal = further.products_from_matrix().diagonal()
    r_11, r_22, r_33 = quaternions.MATRIX.diagonal()
    conditions = [condition for condition, _ in forms.quaternion_from_matrix().steps[0].branches]
    assert expand(diagonal[1] + diagonal[2]) == 2 - 2 * r_33
    assert expand(diagonal[1] - diagonal[2]) == 2 * (r_11 - r_22)
    assert conditions[:2] == [(r_33 < 0) & (r_11 > r_22), r_33 < 0]
    assert expand(diagonal[0] + diagonal[3]) == 2 + 2 * r_33
    assert expand(diagonal[3] - diagonal[0]) == -2 * (r_11 + r_22)
    assert conditions[2] == (r_11 < -r_22)


def test_quaternion_and_axis_with_angle() -> None:
    x, y, z = AXIS
    length = sqrt(x**2 + y**2 + z**2)
    unit = ImmutableMatrix([x / length, y / length, z / length])
    derived = quaternions.from_axis_angle(unit, alpha)
    assert same(forms.quaternion_from_axis_angle().inlined(0), derived)
    axis, angle = quaternions.axis_angle_from_quaternion()
    form = forms.axis_angle_from_quaternion().inlined(1, 0, 1)
    assert same(form, ImmutableMatrix([*axis, angle.subs(a, Abs(a))]))


def test_inverse_and_rotations_of_vectors() -> None:
    assert same(forms.quaternion_inverse().inlined(), hamilton.inverse(quaternions.ATTITUDE))
    for form, derived in (
        (forms.rotate_to_inertial(), quaternions.rotate_to_inertial()),
        (forms.rotate_to_body(), quaternions.rotate_to_body()),
    ):
        assert same(form.inlined(), ImmutableMatrix(derived / NORM))


def test_inclination() -> None:
    assert same(forms.inclination().inlined(), quaternions.inclination())


def test_constant_rates_with_and_without_a_turn() -> None:
    derived = quaternions.constant_rate_step()
    assert same(forms.constant_rate_step().inlined(0), derived.replace(*_SINC))
    still = dict.fromkeys(symbols("p q r"), 0)
    by_name = {symbol: 0 for symbol in derived.free_symbols if symbol.name in map(str, still)}
    assert same(forms.constant_rate_step().inlined(1).subs(by_name), quaternions.ATTITUDE)


_SINC = (lambda value: value.func.__name__ == "sinc", lambda value: value.rewrite(sin).args[0][0])


def test_steps_of_the_gyros() -> None:
    turn = filters.gyro_turn().inlined(0, 0)
    assert same(turn, forms.constant_rate_step().inlined(0))
    still = ImmutableMatrix(filters.gyro_turn().inlined(1, 1))
    assert same(still, quaternions.ATTITUDE)
    predicted = [
        estimation.euler_step(*pair) for pair in zip(EULER, euler.euler_rates(), strict=True)
    ]
    assert same(filters.gyro_step().inlined(0), ImmutableMatrix(predicted))
    assert same(filters.gyro_step().inlined(1), ImmutableMatrix(EULER))


def test_tilt() -> None:
    # Neither without direction, nor straight up or down, nor at the end of the range.
    assert same(filter_forms.tilt().inlined(3, 0), estimation.tilt())


def test_the_reading_at_rest_is_that_of_euler_angles() -> None:
    attitude = dict(zip(QUATERNION, quaternions.from_euler(), strict=True))
    seen = ImmutableMatrix(further.gravity_seen().xreplace(attitude))
    assert same(g * seen, estimation.accelerometer_at_rest())


def test_the_turn_towards_a_reading_brings_what_is_expected_there() -> None:
    # Two directions at an angle of alpha to each other, about any axis at right angles to both.
    reading = ImmutableMatrix([1, 0, 0])
    expected = ImmutableMatrix([cos(alpha), sin(alpha), 0])
    values = dict(zip(ACCELEROMETER, reading, strict=True))
    values |= dict(zip(further.EXPECTED, expected, strict=True))
    turn = further.turn_towards().xreplace(values)
    # Below 180 degrees the angle is alpha itself.
    turn = turn.subs(sqrt(sin(alpha) ** 2), sin(alpha)).subs(atan2(sin(alpha), cos(alpha)), alpha)
    seen = hamilton.sandwich(hamilton.conjugate(ImmutableMatrix(turn)), expected)
    left = (1 - estimation.L) * alpha
    assert same(ImmutableMatrix(seen), ImmutableMatrix([cos(left), sin(left), 0]))


def test_observers() -> None:
    predicted = dict(zip(QUATERNION, filters.gyro_turn().inlined(0, 0), strict=True))
    turn = further.turn_towards()
    size = sum(map(Abs, ACCELEROMETER))
    scaled = {each: each / size for each in ACCELEROMETER}
    seen = further.gravity_seen()
    known = dict(zip(further.EXPECTED, seen, strict=True))
    turned = ImmutableMatrix(turn.xreplace(scaled).xreplace(known))
    derived = hamilton.multiply(quaternions.ATTITUDE, turned)
    # Numbers in place of symbols: a proof would have to simplify three nested roots.
    names = (*QUATERNION, *BODY_RATES, *ACCELEROMETER, T, estimation.L)
    values = (0.5, -0.5, 0.7, 0.1, 0.4, -1.1, 0.3, 1.0, -2.0, -9.0, 0.1, 0.3)
    form = lambdify(names, list(filters.observer_turn().inlined(0, 0, 0, 0)), cse=True)
    expected = lambdify(names, list(derived.xreplace(predicted)), cse=True)
    assert form(*values) == pytest.approx(expected(*values), abs=1e-14)
    unheard = filters.observer_turn().inlined(0, 0, 1, 1)
    assert same(unheard, filters.gyro_turn().inlined(0, 0))


def test_the_notes_observer() -> None:
    update = estimation.update_on_circle()
    guesses = filters.gyro_step().inlined(0)
    updated = [
        update.subs({estimation.predicted: guess, estimation.measured: seen})
        for guess, seen in zip(guesses[:2], estimation.tilt(), strict=True)
    ]
    found = filters.euler_observer_step().inlined(0, 3, 0, 0)
    for value, expected in zip(found, (*updated, guesses[2]), strict=True):
        assert expand(value - expected, func=True) == 0
    assert same(filters.euler_observer_step().inlined(0, 3, 0, 1), ImmutableMatrix(guesses))


def test_heading_and_factor() -> None:
    assert same(filter_forms.heading().inlined(0), validation.heading())
    size = sum(map(Abs, MAGNETOMETER))
    scaled = {each: each / size for each in MAGNETOMETER}
    assert same(filter_forms.factor().inlined(0, 0), validation.factor().xreplace(scaled))


def test_models_of_calibration() -> None:
    assert same(sensor_forms.measured().inlined(), calibration.measured())
    coupled = calibration.coupled()
    assert same(sensor_forms.measured(coupled).inlined(), calibration.measured(coupled))


def test_dead_reckoning_step() -> None:
    at_the_end = dead_reckoning.ACCELERATION + dead_reckoning.JERK * T
    values = dict(zip(reckoning_forms.NEXT, at_the_end, strict=True))
    derived = [*dead_reckoning.velocity_after_step(), *dead_reckoning.position_after_step()]
    assert same(ImmutableMatrix(reckoning_forms.step().subs(values)), ImmutableMatrix(derived))


def test_inlining_takes_the_branch_that_is_asked_for_and_keeps_what_is_open() -> None:
    x, y, z = symbols("x y z", real=True)
    form = Computation((Let(y, x + 1), Choice((z,), ((y > 0, (2 * y,)), otherwise(-y)))), z * x)
    assert same(form.inlined(0), 2 * x * (x + 1))
    assert same(form.inlined(1), -x * (x + 1))
    assert form.inlined().subs(x, 3) == 24
    assert form.inlined().subs(x, -3) == -6
