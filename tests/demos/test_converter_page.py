"""The converter on a page."""

import json
import re

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from chr_notes.demos import ConverterDemo
from chr_notes.demos.converter import KINDS

from .modules import ROTATION
from .parts import PageOf, Visit, output
from .test_converter import EXTREME, RANDOM, are_those_of_python, states
from .test_converter_texts import TABLE, TEXTS


def numbers(page: Page, name: str) -> list[float]:
    text = str(output(page, name).text_content())
    return [float(each) for each in re.split(r"[,\n]\s*", text)]


def test_on_a_page_from_a_file(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ConverterDemo()), width=1280)
    page.locator('textarea[name="matrix"]').fill(str(ROTATION).replace("-", "−"))
    page.locator('select[name="target"]').select_option("SciPy")
    expected = ConverterDemo(
        kind="matrix", value=np.ravel(ROTATION).tolist(), target="SciPy", target_unit=""
    ).readouts()
    for kind in KINDS:
        got = numbers(page, f"target_{kind.replace(' ', '_')}")
        assert got == pytest.approx(expected[kind], abs=1e-13)
    # What is no rotation is said, no number is left, and the nearest one is offered.
    page.locator('textarea[name="matrix"]').fill(str(np.round(ROTATION, 2).tolist()))
    expect(page.locator(".chr-fault")).to_contain_text("No rotation: R Rᵀ is off")
    expect(output(page, "target_quaternion")).to_have_text("–")
    page.get_by_role("button", name="Take the nearest rotation").click()
    expect(page.locator(".chr-fault")).to_be_hidden()
    assert numbers(page, "target_quaternion") == pytest.approx(expected["quaternion"], abs=5e-3)
    check_typing(page, expected["quaternion"])
    # The address keeps all digits.
    page.locator('textarea[name="quaternion"]').fill("0.5 0.1 0.2 0.3333333333333333")
    page.wait_for_function("location.hash.includes('0.3333333333333333')")
    before = numbers(page, "target_matrix")
    page.reload()
    assert numbers(page, "target_matrix") == before
    page.get_by_role("button", name="Swap").click()
    page.get_by_role("button", name="Swap").click()
    assert numbers(page, "target_matrix") == pytest.approx(before, abs=1e-15)
    page.get_by_role("button", name="Reset").click()
    expect(page.locator('textarea[name="angles"]')).to_have_value("10, 20, 30")
    page.locator('input[type="range"][name="turn_2"]').press("End")
    expect(page.locator('textarea[name="angles"]')).to_have_value("10, 180, 30")
    page.locator('textarea[name="angles"]').fill("10 90 30")
    expect(output(page, "source_lock")).to_contain_text("At the lock")
    expect(output(page, "target_lock")).to_contain_text("At the lock")
    check_a_narrow_screen(page)


LINES = """(each) => {
  const style = getComputedStyle(each);
  const height = each.scrollHeight - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom);
  return [height, parseFloat(style.lineHeight), each.scrollWidth, each.clientWidth];
}"""
"""The height of the text, that of a line, and the width that the text needs and has."""
CHOSEN = """(each) => {
  const context = document.createElement("canvas").getContext("2d");
  context.font = getComputedStyle(each).font;
  return [context.measureText(each.selectedOptions[0].text).width, each.clientWidth];
}"""
"""The width of what is chosen, and that of its field."""


def check_typing(page: Page, pasted: list[float]) -> None:
    """What is being typed stays under the cursor, and means what its field is for."""
    quaternion = page.locator('textarea[name="quaternion"]')
    quaternion.fill("")
    quaternion.press_sequentially("0.1, 0.2, 0.3")
    expect(page.locator(".chr-fault")).to_have_text("Expected 4 numbers, found 3.")
    expect(output(page, "source_triples")).to_have_text("the last valid attitude")
    expect(page.get_by_role("button", name="Copy as")).to_be_disabled()
    quaternion.press_sequentially(", 0.9273618")
    expect(quaternion).to_have_value("0.1, 0.2, 0.3, 0.9273618")
    expect(output(page, "source_triples")).to_contain_text("360° more or less")
    expect(page.get_by_role("button", name="Copy as")).to_be_enabled()
    # A matrix that is pasted there is a matrix.
    page.locator('textarea[name="matrix"]').fill(str(ROTATION))
    page.locator('textarea[name="matrix"]').press("Control+a")
    page.locator('textarea[name="matrix"]').press("Control+c")
    quaternion.fill("1 0 0 0")
    quaternion.press("Control+a")
    quaternion.press("Control+v")
    assert numbers(page, "target_quaternion") == pytest.approx(pasted, abs=1e-13)


def check_a_narrow_screen(page: Page) -> None:
    """Each row of a matrix is a line there, and no field or choice hides what it has."""
    page.locator('textarea[name="angles"]').fill("10.123456789 20.123456789 30.123456789")
    page.set_viewport_size({"width": 390, "height": 844})
    expect(page.locator(".chr-aside").last).to_have_text("Shown with 8 decimals, copied with all.")
    for name in ('output[name="target_matrix"]', 'textarea[name="matrix"]'):
        height, line, wide, room = page.locator(name).evaluate(LINES)
        assert height / line == pytest.approx(3, abs=0.1), name
        assert wide <= room, name
    for name in ("angles", "axis angle"):
        lacking = page.locator(f'textarea[name="{name}"]').evaluate(
            "(each) => each.scrollHeight - each.clientHeight"
        )
        assert lacking <= 0, name
    for select in page.locator(".chr-choices select").all():
        wide, room = select.evaluate(CHOSEN)
        assert wide + 30 <= room  # beside the arrow


def test_another_spelling_is_the_same_attitude(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ConverterDemo()))
    before = numbers(page, "target_matrix")
    page.locator('select[name="source_unit"]').select_option("radians")
    page.locator('select[name="source_sequence"]').select_option("ZXZ")
    assert numbers(page, "target_matrix") == pytest.approx(before, abs=1e-14)
    # What is announced tells the change, though the other side stays as it was.
    angles = page.locator('textarea[name="angles"]').input_value().split(", ")
    told = ", ".join(f"{float(each):.4f}".rstrip("0") for each in angles).replace("-", "−")
    expect(page.locator(".chr-live")).to_contain_text(f"angles {told}, radians")
    # Another system takes the numbers for its own.
    page.locator('select[name="source"]').select_option("CHR")
    page.locator('textarea[name="angles"]').fill("10, 20, 30")
    page.locator('select[name="source"]').select_option("this book")
    expect(page.locator('textarea[name="angles"]')).to_have_value("10, 20, 30")
    assert numbers(page, "target_matrix") != pytest.approx(before, abs=1e-2)


def test_an_address_that_means_nothing_changes_nothing(visit: Visit, page_of: PageOf) -> None:
    address = page_of(ConverterDemo())
    page = visit(address)
    for query in ("kind=matrix&value=1,2,3", "value=a,b,c", "source=Excel", "target_sequence=ZZX"):
        page.goto("about:blank")
        page.goto(f"{address}#converter?{query}")
        state = json.loads(str(page.locator(".chr-demo").get_attribute("data-state")))
        assert state == ConverterDemo().state(), query


TYPED = """(given) => given.map(({ kind, texts, ...choices }) => {
  const put = (element, value, event) => {
    element.value = value;
    element.dispatchEvent(new Event(event, { bubbles: true }));
  };
  document.querySelector('button[name="reset"]').click();
  for (const [name, value] of Object.entries(choices))
    if (value) put(document.querySelector(`select[name="${name}"]`), value, "change");
  put(document.querySelector(`textarea[name="${kind}"]`), texts, "input");
  const said = (name) => document.querySelector(`output[name="${name}"]`).textContent;
  const kinds = ["angles", "quaternion", "axis_angle", "matrix"];
  return Object.fromEntries(kinds.map((name) => [name.replace("_", " "), said(`target_${name}`)]));
})"""


def typed(page: Page, given: list[dict[str, str]]) -> list[dict[str, list[float] | None]]:
    """What the page says of each text that is typed, after its choices are made."""
    return [
        {
            kind: None if text == "–" else [float(each) for each in re.split(r"[,\n]\s*", text)]
            for kind, text in said.items()
        }
        for said in page.evaluate(TYPED, given)
    ]


@pytest.mark.full
def test_all_states_and_texts_on_a_page_from_a_file(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(ConverterDemo()), width=1280)  # all digits
    given = states(RANDOM, EXTREME)
    choices = [{k: v for k, v in state.items() if k != "value"} for state in given]
    texts = [", ".join(map(repr, state["value"])) for state in given]
    pairs = zip(choices, texts, strict=True)
    said = typed(page, [{**choice, "texts": text} for choice, text in pairs])
    for state, each in zip(given, said, strict=True):
        there = {kind: np.array(each[kind], dtype=float) for kind in KINDS}
        are_those_of_python(state, there, rounded=5e-15)  # half a unit of the 15th digit
    # Pasted texts: an attitude in the notation of its kind, or none at all.
    for kind, text in TEXTS.values():
        (said_,) = typed(page, [{"kind": kind, "source": "PX4", "target": "PX4", "texts": text}])
        assert said_[kind] == pytest.approx(np.ravel(ROTATION), abs=1e-6)
    for text, expected in TABLE.items():
        first = expected is None or expected[1]
        kind = "angles" if expected is None else expected[0]
        system = "PX4" if first else "SciPy"
        (said_,) = typed(page, [{"kind": kind, "source": system, "target": system, "texts": text}])
        assert (said_[kind] is None) == (expected is None), text
