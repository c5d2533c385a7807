"""The words of a step, against what it states: what they name must show.

A table says which sign in LaTeX a word for an operation wants in the step itself, another which one
a word for a quantity wants in the step or in the formula. Symbols in the words are looked for as
well. Whether the words are the reason for what is stated, no table can tell.
"""

import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.ledger.words import SIGNS, met
from chr_notes.typeset import latex

OPERATIONS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "transpose": r"\^\{T\}",
        "undo|undoes|undone|inverse": r"\^\{-1\}|\^\{T\}|= 1(?!\d)|\\left\(- \\|= -1",
        "conjugate": r"\*\}",
        "divided|quotient|per unit|per mass": r"\\frac",
        "squares?|squared": r"\^\{2\}",
        "cube|third power": r"\^\{3\}",
        "sine": r"\\sin",
        "cosine": r"\\cos",
        "tangent": r"\\tan",
        "arctangent": r"atan2",
        "determinant": r"\\det|A =",
        "slope": r"\\partial|= 0",
        "limit": r"\\lim",
        "half the": r"\{2\}",
        "minus": r"-",
        "vanish": r"= 0",
        "magnitude": r"\\left\||\\sqrt|\\lVert",
    }
)
"""Words for what is done, and the signs of which the step shows one."""

QUANTITIES: Final = (
    "roll|rolling",
    "pitch|pitching",
    "yaw|yawing",
    "gyros?'?",
    "magnetometers?(?:'s)?",
    "bias",
    "gravity|gravities",
    "field(?:'s)?",
    "gain",
)
"""Words for quantities, of `words.SIGNS`, of which the step or the formula shows a sign."""

GREEK: Final[Mapping[str, str]] = MappingProxyType(
    {
        letter: rf"\\{name}"
        for letter, name in {
            "α": "alpha", "β": "beta", "δ": "delta", "ε": "varepsilon", "θ": "theta", "σ": "sigma",
            "ϕ": "phi", "ψ": "psi", "ω": "omega",
        }.items()
    }
)  # fmt: skip

ELSEWHERE: Final[Mapping[str, frozenset[str]]] = MappingProxyType(
    {
        "euler.6.d/1": frozenset({"pitch", "roll", "yaw"}),
        "euler.6.e/1": frozenset({"roll", "yaw"}),
        "quaternions.3.a/2": frozenset({"conjugate"}),
        "quaternions.4.1/2": frozenset({"quotient"}),
        "quaternions.4.3/2": frozenset({"quotient"}),
        "quaternions.4.c/1": frozenset({"pitch", "yaw"}),
        "quaternions.4.c/2": frozenset({"pitch", "yaw"}),
        "estimation.2.3/1": frozenset({"yaw"}),
        "estimation.2.6/1": frozenset({"cosine", "magnitude", "pitch", "sine"}),
        "estimation.4.3/1": frozenset({"squares"}),
        "estimation.3.c/2": frozenset({"vanish"}),
        "validation.2/1": frozenset({"yaw"}),
        "validation.11/1": frozenset({"squares"}),
        "validation.g/1": frozenset({"magnitude"}),
        "validation.g/2": frozenset({"pitch", "roll", "yaw"}),
        "validation.h/2": frozenset({"per unit"}),
    }
)
"""Entry and step, and words in it that mean what it does not show: why, or what comes before."""


def check_words(case: Case) -> None:
    """Refuse words of a step that name what does not show.

    Raises
    ------
    CannotJudgeError
        Then. It names each step and word.
    """
    statements = [case.printed.statement, *([case.right] if case.right is not None else [])]
    formula = " ".join(latex(each) for each in statements)
    odd = [
        f"step {place} says “{word}”, which does not show in what it states"
        for place, step in enumerate(case.steps, 1)
        for word in unseen(step.says, latex(step.statement), formula)
        if word.lower() not in ELSEWHERE.get(f"{case.id}/{place}", frozenset())
    ]
    if odd:
        msg = f"{case.id}: {'; '.join(odd)}"
        raise CannotJudgeError(msg)


def unseen(says: str, shown: str, formula: str) -> Iterator[str]:
    """Yield the words of a step that name what neither it nor, for quantities, the formula shows.

    Parameters
    ----------
    says
        The words.
    shown, formula
        What the step states, and what the derivation leads to, in LaTeX.
    """
    wanted = [
        (word, signs, shown) for words, signs in OPERATIONS.items() for word in met(words, says)
    ]
    wanted += [
        (word, SIGNS[words], f"{shown} {formula}")
        for words in QUANTITIES
        for word in met(words, says)
    ]
    wanted += [
        (letter, sign, f"{shown} {formula}") for letter, sign in GREEK.items() if letter in says
    ]
    for word, signs, where in wanted:
        if not re.search(signs, where):
            yield word
