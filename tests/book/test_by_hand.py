"""A picture is chosen and an arrow is dragged, by mouse, by finger and by keys."""

import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

Visit = Callable[..., Page]

SEEN = """(image) => {
  const { width, height } = image.getBoundingClientRect();
  return image.complete && image.naturalWidth > 0 && Math.min(width, height);
}"""


def place(arrow: Locator, part: str = ".chr-arrow") -> tuple[float, float]:
    """The middle of the plane, or of a part of it, in the window."""
    box = arrow.locator(part).bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def at(middle: tuple[float, float], clockwise: float) -> tuple[float, float]:
    """A place on the page, so many degrees from its top."""
    turned = math.radians(clockwise)
    return middle[0] + 60 * math.sin(turned), middle[1] - 60 * math.cos(turned)


def about(angle: int) -> re.Pattern[str]:
    """What the box says of an arrow put there by hand: a pixel is most of a degree."""
    return re.compile(f"^({angle - 1}|{angle}|{angle + 1})°$")


def replied(exercise: Locator, button: str = "Check") -> Locator:
    exercise.get_by_role("button", name=button).click()
    return exercise.get_by_role("status")


def test_an_arrow_is_dragged_moved_by_keys_or_given_as_a_number(visit: Visit, book: Path) -> None:
    page = visit((book / "notebooks" / "euler.html").as_uri())
    exercise = page.locator("#exercise-1")
    arrow = exercise.get_by_role("slider")
    box = exercise.get_by_role("textbox")
    expect(arrow).to_have_attribute("aria-valuetext", "0°, north")
    arrow.scroll_into_view_if_needed()

    middle, tip = place(exercise), place(exercise, ".chr-grip")
    page.mouse.move(*tip)
    page.mouse.down()
    page.mouse.move(*at(middle, 90), steps=3)
    page.mouse.move(*at(middle, 150), steps=3)
    page.mouse.up()
    expect(box).to_have_value(about(150))
    expect(arrow).to_have_attribute("aria-valuetext", re.compile(", between south and east$"))
    page.mouse.move(*at(middle, 20))
    expect(box).to_have_value(about(150))
    expect(replied(exercise)).to_contain_text("Wrong axis: ")

    page.mouse.click(*at(middle, 297))
    expect(box).to_have_value(about(-63))
    expect(replied(exercise)).to_contain_text("Transposed: ")

    arrow.press("Home")
    for key in ("PageUp", "PageUp", "PageUp", "PageUp", "ArrowRight", "ArrowLeft"):
        arrow.press(key)
    expect(arrow).to_have_attribute("aria-valuenow", "60")
    arrow.press("Enter")
    expect(exercise.get_by_role("status")).to_contain_text("So the left wing points.")
    for _ in range(12):
        arrow.press("PageDown")
    expect(arrow).to_have_attribute("aria-valuetext", "-120°, between west and south")
    expect(replied(exercise)).to_have_text("Right.")

    box.fill("3*pi/4 rad")
    expect(arrow).to_have_attribute("aria-valuenow", "135")
    box.fill("3*pi/")
    expect(arrow).to_have_attribute("aria-valuenow", "135")
    turned = place(exercise, ".chr-grip")
    assert math.degrees(math.atan2(turned[0] - middle[0], middle[1] - turned[1])) == pytest.approx(
        135, abs=1
    )


def test_a_finger_drags_the_tip_and_elsewhere_scrolls_the_page(visit: Visit, book: Path) -> None:
    address = (book / "notebooks" / "sensors.html").as_uri()
    page = visit(address, width=320, has_touch=True, is_mobile=True)
    exercise = page.locator("#exercise-2")
    exercise.scroll_into_view_if_needed()
    fingers = page.context.new_cdp_session(page)

    def swipe(places: list[tuple[float, float]]) -> None:
        for i, (x, y) in enumerate(places):
            kind = "touchMove" if i else "touchStart"
            points = [{"x": x, "y": y}]
            fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        fingers.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    grip = exercise.locator(".chr-grip").bounding_box()
    assert grip is not None
    assert min(grip["width"], grip["height"]) >= 44
    before = page.evaluate("scrollY")
    middle = place(exercise)
    swipe([at(middle, 90 - angle) for angle in (0, 10, 25, 40, 59)])
    expect(exercise.get_by_role("textbox")).to_have_value(about(59))
    assert page.evaluate("scrollY") == before
    expect(replied(exercise)).to_have_text("Right.")
    page.touchscreen.tap(*at(place(exercise), 180))
    expect(exercise.get_by_role("textbox")).to_have_value(about(-90))
    x, y = at(place(exercise), 0)
    swipe([(x, y + 15 - 8 * i) for i in range(9)])
    page.wait_for_function("(before) => scrollY > before + 20", arg=before)
    expect(exercise.get_by_role("textbox")).to_have_value(about(-90))


def test_a_picture_is_chosen_by_mouse_or_keys(visit: Visit, served: str) -> None:
    page = visit(served + "notebooks/quaternions.html", width=320, color_scheme="light")
    exercise = page.locator("#exercise-1")
    group = exercise.get_by_role("radiogroup", name="Pictures of exercise 1")
    choices = group.get_by_role("radio")
    expect(choices).to_have_count(4)
    exercise.scroll_into_view_if_needed()
    for theme in ("dark", "light"):
        page.evaluate("(theme) => { document.documentElement.dataset.theme = theme; }", theme)
        for image in group.locator("img").all():
            assert page.wait_for_function(SEEN, arg=image.element_handle()).json_value() >= 44
    expect(replied(exercise)).to_have_text("Choose one of the pictures: A, B, C, D.")

    exercise.locator("label", has_text="C").click()
    expect(replied(exercise)).to_have_text(re.compile("^Half angle: "))
    choices.nth(2).press("ArrowLeft")
    expect(group.get_by_role("radio", checked=True)).to_have_value("B")
    page.keyboard.press("Enter")
    expect(exercise.get_by_role("status")).to_have_text(re.compile("^Conjugate: "))
    group.get_by_role("radio", name="Nose: north 0.28, east 0.96, down 0.00").check()
    expect(replied(exercise)).to_have_text("Right.")
    assert page.evaluate("document.documentElement.scrollWidth") <= 320


def test_without_scripts_both_are_still_questions(browser: Browser, book: Path) -> None:
    # Not by `visit`: what the page would load in advance for its scripts counts as failed there.
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((book / "notebooks" / "quaternions.html").as_uri())
    expect(page.locator("#exercise-1 img")).to_have_count(4)
    expect(page.locator("#exercise-6 .chr-answer")).to_be_hidden()
    expect(page.locator("#exercise-6")).to_contain_text("counted from north towards east")
    page.locator("#exercise-1 summary").click()
    expect(page.locator("#exercise-1")).to_contain_text("C. Half angle: ")
    context.close()
