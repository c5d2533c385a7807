"""The tilt demo: its readouts are Python's numbers."""

import numpy as np
import pytest
from playwright.sync_api import expect

from chr_notes import (
    STANDARD_GRAVITY,
    accelerometer_at_rest,
    tilt_from_accelerometer,
    wrap_angle,
)
from chr_notes.demos import TiltDemo
from chr_notes.demos.base import rounded
from chr_notes.demos.tilt import VIBRATION
from chr_notes.palette import PALETTE

from .parts import SET_AND_READ, PageOf, Visit, drawn, output, slider


def expected(state: dict[str, float]) -> dict[str, float]:
    """The readouts by another way: in body axes alone, and with arrays."""
    truth = np.radians([state["roll"], state["pitch"]])
    acceleration = np.array([state["forward_acceleration"], state["lateral_acceleration"], 0])
    reading = accelerometer_at_rest([*truth, 0]) + acceleration
    readings = reading + state["vibration"] * np.array(VIBRATION)
    average = tilt_from_accelerometer(reading)
    apart = wrap_angle(tilt_from_accelerometer(readings) - average)
    columns = {
        "estimate": average,
        "error": wrap_angle(average - truth),
        "scatter": np.sqrt(np.mean(apart**2, axis=0)),
    }
    return {
        f"{name}_{kind}": float(np.degrees(values[i]))
        for kind, values in columns.items()
        for i, name in enumerate(("roll", "pitch"))
    }


def test_vibration_is_white_has_no_average_and_the_power_that_it_says() -> None:
    samples = np.array(VIBRATION)
    assert samples.shape == (100, 3)
    np.testing.assert_allclose(samples.sum(axis=0), 0, atol=1e-12)
    np.testing.assert_allclose(np.sqrt(np.mean(samples**2, axis=0)), 1, atol=1e-3)
    between_axes = np.corrcoef(samples.T) - np.eye(3)
    one_later = [np.corrcoef(axis[1:], axis[:-1])[0, 1] for axis in samples.T]
    assert np.max(np.abs([*between_axes.ravel(), *one_later])) < 0.25


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo()))
    random = np.random.default_rng(3)
    low, high = [-1790, -890, -100, -100, 0], [1790, 890, 100, 100, 50]
    rows = random.integers(low, high, size=(50, 5), endpoint=True) / [10, 10, 10, 10, 10]
    rows[:, :2] = np.round(rows[:, :2])
    names = TiltDemo.controls
    extremes = [[-150, 90, 0, 0, 0], [30, -90, -10, 0, 5], [0, 90, 10, -10, 0], [-180, 0, 0, 0, 1]]
    states = [dict(zip(names, row, strict=True)) for row in rows.tolist() + extremes]
    for state, (shown, texts) in zip(states, page.evaluate(SET_AND_READ, states), strict=True):
        assert shown == state
        numbers = expected(state)
        assert {name: texts[name] for name in numbers} == {
            name: rounded(value) for name, value in numbers.items()
        }
        assert TiltDemo(**state).readouts() == pytest.approx(numbers, abs=1e-9)


def test_at_rest_both_angles_are_right(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo(roll=-150, pitch=80)))
    expect(output(page, "roll_estimate")).to_have_text("−150")
    expect(output(page, "pitch_estimate")).to_have_text("80")
    expect(output(page, "roll_error")).to_have_text("0")
    expect(output(page, "meaning")).to_contain_text("both angles are right")


def test_forward_acceleration_is_taken_for_a_raised_nose(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo(forward_acceleration=STANDARD_GRAVITY)))
    expect(output(page, "pitch_error")).to_have_text("45")
    expect(output(page, "roll_error")).to_have_text("0")
    expect(output(page, "meaning")).to_contain_text("pitch is wrong by 45°")


def test_vibration_scatters_and_leaves_the_average(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo(roll=20, vibration=2)))
    expect(output(page, "roll_estimate")).to_have_text("20")
    expect(output(page, "meaning")).to_contain_text("Single readings scatter")
    assert float(str(output(page, "roll_scatter").text_content())) > 5


@pytest.mark.parametrize(
    ("pitch", "others"),
    [
        (90, (30, 0, 0)),
        (-90, (0, -10, 2)),
        pytest.param(-90, (30, 0, 0), marks=pytest.mark.full),
        pytest.param(90, (-150, 3, 0), marks=pytest.mark.full),
    ],
)
def test_roll_is_undefined_where_the_reading_lies_along_the_roll_axis(
    visit: Visit, page_of: PageOf, pitch: float, others: tuple[float, float, float]
) -> None:
    roll, forward, vibration = others
    demo = TiltDemo(roll=roll, pitch=pitch, forward_acceleration=forward, vibration=vibration)
    page = visit(page_of(demo))
    for kind in ("estimate", "error", "scatter"):
        for name, note in (("roll", "undefined"), ("pitch", "")):
            readout = page.locator(".chr-readout", has=output(page, f"{name}_{kind}"))
            expect(readout.locator(".chr-note")).to_have_text(note)
    # The number is the function's all the same.
    estimate = rounded(demo.readouts()["roll_estimate"])
    expect(output(page, "roll_estimate")).to_have_text(estimate)
    expect(output(page, "meaning")).to_contain_text(f"the {estimate}° is left by rounding.")
    assert "undefined" in [text for text, _ in drawn(page)]
    assert demo.undefined() == {"roll": True, "pitch": False}
    assert "roll undefined; pitch" in demo.fallback()
    slider(page, "vibration").press("ArrowRight")
    expect(page.locator("[aria-live=polite]")).to_contain_text("Estimated roll undefined; pitch")
    slider(page, "pitch").press("ArrowLeft" if pitch > 0 else "ArrowRight")
    expect(page.locator(".chr-note").first).to_have_text("")


def test_in_free_fall_both_angles_are_undefined(visit: Visit, page_of: PageOf) -> None:
    demo = TiltDemo(roll=90, lateral_acceleration=STANDARD_GRAVITY)
    page = visit(page_of(demo))
    assert page.locator(".chr-note").all_text_contents()[:6] == ["undefined"] * 6
    expect(output(page, "meaning")).to_contain_text("falls freely")
    assert demo.undefined() == {"roll": True, "pitch": True}


def test_arrows_of_acceleration_are_told_apart(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo(roll=30, forward_acceleration=8, lateral_acceleration=8)))
    written = [pair for pair in drawn(page) if pair[0]]
    for axis in ("x", "y"):
        colour = PALETTE[axis].light
        at = written.index(("a", colour))
        assert written[at + 1] == (axis, colour)
    legend = page.locator(".chr-legend li").all_text_contents()
    assert {"ax, forward acceleration", "ay, lateral acceleration"} <= set(legend)
    for axis, name in (("x", "forward"), ("y", "lateral")):
        caption = page.locator("label", has=slider(page, f"{name}_acceleration"))
        expect(caption.locator(".chr-symbol")).to_have_text(f"a{axis}")
        assert caption.get_attribute("data-axis") == axis


def test_text_has_the_state_and_the_numbers() -> None:
    text = TiltDemo(roll=-20, pitch=10, forward_acceleration=4, vibration=1.5).fallback()
    assert "roll −20° and pitch 10°" in text
    assert "4 m/s² forward and 0 m/s² to the right, with a vibration of 1.5 m/s² RMS" in text
    numbers = expected(TiltDemo(roll=-20, pitch=10, forward_acceleration=4, vibration=1.5).state())
    assert f"pitch {rounded(numbers['pitch_estimate'])}°" in text
    assert f"error {rounded(numbers['pitch_error'])}°" in text
