"""What a chapter asks: guesses before it tells, and exercises at its end.

Each is one cell. Its output is Markdown with HTML in it, so that it is typeset in the book and in a
notebook alike, and what is left of it where scripts and styles are stripped still reads.
"""

import ast
import html
import inspect
import json
import re
import textwrap
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import cast

import numpy as np
from numpy.typing import ArrayLike

from chr_notes.lesson.answers import Expected, judge
from chr_notes.lesson.hand import Pictures, Plane, letters, mixed
from chr_notes.lesson.task import Task, choose
from chr_notes.lesson.words import MISCONCEPTIONS, WORDS

__all__ = ["Task", "exercise", "guess", "guess_number"]

_DIGITS, _KEPT = 4, 8  # shown, and kept to compare with
Wrong = Mapping[str, ArrayLike | tuple[ArrayLike, str]]


def exercise(
    number: int,
    question: str,
    worked: Callable[[], ArrayLike] | None = None,
    asked: str | Plane | Pictures = "",
    wrong: Wrong | None = None,
) -> Task:
    """Ask for a number, recognise usual mistakes, and fold the worked solution in below.

    Parameters
    ----------
    number
        The exercise's number in its chapter.
    question
        What is asked, in Markdown.
    worked
        The worked solution: a function of nothing that returns the number, or the numbers of a
        vector. Its docstring is shown as words, its body as code, what it returns as the result.
        Without one there is only the question, as in notebooks for a class.
    asked
        What is asked for: a number in one of `words.UNITS`, with ± before it where the opposite is
        as right, as of a quaternion or of a mere size; the angle, in degrees, of an arrow that
        is dragged in a `Plane`; or one of `Pictures` of what the solution and each mistake lead to.
    wrong
        What usual mistakes lead to, computed as they come about: by the name of the mistake in
        `words.MISCONCEPTIONS`, the number, or the number and a sentence that stands in place of the
        general one.

    Returns
    -------
    Task
        Shown by a notebook; its `check("3*pi/4")` answers where no script does.

    Raises
    ------
    ValueError
        If a mistake leads to the right answer, or to the same as another one.
    KeyError
        If a mistake or a unit has an unknown name.
    """
    head = f'<div class="chr-lesson chr-exercise" id="exercise-{number}">\n'
    question = f"{question} {asked.told()}" if isinstance(asked, Plane) else question
    task = Task(f"Exercise {number}. {question}", "")
    question = f"**Exercise {number}.** {question}\n"
    if worked is None:
        shown = asked.html(number, asked.drawn) if isinstance(asked, Pictures) else ""
        return replace(task, body=f"{head}\n{question}\n{shown}\n</div>\n")
    found = worked(), [_mistake(name, found) for name, found in (wrong or {}).items()]
    if isinstance(asked, Pictures):
        task, answer, result = _chosen(task, number, found, asked)
    else:
        task, answer, result = _typed(task, number, found, asked)
    words, code = _source(worked)
    lines = [
        head,
        question,
        answer,
        "<details>\n<summary>Worked solution</summary>\n",
        f"{words}\n" if words else "",
        f"```python\n{code}\n```\n",
        f"{result}\n",
        "</details>\n</div>\n",
    ]
    return replace(task, body="\n".join(filter(None, lines)))


Found = tuple[ArrayLike, Sequence[tuple[ArrayLike, str]]]


def _typed(task: Task, number: int, found: Found, asked: str | Plane) -> tuple[Task, str, str]:
    """Ask for numbers in a box, with an arrow above it if there is a plane."""
    plane = asked if isinstance(asked, Plane) else None
    either = not plane and str(asked).startswith("±")
    unit = "°" if isinstance(asked, Plane) else asked.removeprefix("±")
    values = _numbers(found[0])
    mistakes = tuple((_numbers(each), words) for each, words in found[1])
    turn = plane.within if plane else 0.0
    expected = Expected(values, unit, wrong=mistakes, turn=turn, either=either)
    _told_apart(task.question, expected)
    data = {"values": values, "unit": unit, "within": expected.within, "wrong": mistakes}
    data |= {"turn": expected.turn} if plane else {}
    data |= {"either": True} if either else {}
    box = _box(f"Your answer to exercise {number}", _asked(values, unit), data, plane=plane)
    return replace(task, expected=expected), box, f"**{_shown(values, unit)}**"


def _chosen(task: Task, number: int, found: Found, by: Pictures) -> tuple[Task, str, str]:
    """Ask for the right one among pictures of what solution and mistakes lead to."""
    options = [(found[0], WORDS["right"]), *found[1]]
    order = mixed([words for _, words in options], task.question)
    replies = {
        letter: options[place][1] for letter, place in zip(letters(len(order)), order, strict=True)
    }
    shown = by.html(number, [options[place][0] for place in order])
    data = _data({**replies, "": choose(replies)})
    box = (
        f'<div class="chr-answer" role="group" hidden data-kind="picture" data-task="{data}">'
        '<button type="button">Check</button> <output aria-live="polite"></output></div>\n'
    )
    right = next(letter for letter, words in replies.items() if words == WORDS["right"])
    others = (f"- {letter}. {words}" for letter, words in replies.items() if letter != right)
    result = "\n".join([f"**{right}**. The others:\n", *others])
    return replace(task, replies=replies), f"{shown}\n{box}", result


def guess(
    question: str, choices: Mapping[str, str], right: str, *, hides_next: bool = False
) -> Task:
    """Have the reader choose before the page tells.

    Parameters
    ----------
    question
        What is asked, in Markdown.
    choices
        What can be chosen, each with the reply to it in Markdown.
    right
        The choice that is right.
    hides_next
        Whether the book shows what the next cell has only after the guess.

    Raises
    ------
    ValueError
        If `right` is none of the choices.
    """
    if right not in choices:
        msg = f"expected the right choice to be one of {list(choices)}, got {right!r}"
        raise ValueError(msg)
    return _guess(question, _choices(question, choices, right), None, hides_next=hides_next)


def guess_number(
    question: str, value: float, unit: str = "", then: str = "", *, hides_next: bool = False
) -> Task:
    """Have the reader guess a number before the page tells, and say by how much it is off.

    Parameters
    ----------
    question
        What is asked, in Markdown.
    value
        The number, with as many digits as are to be shown.
    unit
        Its unit, one of `words.UNITS`.
    then
        What is told of it, in Markdown.
    hides_next
        As for `guess`.
    """
    values = _numbers(value)
    shown = _shown(values, unit)
    task = {"value": values[0], "unit": unit, "shown": shown}
    lines = [
        _box("Your guess", _asked(values, unit), task, kind="guess"),
        f"<details>\n<summary>What it is</summary>\n\n**{shown}.** {then}\n\n</details>\n",
    ]
    return _guess(question, lines, Expected(values, unit), hides_next=hides_next)


def _guess(
    question: str, lines: Iterable[str], expected: Expected | None, *, hides_next: bool
) -> Task:
    hides = " data-hides" if hides_next else ""
    head = f'<div class="chr-lesson chr-guess"{hides}>\n\n**Guess first.** {question}\n'
    return Task(question, "\n".join([head, *lines, "</div>\n"]), expected)


def _choices(question: str, choices: Mapping[str, str], right: str) -> Iterator[str]:
    # Of details with one name a browser keeps one open.
    name = f"guess-{zlib.crc32(question.encode()):08x}"
    for choice, reply in choices.items():
        mark = "✓ **Yes.**" if choice == right else "✗ **No.**"
        kind = "chr-yes" if choice == right else "chr-no"
        yield f'<details name="{name}" class="{kind}">\n<summary>{html.escape(choice)}</summary>\n'
        yield f"{mark} {reply}\n\n</details>\n"


def _box(
    label: str,
    asked: str,
    task: Mapping[str, object],
    kind: str = "exercise",
    plane: Plane | None = None,
) -> str:
    # Hidden until a script can answer. One line: a blank one would end the HTML.
    drawn = f' data-plane="{_data(plane.data())}"' if plane else ""
    return (
        f'<div class="chr-answer" role="group" hidden data-kind="{kind}" data-task="{_data(task)}"'
        f'{drawn}><input type="text" aria-label="{label}, {asked}" placeholder="{asked}" '
        'autocomplete="off" autocapitalize="off" spellcheck="false"> '
        f'<button type="button">{"Check" if kind == "exercise" else "Guess"}</button> '
        '<output aria-live="polite"></output></div>\n'
    )


def _data(task: Mapping[str, object]) -> str:
    return html.escape(json.dumps(task, ensure_ascii=False, separators=(",", ":")))


def _asked(values: Sequence[float], unit: str) -> str:
    count = f"{len(values)} numbers" if len(values) > 1 else "a number"
    return f"{count} in {unit}".replace("^2", "²") if unit else count


def _numbers(found: ArrayLike) -> tuple[float, ...]:
    # The last digits differ from one processor to the next.
    values = np.ravel(np.asarray(found, dtype=float))
    return tuple(float(f"{value:.{_KEPT}g}") + 0.0 for value in values)


def _mistake(name: str, found: ArrayLike | tuple[ArrayLike, str]) -> tuple[ArrayLike, str]:
    general, head = MISCONCEPTIONS[name], f"{name[0].upper()}{name[1:]}"
    own = found[-1] if isinstance(found, tuple) else ""
    if isinstance(own, str) and own:
        # A box shows text as it is, and no Markdown.
        return cast("tuple[ArrayLike, str]", found)[0], f"{head}: {re.sub('[$*]', '', own)}"
    return cast("ArrayLike", found), f"{head}: {general}"


def _told_apart(question: str, expected: Expected) -> None:
    written = ", ".join(map(repr, expected.values))
    if judge(written, expected) != "Right.":
        msg = f"its own solution is not right: {question}"
        raise ValueError(msg)
    for values, words in expected.wrong:
        reply = judge(", ".join(map(repr, values)), expected)
        if reply != words:
            msg = f"{values} is to be answered by {words!r}, is by {reply!r}: {question}"
            raise ValueError(msg)


def _shown(values: Sequence[float], unit: str) -> str:
    numbers = ", ".join(f"{value:.{_DIGITS}g}".replace("-", "−") for value in values)
    numbers = f"({numbers})" if len(values) > 1 else numbers
    return f"{numbers}{'' if unit[:1] in ('°', '') else ' '}{unit}".replace("^2", "²")


def _source(worked: Callable[[], ArrayLike]) -> tuple[str, str]:
    """Take a function apart: its docstring, and its body as one would type it."""
    source = textwrap.dedent(inspect.getsource(worked))
    (function,) = ast.parse(source).body
    if not isinstance(function, ast.FunctionDef):
        msg = f"expected a function by def, got: {source}"
        raise TypeError(msg)
    told = ast.get_docstring(function) or ""
    first = 1 if told else 0
    before = function.body[0].end_lineno if told else function.lineno
    lines = source.splitlines()[before:]
    body = textwrap.dedent("\n".join(lines))
    last = function.body[-1]
    if isinstance(last, ast.Return) and len(function.body) > first:
        body = "".join(body.rsplit("return ", 1))
    return told, body.strip()
