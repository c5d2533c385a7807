"""Routes between attitudes: rotations that come out are those that went in, up to the pole."""

import pickle
import tracemalloc
import warnings
from collections.abc import Callable

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes._rows import BLOCK

Floats = NDArray[np.float64]
RNG_SEED = 20
LOCK = chr_notes.GimbalLockWarning


def random_quaternions(count: int, seed: int = RNG_SEED) -> Floats:
    quaternions = np.random.default_rng(seed).normal(size=(count, 4))
    return quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)


def special_quaternions() -> Floats:
    """All octants, half turns, quarter turns, and both signs of each."""
    digits = np.array(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 4)).reshape(4, -1).T
    return digits[np.any(digits, axis=1)]


def near_the_pole(distance: float, count: int) -> Floats:
    """Quaternions whose pitch is that far from ±90°, up to rounding."""
    rng = np.random.default_rng(RNG_SEED)
    roll, yaw = rng.uniform(-np.pi, np.pi, (2, count))
    pitch = rng.choice([-1.0, 1.0], count) * (np.pi / 2 - distance)
    return Rotation.from_euler("ZYX", np.stack([yaw, pitch, roll], 1)).as_quat(scalar_first=True)


def scipy(q: Floats) -> Rotation:
    # SciPy's own normalisation loses denormal numbers and overflows for huge ones.
    return Rotation.from_quat(q / np.abs(q).max(axis=-1, keepdims=True), scalar_first=True)


def assert_same_rotation(first: Rotation, second: Rotation, tolerance: float = 1e-12) -> None:
    assert (first.inv() * second).magnitude().max() < tolerance


def by_matrix(q: Floats) -> Floats:
    return chr_notes.euler_from_matrix(chr_notes.matrix_from_quaternion(q), on_gimbal_lock="ignore")


def by_quaternion(q: Floats) -> Floats:
    return chr_notes.euler_from_quaternion(q, on_gimbal_lock="ignore")


EVERY = np.concatenate(
    [
        random_quaternions(2000),
        special_quaternions(),
        *(near_the_pole(distance, 200) for distance in (1e-7, 1e-11, 1e-14, 3e-15, 0.0)),
        5e-324 * np.array([[1, 0, 0, 0], [3, -2, 1, 4], [0, 0, -7, 0]]),
        1e-310 * random_quaternions(20),
        1e-200 * random_quaternions(20),
        1e308 * random_quaternions(20),
    ]
)


def test_matrix_from_quaternion() -> None:
    matrix = chr_notes.matrix_from_quaternion(EVERY)
    assert_allclose(matrix, scipy(EVERY).inv().as_matrix(), atol=1e-15)


@pytest.mark.parametrize("route", [by_quaternion, by_matrix])
def test_euler_angles_rebuild_the_rotation(route: Callable[[Floats], Floats]) -> None:
    euler = route(EVERY)
    assert np.isfinite(euler).all()
    assert (np.abs(euler) <= [np.pi, np.pi / 2, np.pi]).all()
    assert_same_rotation(Rotation.from_euler("ZYX", euler[:, ::-1]), scipy(EVERY))
    assert_same_rotation(scipy(chr_notes.quaternion_from_euler(euler)), scipy(EVERY))


@pytest.mark.parametrize(
    "route",
    [
        lambda q: chr_notes.quaternion_from_matrix(chr_notes.matrix_from_quaternion(q)),
        lambda q: chr_notes.quaternion_from_euler(by_quaternion(q)),
        lambda q: chr_notes.quaternion_from_axis_angle(*chr_notes.axis_angle_from_quaternion(q)),
    ],
)
def test_quaternions_are_unit_with_a_positive_scalar_part(
    route: Callable[[Floats], Floats],
) -> None:
    quaternion = route(EVERY)
    assert (quaternion[:, 0] >= 0).all()
    assert_allclose(np.linalg.norm(quaternion, axis=1), 1, atol=1e-15)
    assert_same_rotation(scipy(quaternion), scipy(EVERY))


@pytest.mark.parametrize("axis", range(3))
def test_half_a_turn_about_an_axis_of_the_frame_has_that_axis(axis: int) -> None:
    expected = np.eye(4)[axis + 1]
    matrix = np.diag(2 * np.eye(3)[axis] - 1)
    assert_array_equal(chr_notes.quaternion_from_matrix(matrix), expected)
    assert_array_equal(chr_notes.axis_angle_from_quaternion(expected)[0], expected[1:])


def test_axis_and_angle() -> None:
    axis, angle = chr_notes.axis_angle_from_quaternion(EVERY)
    assert_allclose(np.linalg.norm(axis, axis=1), 1, atol=1e-15)
    assert ((angle >= 0) & (angle <= np.pi)).all()
    assert_same_rotation(Rotation.from_rotvec(axis * angle[:, np.newaxis]), scipy(EVERY))
    still_axis, still = chr_notes.axis_angle_from_quaternion([-3.0, 0.0, 0.0, 0.0])
    assert_array_equal(still_axis, [1, 0, 0])
    assert still == 0


def test_small_turns_keep_their_digits() -> None:
    angles = 10.0 ** -np.arange(0.0, 150.0, 0.5)
    axis = np.array([1.0, -2.0, 2.0]) / 3
    found = chr_notes.axis_angle_from_quaternion(chr_notes.quaternion_from_axis_angle(axis, angles))
    assert_allclose(found[1], angles, rtol=1e-15)
    assert_allclose(found[0], np.broadcast_to(axis, (len(angles), 3)), rtol=1e-15)


@given(st.floats(-700, 700), st.tuples(*[st.floats(-1, 1)] * 3), st.floats(-10, 10))
def test_axis_has_any_length(
    exponent: float, axis: tuple[float, float, float], angle: float
) -> None:
    if np.linalg.norm(axis) < 0.01:
        return
    there = chr_notes.quaternion_from_axis_angle(axis, angle)
    assert_allclose(
        chr_notes.quaternion_from_axis_angle(np.array(axis) * np.exp(exponent), angle),
        there,
        atol=1e-14,
    )
    turned = Rotation.from_rotvec(angle * np.array(axis) / np.linalg.norm(axis))
    assert_same_rotation(scipy(np.array([there])), turned)


def test_vectors_are_rotated_there_and_back() -> None:
    vectors = np.random.default_rng(RNG_SEED).normal(size=(len(EVERY), 3))
    turned = chr_notes.rotate_to_inertial(EVERY, vectors)
    assert_allclose(turned, scipy(EVERY).apply(vectors), atol=1e-14)
    assert_allclose(chr_notes.rotate_to_body(EVERY, turned), vectors, atol=1e-14)
    matrices = chr_notes.matrix_from_quaternion(EVERY)
    by_product = np.einsum("nij,nj->ni", matrices, turned)
    assert_allclose(chr_notes.rotate_to_body(EVERY, turned), by_product, atol=1e-14)


def exact_euler(q: Floats) -> Floats:
    """Euler angles of quaternions by mpmath with 50 digits, by the formulas of the matrix."""
    context = mpmath.mp.clone()
    context.dps = 50
    rows = []
    for a, b, c, d in ([context.mpf(float(x)) for x in row] for row in q):
        length = a * a + b * b + c * c + d * d
        roll = context.atan2(2 * (a * b + c * d), a * a - b * b - c * c + d * d)
        pitch = context.asin(max(-1, min(1, 2 * (a * c - b * d) / length)))
        yaw = context.atan2(2 * (a * d + b * c), a * a + b * b - c * c - d * d)
        rows.append([roll, pitch, yaw])
    return np.array(rows, dtype=object)


@pytest.mark.parametrize(
    "q",
    [
        pytest.param(random_quaternions(100_000), id="random"),
        pytest.param(near_the_pole(1e-3, 2000), id="1e-3"),
        pytest.param(near_the_pole(1e-6, 2000), id="1e-6"),
        pytest.param(near_the_pole(1e-9, 2000), id="1e-9"),
    ],
)
def test_each_euler_angle_is_right_to_1e_15(q: Floats, samples: Callable[[int, int], int]) -> None:
    q = q[: samples(5_000, 100_000)]
    off = np.abs((by_quaternion(q) - exact_euler(q)).astype(np.float64))
    assert np.minimum(off, np.abs(off - 2 * np.pi)).max() <= 1e-15


@pytest.mark.parametrize("pole", [np.pi / 2, -np.pi / 2])
def test_at_a_pole(pole: float) -> None:
    rng = np.random.default_rng(RNG_SEED)
    euler = np.column_stack(
        [rng.uniform(-np.pi, np.pi, 400), np.full(400, pole), rng.uniform(-np.pi, np.pi, 400)]
    )
    attitude = Rotation.from_euler("ZYX", euler[:, ::-1])
    routes: list[tuple[Callable[..., Floats], Floats]] = [
        (chr_notes.euler_from_quaternion, chr_notes.quaternion_from_euler(euler)),
        (chr_notes.euler_from_quaternion, attitude.as_quat(scalar_first=True)),
        (chr_notes.euler_from_matrix, chr_notes.matrix_from_euler(euler)),
        (chr_notes.euler_from_matrix, attitude.inv().as_matrix()),
    ]
    for route, given_attitude in routes:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            found = route(given_attitude)
        assert [warning.category for warning in caught] == [LOCK]
        assert caught[0].filename == __file__
        assert_array_equal(found[:, 0], 0)
        assert_allclose(found[:, 1], pole, rtol=0, atol=2e-15)
        assert_same_rotation(Rotation.from_euler("ZYX", found[:, ::-1]), attitude)
        # Warnings are errors here, so silence is checked too.
        assert_array_equal(route(given_attitude, on_gimbal_lock="ignore"), found)
        with pytest.raises(chr_notes.GimbalLockError) as error:
            route(given_attitude, on_gimbal_lock="raise")
        assert error.value.indices == tuple((row,) for row in range(400))


@pytest.mark.parametrize("distance", [4e-15, 1e-14, 1e-12, 1e-9, 1e-3])
def test_off_a_pole_nothing_is_set_to_zero(distance: float) -> None:
    q = near_the_pole(distance, 500)
    # A warning would be an error.
    assert (chr_notes.euler_from_quaternion(q)[:, 0] != 0).all()
    matrix = chr_notes.matrix_from_euler([0.4, np.pi / 2 - distance, 0.3])
    roll = chr_notes.euler_from_matrix(matrix)[0]
    # cos(pitch) is known to a rounding of pi/2, sin(roll) cos(pitch) to one of 1.
    assert_allclose(roll, 0.4, atol=1e-15 / distance)


def test_lock_is_where_only_rounding_tells_the_pitch_from_90_degrees() -> None:
    q = near_the_pole(1e-15, 500)
    for route, attitude in (
        (chr_notes.euler_from_quaternion, q),
        (chr_notes.euler_from_matrix, scipy(q).inv().as_matrix()),
    ):
        with pytest.warns(LOCK, match=r"^500 attitude"):
            assert (route(attitude)[:, 0] == 0).all()


def test_lock_in_several_dimensions_and_blocks_is_named_by_its_place() -> None:
    q = random_quaternions(3 * BLOCK).reshape(3, BLOCK, 4)
    q[0, 5] = q[2, 7] = [1, 0, 1, 0]
    with pytest.raises(chr_notes.GimbalLockError, match=r"got 2 .* index \(0, 5\)") as error:
        chr_notes.euler_from_quaternion(q, on_gimbal_lock="raise")
    assert error.value.indices == ((0, 5), (2, 7))
    with pytest.raises(chr_notes.GimbalLockError, match=r"index \(\)"):
        chr_notes.euler_from_quaternion([1, 0, 1, 0], on_gimbal_lock="raise")


@pytest.mark.parametrize("mode", ["warn", "ignore"])
def test_attitudes_that_are_all_at_lock_take_no_more_memory(mode: str) -> None:
    q = np.tile([1.0, 0.0, 1.0, 0.0], (1_000_000, 1))
    tracemalloc.start()
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            euler = chr_notes.euler_from_quaternion(q, on_gimbal_lock=mode)  # type: ignore[arg-type] # one of the three
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak - euler.nbytes < 8_000_000
    said = [str(warning.message).split(":")[0] for warning in caught]
    expected = "1000000 attitude(s) at gimbal lock, the first at index (0,)"
    assert said == ([expected] if mode == "warn" else [])


def test_the_error_comes_back_from_another_process_as_it_was() -> None:
    error = chr_notes.GimbalLockError(((2, 1), (3, 0)))
    back = pickle.loads(pickle.dumps(error))  # noqa: S301 # made in the line itself
    assert (back.indices, str(back)) == (error.indices, str(error))


def test_axis_of_a_turn_that_is_no_number_is_none_either() -> None:
    axis, angle = chr_notes.axis_angle_from_quaternion([[1, np.nan, 0, 0], [1, 0, 0, 0]])
    assert_array_equal(axis, [[np.nan] * 3, [1, 0, 0]])
    assert_array_equal(angle, [np.nan, 0])


def test_an_unknown_way_to_deal_with_lock_is_refused() -> None:
    for route, attitude in (
        (chr_notes.euler_from_quaternion, [1, 0, 0, 0]),
        (chr_notes.euler_from_matrix, np.eye(3)),
    ):
        with pytest.raises(ValueError, match=r"expected one of \('warn', .* got 'loudly'"):
            route(attitude, on_gimbal_lock="loudly")  # type: ignore[operator] # wrong on purpose


@pytest.mark.parametrize("size", [1e-20, 1e-149, 1e-160, 1e-300, 5e-324])
def test_the_smallest_turns_have_an_axis(size: float) -> None:
    axis, angle = chr_notes.axis_angle_from_quaternion([-1.0, 0.0, size, -size])
    assert_allclose(axis, np.array([0.0, -1.0, 1.0]) / np.sqrt(2), rtol=1e-15)
    assert_allclose(angle, 2 * np.hypot(size, size), rtol=1e-15)
