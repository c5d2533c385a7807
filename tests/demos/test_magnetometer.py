"""The magnetometer demo: its fit is the project's, and refuses where the project's does."""

import math
import re

import numpy as np
import pytest
from playwright.sync_api import expect

import chr_notes
from chr_notes.demos import MagnetometerDemo
from chr_notes.demos.base import rounded
from chr_notes.demos.magnetometer import SETTING
from chr_notes.sensors import ellipsoid
from chr_notes.sensors.coverage import evenly_spread

from .parts import SET_AND_READ, PageOf, Samples, Visit, output, random_states

STEPS = {"readings": 1, "tilt": 5, "hard_iron": 1, "soft_iron": 0.01, "noise": 0.1}


def expected(demo: MagnetometerDemo) -> dict[str, float]:
    """The errors by the project's arrays and its calibration; NaN where the fit refuses."""
    stretch = np.eye(3) + demo.soft_iron * np.reshape(SETTING.soft, (3, 3))
    iron = chr_notes.MagnetometerCalibration(
        soft_iron=np.linalg.inv(stretch), hard_iron=demo.hard_iron * np.array(SETTING.hard)
    )
    yaw = 2 * np.pi * np.arange(SETTING.headings) / SETTING.headings
    level = np.column_stack([0 * yaw, 0 * yaw, yaw])
    raw = iron.measure(chr_notes.matrix_from_euler(level) @ SETTING.field)

    def largest(mag: np.ndarray) -> float:
        off = chr_notes.heading_from_magnetometer(mag, level[:, :2]) - yaw
        return float(np.degrees(np.abs(chr_notes.wrap_angle(off)).max()))

    try:
        after = largest(chr_notes.fit_magnetometer(demo.cloud()).correct(raw))
    except ValueError:
        after = math.nan
    return {"error_before": largest(raw), "error_after": after}


def test_readouts_are_those_of_the_calibration(
    visit: Visit, page_of: PageOf, samples: Samples
) -> None:
    page = visit(page_of(MagnetometerDemo()))
    states = random_states(MagnetometerDemo, STEPS, seed=9)[: samples(9, 50)]
    for state in states[::3]:  # a third of them tilted far enough for a fit, a third near there
        state |= {"tilt": 180.0 - state["tilt"] / 6, "readings": 200.0 - state["readings"] / 2}
    for state in states[1::3]:
        state |= {"tilt": 60.0 + state["tilt"] / 6, "readings": 200.0 - state["readings"] / 2}
        state["noise"] = 0.0 if state["noise"] < 1 else state["noise"] / 10
    names = MagnetometerDemo.controls
    extremes = [[10, 0, 0, 0, 0], [200, 180, 40, 0.5, 2], [200, 0, 40, 0.5, 0], [200, 180, 0, 0, 0]]
    extremes += [[152, 75, 17, 0.33, 0.3], [154, 70, 0, 0.12, 0], [177, 60, 10, 0.26, 0]]
    states += [dict(zip(names, row, strict=True)) for row in extremes]
    refused = 0
    for state, texts in page.evaluate(SET_AND_READ, states):
        demo = MagnetometerDemo(**state)
        numbers = expected(demo)
        found = demo.readouts()
        assert found["error_before"] == pytest.approx(numbers["error_before"], abs=1e-9)
        assert found["error_after"] == pytest.approx(numbers["error_after"], abs=1e-6, nan_ok=True)
        unknown = math.isnan(numbers["error_after"])
        refused += unknown
        assert texts["error_after"] == ("–" if unknown else rounded(numbers["error_after"])), state
        assert texts["error_before"] == rounded(numbers["error_before"])
        assert texts["gap"] == rounded(found["gap"])
        assert ("refuses" in texts["meaning"]) == unknown
    assert len(states) / 5 < refused < len(states) * 4 / 5


def test_walk_keeps_the_field_and_covers_what_it_says() -> None:
    ring = MagnetometerDemo(tilt=0, readings=200).walk()
    np.testing.assert_allclose(ring[:, 2], SETTING.field[2], atol=1e-12)
    everywhere = MagnetometerDemo(tilt=180, readings=200, noise=0)
    lengths = np.linalg.norm(everywhere.walk(), axis=1)
    np.testing.assert_allclose(lengths, np.linalg.norm(SETTING.field), rtol=1e-12)
    assert everywhere.readouts()["gap"] < 25


def test_a_turn_about_one_axis_is_refused(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(MagnetometerDemo(tilt=0)))
    expect(page.locator(".chr-note").last).to_have_text("refused")
    expect(output(page, "meaning")).to_contain_text("The fit refuses: no reading comes from within")
    assert "the fit refuses" in MagnetometerDemo(tilt=0).fallback()


def test_a_refusal_says_how_far_off_the_ellipsoid_is(
    visit: Visit, page_of: PageOf, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ellipsoid, "WIDEST_GAP", math.pi)  # so that it answers
    monkeypatch.setattr(ellipsoid, "LARGEST_ERROR", math.inf)
    few = MagnetometerDemo(tilt=60, noise=0.1)
    noisy = MagnetometerDemo(readings=200, tilt=0, hard_iron=4, soft_iron=0.5, noise=0.8)
    cases = {few: "where it takes 100° at most", noisy: "too far with so much noise"}
    for demo, why in cases.items():
        found = chr_notes.fit_ellipsoid(demo.cloud())
        stretch = np.eye(3) + demo.soft_iron * np.reshape(SETTING.soft, (3, 3))
        everywhere = evenly_spread(500) * np.linalg.norm(SETTING.field)
        true = (everywhere + demo.hard_iron * np.array(SETTING.hard)) @ stretch.T
        norms = np.linalg.norm((true - found.centre) @ found.to_sphere, axis=1) / found.radius
        said = str(output(visit(page_of(demo)), "meaning").text_content())
        assert why in said
        numbers = [
            float(each) for each in re.findall(r"(?<=within )[\d.]+|[\d.]+(?=\u00a0%)", said)
        ]
        gap, off = math.degrees(found.gap), 100 * np.abs(norms - 1).max()
        assert numbers == pytest.approx([gap, off], rel=0.03)


def test_text_has_the_state_and_the_numbers() -> None:
    demo = MagnetometerDemo(hard_iron=10)
    numbers = expected(demo)
    assert "150 readings" in demo.fallback()
    assert f"off by up to {rounded(numbers['error_before'])}°, after it" in demo.fallback()
    assert f"after it {rounded(numbers['error_after'])}°." in demo.fallback()
