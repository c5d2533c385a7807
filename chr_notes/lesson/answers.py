"""What is right or wrong with a reader's answer, in words.

`lesson.js` says the same in a page, with the same tables; `tests/lesson/answers.json` holds both to
the same replies.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from chr_notes.lesson.reading import AnswerError, read
from chr_notes.lesson.words import UNITS, WORDS

__all__ = ["Expected", "compare", "judge"]

_CLOSE: Final = 1.5
_TEN: Final = 10.0


@dataclass(frozen=True)
class Expected:
    """What an exercise takes for right, and what it recognises.

    Attributes
    ----------
    values
        The right numbers, in `unit`: one, or those of a vector.
    unit
        A key of `words.UNITS`; a number without a unit is read in it.
    within
        Largest error that still counts as right, as a share of the largest of the values.
    wrong
        Numbers that a usual mistake leads to, in `unit`, each with what to say of it.
    turn
        For directions in degrees the largest error that still counts as right, and whole turns
        count for nothing; 0 for other numbers.
    either
        Whether the opposite is as right: of a size, or of a quaternion.
    """

    values: tuple[float, ...]
    unit: str = ""
    within: float = 0.01
    wrong: tuple[tuple[tuple[float, ...], str], ...] = ()
    turn: float = 0.0
    either: bool = False


def _near(values: Sequence[float], others: Sequence[float], expected: Expected) -> bool:
    if len(values) != len(others):
        return False
    if expected.turn:
        pairs = zip(values, others, strict=True)
        return all(abs((a - b + 180) % 360 - 180) <= expected.turn for a, b in pairs)
    margin = expected.within * (max(map(abs, others)) or 1.0) + 1e-12
    return all(abs(a - b) <= margin for a, b in zip(values, others, strict=True))


def judge(text: str, expected: Expected) -> str:
    """Say what is right or wrong with an answer; the solution itself is not given away.

    Examples
    --------
    >>> turn = Expected((90.0,), "°", wrong=(((45.0,), "That is the half angle."),))
    >>> judge("pi/2 rad", turn), judge("45", turn)
    ('Right.', 'That is the half angle.')
    """
    try:
        values, unit = read(text, expected.unit)
    except AnswerError as error:
        return str(error)
    kind, factor = UNITS[expected.unit]
    found, share = UNITS[unit or expected.unit]
    if found != kind:
        return WORDS["kind"].format(found, kind)
    if len(values) != len(expected.values):
        word = "several" if len(expected.values) > 1 else "one"
        return WORDS[word].format(len(expected.values), len(values))
    answer = [value * share / factor for value in values]
    opposite = [-value for value in answer]
    if expected.either and _near(opposite, expected.values, expected):
        return WORDS["right"]
    known = [(expected.values, WORDS["right"]), *expected.wrong]
    replies = [words for numbers, words in known if _near(answer, numbers, expected)]
    if not unit:
        replies += _in_other_units(values, expected)
    if _near(opposite, expected.values, expected):
        replies.append(WORDS["sign"])
    return next(iter(replies), WORDS["not yet"])


def _in_other_units(values: Sequence[float], expected: Expected) -> Iterator[str]:
    kind, factor = UNITS[expected.unit]
    for name, (other, size) in UNITS.items():
        scaled = [value * size / factor for value in values]
        if other == kind and _near(scaled, expected.values, expected):
            yield WORDS["other unit"].format(name or "plain numbers", expected.unit or "them")


def compare(text: str, value: float, unit: str, shown: str) -> str:
    """Say by how much a guess is off, and what it is.

    Examples
    --------
    >>> compare("10", 300.0, "m", "300 m")
    'It is 300 m: 30 times your guess.'
    """
    try:
        values, written = read(text, unit)
    except AnswerError as error:
        return str(error)
    kind, factor = UNITS[unit]
    found, share = UNITS[written] if written else (kind, factor)
    if found != kind:
        return WORDS["kind"].format(found, kind)
    guess = values[0] * share / factor
    if guess == 0 or value == 0:
        return WORDS["far"].format(shown)
    if guess * value < 0:
        return WORDS["other way"].format(shown)
    times = value / guess
    if 1 / _CLOSE <= times <= _CLOSE:
        return WORDS["close"].format(shown)
    word, times = ("under", times) if times > 1 else ("over", 1 / times)
    return WORDS[word].format(shown, f"{times:.0f}" if times >= _TEN else f"{times:.1f}")
