"""Arrows to drag and pictures to choose, as a cell of a notebook shows and answers them."""

import base64
import html
import json
import re

import numpy as np
import pytest

import chr_notes
from chr_notes.lesson import COMPASS, FROM_ABOVE, FROM_ASIDE, FROM_BEHIND, Pictures, Task, exercise
from chr_notes.lesson.pictures import Drawing, from_above, path

TURNED = chr_notes.matrix_from_euler(np.radians([0, 0, 70]))
HALF = chr_notes.matrix_from_euler(np.radians([0, 0, 35]))


def heading() -> float:
    """Three quarters of a turn, less a third of one."""
    return 240


def attitude() -> np.ndarray:
    """To the right by 70°."""
    return TURNED


def arrow(**wrong: object) -> Task:
    return exercise(2, "Where to?", heading, COMPASS, wrong=wrong)


def choice() -> Task:
    wrong = {"transposed": TURNED.T, "half angle": (HALF, "Twice that.")}
    return exercise(4, "How is it turned?", attitude, Pictures(from_above), wrong=wrong)


def pictures(task: Task) -> dict[str, Drawing]:
    """What a reader sees, by its letter."""
    shown = re.findall(r'value="(\w)"> \1 <img alt="([^"]*)" src="[^,]*;base64,([^"]*)"', task.body)
    return {
        letter: Drawing(base64.b64decode(data).decode(), html.unescape(alt))
        for letter, alt, data in shown
    }


@pytest.mark.parametrize("plane", [COMPASS, FROM_ABOVE, FROM_ASIDE, FROM_BEHIND])
def test_a_right_angle_leads_from_one_name_to_the_next(plane: object) -> None:
    data = plane.data()
    for angle, name in ((0, plane.start), (90, plane.towards)):
        on_the_page = (data["start"] + data["sense"] * angle) % 360
        assert plane.names[on_the_page // 90] == name


def test_an_arrow_is_answered_as_a_direction() -> None:
    task = arrow(sign=(60, "The other wing."), transposed=-63.4)
    assert task.check("-117°") == task.check("244") == task.check("4*pi/3 rad") == "Right."
    assert task.check("-114°") == "Not yet. The way there is folded in below."
    assert task.check("63°").endswith("The other wing.")
    assert task.check("297°").startswith("Transposed: ")
    with pytest.raises(ValueError, match=r"is by 'Right\.'"):
        arrow(sign=-122)


def test_an_arrow_reads_as_a_question_with_a_number_to_give() -> None:
    question, _, box = arrow().body.partition('<div class="chr-answer"')
    assert "give its angle in degrees, counted from north towards east." in question
    assert " hidden " in box.partition(">")[0]
    (plane,) = re.findall(r'data-plane="([^"]*)"', box)
    assert json.loads(html.unescape(plane)) == dict(COMPASS.data()) | {"names": [*COMPASS.names]}


def test_each_letter_is_answered_by_what_its_picture_comes_from() -> None:
    task = choice()
    drawn = pictures(task)
    expected = {
        from_above(TURNED).alt: "Right.",
        from_above(TURNED.T).alt: "Transposed: ",
        from_above(HALF).alt: "Half angle: ",
    }
    assert {each.alt for each in drawn.values()} == {*expected}
    for letter, drawing in drawn.items():
        assert task.check(f" {letter.lower()} ").startswith(expected[drawing.alt])
    for other in ("", "D", "74°"):
        assert task.check(other) == "Choose one of the pictures: A, B, C."
    (data,) = re.findall(r'data-kind="picture" data-task="([^"]*)"', task.body)
    told = json.loads(html.unescape(data))
    assert {letter: task.check(letter) for letter in ("", *drawn)} == told


def test_the_solution_names_the_picture_and_the_mistakes_of_the_others() -> None:
    task = choice()
    asked, _, solved = task.body.partition("<details>")
    right = next(letter for letter in "ABC" if task.check(letter) == "Right.")
    assert f"**{right}**. The others:" in solved
    for letter in {*"ABC"} - {right}:
        assert f"- {letter}. {task.check(letter)}" in solved
    assert "Half angle" not in asked.partition('<div class="chr-answer"')[0]


def test_pictures_that_are_alike_are_refused() -> None:
    with pytest.raises(ValueError, match="of exercise 1 have the same svg"):
        exercise(1, "?", attitude, Pictures(from_above), wrong={"sign": TURNED + 1e-9})
    blind = Pictures(lambda each: Drawing(from_above(each).svg, "An aircraft."))
    with pytest.raises(ValueError, match="of exercise 1 have the same alt"):
        exercise(1, "?", attitude, blind, wrong={"sign": HALF})


def test_a_class_sees_the_pictures_and_no_reply() -> None:
    with_replies = choice()
    (kept,) = re.findall('data-drawn="([^"]*)"', with_replies.body)
    drawn = json.loads(html.unescape(kept))
    asked = exercise(4, "How is it turned?", asked=Pictures(from_above, drawn=drawn))
    assert pictures(asked) == pictures(with_replies)
    assert "data-task" not in asked.body
    assert "towards east." in exercise(2, "Where to?", asked=COMPASS).body


def test_the_aircraft_is_drawn_where_its_axes_point() -> None:
    drawn = from_above(TURNED)
    assert drawn.alt.startswith("Nose: north 0.34, east 0.94, down 0.00. Right wing: north -0.94,")
    lines = dict(re.findall(r'<path class="([xy])" [^>]*d="M100 100L(\d+ \d+)"', drawn.svg))
    for row, name in zip(TURNED, "xy", strict=False):
        north, east, _ = row
        right, below = map(int, lines[name].split())
        across = (right - 100, 100 - below)
        assert np.degrees(np.arctan2(*across) - np.arctan2(east, north)) == pytest.approx(0, abs=1)
    (dash,) = re.findall(r'class="y" stroke-width="3" stroke-dasharray="([^"]*)"', drawn.svg)
    assert dash == "7 3"


def test_a_line_is_drawn_to_scale_and_told() -> None:
    drawn = path([[0, 0], [5, 0], [5, 10]], 10.0, beside=[[0, 0], [-10, 0]], every=2)
    assert drawn.alt == "Through (north, east) = (0, 0), (5, 10)."
    (line,) = re.findall(r'class="ink" stroke-width="4" d="M([^"]*)"', drawn.svg)
    assert line == "100 100L100 52L197 52"
    assert 'stroke-dasharray="6 5" d="M100 100L100 197"' in drawn.svg
