"""What makes a lesson of a chapter: guesses, exercises, and their style and script."""

from chr_notes.lesson.exercise import Task, exercise, guess, guess_number
from chr_notes.lesson.hand import COMPASS, FROM_ABOVE, FROM_ASIDE, FROM_BEHIND, Pictures, Plane
from chr_notes.lesson.style import begin, script, styles

__all__ = [
    "COMPASS",
    "FROM_ABOVE",
    "FROM_ASIDE",
    "FROM_BEHIND",
    "Pictures",
    "Plane",
    "Task",
    "begin",
    "exercise",
    "guess",
    "guess_number",
    "script",
    "styles",
]
