"""Exercises say what is wrong with an answer without giving the right one away."""

import math

import pytest

from chr_notes.exercises import check


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (None, "No answer yet"),
        (2.0, "Right."),
        (2.01, "Right."),
        (-2.0, "The size is right"),
        (math.degrees(2.0), "Degrees and radians"),
        (math.radians(2.0), "Degrees and radians"),
        (3.0, "Not yet"),
    ],
)
def test_what_the_reader_is_told(answer: float | None, expected: str) -> None:
    assert check(answer, 2.0).startswith(expected)
