"""The filter demo: its errors are those of the project's filters on the same readings."""

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import expect

import chr_notes
from chr_notes.demos import FilterDemo
from chr_notes.demos.base import formatted, rounded
from chr_notes.demos.filter import RUN

from .parts import SET_AND_READ, PageOf, Samples, Visit, output, random_states

Array = NDArray[np.float64]
POSITIONS = 80  # of the slider of the gain
STEPS = {"gain": 0.05, "bank": 1, "push": 0.1, "bias": 0.05, "gyro_noise": 0.1, "accel_noise": 0.1}


def rms_apart(estimates: Array, truth: Array) -> float:
    """RMS angle between the verticals of Euler angles and of quaternions, degrees."""
    down = chr_notes.matrix_from_euler(estimates)[..., 2]
    true = chr_notes.rotate_to_body(truth, [0, 0, 1])
    apart = np.arctan2(np.linalg.norm(np.cross(down, true), axis=-1), np.sum(down * true, axis=-1))
    counted = np.degrees(apart[RUN.every - 1 :: RUN.every])
    return float(np.sqrt(np.mean(counted**2)))


def expected(demo: FilterDemo) -> dict[str, float]:
    truth, rates, force = (np.array(column) for column in zip(*demo.recording(), strict=True))
    observed = {
        gain: rms_apart(chr_notes.fixed_gain_observer(rates, force, RUN.step, gain), truth)
        for gain in (0.0, demo.gain, *RUN.gains)
    }
    tilt = np.column_stack([chr_notes.tilt_from_accelerometer(force), np.zeros(len(force))])
    best = min(RUN.gains, key=observed.__getitem__)
    averaging = chr_notes.averaging_observer(rates, force, RUN.step, bias=0.0)
    return {
        "gyro_error": observed[0.0],
        "observer_error": observed[demo.gain],
        "accelerometer_error": rms_apart(tilt, truth),
        "averaging_error": rms_apart(averaging, truth),
        "best_gain": best,
        "best_error": observed[best],
    }


def test_readouts_are_those_of_the_filters(visit: Visit, page_of: PageOf, samples: Samples) -> None:
    page = visit(page_of(FilterDemo()))
    positions = random_states(FilterDemo, STEPS, seed=8)[: samples(6, 50)]
    for position in positions:
        position["gain"] = round(position["gain"] * POSITIONS)
    names = FilterDemo.controls
    extremes = [
        [0, 0, 0, 0, 0, 0],
        [80, 45, 3, 1, 5, 3],
        [0, 45, 0, 1, 5, 0],
        [46, 30, 0, 0.2, 1, 1.5],
    ]
    positions += [dict(zip(names, row, strict=True)) for row in extremes]
    for state, texts in page.evaluate(SET_AND_READ, positions):
        numbers = expected(FilterDemo(**state))
        shown = {name: formatted if name == "best_gain" else rounded for name in numbers}
        assert {name: texts[name] for name in numbers} == {
            name: shown[name](value) for name, value in numbers.items()
        }, state


def test_python_says_the_same_as_the_filters() -> None:
    for state in ({}, {"bank": 40.0, "push": 1.0}, {"gain": 1.0, "bias": 1.0, "accel_noise": 0.0}):
        demo = FilterDemo(**state)
        numbers = expected(demo)
        for name, value in demo.readouts().items():
            assert value == pytest.approx(numbers[name], abs=1e-9)


def test_noise_is_white_and_has_the_power_that_it_says() -> None:
    demo = FilterDemo(bias=0, gyro_noise=1, accel_noise=1)
    quiet = FilterDemo(bias=0, gyro_noise=0, accel_noise=0)
    noise = np.array(
        [
            [
                *np.degrees(np.subtract(loud.rates, still.rates)),
                *np.subtract(loud.force, still.force),
            ]
            for loud, still in zip(demo.recording(), quiet.recording(), strict=True)
        ]
    )
    np.testing.assert_allclose(noise.mean(axis=0), 0, atol=0.1)
    np.testing.assert_allclose(noise.std(axis=0), 1, atol=0.05)
    assert np.abs(np.corrcoef(noise.T) - np.eye(6)).max() < 0.1
    assert np.abs([np.corrcoef(axis[1:], axis[:-1])[0, 1] for axis in noise.T]).max() < 0.1


def test_the_body_does_what_the_demo_says() -> None:
    """In the steady turn it is banked, and the force goes straight through its floor."""
    demo = FilterDemo(bank=30, push=0, bias=0, gyro_noise=0, accel_noise=0)
    attitude, rates, force = demo.recording()[500]
    roll, pitch, _ = np.degrees(chr_notes.euler_from_quaternion(attitude))
    assert (roll, pitch) == pytest.approx((30, 0), abs=0.2)
    assert force == pytest.approx([0, 0, -chr_notes.STANDARD_GRAVITY / np.cos(np.pi / 6)], abs=0.1)
    turn = chr_notes.euler_rates_from_body_rates(np.radians([30, 0, 0]), rates)
    assert turn == pytest.approx(
        [0, 0, chr_notes.STANDARD_GRAVITY * np.tan(np.pi / 6) / 2], abs=1e-9
    )
    assert demo.readouts()["gyro_error"] < 1e-6
    pushed = FilterDemo(push=2, bias=0, gyro_noise=0, accel_noise=0).recording()[500]
    assert pushed.force == pytest.approx([2, 0, -chr_notes.STANDARD_GRAVITY], abs=1e-9)


def test_sentence_names_both_valleys_in_a_turn(visit: Visit, page_of: PageOf) -> None:
    without = FilterDemo(gain=1, bias=0, gyro_noise=0, accel_noise=0)
    page = visit(page_of(FilterDemo(gain=0.02), FilterDemo(gain=0.02, bank=30), without))
    rest, turn, exact = (output(page, "meaning").nth(i) for i in (0, 1, 2))
    expect(exact).to_contain_text(
        "alone by 0°. A gain of 1 is the accelerometer alone. No other gain does much better."
    )
    best = {bank: expected(FilterDemo(bank=bank)) for bank in (0, 30)}
    there = formatted(best[0]["best_gain"])
    here = rounded(expected(FilterDemo(gain=best[0]["best_gain"], bank=30))["observer_error"])
    back = rounded(expected(FilterDemo(gain=best[30]["best_gain"]))["observer_error"])
    expect(rest).to_contain_text("No other gain does much better.")
    expect(turn).to_contain_text(f"best at rest, {there}, is off by {here}° here")
    expect(turn).to_contain_text(f"by {rounded(best[30]['best_error'])}°, and at rest by {back}°")


def test_text_has_the_state_and_the_numbers() -> None:
    demo = FilterDemo(gain=0.02, bank=30)
    numbers = expected(demo)
    assert f"with a gain of 0.02 {rounded(numbers['observer_error'])}°" in demo.fallback()
    assert f"gyro alone {rounded(numbers['gyro_error'])}°" in demo.fallback()
