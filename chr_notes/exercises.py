"""Answers to a chapter's exercises, checked where the reader works."""

import math


def check(answer: float | None, solution: float, *, within: float = 0.01) -> str:
    """Compare a reader's number with the solution.

    Parameters
    ----------
    answer
        The reader's number, or None as long as there is none.
    solution
        The right number, in the same unit.
    within
        Largest relative error that still counts as right.

    Returns
    -------
    str
        What to tell the reader; it does not give the solution away.
    """
    if answer is None:
        return "No answer yet: put your number in the cell above and run both."
    if math.isclose(answer, solution, rel_tol=within, abs_tol=1e-12):
        return "Right."
    if math.isclose(answer, -solution, rel_tol=within):
        return "The size is right, the sign is not."
    if math.isclose(math.radians(answer), solution, rel_tol=within) or math.isclose(
        math.degrees(answer), solution, rel_tol=within
    ):
        return "Degrees and radians are mixed up."
    return "Not yet. The solution is folded in below the question."
