"""A guess or an exercise, as a notebook shows it and Python answers it."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from chr_notes.lesson.answers import Expected, judge

__all__ = ["Task", "choose"]


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
    replies
        What is said to each letter, where one chooses a picture.
    """

    question: str
    body: str
    expected: Expected | None = None
    replies: Mapping[str, str] = field(default_factory=dict)

    def check(self, answer: str) -> str:
        """Say what is right or wrong with an answer, where the box on the page is dead."""
        if self.replies:
            return self.replies.get(answer.strip().upper(), choose(self.replies))
        if self.expected is None:
            msg = f"expected a task with a number for its answer, got a choice: {self.question}"
            raise TypeError(msg)
        return judge(answer, self.expected)

    def __repr__(self) -> str:
        """Give the question, where no Markdown can be shown."""
        return self.question

    def _repr_markdown_(self) -> str:
        return self.body


def choose(replies: Mapping[str, str]) -> str:
    """Say what to do to someone who has chosen none of the pictures."""
    return f"Choose one of the pictures: {', '.join(replies)}."
