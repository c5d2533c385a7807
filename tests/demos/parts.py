"""Where the parts of a demo are, for the tests of all demos."""

import json
from collections.abc import Callable, Mapping, Sequence

import numpy as np
import pytest
from playwright.sync_api import Locator, Page

from chr_notes import demos
from chr_notes.demos import (
    ConverterDemo,
    DetectiveDemo,
    FilterDemo,
    FramesDemo,
    GimbalLockDemo,
    MagnetometerDemo,
    QuaternionDemo,
    TiltDemo,
    ValidationDemo,
)
from chr_notes.demos.base import Demo, entry, rounded

Visit = Callable[..., Page]
PageOf = Callable[..., str]
Samples = Callable[[int, int], int]

ALL: tuple[type[Demo], ...] = tuple(getattr(demos, name) for name in demos.__all__)
# These have fields where the others have sliders and a story.
DEMOS = tuple(demo for demo in ALL if demo not in (ConverterDemo, DetectiveDemo))

# Of whose picture something is held, and the parts of the state that it moves, by keys as well.
HELD_BY_KEYS: dict[type[Demo], set[str]] = {
    FramesDemo: {"wind"},
    GimbalLockDemo: {"yaw"},
    MagnetometerDemo: {"turned"},
    QuaternionDemo: {"axis_yaw", "axis_pitch"},
    ValidationDemo: {"axis_yaw", "axis_pitch"},
}

# The parts of the state whose sliders are folded away until they are asked for.
FOLDED: dict[type[Demo], tuple[str, ...]] = {ValidationDemo: ("iron", "inclination")}

each_demo = pytest.mark.parametrize("demo", DEMOS, ids=lambda demo: demo.element)

# What all do by the same code is tried on one of each kind of picture; on all with --full.
KINDS = (FilterDemo, GimbalLockDemo, TiltDemo)
each_kind = pytest.mark.parametrize(
    "demo",
    [
        pytest.param(demo, id=demo.element, marks=() if demo in KINDS else pytest.mark.full)
        for demo in DEMOS
    ],
)


def output(page: Page | Locator, name: str) -> Locator:
    return page.locator(f'output[name="{name}"]')


def slider(page: Page | Locator, name: str) -> Locator:
    """What moves a value: a slider, or a choice."""
    return page.locator(f':is(input[type="range"], select)[name="{name}"]')


def field(page: Page, name: str) -> Locator:
    """The number beside a slider."""
    return page.locator(".chr-control", has=slider(page, name)).locator('input[type="number"]')


def state_of(page: Page | Locator) -> dict[str, float]:
    """The state of the first demo of a page, or of a part of it."""
    state: dict[str, float] = json.loads(
        str(page.locator(".chr-demo").first.get_attribute("data-state"))
    )
    return state


def unfold(page: Page) -> None:
    """Open what holds the sliders that are folded away."""
    page.locator(".chr-controls details").evaluate_all(
        "(all) => all.forEach((each) => { each.open = true; })"
    )


def changed(page: Page, demo: Demo) -> set[str]:
    """What of the state is not as it was."""
    now = state_of(page)
    return {name for name, value in demo.state().items() if now[name] != value}


def hold(page: Page) -> None:
    """Stop the time of the page: only `let_pass` and `page.clock` make it pass."""
    page.clock.install(time=0)
    page.clock.pause_at(1_000)


def let_pass(page: Page, milliseconds: int, *, frame: int = 200) -> None:
    """Let time pass with a frame now and then; `page.clock.run_for` would draw sixty a second."""
    for _ in range(0, milliseconds, frame):
        page.clock.fast_forward(frame)


PICTURE = """async (canvas) => {
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const { width, height } = canvas;
  const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, width, height);
  let sum = 0;
  for (const number of new Uint32Array(data.buffer)) sum = (31 * sum + number) | 0;
  return sum;
}"""


def picture(page: Page | Locator) -> int:
    """A number for what is drawn, once it has been; another picture has another."""
    drawn: int = page.locator("canvas").evaluate(PICTURE)
    return drawn


SET_AND_READ = """(states) => states.map((state) => {
  for (const [name, value] of Object.entries(state)) {
    const input = document.querySelector(`:is(input, select)[name="${name}"]`);
    input.value = value;
    input.dispatchEvent(new Event("input"));
  }
  const outputs = [...document.querySelectorAll("output")];
  const texts = outputs.map((output) => [output.name, output.textContent]);
  return [
    JSON.parse(document.querySelector(".chr-demo").dataset.state),
    Object.fromEntries(texts),
  ];
})"""
"""Set the sliders to each of some positions; return the states and the texts of the outputs."""

RECORD = """() => {
  window.drawn = [];
  const { fill, fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fill = function (...given) {
    window.drawn.push(["", this.fillStyle]);
    return fill.apply(this, given);
  };
  CanvasRenderingContext2D.prototype.fillText = function (text, ...given) {
    window.drawn.push([text, this.fillStyle]);
    return fillText.call(this, text, ...given);
  };
  document.body.dataset.again = "draw";
}"""


def drawn(page: Page) -> list[tuple[str, str]]:
    """What is painted, in order: the words, or none for an area, and the colour of each."""
    page.evaluate(RECORD)
    picture(page)
    return [(text, colour) for text, colour in page.evaluate("drawn")]


Numbers = Mapping[str, float | Sequence[float]]


def random_states(
    demo: type[Demo], steps: Mapping[str, float], seed: int
) -> list[dict[str, float]]:
    """Fifty states within the sliders of a demo, each value on a step of its slider."""
    random = np.random.default_rng(seed)
    limits = {name: demo.class_traits()[name] for name in demo.controls}
    return [
        {
            name: round(
                float(random.integers(each.min / step, each.max / step, endpoint=True) * step), 6
            )
            for (name, each), step in zip(limits.items(), steps.values(), strict=True)
        }
        for _ in range(50)
    ]


def shown(value: float | Sequence[float]) -> str:
    """A number, or numbers in a column, as an output shows it."""
    if isinstance(value, (int, float)):
        return rounded(value)
    return "\n".join(entry(each).rjust(6) for each in value)


def check_readouts(
    page: Page, states: list[dict[str, float]], expected: Callable[[dict[str, float]], Numbers]
) -> None:
    """Set the sliders to each state, and compare the outputs with the expected numbers."""
    for state, (now, texts) in zip(states, page.evaluate(SET_AND_READ, states), strict=True):
        assert now == state
        numbers = expected(state)
        assert {name: texts[name] for name in numbers} == {
            name: shown(value) for name, value in numbers.items()
        }, state
