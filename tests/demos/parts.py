"""Where the parts of a demo are, for the tests of all demos."""

from collections.abc import Callable

from playwright.sync_api import Locator, Page

from chr_notes.demos import DriftDemo, GimbalLockDemo, TiltDemo

Visit = Callable[..., Page]
PageOf = Callable[..., str]

DEMOS = (DriftDemo, GimbalLockDemo, TiltDemo)


def output(page: Page | Locator, name: str) -> Locator:
    return page.locator(f'output[name="{name}"]')


def slider(page: Page | Locator, name: str) -> Locator:
    return page.locator(f'input[type="range"][name="{name}"]')


def picture(page: Page | Locator) -> str:
    """What is drawn, once it has been."""
    page.locator("canvas").evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )
    return str(page.locator("canvas").evaluate("(canvas) => canvas.toDataURL()"))


SET_AND_READ = """(states) => states.map((state) => {
  for (const [name, value] of Object.entries(state)) {
    const input = document.querySelector(`input[name="${name}"]`);
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
