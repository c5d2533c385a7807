"""With a kernel: the demo and its model follow each other, and the model is not flooded."""

from playwright.sync_api import Page, expect

from chr_notes.demos.base import Demo

from .parts import PageOf, Visit, each_kind, hold, let_pass, slider, state_of, unfold

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


def rendered(visit: Visit, page_of: PageOf, demo: type[Demo]) -> Page:
    page = visit(page_of(), own=True)
    hold(page)
    page.evaluate(RENDER, [demo().get_state()["_esm"], demo().state()])
    return page


@each_kind
def test_widget_and_model_follow_each_other(
    visit: Visit, page_of: PageOf, demo: type[Demo]
) -> None:
    page = rendered(visit, page_of, demo)
    unfold(page)
    control = demo.controls[-1]
    slider(page, control).press("ArrowRight")
    assert page.evaluate("saved") == 1
    assert page.evaluate(f"values.{control}") > demo().state()[control]
    most = demo.class_traits()[control].max
    page.evaluate(f"model.set('{control}', {most})")
    assert state_of(page)[control] == most
    page.clock.run_for(300)
    the_model_is_told_a_few_times_a_second_and_of_the_end(page)
    a_change_by_the_kernel_ends_the_story(page, control, most)
    what_still_waits_is_sent_when_the_widget_closes(page, control)
    assert page.locator(".chr-demo").count() == 0


def the_model_is_told_a_few_times_a_second_and_of_the_end(page: Page) -> None:
    page.get_by_role("button", name="Play").click()
    frames = set()
    let_pass(page, 6_000, frame=400)
    before = page.evaluate("saved")
    for _ in range(20):
        page.clock.fast_forward(50)
        frames.add(str(page.locator(".chr-demo").get_attribute("data-state")))
    assert 0 < page.evaluate("saved") - before <= 5
    assert len(frames) > 10
    page.get_by_role("button", name="Pause").click()
    page.clock.run_for(300)
    assert page.evaluate("values") == state_of(page)


def a_change_by_the_kernel_ends_the_story(page: Page, control: str, most: float) -> None:
    page.get_by_role("button", name="Go on").click()
    let_pass(page, 1_000)
    page.evaluate(f"model.set('{control}', {most})")
    let_pass(page, 10_000, frame=2_000)
    assert state_of(page)[control] == most
    expect(page.get_by_role("button", name="Pause")).to_have_count(0)


def what_still_waits_is_sent_when_the_widget_closes(page: Page, control: str) -> None:
    page.clock.run_for(300)
    slider(page, control).press("ArrowLeft")
    slider(page, control).press("ArrowLeft")
    state = state_of(page)
    assert page.evaluate("values") != state
    page.evaluate("window.close()")
    assert page.evaluate("values") == state
