"""The fixed-gain observer."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import chr_notes
from chr_notes import fixed_gain_observer, integrate_gyro, observe, tilt_from_accelerometer
from chr_notes.simulation import at_rest, ideal_readings, swing, trajectory
from tests.attitudes import apart, inclinations_apart, turns
from tests.sampling import few

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
roll_angles = st.floats(-np.pi, np.pi)
methods = st.sampled_from(["quaternion", "euler"])
off_the_pole = st.floats(-1.55, 1.55)
LEVEL = np.array([0.0, 0.0, -9.80665])


@given(seeds, methods)
@few(20)
def test_no_gain_leaves_the_gyros_and_full_gain_the_accelerometer(seed: int, method: str) -> None:
    generator = np.random.default_rng(seed)
    rates = generator.normal(0, 0.3, (30, 3))
    forces = LEVEL + generator.normal(0, 3.0, (30, 3))
    steps = generator.uniform(0.001, 0.02, 30)
    alone = fixed_gain_observer(rates, forces, steps, 0.0, (0.1, 0.2, 0.3), method=method)
    gyros = integrate_gyro(rates, steps, (0.1, 0.2, 0.3), method=method)
    assert_allclose(alone, gyros, atol=1e-13)
    led = fixed_gain_observer(rates, forces, steps, 1.0, method=method)
    tilt = tilt_from_accelerometer(forces)
    assert_allclose(np.exp(1j * led[:, :2]), np.exp(1j * tilt), atol=1e-12)


@given(st.floats(0.001, 1.0), roll_angles, off_the_pole, roll_angles, st.floats(-1.5, 1.5))
@few(50)
def test_a_still_sensor_converges_to_its_tilt(
    gain: float, roll: float, pitch: float, first_roll: float, first_pitch: float
) -> None:
    count = int(30 / gain)
    forces = np.tile(chr_notes.accelerometer_at_rest([roll, pitch, 0.0]), (count, 1))
    initial = (first_roll, first_pitch, 0.5)
    start = inclinations_apart(initial, [roll, pitch, 0.0])
    if np.pi - start < 1e-6:  # upside down, no way is the shorter one
        return
    found = fixed_gain_observer(np.zeros((count, 3)), forces, 0.01, gain, initial)
    shares = (1 - gain) ** np.arange(1, count + 1)
    # The angle between what is expected and what is measured, by the same share each sample.
    off = inclinations_apart(found, [roll, pitch, 0.0])
    assert_allclose(off, start * shares, atol=5e-8)
    # All turns are about one level axis, so the whole is one turn about it.
    whole = apart(found[-1], initial)
    assert_allclose(whole, start * (1 - shares[-1]), atol=1e-6)


@given(st.floats(0.001, 1.0), roll_angles, off_the_pole, roll_angles, st.floats(-1.5, 1.5))
@few(50)
def test_the_notes_step_moves_each_angle_by_its_share(
    gain: float, roll: float, pitch: float, first_roll: float, first_pitch: float
) -> None:
    count = int(30 / gain)
    forces = np.tile(chr_notes.accelerometer_at_rest([roll, pitch, 0.0]), (count, 1))
    initial = (first_roll, first_pitch, 0.5)
    found = fixed_gain_observer(np.zeros((count, 3)), forces, 0.01, gain, initial, method="euler")
    assert inclinations_apart(found[-1], [roll, pitch, 0.0]) < 1e-8
    assert_allclose(found[-1, 2], 0.5)
    # The way there is the shorter one.
    off = np.angle(np.exp(1j * (found[:, 0] - roll)))
    start = np.angle(np.exp(1j * (first_roll - roll)))
    if abs(abs(start) - np.pi) > 1e-6:
        assert_allclose(off[:20], start * (1 - gain) ** np.arange(1, 21)[: len(off)], atol=1e-8)
    shares = (1 - gain) ** np.arange(1, count + 1)
    assert_allclose(found[:, 1] - pitch, (first_pitch - pitch) * shares, atol=1e-8)


def test_opposite_to_what_is_expected_the_reading_is_not_heard() -> None:
    found = fixed_gain_observer(np.zeros((3, 3)), np.tile(-LEVEL, (3, 1)), 0.01, 0.5, (0, 0, 0.2))
    assert_allclose(found, np.tile([0, 0, 0.2], (3, 1)), atol=1e-15)


def test_fast_turns_are_followed_as_far_as_the_gyros_can() -> None:
    # 700 deg/s at 100 Hz with perfect sensors.
    time = np.arange(2000) * 0.01

    def rates(at: Floats) -> Floats:
        turning = np.stack([np.cos(3 * at), np.sin(2 * at), np.full(len(at), 0.5)], axis=1)
        return np.radians(600) * turning

    fine = np.arange(2000 * 50) * 0.01 / 50
    truth = integrate_gyro(rates(fine), 0.01 / 50, method="quaternion")[49::50]
    forces, gyros = chr_notes.accelerometer_at_rest(truth), rates(time + 0.005)

    def off(found: Floats) -> float:
        return float(np.degrees(np.sqrt(np.mean(inclinations_apart(found, truth) ** 2))))

    alone = off(integrate_gyro(gyros, 0.01, method="quaternion"))
    for gain in (0.005, 0.02):
        assert off(fixed_gain_observer(gyros, forces, 0.01, gain)) < alone < 0.1


@given(seeds, st.floats(-3.0, 3.0))
@few(20)
def test_turning_the_world_about_the_vertical_changes_yaw_alone(seed: int, turn: float) -> None:
    generator = np.random.default_rng(seed)
    rates = generator.normal(0, 0.5, (200, 3))
    forces = LEVEL + generator.normal(0, 4.0, (200, 3))
    initial = np.array([0.3, -0.2, 0.1])
    one = fixed_gain_observer(rates, forces, 0.02, 0.05, initial)
    other = fixed_gain_observer(rates, forces, 0.02, 0.05, initial + np.array([0, 0, turn]))
    assert_allclose(other[:, :2], one[:, :2], atol=1e-9)
    assert_allclose(np.exp(1j * (other[:, 2] - one[:, 2])), np.exp(1j * turn), atol=1e-9)


@given(seeds, st.floats(1e-3, 1e3))
@few(20)
def test_the_scale_of_the_accelerometer_does_not_matter(seed: int, scale: float) -> None:
    generator = np.random.default_rng(seed)
    rates, forces = generator.normal(size=(2, 50, 3))
    one = fixed_gain_observer(rates, forces, 0.01, 0.1)
    assert_allclose(fixed_gain_observer(rates, scale * forces, 0.01, 0.1), one, atol=1e-11)


def test_rolls_near_180_degrees_are_averaged_the_short_way() -> None:
    roll = np.radians(179.9) + np.radians(5) * np.random.default_rng(0).normal(size=2000)
    forces = chr_notes.accelerometer_at_rest(np.stack([roll, 0 * roll, 0 * roll], axis=1))
    found = fixed_gain_observer(np.zeros((2000, 3)), forces, 0.01, 0.02)
    assert inclinations_apart(found[200:], np.radians([179.9, 0, 0])).max() < np.radians(3)
    assert (found[:, 0] >= -np.pi).all()
    assert (found[:, 0] < np.pi).all()


@pytest.mark.parametrize("gain", [0.005, 0.02, 0.2])
def test_a_loop_through_the_pole_is_followed(gain: float) -> None:
    time = np.arange(0, 20, 0.005)
    loop = swing(time, [0.2, 0.0, 0.3], [0.1, 0.0, 0.1], slope=[0.0, np.pi / 5, 0.0])
    truth = trajectory(time, loop, at_rest(time))
    ideal = ideal_readings(truth)
    found = fixed_gain_observer(ideal.body_rates, ideal.accel, 0.005, gain, truth.euler[0])
    # 0.2° is the half step by which the rates, read at the end of each step, are late.
    assert apart(found, truth.euler).max() < np.radians(0.5)


@pytest.mark.parametrize("pitch_deg", [-89.9, -80.0, 20.0, 75.1, 89.9])
def test_the_prediction_is_an_exact_turn_or_the_step_of_the_notes(pitch_deg: float) -> None:
    start, rates, unread = np.radians([20.0, pitch_deg, 50.0]), [0.9, 0.2, -0.3], [[np.nan] * 3]
    found = fixed_gain_observer([rates], unread, 0.1, 0.0, start)
    expected = turns(start) * Rotation.from_rotvec(0.1 * np.array(rates))
    assert (turns(found[0]).inv() * expected).magnitude() < 1e-14
    found = fixed_gain_observer([rates], unread, 0.1, 0.0, start, method="euler")
    euler_rates = chr_notes.euler_rates_from_body_rates(start, rates)
    assert_allclose(
        turns(found[0]).as_matrix(), turns(start + 0.1 * euler_rates).as_matrix(), atol=1e-12
    )


def test_straight_up_nothing_breaks() -> None:
    forces = np.tile([9.81, 0.0, 0.0], (200, 1))
    rates = np.random.default_rng(0).normal(0, 0.01, (200, 3))
    found = fixed_gain_observer(rates, forces, 0.01, 0.1, (1.0, np.pi / 2, 0.0))
    assert inclinations_apart(found, [0, np.pi / 2, 0]).max() < 0.01


# Recordings


def test_inclination_on_a_recording_with_optical_truth(recordings: Path) -> None:
    file = recordings / "broad_01_slow_rotation_A_95hz_ned.csv"
    columns = np.genfromtxt(file, delimiter=",", skip_header=1)
    rates, forces, truth = columns[:, 1:4], columns[:, 4:7], np.radians(columns[:, 14:17])
    scored = (columns[:, 17] == 1) & np.isfinite(truth).all(axis=1)
    steps = np.diff(columns[:, 0], prepend=columns[0, 0])

    def rms_deg(estimate: Floats) -> float:
        off = inclinations_apart(estimate[scored], truth[scored])
        return float(np.degrees(np.sqrt(np.mean(off**2))))

    assert rms_deg(fixed_gain_observer(rates, forces, steps, 0.02)) <= 0.90
    assert rms_deg(fixed_gain_observer(rates, forces, steps, 1.0)) > 5
    assert rms_deg(integrate_gyro(rates, steps, truth[0])) > 15


# What is refused

N3 = np.zeros((5, 3))
REFUSED = {
    "a negative step": (
        lambda: fixed_gain_observer(N3, N3 + LEVEL, [1, 1, -1, 1, 1], 0.1),
        r"dt: expected seconds, not negative, got -1\.0 at 2",
    ),
    "an initial quaternion": (
        lambda: fixed_gain_observer(N3, N3 + LEVEL, 0.01, 0.1, (1, 0, 0, 0)),
        r"initial: expected shape \(\.\.\., 3\), got \(4,\)",
    ),
    "sensors of different lengths": (
        lambda: fixed_gain_observer(N3, N3[:4] + LEVEL, 0.01, 0.1),
        r"expected as many rows in each of body_rates, accel, got 5, 4",
    ),
    "a gain above 1": (
        lambda: fixed_gain_observer(N3, N3 + LEVEL, 0.01, 1.1),
        r"gain: expected a number from 0 to 1, got 1\.1",
    ),
    "a gain of NaN": (
        lambda: fixed_gain_observer(N3, N3 + LEVEL, 0.01, np.nan),
        r"gain: expected a number from 0 to 1, got nan",
    ),
    "a gain for each sample": (
        lambda: fixed_gain_observer(N3, N3 + LEVEL, 0.01, np.full(5, 0.1)),  # type: ignore[arg-type]
        r"gain: expected a number, got shape \(5,\)",
    ),
    "many samples for a step": (
        lambda: chr_notes.observe_sample([0, 0, 0], N3, N3 + LEVEL, 0.01, 0.1),
        r"body_rates: expected shape \(3,\), got \(5, 3\)",
    ),
    "many times for a step": (
        lambda: chr_notes.observe_sample([0, 0, 0], N3[0], LEVEL, [0.1, 0.2], 0.1),  # type: ignore[arg-type]
        r"dt: expected a number, got shape \(2,\)",
    ),
    "many samples at a time from a stream": (
        lambda: list(observe([(N3[0], N3 + LEVEL, 0.01)], 0.1)),
        r"accel: expected shape \(3,\), got \(5, 3\)",
    ),
    "a wrong gain for an empty stream": (
        lambda: list(observe([], 1.5)),
        r"gain: expected a number from 0 to 1, got 1\.5",
    ),
    "nothing to start from": (
        lambda: fixed_gain_observer(N3, N3, 0.01, 0.1),
        r"accel: expected a sample that shows a tilt to start from, got all \d of them zero; pass",
    ),
    "a method that is none": (
        lambda: fixed_gain_observer(N3, N3 + LEVEL, 0.01, 0.1, method="kalman"),  # type: ignore[arg-type]
        r'method: expected "quaternion" or "euler", got \'kalman\'',
    ),
    "a wrong gain for a stream": (
        lambda: list(observe([(np.zeros(3), LEVEL, 0.01)], -0.1)),
        r"gain: expected a number from 0 to 1, got -0\.1",
    ),
}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_wrong_arguments_are_refused(call: Any, message: str) -> None:  # noqa: ANN401
    with pytest.raises(ValueError, match=message):
        call()


def test_no_samples_give_no_estimates() -> None:
    empty = np.zeros((0, 3))
    assert fixed_gain_observer(empty, empty, 0.01, 0.1).shape == (0, 3)
