"""The phone as the sensor of the tilt demo: signs, what is missing, and the recording."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Locator, Page, expect

import chr_notes
from chr_notes.demos import TiltDemo

from .parts import PageOf, Visit, state_of

Array = NDArray[np.float64]
STEP, COUNT, FLAT_FOR, NOISE = 0.02, 1000, 100, 0.01

SHAKE = """(readings) => readings.forEach(([time, x, y, z, alpha, beta, gamma]) => {
  const event = new DeviceMotionEvent("devicemotion", {
    accelerationIncludingGravity: { x, y, z }, rotationRate: { alpha, beta, gamma }, interval: 20,
  });
  Object.defineProperty(event, "timeStamp", { value: time });
  dispatchEvent(event);
})"""


def turning() -> tuple[Array, Array]:
    """Attitudes of a phone that lies flat for a while, then turns; and its body rates."""
    time = STEP * np.maximum(np.arange(COUNT) - FLAT_FOR, 0)
    swing = [0.5 * np.sin(0.9 * time), 0.4 * np.sin(0.7 * time), 0.6 * np.sin(0.5 * time)]
    euler = np.stack(swing, axis=-1)
    rates = chr_notes.body_rates_from_euler_rates(euler, np.gradient(euler, STEP, axis=0))
    return euler, rates


def as_phone(euler: Array, rates: Array, sign: float) -> list[list[float]]:
    """Readings in the axes of a browser, with the sign of an Android phone or of an iPhone."""
    forward, right, down = sign * chr_notes.accelerometer_at_rest(euler).T
    p, q, r = np.degrees(rates).T
    milliseconds = 1000 * STEP * np.arange(len(euler)) + 5000
    readings = np.stack([right, forward, -down, q, p, -r], axis=-1)
    noise = np.random.default_rng(5).normal(size=readings.shape, scale=NOISE)
    return np.column_stack([milliseconds, readings + noise]).tolist()


def said(page: Page) -> Locator:
    return page.locator("p[role=status]")


def press(page: Page, name: str) -> None:
    page.get_by_role("button", name=name).click()


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_phone_tilts_the_aircraft_and_its_recording_is_read(
    visit: Visit, page_of: PageOf, tmp_path: Path, sign: float
) -> None:
    page = visit(page_of(TiltDemo(vibration=3)))
    euler, rates = turning()
    readings = as_phone(euler, rates, sign)
    page.evaluate("() => { DeviceMotionEvent.requestPermission = async () => 'granted'; }")
    press(page, "Use this phone")
    page.evaluate(SHAKE, as_phone(np.array([[0.6, 0, 0]] * 15), np.zeros((15, 3)), sign))
    press(page, "It lies flat")
    expect(said(page)).to_contain_text("It does not lie flat yet")
    page.evaluate(SHAKE, readings[:20])
    press(page, "It lies flat")
    press(page, "Record")
    page.evaluate(SHAKE, readings)
    tilt = np.degrees(chr_notes.tilt_from_accelerometer(
        chr_notes.accelerometer_at_rest(euler[-15:]).mean(axis=0)
    ))  # fmt: skip
    state = state_of(page)
    assert [state["roll"], state["pitch"]] == pytest.approx(tilt, abs=3)  # shown 10 times a second
    assert state["vibration"] == 0
    expect(page.get_by_text("The phone reads (")).to_have_count(1)
    with page.expect_download() as saved:
        press(page, "Stop and save")
    path = tmp_path / "phone.csv"
    saved.value.save_as(path)
    recording = chr_notes.read_log(path)
    assert recording.accel == pytest.approx(chr_notes.accelerometer_at_rest(euler), abs=6 * NOISE)
    assert recording.body_rates == pytest.approx(rates, abs=6 * np.radians(NOISE))
    found = chr_notes.fixed_gain_observer(recording.body_rates, recording.accel, recording.dt, 0.02)
    off = chr_notes.wrap_angle(found[:, :2] - euler[:, :2])
    assert np.degrees(np.abs(off)).max() < 1


def test_what_is_missing_is_told(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo()))
    for without, words in (
        ("DeviceMotionEvent.requestPermission = async () => 'denied'", "permission was denied"),
        ("DeviceMotionEvent.requestPermission = () => Promise.reject()", "permission was denied"),
        ("DeviceMotionEvent.requestPermission = async () => 'granted'", "has no accelerometer"),
        ("delete window.DeviceMotionEvent", "has no accelerometer"),
        (
            "Object.defineProperty(window, 'isSecureContext', { value: false })",
            "only to pages that came over https",
        ),
    ):
        said(page).evaluate(f"(said) => {{ said.textContent = ''; {without}; }}")
        press(page, "Use this phone")
        expect(said(page)).to_contain_text(words)
        expect(page.get_by_role("button", name="Use this phone")).to_be_visible()
    assert state_of(page) == TiltDemo().state()
