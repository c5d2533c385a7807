"""The quaternion demo: its readouts are Python's numbers, over two whole turns."""

import re

import numpy as np
from playwright.sync_api import expect

import chr_notes
from chr_notes.demos import QuaternionDemo
from chr_notes.demos.base import SOURCES

from .parts import PageOf, Visit, check_readouts, output, picture, random_states, state_of

STEPS = {"axis_yaw": 1, "axis_pitch": 1, "angle": 5, "product": 0.05}


def part(axis: np.ndarray, degrees: float) -> np.ndarray:
    """Cosine and sine of half an angle, so that the sign is kept."""
    half = np.radians(degrees) / 2
    return np.array([np.cos(half), *np.sin(half) * axis])


def expected(state: dict[str, float]) -> dict[str, float | list[float]]:
    angles = np.radians([0, state["axis_pitch"], state["axis_yaw"]])
    axis = chr_notes.matrix_from_euler(angles)[0]
    left = part(axis, min(1, state["product"]) * state["angle"])
    right = part(axis, max(0, state["product"] - 1) * state["angle"])
    product = chr_notes.quaternion_multiply(
        chr_notes.quaternion_multiply(left, [0, 1, 0, 0]), chr_notes.quaternion_conjugate(right)
    )
    return {
        "half_angle": state["angle"] / 2,
        "quaternion": part(axis, state["angle"]).tolist(),
        "product": product.tolist(),
    }


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    states = random_states(QuaternionDemo, STEPS, seed=5)
    states += [
        {"axis_yaw": yaw, "axis_pitch": pitch, "angle": angle, "product": product}
        for yaw, pitch in ((0, 0), (-180, 90), (180, -90))
        for angle, product in ((0, 0), (360, 1), (720, 2), (180, 2))
    ]
    check_readouts(visit(page_of(QuaternionDemo())), states, expected)
    for state in states:
        found = QuaternionDemo(**state).readouts()
        for name, value in expected(state).items():
            np.testing.assert_allclose(found[name], value, atol=1e-14)


def test_after_both_products_the_vector_points_along_the_nose() -> None:
    found = QuaternionDemo(axis_yaw=20, axis_pitch=-40, angle=250, product=2).readouts()
    q, product = found["quaternion"], found["product"]
    nose = chr_notes.rotate_to_inertial(q, [1, 0, 0])
    np.testing.assert_allclose(product, [0, *nose], atol=1e-14)


def test_360_degrees_are_not_home_and_720_are(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(QuaternionDemo(angle=360), QuaternionDemo(angle=720)))
    for i, (sentence, scalar) in enumerate([("q = −1", "−1.000"), ("q = 1", " 1.000")]):
        expect(output(page, "meaning").nth(i)).to_contain_text(sentence)
        assert str(output(page, "quaternion").nth(i).text_content()).startswith(scalar)


def test_text_has_the_state_and_the_numbers() -> None:
    text = QuaternionDemo(axis_yaw=0, axis_pitch=-90, angle=90, product=1).fallback()
    assert "yaw 0° and pitch −90°. Half the angle is 45°, the quaternion 0.707, 0.000" in text
    assert "After 1 of 2 products the vector is 0.000, 0.707, 0.707, 0.000." in text


def test_the_vector_of_the_first_product_is_seen_apart_from_the_nose() -> None:
    """By more than 25 degrees on the screen, in the state that the chapter opens with."""
    source = (SOURCES / "quaternion.js").read_text(encoding="utf-8")
    found = re.findall(r"heading: (\S+), elevation: (\S+) \}", source)[0]
    heading, elevation = map(float, found)
    camera = chr_notes.matrix_from_euler(np.radians([0, elevation, heading]))
    readouts = QuaternionDemo().readouts()
    nose = chr_notes.rotate_to_inertial(readouts["quaternion"], [1, 0, 0])
    seen = [(camera @ np.array(axis))[1:] for axis in (nose, readouts["product"][1:])]
    cosine = seen[0] @ seen[1] / np.prod(np.linalg.norm(seen, axis=1))
    assert np.degrees(np.arccos(cosine)) > 25


def test_a_button_goes_to_a_stop(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(QuaternionDemo()), reduced_motion="reduce")
    for name in ("360°", "q v q*"):
        button = page.get_by_role("button", name=name, exact=True)
        assert button.get_attribute("aria-pressed") == "false"
        button.click()
        assert button.get_attribute("aria-pressed") == "true"
    assert state_of(page) == QuaternionDemo(angle=360, product=2).state()


PLACES = """() => {
  const { fillText } = CanvasRenderingContext2D.prototype;
  window.places = {};
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
    window.places[text] = y / this.canvas.clientHeight;
    return fillText.call(this, text, x, y);
  };
  document.body.dataset.again = "draw";
}"""


def test_the_name_of_an_axis_that_points_down_is_not_cut(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(QuaternionDemo(axis_yaw=-170, axis_pitch=-60)))
    page.evaluate(PLACES)
    picture(page)
    # The sphere has this part of the height; half a letter is below the middle of the name.
    assert page.evaluate("places.axis") <= 0.64 - 0.014
