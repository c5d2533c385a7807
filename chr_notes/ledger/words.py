"""Our words for a statement, against its formula: a sense that is turned round does not fit.

One table says which sign in LaTeX a word of sense wants, another which word a sign wants; numbers
are looked for as they are, as fractions, and 90 as half of pi. Words for what stands only in the
meaning of a symbol, or in an equality, are listed by entry, and wanted there.
"""

import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final

from sympy import Rational

from chr_notes.ledger.case import CannotJudgeError, Case
from chr_notes.typeset import latex

SIGNS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "negative": r"< 0",
        "positive": r"> 0",
        "not|never|cannot": r"\\neq|\\emptyset",
        "same|equal|equivalent": r" = ",
        "larger|more": r">",
        "smaller|less sensitive|fewer": r"<",
        "less that|less gravity": r"-",
        "diverge|drifts?": r"\\infty|= 0",
        "converges?|towards": r"\\lim",
        "converges?": r"\\lim(?!.*= \\infty)",
        "larger one makes the estimate less": r"\(L_2\\right\) <",
        "smaller one makes the estimate less": r"\(L_1\\right\) <",
        "larger one makes the estimate more": r"bias.*\(L_2\\right\) > e",
        "noise of the gyro, and in general less": r"vibration.*\(L_2\\right\) <",
        "upwards": r"- g",
        "downwards": r"\\\\ g",
        "zero|nothing": r"0",
        "roll|rolling": r"\\phi|roll",
        "pitch|pitching": r"\\theta|pitch|R_\{I\}\^\{B\}\\left\(",
        "yaw|yawing": r"\\psi|yaw",
        "accelerometers?(?:'s)?": r"a\}?_\{?m|accel|a\}_B|g_\{xb\}|a_x",
        "gyros?'?": r"gyro|p\\\\q|\\mathbf\{p\}|\\dot|S_g|b(?![a-z_])",
        "magnetometers?(?:'s)?": r"M_|magnetometer|\\mathbf\{[bm]\}|S_b",
        "velocity": r"v(?![a-z])",
        "position": r"r(?![a-z])",
        "bias": r"\\beta|bias|b(?![a-z_])",
        "noise": r"\\operatorname\{var\}|sigma",
        "gravity|gravities": r"g(?![a-z])",
        "field(?:'s)?": r"M_|\\mathbf\{[bBMm]\}|b_",
        "gain": r"L|gain",
        "sine": r"\\sin",
        "cosine": r"\\cos",
        "tangent": r"\\tan",
        "inverse": r"\^\{-1\}|inverse|- \\frac\{1\}",
        "conjugate": r"\*\}",
        "inertial": r"I\}|\^I|_I|i\}|_i",
        "body frame|body to": r"B\}|\^B|_B|b\}|_b|m_",
        "vehicle-1": r"v_1|vehicle-1",
        "vehicle-2": r"v_2|vehicle-2",
        "vehicle-3": r"v_3|vehicle-3",
        "x|x-axis": r"(1|p)\\\\0\\\\0|x",
        "y|y-axis": r"0\\\\(1|q)\\\\0|y",
        "z|z-axis": r"0\\\\0\\\\(1|r)|z",
        "one degrees?": r"1\.0\^",
        "two degrees?": r"2\.0\^|2 \\pi\}\{180",
        "a minute": r"1\\,\\mathrm\{min\}",
        "five minutes": r"[^0-9]5\\,\\mathrm\{min\}",
        "ten minutes": r"10\\,\\mathrm\{min\}",
    }
)
"""Words, and the signs of which one is wanted."""

FRAMES: Final[Mapping[str, str]] = MappingProxyType(
    {"inertial": "[Ii]", "body": "[Bb]", "vehicle-1": "v_1", "vehicle-2": "v_2"}
)
"""Frames, and their index in a formula."""

FROM_TO: Final = re.compile(
    rf"({'|'.join(FRAMES)})(?: frame)? to (?:the )?({'|'.join(FRAMES)})(?![\w-])", re.IGNORECASE
)
VECTOR: Final = re.compile(r"\\mathbf\{\w\}_\{?([IiBb])|_\{x([ib])\}")

WORDS: Final[Mapping[str, str]] = MappingProxyType(
    {
        r"< 0": "negative",
        r"> 0": "positive",
        r"= 0": "zero|nothing|stops|no|always fails|only one|divides",
        r"\\neq": "not|never|cannot|depends?|differ|wrong|seems|show",
        r"= \\infty": "diverges?|drifts?",
        r"\\emptyset": "no|without|a function of|goes on",
    }
)
"""Signs, and the words of which one is wanted."""

ELSEWHERE: Final[Mapping[str, frozenset[str]]] = MappingProxyType(
    {
        # In what a symbol means.
        "euler.4.b": frozenset({"yaw", "pitch"}),
        "euler.6.e": frozenset({"pitch", "90"}),
        "euler.7.d": frozenset({"roll", "pitch", "yaw"}),
        "sensors.4.a": frozenset({"zero"}),
        "estimation.3.d": frozenset({"yaw"}),
        "validation.p": frozenset({"roll", "pitch"}),
        # A sameness, in words a denial.
        "estimation.3.b": frozenset({"not"}),
        "estimation.4.c": frozenset({"not"}),
        # What is measured or estimated, and by what.
        "euler.7.b": frozenset({"gyros"}),
        "sensors.2.d": frozenset({"gravity"}),
        "sensors.2.g": frozenset({"never", "gravity"}),
        "estimation.4.a": frozenset({"gyros"}),
        "dead_reckoning.4.f": frozenset({"accelerometer's"}),
        "dead_reckoning.4.i": frozenset({"velocity", "position"}),
        "validation.k": frozenset({"cannot"}),
    }
)


def check_says(case: Case) -> None:
    """Refuse our words for a statement where they do not fit its formula.

    Raises
    ------
    CannotJudgeError
        Then. It has all that does not fit.
    """
    formula = latex(case.printed.statement, as_written=True)
    presumed = " ".join(latex(each.holds) for each in case.given)
    odd = [*misfits(case.id, case.printed.says, formula, presumed)]
    if odd:
        msg = f"{case.id}: our words do not fit the formula: {'; '.join(odd)}"
        raise CannotJudgeError(msg)


def misfits(name: str, says: str, formula: str, presumed: str = "") -> Iterator[str]:
    """Yield what is said and not written, and what is written and not said.

    Parameters
    ----------
    name
        The id of the statement.
    says
        Our words.
    formula, presumed
        The statement, and what is presumed with it, in LaTeX.
    """
    elsewhere = ELSEWHERE.get(name, frozenset())
    for word in elsewhere:
        if not any(met(word, says)):
            yield f"“{word}” is meant and not said"
    for words, signs in SIGNS.items():
        for word in met(words, says):
            if word.lower() not in elsewhere and not re.search(signs, formula + presumed):
                yield f"“{word}” is said and does not show"
    yield from _wrong_ways(says, formula)
    for word in re.findall(r"(?<![\w.-])(?<!Table )\d+(?:\.\d+)?(?![\w-])", says):
        if word not in elsewhere and not re.search(_written(word), formula + presumed):
            yield f"{word} is said and does not show"
    for sign, words in WORDS.items():
        if re.search(sign, formula) and not any(met(words, says)):
            yield f"what {sign} shows is not said"


def _wrong_ways(says: str, formula: str) -> Iterator[str]:
    for source, target in FROM_TO.findall(says):
        if not _leads(FRAMES[source.lower()], FRAMES[target.lower()], formula):
            yield f"“from {source} to {target}” is said and does not show"


def _leads(source: str, target: str, formula: str) -> bool:
    """Whether a formula leads from one frame to another: by its vectors, else by its matrix."""
    left, _, right = formula.partition(" = ")
    for side, frame in ((left, target), (right, source)):
        named = VECTOR.search(side)
        if named is not None:
            return re.fullmatch(frame, named[1] or named[2]) is not None
    return re.search(rf"R_\{{{source}\}}\^\{{{target}\}}", formula) is not None


def met(words: str, says: str) -> list[str]:
    """List the words of a pattern that are said."""
    return re.findall(rf"(?<![\w-])(?:{words})(?![\w-])", says, re.IGNORECASE)


def _written(word: str) -> str:
    number = Rational(word)
    fraction = rf"\\frac\{{{number.p}\}}\{{{number.q}\}}"
    right_angle = r"|\\frac\{\\pi\}\{2\}" if number == Rational(90) else ""
    return rf"(?<![\d.]){re.escape(word)}(?!\d)|{fraction}{right_angle}"
