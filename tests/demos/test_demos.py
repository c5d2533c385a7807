"""What holds for each demo: everyone can use it, and several stand on a page."""

import json
import subprocess
import sys
from html.parser import HTMLParser

import pytest
from playwright.sync_api import expect
from traitlets import TraitError

from chr_notes.demos import DriftDemo, GimbalLockDemo, TiltDemo
from chr_notes.demos.base import BUILT, Demo, formatted, rounded

from .parts import DEMOS, PageOf, Visit, output, picture, slider

each_demo = pytest.mark.parametrize("demo", DEMOS, ids=lambda demo: demo.element)


# ── in Python ──────────────────────────────────────────────────────────────────────────────────


def test_demos_do_not_load_sympy() -> None:
    code = "import sys, chr_notes.demos; print('sympy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "False"


@each_demo
def test_notebook_gets_widget_html_and_text(demo: type[Demo]) -> None:
    data, _ = demo()._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in data
    assert data["text/plain"] == repr(demo())
    assert data["text/html"] == demo().to_html()


@each_demo
def test_html_holds_the_state_and_the_text(demo: type[Demo]) -> None:
    found: dict[str, str | None] = {}
    words: list[str] = []

    class Parser(HTMLParser):
        def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            if tag == "div":
                found.update(attrs)

        def handle_data(self, data: str) -> None:
            words.append(data)

    Parser().feed(demo().to_html())
    assert found["data-demo"] == demo.element
    assert json.loads(str(found["data-state"])) == demo().state()
    assert "".join(words) == demo().fallback()


@each_demo
def test_state_outside_a_slider_is_refused(demo: type[Demo]) -> None:
    for name in demo.controls:
        for limit in (demo.class_traits()[name].min, demo.class_traits()[name].max):
            assert demo(**{name: limit}).state()[name] == limit
            with pytest.raises(TraitError):
                demo(**{name: limit + (1 if limit > 1 else -1)})


@each_demo
def test_widget_carries_its_module_and_styles(demo: type[Demo]) -> None:
    state = demo().get_state()
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
        (float("inf"), "∞"),
        (float("-inf"), "−∞"),
    ],
)
def test_numbers_are_shown_with_four_digits(value: float, text: str) -> None:
    assert formatted(value) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [(29.999999999999996, "30"), (-0.001, "0"), (-12.345678, "−12.35"), (179.5, "179.5")],
)
def test_angles_are_shown_with_two_decimals(value: float, text: str) -> None:
    assert rounded(value) == text


# ── in the browser ─────────────────────────────────────────────────────────────────────────────


@each_demo
def test_keyboard_moves_each_slider_and_the_picture(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = visit(page_of(demo()))
    for name in demo.controls:
        before = picture(page)
        slider(page, name).focus()
        page.keyboard.press("ArrowRight")
        page.keyboard.press("ArrowRight")
        state = json.loads(str(page.locator(".chr-demo").get_attribute("data-state")))
        assert state[name] > demo().state()[name]
        assert picture(page) != before, name


@each_demo
def test_keys_do_not_reach_the_page_around(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    page.evaluate("document.addEventListener('keydown', () => { window.heard = true; })")
    page.locator("input").first.focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("window.heard") is None
    assert page.locator(".chr-demo[data-lm-suppress-shortcuts]").count() == 1


@each_demo
def test_screen_reader_hears_once_the_reader_pauses(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = visit(page_of(demo()))
    live = page.locator("[aria-live=polite]")
    assert live.text_content() == ""
    page.locator("input").first.focus()
    page.keyboard.press("ArrowRight")
    assert live.text_content() == ""
    expect(live).not_to_have_text("")


@each_demo
def test_everything_has_a_name(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    for control in page.locator("input, button, canvas, [role=group]").all():
        label = control.evaluate(
            "(each) => each.ariaLabel ?? each.labels?.[0]?.textContent ?? each.textContent"
        )
        assert str(label).strip() != ""
    for control in page.locator("input").all():
        assert control.get_attribute("aria-valuetext")
    for text in ("Play", "Reset"):
        expect(page.get_by_role("button", name=text)).to_have_count(1)


@each_demo
def test_picture_follows_the_theme(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    light = picture(page)
    page.evaluate("document.documentElement.dataset.theme = 'dark'")
    assert picture(page) != light


@each_demo
@pytest.mark.parametrize("width", [390, 1280])
def test_demo_fits_the_page(visit: Visit, page_of: PageOf, demo: type[Demo], width: int) -> None:
    page = visit(page_of(demo()), width=width)
    assert page.evaluate("document.documentElement.scrollWidth") <= width


@each_demo
def test_several_demos_on_a_page_keep_apart(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = visit(page_of(demo(), DriftDemo(time=60), GimbalLockDemo(pitch=60), TiltDemo(roll=10)))
    for name in demo.controls:
        slider(page, name).first.focus()
        page.keyboard.press("End")
    others = page.locator("[data-demo]").all()[1:]
    expect(output(others[0], "velocity_error")).to_have_text("10.26")
    expect(output(others[1], "determinant")).to_have_text("2")
    expect(output(others[2], "roll_estimate")).to_have_text("10")


# ── moving by itself ───────────────────────────────────────────────────────────────────────────


@each_demo
def test_nothing_moves_unless_asked(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    before = picture(page)
    page.wait_for_timeout(400)
    assert picture(page) == before


@each_demo
def test_play_moves_and_pause_stops(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    root = page.locator(".chr-demo")
    first = root.get_attribute("data-state")
    page.clock.install()
    page.get_by_role("button", name="Play").click()
    expect(page.locator(".chr-said")).not_to_have_text("")
    page.clock.run_for(7_000)
    page.get_by_role("button", name="Pause").click()
    stopped = root.get_attribute("data-state")
    assert stopped != first
    page.clock.run_for(60_000)
    assert root.get_attribute("data-state") == stopped
    page.get_by_role("button", name="Go on").click()
    page.clock.run_for(120_000)
    expect(page.get_by_role("button", name="Play")).to_have_count(1)


@each_demo
def test_a_hand_on_a_slider_ends_the_story(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    page = visit(page_of(demo()))
    page.clock.install()
    page.get_by_role("button", name="Play").click()
    page.clock.run_for(7_000)
    page.locator("input").first.focus()
    page.keyboard.press("ArrowLeft")
    state = page.locator(".chr-demo").get_attribute("data-state")
    page.clock.run_for(60_000)
    assert page.locator(".chr-demo").get_attribute("data-state") == state
    expect(page.locator(".chr-said")).to_have_text("")


@each_demo
def test_where_less_motion_is_wanted_the_story_goes_step_by_step(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = visit(page_of(demo()), reduced_motion="reduce")
    root, said = page.locator(".chr-demo"), page.locator(".chr-said")
    page.get_by_role("button", name="Show me, step by step").click()
    texts = [said.text_content()]
    while page.get_by_role("button", name="Next step").count() > 0:
        page.get_by_role("button", name="Next step").click()
        state = root.get_attribute("data-state")
        page.wait_for_timeout(50)
        assert root.get_attribute("data-state") == state, "it moves"
        texts.append(said.text_content())
    assert len(set(texts)) == len(texts) > 3
    page.get_by_role("button", name="Reset").click()
    assert json.loads(str(root.get_attribute("data-state"))) == demo().state()
    expect(said).to_have_text("")


@each_demo
def test_reset_returns_to_the_start(visit: Visit, page_of: PageOf, demo: type[Demo]) -> None:
    state = {name: demo.class_traits()[name].max for name in demo.controls}
    page = visit(page_of(demo(**state)))
    page.get_by_role("button", name="Reset").click()
    page.wait_for_function(
        "(start) => document.querySelector('.chr-demo').dataset.state === start",
        arg=json.dumps(demo().state(), separators=(",", ":")).replace(".0", ""),
    )


# ── with a kernel ──────────────────────────────────────────────────────────────────────────────

RENDER = """async ([source, values]) => {
  const url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  const { default: widget } = await import(url);
  const heard = {};
  window.values = values;
  window.saved = 0;
  window.model = {
    get: (name) => values[name],
    set(name, value) { values[name] = value; heard[`change:${name}`]?.(); },
    save_changes() { window.saved += 1; },
    on(event, call) { heard[event] = call; },
    off(event) { delete heard[event]; },
  };
  window.close = await widget.render({ model: window.model, el: document.body });
}"""


@each_demo
def test_widget_and_model_follow_each_other(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = visit(page_of())
    name = demo.element.replace("-", "_")
    page.evaluate(RENDER, [(BUILT / f"{name}.mjs").read_text(encoding="utf-8"), demo().state()])
    control = demo.controls[-1]
    slider(page, control).focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("saved") == 1
    assert page.evaluate(f"values.{control}") > demo().state()[control]
    page.evaluate(f"model.set('{control}', {demo.class_traits()[control].max})")
    state = json.loads(str(page.locator(".chr-demo").get_attribute("data-state")))
    assert state[control] == demo.class_traits()[control].max
    page.evaluate("window.close()")
    assert page.locator(".chr-demo").count() == 0
