"""Any three turns: against SciPy, at the locks, and as the rest of the package has it."""

import warnings
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes.derivations import sequences as derived
from chr_notes.generated.scalar.sequences import angles_from_quaternion
from chr_notes.sequences import SEQUENCES

from .attitudes import of_quaternion
from .sampling import few

EACH = pytest.mark.parametrize("sequence", SEQUENCES)
TURN = st.floats(-3.2, 3.2)
Angles = tuple[float, float, float]


def apart(matrix: np.ndarray, expected: Rotation) -> np.ndarray:
    """Angles between what matrices of this package turn and rotations of SciPy."""
    found = Rotation.from_matrix(np.swapaxes(matrix, -1, -2))
    return np.asarray((found.inv() * expected).magnitude())


def proper(sequence: str) -> bool:
    return sequence[0] == sequence[2]


def attitudes(sequence: str) -> np.ndarray:
    """Random angles, and the locks with what is next to them."""
    random = np.random.default_rng(3)
    angles = random.uniform(-np.pi, np.pi, (60, 3))
    off = [0.0, 1e-16, 1e-15, 3e-15, 1e-12, 1e-8, 1e-4]
    lock = (0.0, np.pi) if proper(sequence) else (np.pi / 2, -np.pi / 2)
    for place, at in enumerate(lock):
        inside = np.add(off, at) if at <= 0 else np.subtract(at, off)
        angles[10 * place : 10 * place + 7, 1] = inside
    return angles


def test_the_sequences_are_those_that_are_derived() -> None:
    assert (*derived.ROTATING, *derived.FIXED) == SEQUENCES


@EACH
def test_agrees_with_scipy_at_the_locks_too(sequence: str) -> None:
    angles = attitudes(sequence)
    expected = Rotation.from_euler(sequence, angles)
    matrix = chr_notes.matrix_from_angles(angles, sequence)
    assert apart(matrix, expected).max() < 1e-14
    q = chr_notes.quaternion_from_angles(angles, sequence)
    assert (of_quaternion(q).inv() * expected).magnitude().max() < 1e-14
    assert (q[:, 0] >= 0).all()
    for function, given_ in (
        (chr_notes.angles_from_matrix, matrix),
        (chr_notes.angles_from_quaternion, q * 3),
    ):
        back = function(given_, sequence, on_gimbal_lock="ignore")
        again = chr_notes.matrix_from_angles(back, sequence)
        assert apart(again, expected).max() < 1e-14
        low, high = (0, np.pi) if proper(sequence) else (-np.pi / 2, np.pi / 2)
        assert low <= back[:, 1].min()
        assert back[:, 1].max() <= high
        last = 2 if sequence.isupper() else 0
        # Right at the locks, and nowhere among the random ones.
        assert (back[[0, 1, 2, 10, 11, 12], last] == 0).all()
        assert (back[20:, last] != 0).all()
        usual = Rotation.as_euler(expected[20:], sequence)
        assert_allclose(np.exp(1j * back[20:]), np.exp(1j * usual), atol=1e-12)


@few(10)
@given(angles=st.tuples(TURN, TURN, TURN))
def test_yaw_pitch_roll_are_those_of_the_package(angles: Angles) -> None:
    euler = angles[::-1]
    matrix = chr_notes.matrix_from_euler(euler)
    assert_allclose(chr_notes.matrix_from_angles(angles, "ZYX"), matrix, atol=4e-16)
    assert_allclose(chr_notes.matrix_from_angles(euler, "xyz"), matrix, atol=4e-16)
    rates = chr_notes.euler_rates_matrix(euler)
    near = {"rtol": 1e-13, "atol": 1e-300}  # smaller numbers lose digits
    assert_allclose(chr_notes.angle_rates_matrix(angles, "ZYX"), rates[::-1], **near)
    assert_allclose(chr_notes.angle_rates_matrix(euler, "xyz"), rates, **near)
    q = chr_notes.quaternion_from_euler(euler)
    back = chr_notes.euler_from_quaternion(q, on_gimbal_lock="ignore")
    found = chr_notes.angles_from_quaternion(q, "xyz", on_gimbal_lock="ignore")
    assert_allclose(np.exp(1j * found), np.exp(1j * back), atol=1e-14)


@EACH
def test_rates_are_those_that_are_derived(sequence: str) -> None:
    angles = np.array([0.7, 1.1, -1.3])
    step = 1e-6
    matrix = chr_notes.matrix_from_angles(angles, sequence)
    columns = []
    for one in np.eye(3):
        ahead, behind = (
            chr_notes.matrix_from_angles(angles + sign * step * one, sequence) for sign in (1, -1)
        )
        skew = matrix @ ((ahead - behind) / (2 * step)).T
        columns.append([skew[2, 1], skew[0, 2], skew[1, 0]])
    found = chr_notes.angle_rates_matrix(angles, sequence)
    assert_allclose(found @ np.transpose(columns), np.eye(3), atol=1e-8)


def test_at_the_lock_there_are_no_rates() -> None:
    d = chr_notes.angle_rates_matrix([0.3, 0.0, 0.2], "ZXZ")
    assert np.isnan(d[[0, 2]]).all()
    assert np.isfinite(d[1]).all()


def test_a_small_tilt_keeps_all_its_digits() -> None:
    q = chr_notes.quaternion_from_angles([0.5, 1e-9, 0.25], "ZYZ")
    assert_allclose(chr_notes.angles_from_quaternion(q, "ZYZ"), [0.5, 1e-9, 0.25], rtol=1e-12)


def test_the_lock_is_told() -> None:
    level = np.broadcast_to(np.eye(3), (2, 3, 3))
    with pytest.warns(chr_notes.GimbalLockWarning, match="2 attitude.* angle of the last turn"):
        assert (chr_notes.angles_from_matrix(level, "ZYZ") == 0).all()
    with pytest.raises(chr_notes.GimbalLockError) as caught:
        chr_notes.angles_from_quaternion(
            [[1, 2, 3, 4], [1, 0, 0, 0]], "XYX", on_gimbal_lock="raise"
        )
    assert caught.value.indices == ((1,),)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        chr_notes.angles_from_matrix(level, "ZYX")


@pytest.mark.usefixtures("each_way")
@pytest.mark.parametrize("sequence", ["XYZ", "ZXY", "XZY", "YXY"])
def test_a_half_turn_has_the_same_sign_as_in_floats(sequence: str) -> None:
    turns = np.array([q for q in product((0.0, 1.0, -1.0), repeat=4) if any(q)])
    found = chr_notes.angles_from_quaternion(turns, sequence, on_gimbal_lock="ignore")
    axes = [1.0 + "XYZ".index(letter) for letter in sequence]
    expected = [angles_from_quaternion(*turn, *axes)[:3] for turn in turns.tolist()]
    assert_allclose(found, expected, atol=1e-15)


@pytest.mark.parametrize("sequence", ["ZYX", "zxz"])
def test_shapes_nan_and_results_given(sequence: str) -> None:
    angles = np.random.default_rng(1).uniform(-1, 1, (2, 5, 3))
    angles[1, 2, 0] = np.nan
    for function, last in (
        (chr_notes.matrix_from_angles, (3, 3)),
        (chr_notes.quaternion_from_angles, (4,)),
        (chr_notes.angle_rates_matrix, (3, 3)),
    ):
        found = function(angles, sequence)
        assert found.shape == (2, 5, *last)
        assert np.isnan(found[1, 2]).all()
        assert np.isnan(found).sum() == np.prod(last)
        out = np.empty_like(found)
        assert function(angles, sequence, out=out) is out
        np.testing.assert_array_equal(out, found)
    for function, given_ in (
        (chr_notes.angles_from_quaternion, chr_notes.quaternion_from_angles(angles, sequence)),
        (chr_notes.angles_from_matrix, chr_notes.matrix_from_angles(angles, sequence)),
    ):
        found = function(given_, sequence)
        assert np.isnan(found[1, 2]).all()
        out = np.empty_like(found)
        assert function(given_, sequence, out=out) is out
        np.testing.assert_array_equal(out, found)


@pytest.mark.parametrize("sequence", ["zYX", "ZZX", "ABC", "ZY", ""])
def test_what_is_no_sequence_is_refused(sequence: str) -> None:
    with pytest.raises(ValueError, match=rf"sequence: expected three .* got '{sequence}'"):
        chr_notes.matrix_from_angles([0, 0, 0], sequence)


def test_wrong_input_is_refused() -> None:
    with pytest.raises(ValueError, match=r"angles: expected shape \(\.\.\., 3\)"):
        chr_notes.matrix_from_angles([0, 0], "xyz")
    with pytest.raises(ValueError, match="matrix: expected rotations"):
        chr_notes.angles_from_matrix(2 * np.eye(3), "xyz")
    with pytest.raises(ValueError, match="q: expected no row of zeros"):
        chr_notes.angles_from_quaternion([0, 0, 0, 0], "xyz")
