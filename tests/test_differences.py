"""How far attitudes are apart, interpolation, and series without jumps of sign."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from scipy.spatial.transform import Rotation, Slerp

import chr_notes
from chr_notes import (
    angle_between_attitudes,
    angle_between_verticals,
    continuous_quaternions,
    inclination_from_quaternion,
    slerp,
)

from .attitudes import of_quaternion

seeds = st.integers(0, 2**32 - 1)
scales = st.floats(1e-100, 1e100)
DOWN = np.array([0.0, 0.0, 1.0])


def random(seed: int, *shape: int) -> Any:  # noqa: ANN401 (arrays of any shape)
    return np.random.default_rng(seed).normal(size=(*shape, 4))


@given(seeds, scales, scales)
def test_angles_are_those_of_scipy_whatever_norm_and_sign(
    seed: int, scale: float, other: float
) -> None:
    p, q = random(seed, 2)
    expected = (of_quaternion(p).inv() * of_quaternion(q)).magnitude()
    assert_allclose(angle_between_attitudes(scale * p, -other * q), expected, atol=1e-14)
    seen = [of_quaternion(each).inv().apply(DOWN) for each in (p, q)]
    tilt = np.arctan2(np.linalg.norm(np.cross(*seen)), np.dot(*seen))
    assert_allclose(angle_between_verticals(scale * p, -other * q), tilt, atol=1e-14)
    assert angle_between_verticals(p, q) <= angle_between_attitudes(p, q) + 1e-14


@pytest.mark.parametrize("angle", [0.0, 1e-300, 1e-12, 1e-3, 1.5, np.pi - 1e-9, np.pi])
def test_small_and_large_angles_keep_their_digits(angle: float) -> None:
    start = random(3)
    tilted = chr_notes.quaternion_multiply(
        chr_notes.quaternion_from_axis_angle([0.6, -0.8, 0.0], angle), start
    )
    yawed = chr_notes.quaternion_multiply(
        chr_notes.quaternion_from_axis_angle([0.0, 0.0, 1.0], angle), start
    )
    for found in (
        angle_between_attitudes(start, tilted),
        angle_between_attitudes(start, yawed),
        angle_between_verticals(start, tilted),
    ):
        assert_allclose(found, angle, rtol=1e-9, atol=1e-15)
    assert angle_between_verticals(start, yawed) < 1e-15


@given(seeds, scales)
def test_inclination_is_the_angle_of_the_third_axis(seed: int, scale: float) -> None:
    q = random(seed, 5)
    expected = np.arccos(np.clip(of_quaternion(q).apply(DOWN)[:, 2], -1, 1))
    assert_allclose(inclination_from_quaternion(scale * q), expected, atol=1e-7)


@given(seeds, st.floats(0, 1), scales)
def test_slerp_is_scipys(seed: int, share: float, scale: float) -> None:
    p, q = random(seed, 2)
    expected = Slerp([0, 1], Rotation.concatenate([of_quaternion(p), of_quaternion(q)]))(share)
    found = slerp(scale * p, -q, share)
    assert (expected.inv() * of_quaternion(found)).magnitude() < 1e-13
    assert_allclose(np.linalg.norm(found), 1, rtol=1e-14)
    assert found @ p >= -1e-14


def test_slerp_ends_where_it_should_and_broadcasts() -> None:
    p, q = random(5, 2)
    way = slerp(p, q, np.linspace(0, 1, 5))
    assert way.shape == (5, 4)
    assert_allclose(way[0], p / np.linalg.norm(p), atol=1e-15)
    assert_allclose(angle_between_attitudes(way[:-1], way[1:]), angle_between_attitudes(p, q) / 4)
    assert_allclose(slerp(p, p, 0.3), p / np.linalg.norm(p), atol=1e-15)
    assert_allclose(slerp(p, -p, 0.3), p / np.linalg.norm(p), atol=1e-15)


@given(seeds)
def test_a_series_of_any_signs_becomes_one_without_jumps(seed: int) -> None:
    generator = np.random.default_rng(seed)
    rates = generator.normal(0, 3, (200, 3))
    euler = chr_notes.integrate_gyro(rates, 0.05)
    q = chr_notes.quaternion_from_euler(euler)
    found = continuous_quaternions(q * generator.choice([-1.0, 1.0], (200, 1)))
    assert (np.einsum("ij,ij->i", found[1:], found[:-1]) > 0).all()
    assert_array_equal(np.abs(found), np.abs(q))


def test_missing_rows_are_passed_over() -> None:
    q = chr_notes.quaternion_from_axis_angle([1.0, 0.0, 0.0], np.radians([170.0, 180.0, 190.0]))
    q[1] = np.nan
    given_ = q.copy()
    found = continuous_quaternions(q)
    assert np.isnan(found[1]).all()
    assert found[0] @ found[2] > 0
    assert_array_equal(q, given_)
    assert continuous_quaternions(np.zeros((0, 4))).shape == (0, 4)
    assert np.isnan(angle_between_attitudes(q[1], q[0]))
    assert np.isnan(angle_between_verticals(q[1], q[0]))
    assert np.isnan(slerp(q[1], q[0], 0.5)).all()


ONE, NONE = [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]
REFUSED = {
    "zero first": (lambda: angle_between_attitudes([ONE, NONE], ONE), r"p: .*\(1,\)"),
    "zero second": (lambda: angle_between_attitudes(ONE, NONE), "q: "),
    "verticals, zero first": (lambda: angle_between_verticals([ONE, NONE], ONE), r"p: .*\(1,\)"),
    "verticals, zero second": (lambda: angle_between_verticals(ONE, NONE), "q: "),
    "slerp from zero": (lambda: slerp(NONE, ONE, 0.5), "p: "),
    "slerp to zero": (lambda: slerp(ONE, NONE, 0.5), "q: "),
    "a share beyond": (
        lambda: slerp(ONE, ONE, [0.5, 1.5]),
        r"share: .* 0 to 1, got 1\.5 at index \(1,\)",
    ),
    "one share beyond": (lambda: slerp(ONE, ONE, 1.5), r"share: .* 0 to 1, got 1\.5$"),
    "one quaternion": (lambda: continuous_quaternions(ONE), r"q: expected shape \(N, 4\)"),
    "zero inclination": (lambda: inclination_from_quaternion(NONE), "q: "),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()
