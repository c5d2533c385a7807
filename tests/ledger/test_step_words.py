"""The words of steps name what the steps show."""

from dataclasses import replace

import pytest

from chr_notes.ledger.case import CannotJudgeError
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.step_words import ELSEWHERE, check_words


@pytest.mark.parametrize(
    ("name", "place", "word", "other"),
    [
        ("euler.3.1", 1, "Yaw", "Pitch"),
        ("euler.5.5", 2, "transpose", "conjugate"),
        ("validation.12", 1, "transpose", "magnitude"),
        ("quaternions.3.a", 1, "squares", "sines"),
        ("estimation.2.4", 2, "gravity", "the field"),
        ("validation.4", 2, "sine", "tangent"),
        ("validation.d", 1, "exact", "δ"),
        ("dead_reckoning.4.g", 1, "ε", "ω"),
    ],
)
def test_a_word_that_does_not_show_is_refused(name: str, place: int, word: str, other: str) -> None:
    case = CASES[name]
    steps = list(case.steps)
    wrong = steps[place - 1].says.replace(word, other).replace("sines", "cosine", 1)
    assert wrong != steps[place - 1].says
    steps[place - 1] = replace(steps[place - 1], says=wrong)
    with pytest.raises(CannotJudgeError, match=f"{name}: step {place} says"):
        check_words(replace(case, steps=tuple(steps)))


def test_what_is_meant_otherwise_is_said() -> None:
    for key, words in ELSEWHERE.items():
        name, place = key.split("/")
        says = CASES[name].steps[int(place) - 1].says.lower()
        assert all(word in says for word in words), key
