"""Ranges of angles and gains, each with substitutions that reach all of it.

A range is proved on by putting its symbol in terms of others that are free: the arc tangent of
any number is any angle short of ±90°, 1/(1 + s) with a positive s any fraction between 0 and 1.
"""

from sympy import Abs, And, Dummy, Expr, Ge, Gt, Le, Lt, Symbol, asin, atan, exp, pi

from chr_notes.ledger.case import Condition


def acute(*angles: Symbol) -> Condition:
    """Let angles lie between -90° and 90°, the ends excluded."""
    return Condition(
        And(*(Lt(Abs(angle), pi / 2) for angle in angles), evaluate=False),
        ({angle: atan(Dummy("t", real=True)) for angle in angles},),
    )


def up_to_right_angle(angle: Symbol) -> Condition:
    """Let an angle be from -90° to 90°, the range of pitch."""
    return Condition(Le(Abs(angle), pi / 2), ({angle: asin(Dummy("s", real=True))},))


def short_turn(start: Expr, end: Symbol) -> Condition:
    """Let two angles be at most half a turn apart as numbers: `-pi <= end - start < pi`."""
    s = Dummy("s", nonnegative=True)
    turn = end - start
    reach = start + pi * (2 * s / (1 + s) - 1)
    return Condition(And(Ge(turn, -pi), Lt(turn, pi)), ({end: reach},))


def proper_fractions(less: Symbol, more: Symbol) -> Condition:
    """Let two numbers be between 0 and 1, `0 < less < more < 1`."""
    s, d = Dummy("s", positive=True), Dummy("d", positive=True)
    return Condition(
        And(Gt(less, 0), Lt(less, more), Lt(more, 1), evaluate=False),
        ({less: 1 / (1 + s + d), more: 1 / (1 + s)},),
    )


def _decaying(gain: Symbol) -> dict[Symbol, Expr]:
    """0 < gain < 1, such that the powers of 1 - gain are seen to go to zero."""
    return {gain: 1 - exp(-Dummy("k", positive=True))}


def from_0_to_1(gain: Symbol) -> Condition:
    """Let a number be 0, 1 or between."""
    return Condition(And(Ge(gain, 0), Le(gain, 1)), (_decaying(gain), {gain: 0}, {gain: 1}))


def above_0_to_1(gain: Symbol) -> Condition:
    """Let a number be above 0 and at most 1."""
    return Condition(And(Gt(gain, 0), Le(gain, 1)), (_decaying(gain), {gain: 1}))
