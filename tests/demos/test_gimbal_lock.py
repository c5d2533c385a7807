"""The gimbal-lock demo: its readouts are Python's numbers, and everyone can use it."""

import json
import math
import re
from collections.abc import Callable
from html.parser import HTMLParser

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect
from traitlets import TraitError

import chr_notes
from chr_notes.demos import GimbalLockDemo
from chr_notes.demos.base import BUILT, formatted
from chr_notes.generated.scalar.euler import euler_rates_condition, euler_rates_determinant

Visit = Callable[..., Page]
PageOf = Callable[..., str]


def output(page: Page | Locator, name: str) -> Locator:
    return page.locator(f'output[name="{name}"]')


def slider(page: Page | Locator, name: str) -> Locator:
    return page.locator(f'input[type="range"][name="{name}"]')


# ── in Python ──────────────────────────────────────────────────────────────────────────────────


def test_notebook_gets_widget_html_and_text() -> None:
    data, _ = GimbalLockDemo(pitch=60)._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in data
    assert data["text/plain"] == "GimbalLockDemo(yaw=0, pitch=60, roll=0)"
    assert data["text/html"] == GimbalLockDemo(pitch=60).to_html()


def test_html_holds_the_state_and_the_numbers() -> None:
    found: dict[str, str | None] = {}
    words: list[str] = []

    class Parser(HTMLParser):
        def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            if tag == "div":
                found.update(attrs)

        def handle_data(self, data: str) -> None:
            words.append(data)

    Parser().feed(GimbalLockDemo(yaw=-30.5, pitch=60, roll=20).to_html())
    assert found["data-demo"] == "gimbal-lock"
    assert json.loads(str(found["data-state"])) == {"yaw": -30.5, "pitch": 60, "roll": 20}
    text = "".join(words)
    assert "yaw −30.5°, pitch 60°, roll 20°" in text
    assert "Determinant of D: 2." in text
    assert "Condition number of D: 3.732." in text


def test_at_the_lock_the_numbers_have_no_bound() -> None:
    for pitch in (-90, 90):
        assert GimbalLockDemo(pitch=pitch).fallback().count("∞") == 2


def test_state_outside_a_slider_is_refused() -> None:
    with pytest.raises(TraitError):
        GimbalLockDemo(pitch=90.5)
    with pytest.raises(TraitError):
        GimbalLockDemo(yaw=181)


def test_widget_carries_its_module_and_styles() -> None:
    state = GimbalLockDemo().get_state()
    assert "export" in state["_esm"]
    assert "--chr-x" in state["_css"]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1.9999999999999996, "2"),
        (57.298688498550185, "57.3"),
        (12345.678, "12350"),
        (-0.5, "−0.5"),
        (1.6e16, "∞"),
        (math.inf, "∞"),
        (-math.inf, "−∞"),
    ],
)
def test_numbers_are_shown_with_four_digits(value: float, text: str) -> None:
    assert formatted(value) == text


# ── in the browser ─────────────────────────────────────────────────────────────────────────────


def test_determinant_at_60_degrees_is_2(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    slider(page, "pitch").fill("60")
    expect(output(page, "determinant")).to_have_text("2")
    expect(output(page, "condition")).to_have_text("3.732")


SET_AND_READ = """(states) => states.map((state) => {
  for (const [name, value] of Object.entries(state)) {
    const input = document.querySelector(`input[name="${name}"]`);
    input.value = value;
    input.dispatchEvent(new Event("input"));
  }
  const outputs = [...document.querySelectorAll("output")];
  return Object.fromEntries(outputs.map((output) => [output.name, output.textContent]));
})"""


def test_readouts_are_the_numbers_of_python(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    random = np.random.default_rng(2)
    low, high = [-180, -89, -180], [180, 89, 180]
    attitudes = random.integers(low, high, size=(50, 3), endpoint=True)
    states = [dict(zip(("roll", "pitch", "yaw"), row, strict=True)) for row in attitudes.tolist()]
    for attitude, texts in zip(attitudes, page.evaluate(SET_AND_READ, states), strict=True):
        euler = np.radians(attitude)
        roll_axis = chr_notes.matrix_from_euler(euler)[0]
        apart = math.degrees(math.atan2(math.hypot(*roll_axis[:2]), abs(roll_axis[2])))
        fastest = np.linalg.norm(chr_notes.euler_rates_matrix(euler)[2])
        assert texts["determinant"] == formatted(euler_rates_determinant(euler[1]))
        assert texts["condition"] == formatted(euler_rates_condition(euler[1]))
        numbers = re.findall(r"\d+(?:\.\d+)?", texts["rings"])
        assert numbers == [formatted(apart), formatted(fastest)]


@pytest.mark.parametrize(("pitch", "sense"), [(90, "opposite senses"), (-90, "same sense")])
def test_lock_is_named_at_exactly_90_degrees(
    visit: Visit, page_of: PageOf, pitch: int, sense: str
) -> None:
    page = visit(page_of(GimbalLockDemo(yaw=33, pitch=pitch, roll=-71)))
    expect(output(page, "determinant")).to_have_text("∞")
    expect(output(page, "condition")).to_have_text("∞")
    expect(output(page, "rings")).to_contain_text("about the same axis")
    expect(output(page, "rings")).to_contain_text(sense)


def picture(page: Page | Locator) -> str:
    """What is drawn, once it has been."""
    page.locator("canvas").evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )
    return str(page.locator("canvas").evaluate("(canvas) => canvas.toDataURL()"))


def test_aircraft_stands_still_where_the_readout_says_so() -> None:
    for pitch, roll in ((90, 40), (-90, -40)):
        before = chr_notes.matrix_from_euler(np.radians([0, pitch, 0]))
        after = chr_notes.matrix_from_euler(np.radians([roll, pitch, 40]))
        np.testing.assert_allclose(after, before, atol=1e-15)


def test_keyboard_moves_a_slider_and_the_picture(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(pitch=59)))
    before = picture(page)
    slider(page, "pitch").focus()
    page.keyboard.press("ArrowRight")
    expect(output(page, "determinant")).to_have_text("2")
    expect(slider(page, "pitch")).to_have_attribute("aria-valuetext", "60 degrees")
    assert picture(page) != before
    page.keyboard.press("End")
    expect(output(page, "determinant")).to_have_text("∞")


def test_keys_do_not_reach_the_page_around(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    page.evaluate("document.addEventListener('keydown', () => { window.heard = true; })")
    slider(page, "yaw").focus()
    page.keyboard.press("ArrowRight")
    expect(slider(page, "yaw")).to_have_value("1")
    assert page.evaluate("window.heard") is None
    assert page.locator(".chr-demo[data-lm-suppress-shortcuts]").count() == 1


def test_screen_reader_hears_once_the_reader_pauses(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(pitch=59)))
    live = page.locator("[aria-live=polite]")
    assert live.text_content() == ""
    slider(page, "pitch").focus()
    page.keyboard.press("ArrowRight")
    expect(live).to_contain_text("Determinant 2, condition number 3.732.")


def test_everything_has_a_name(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    expect(page.get_by_role("slider", name="Pitch")).to_have_count(1)
    expect(page.get_by_role("img", name="An aircraft in three rings")).to_have_count(1)
    expect(page.get_by_role("button", name="Reset")).to_have_count(1)


def test_several_demos_on_a_page_keep_apart(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(pitch=60), GimbalLockDemo(pitch=0)))
    first, second = page.locator("[data-demo]").all()
    slider(second, "pitch").fill("-60")
    slider(first, "pitch").fill("0")
    expect(output(first, "determinant")).to_have_text("1")
    expect(output(second, "determinant")).to_have_text("2")


def test_reset_returns_to_the_start(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(yaw=10, pitch=60, roll=-20)))
    page.get_by_role("button", name="Reset").click()
    expect(output(page, "determinant")).to_have_text("1")
    for name in ("yaw", "pitch", "roll"):
        expect(slider(page, name)).to_have_value("0")


def test_reset_does_not_move_where_less_motion_is_wanted(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo(pitch=60)), reduced_motion="reduce")
    page.get_by_role("button", name="Reset").click()
    assert output(page, "determinant").text_content() == "1"


def test_picture_follows_the_theme(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(GimbalLockDemo()))
    light = picture(page)
    page.evaluate("document.documentElement.dataset.theme = 'dark'")
    assert picture(page) != light


@pytest.mark.parametrize("width", [390, 1280])
def test_demo_fits_the_page(visit: Visit, page_of: PageOf, width: int) -> None:
    page = visit(page_of(GimbalLockDemo(pitch=90)), width=width)
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_widget_and_model_follow_each_other(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of())
    module = (BUILT / "gimbal_lock.mjs").read_text(encoding="utf-8")
    page.evaluate(
        """async (source) => {
          const url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
          const { default: widget } = await import(url);
          const values = { yaw: 0, pitch: 59, roll: 0 };
          const heard = {};
          window.values = values;
          window.saved = 0;
          const model = {
            get: (name) => values[name],
            set(name, value) { values[name] = value; heard[`change:${name}`]?.(); },
            save_changes() { window.saved += 1; },
            on(event, call) { heard[event] = call; },
            off(event) { delete heard[event]; },
          };
          window.model = model;
          window.close = await widget.render({ model, el: document.body });
        }""",
        module,
    )
    slider(page, "pitch").focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("[values.pitch, saved]") == [60, 1]
    page.evaluate("model.set('pitch', -60.5)")
    expect(output(page, "determinant")).to_have_text(
        formatted(euler_rates_determinant(math.radians(-60.5)))
    )
    page.evaluate("window.close()")
    assert page.locator(".chr-demo").count() == 0
