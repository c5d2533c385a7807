"""An exercise shows question, box and worked solution; a guess is answered when it is made."""

import html
import json
import math
import re

import pytest

from chr_notes.lesson import Task, begin, exercise, guess, guess_number
from chr_notes.lesson.words import UNITS


def worked() -> float:
    """Twice the angle whose cosine is $0.6$."""
    half = math.acos(0.6)  # in radians
    return math.degrees(2 * half)


def task(**more: object) -> Task:
    return exercise(3, "By how many degrees?", worked, "°", **more)


def test_the_worked_solution_is_what_was_executed() -> None:
    body = task().body
    assert "Twice the angle whose cosine is $0.6$." in body
    assert "```python\nhalf = math.acos(0.6)  # in radians\nmath.degrees(2 * half)\n```" in body
    assert "**106.3°**" in body
    assert body.index("By how many") < body.index("<details>") < body.index("106.3°")


def test_a_page_gets_the_same_numbers_and_words_as_python() -> None:
    shown = task(wrong={"half angle": (53.13, "Double it.")})
    (data,) = re.findall(r'data-task="([^"]*)"', shown.body)
    found = json.loads(html.unescape(data))
    assert found["values"] == [pytest.approx(106.2602, abs=1e-4)]
    ((values, words),) = found["wrong"]
    assert values == [53.13]
    assert words == "Half angle: Double it."
    assert shown.check("53.13°") == words
    assert shown.check("2*acos(0.6) rad") == "Right."


def test_a_mistake_without_a_sentence_of_its_own_has_the_general_one() -> None:
    assert task(wrong={"half angle": 53.13}).check("53.13°").startswith("Half angle: A quaternion")
    marked = task(wrong={"half angle": (53.13, "Not $q$, but *twice* it.")})
    assert marked.check("53.13°") == "Half angle: Not q, but twice it."


def test_a_size_is_right_with_either_sign() -> None:
    assert task().check("-106.26") == "The size is right, the sign is not."
    shown = exercise(3, "By how much?", worked, "±°")
    assert shown.check("-106.26") == shown.check("106.26") == "Right."
    assert '"either":true' in html.unescape(shown.body)
    assert '"either"' not in task().body


def test_html_ends_where_markdown_begins() -> None:
    for line in task().body.splitlines():
        assert "<" not in line or line.startswith("<")
    assert re.search(r"</div>\n\n<details>", task().body)


def test_a_solution_of_several_numbers() -> None:
    shown = exercise(1, "Which quaternion?", plain_numbers, wrong={"scalar last": (0, 0, 0.8, 0.6)})
    assert shown.check("(0.6, 0, 0, 0.8)") == "Right."
    assert shown.check("0, 0, 0.8, 0.6").startswith("Scalar last: ")
    assert "**(0.6, 0, 0, 0.8)**" in shown.body
    assert repr(shown) == "Exercise 1. Which quaternion?"


def plain_numbers() -> tuple[float, ...]:
    return (0.6, 0, 0, 0.8)


def test_a_mistake_that_is_none_is_refused() -> None:
    with pytest.raises(ValueError, match=r"is by 'Right\.'"):
        task(wrong={"half angle": 106.2})
    with pytest.raises(ValueError, match="is to be answered by 'Sign"):
        task(wrong={"half angle": 53.13, "sign": 53.1})
    with pytest.raises(KeyError, match="halved"):
        task(wrong={"halved": 53.13})
    with pytest.raises(KeyError, match="parsec"):
        exercise(1, "How far?", worked, "parsec")


def test_each_choice_has_its_reply() -> None:
    shown = guess("Left & right?", {"left <": "So it is.", "right": "It is not."}, "left <")
    assert "<summary>left &lt;</summary>\n\n✓ **Yes.** So it is." in shown.body
    assert "<summary>right</summary>\n\n✗ **No.** It is not." in shown.body
    assert len(set(re.findall(r'name="([\w-]+)"', shown.body))) == 1
    with pytest.raises(TypeError, match="got a choice"):
        shown.check("left")
    with pytest.raises(ValueError, match="got 'there'"):
        guess("How far?", {"here": "no"}, "there")


def test_a_guessed_number_is_told_in_the_box_and_below() -> None:
    shown = guess_number("How far?", 308, "m", "Half of g t².")
    assert '"shown":"308 m"' in html.unescape(shown.body)
    assert "**308 m.** Half of g t²." in shown.body


def test_a_notebook_gets_style_and_script_once() -> None:
    text = begin()._repr_html_()
    assert text.count("<style>") == text.count("<script>") == 1
    assert ".chr-lesson" in text
    assert all(json.dumps(unit, ensure_ascii=False) in text for unit in UNITS)
