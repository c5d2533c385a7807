"""Ranges of angles and gains that several documents presume."""

from sympy import Abs, And, Expr, Ge, Gt, Le, Lt, Symbol, pi

from chr_notes.ledger.condition import Condition


def acute(*angles: Symbol) -> Condition:
    """Let angles lie between -90° and 90°, the ends excluded."""
    return Condition(And(*(Lt(Abs(angle), pi / 2) for angle in angles), evaluate=False))


def up_to_right_angle(angle: Symbol) -> Condition:
    """Let an angle be from -90° to 90°, the range of pitch."""
    return Condition(Le(Abs(angle), pi / 2))


def short_turn(start: Expr, end: Symbol) -> Condition:
    """Let two angles be at most half a turn apart as numbers: `-pi <= end - start < pi`."""
    turn = end - start
    return Condition(And(Ge(turn, -pi), Lt(turn, pi)))


def proper_fractions(less: Symbol, more: Symbol) -> Condition:
    """Let two numbers be between 0 and 1, `0 < less < more < 1`."""
    return Condition(And(Gt(less, 0), Lt(less, more), Lt(more, 1), evaluate=False))


def from_0_to_1(number: Symbol) -> Condition:
    """Let a number be 0, 1 or between."""
    return Condition(And(Ge(number, 0), Le(number, 1)))


def above_0_to_1(number: Symbol) -> Condition:
    """Let a number be above 0 and at most 1."""
    return Condition(And(Gt(number, 0), Le(number, 1)))


def between_0_and_1(number: Symbol) -> Condition:
    """Let a number be between 0 and 1."""
    return Condition(And(Gt(number, 0), Lt(number, 1)))
