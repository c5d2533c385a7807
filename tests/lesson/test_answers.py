"""One table of answers and replies holds Python and the script of the pages to the same."""

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from chr_notes.lesson import script
from chr_notes.lesson.answers import Expected, compare, judge
from chr_notes.lesson.reading import AnswerError, read
from chr_notes.lesson.words import MISCONCEPTIONS, UNITS, WORDS

CASES = json.loads((Path(__file__).parent / "answers.json").read_text(encoding="utf-8"))
EXERCISES = [
    (case["task"], *reply) for case in CASES["exercise"] for reply in case["replies"].items()
]
GUESSES = [(case["task"], *reply) for case in CASES["guess"] for reply in case["replies"].items()]


def expected(task: dict) -> Expected:
    wrong = tuple((tuple(values), words) for values, words in task["wrong"])
    turn, either = task.get("turn", 0.0), task.get("either", False)
    return Expected(tuple(task["values"]), task["unit"], task["within"], wrong, turn, either)


@pytest.mark.parametrize(("task", "text", "reply"), EXERCISES)
def test_what_the_reader_of_a_notebook_is_told(task: dict, text: str, reply: str) -> None:
    assert judge(text, expected(task)) == reply


@pytest.mark.parametrize(("task", "text", "reply"), GUESSES)
def test_how_a_guess_is_answered(task: dict, text: str, reply: str) -> None:
    assert compare(text, task["value"], task["unit"], task["shown"]) == reply


def test_the_page_says_the_same(program: Callable[[str], str]) -> None:
    run = f"""{script()}
const judged = {json.dumps(EXERCISES)}.map(([task, text]) => judge(text, task));
const compared = {json.dumps(GUESSES)}.map(([task, text]) =>
  compare(text, task.value, task.unit, task.shown));
console.log(JSON.stringify([...judged, ...compared]));"""
    done = subprocess.run(
        [program("node"), "-"], input=run, capture_output=True, text=True, check=True
    )
    replies = [reply for *_, reply in EXERCISES + GUESSES]
    assert json.loads(done.stdout) == replies


def test_each_reply_is_in_the_table() -> None:
    replies = [reply for *_, reply in EXERCISES + GUESSES]
    for words in WORDS.values():
        head = words.split("{")[0]
        assert any(reply.startswith(head) for reply in replies), words


@pytest.mark.parametrize("unit", [unit for unit in UNITS if unit])
def test_each_unit_is_read_as_it_is_written(unit: str) -> None:
    assert read(f"12 {unit}") == ((12.0,), unit)


@pytest.mark.parametrize("text", ["__import__('os')", "9**9**9**9", "2;3", "lambda: 1", "i", "m"])
def test_what_is_no_number_is_refused(text: str) -> None:
    with pytest.raises(AnswerError):
        read(text)


def test_mistakes_are_told_in_whole_sentences() -> None:
    for words in MISCONCEPTIONS.values():
        assert words[0].isupper()
        assert words[-1] == "."
