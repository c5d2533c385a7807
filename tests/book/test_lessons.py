"""Exercises, guesses, small print and the switch of the code in the built page."""

import re
from collections.abc import Callable
from pathlib import Path

from playwright.sync_api import Page, expect

Visit = Callable[..., Page]


def test_a_chapter_answers_without_a_kernel(visit: Visit, book: Path) -> None:
    page = visit((book / "notebooks" / "euler.html").as_uri())

    exercise = page.locator("#exercise-2")
    expect(exercise.locator("details")).not_to_have_attribute("open", "")
    box = exercise.get_by_role("textbox", name="Your answer to exercise 2, 3 numbers")
    box.fill("(cos(120°)*cos(10°), sin(120°)*cos(10°), -sin(10°))")
    box.press("Enter")
    expect(exercise.get_by_role("status")).to_have_text("Right.")
    box.fill("-0.492, 0.853, 0.174")
    exercise.get_by_role("button", name="Check").click()
    expect(exercise.get_by_role("status")).to_contain_text("the nose is up")
    exercise.get_by_text("Worked solution").click()
    expect(exercise.locator("pre")).to_contain_text("chr_notes.matrix_from_euler(NOSE)[0]")

    hidden = page.get_by_text("gyros p, q, r read 0.000 8.660 5.000")
    expect(hidden).to_be_hidden()
    guess = page.locator(".chr-guess", has_text="Which gyros read something?")
    guess.get_by_text("r alone").click()
    expect(guess).to_contain_text("It would in a flat turn")
    expect(hidden).to_be_visible()

    number = page.locator(".chr-guess", has=page.get_by_role("textbox")).first
    number.get_by_role("textbox").fill("1")
    number.get_by_role("button").click()
    expect(number.get_by_role("status")).to_have_text(re.compile("It is .*times your guess"))

    folded = page.locator("details.above-input").first
    switch = page.get_by_role("button", name="Show all code")
    switch.click()
    expect(folded).to_have_attribute("open", "")
    page.get_by_role("button", name="Hide all code").click()
    expect(page.locator("div.cell_input").first).to_be_hidden()
    page.reload()
    expect(page.locator("div.cell_input").first).to_be_hidden()


def test_a_link_opens_small_print(visit: Visit, served: str) -> None:
    page = visit(served + "notebooks/euler.html#entry-euler.7.c")
    expect(page.locator("[id='entry-euler.7.c']")).to_have_attribute("open", "")
    expect(page.locator("[id='entry-euler.4.b']")).not_to_have_attribute("open", "")
