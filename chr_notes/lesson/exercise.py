"""What a chapter asks: guesses before it tells, and exercises at its end.

Each is one cell. Its output is Markdown with HTML in it, so that it is typeset in the book and in a
notebook alike, and what is left of it where scripts and styles are stripped still reads.
"""

import ast
import html
import inspect
import json
import textwrap
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import ArrayLike

from chr_notes.lesson.answers import Expected, judge
from chr_notes.lesson.words import MISCONCEPTIONS

__all__ = ["Task", "exercise", "guess", "guess_number"]

_DIGITS, _KEPT = 4, 8  # shown, and kept to compare with
Wrong = Mapping[str, ArrayLike | tuple[ArrayLike, str]]


@dataclass(frozen=True)
class Task:
    """A guess or an exercise, as a cell shows it.

    Attributes
    ----------
    question
        What is asked, in Markdown.
    body
        The whole, in Markdown with HTML.
    expected
        What counts as right, None where one chooses.
    """

    question: str
    body: str
    expected: Expected | None = None

    def check(self, answer: str) -> str:
        """Say what is right or wrong with an answer, where the box on the page is dead."""
        if self.expected is None:
            msg = f"expected a task with a number for its answer, got a choice: {self.question}"
            raise TypeError(msg)
        return judge(answer, self.expected)

    def __repr__(self) -> str:
        """Give the question, where no Markdown can be shown."""
        return self.question

    def _repr_markdown_(self) -> str:
        return self.body


def exercise(
    number: int,
    question: str,
    worked: Callable[[], ArrayLike] | None = None,
    unit: str = "",
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
    unit
        Of the answer, one of `words.UNITS`.
    wrong
        What usual mistakes lead to, computed as they come about: by the name of the mistake in
        `words.MISCONCEPTIONS`, the number, or the number and a sentence of its own.

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
    asked = f"**Exercise {number}.** {question}\n"
    if worked is None:
        return Task(f"Exercise {number}. {question}", f"{head}\n{asked}\n</div>\n")
    values = _numbers(worked())
    mistakes = tuple(_mistake(name, found) for name, found in (wrong or {}).items())
    expected = Expected(values, unit, wrong=mistakes)
    _told_apart(question, expected)
    words, code = _source(worked)
    task = {"values": values, "unit": unit, "within": expected.within, "wrong": mistakes}
    lines = [
        head,
        asked,
        _box(f"Your answer to exercise {number}", _asked(values, unit), task),
        "<details>\n<summary>Worked solution</summary>\n",
        f"{words}\n" if words else "",
        f"```python\n{code}\n```\n",
        f"**{_shown(values, unit)}**\n",
        "</details>\n</div>\n",
    ]
    return Task(f"Exercise {number}. {question}", "\n".join(filter(None, lines)), expected)


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


def _box(label: str, asked: str, task: Mapping[str, object], kind: str = "exercise") -> str:
    # Hidden until a script can answer. One line: a blank one would end the HTML.
    data = html.escape(json.dumps(task, ensure_ascii=False, separators=(",", ":")))
    return (
        f'<div class="chr-answer" role="group" hidden data-kind="{kind}" data-task="{data}">'
        f'<input type="text" aria-label="{label}, {asked}" placeholder="{asked}" '
        'autocomplete="off" autocapitalize="off" spellcheck="false"> '
        f'<button type="button">{"Check" if kind == "exercise" else "Guess"}</button> '
        '<output aria-live="polite"></output></div>\n'
    )


def _asked(values: Sequence[float], unit: str) -> str:
    count = f"{len(values)} numbers" if len(values) > 1 else "a number"
    return f"{count} in {unit}" if unit else count


def _numbers(found: ArrayLike) -> tuple[float, ...]:
    # The last digits differ from one processor to the next.
    values = np.ravel(np.asarray(found, dtype=float))
    return tuple(float(f"{value:.{_KEPT}g}") + 0.0 for value in values)


def _mistake(name: str, found: ArrayLike | tuple[ArrayLike, str]) -> tuple[tuple[float, ...], str]:
    words = f"{name[0].upper()}{name[1:]}: {MISCONCEPTIONS[name]}"
    more = found[-1] if isinstance(found, tuple) else ""
    if isinstance(more, str) and more:
        return _numbers(cast("tuple[ArrayLike, str]", found)[0]), f"{words} {more}"
    return _numbers(cast("ArrayLike", found)), words


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
