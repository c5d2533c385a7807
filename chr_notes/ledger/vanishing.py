"""When a difference cannot vanish: what is never zero, and what is only where it is excluded."""

from collections.abc import Mapping
from itertools import chain, product

from sympy import Basic, Dummy, Expr, Ne, Or, Set, cancel, fraction, tan, together

from chr_notes.ledger.condition import Condition
from chr_notes.ledger.evaluation import evaluate, parts, sides
from chr_notes.ledger.identities import difference, is_positive, is_zero
from chr_notes.ledger.reading import Read


def never_equal(
    relation: Ne, read: Read, by: Mapping[Basic, Basic], conditions: tuple[Condition, ...]
) -> bool:
    """Whether some component of the difference is one that is, or is presumed to be, not zero.

    Of two sets, whether one has an element that the other lacks.
    """
    left, right = sides(relation, read, by)
    if isinstance(left, Set) and isinstance(right, Set):
        return (left ^ right).is_empty is False
    return some_cannot_vanish(difference(left, right), read, by, conditions)


def some_cannot_vanish(
    components: tuple[Expr, ...],
    read: Read,
    by: Mapping[Basic, Basic],
    conditions: tuple[Condition, ...],
) -> bool:
    """Whether one of several components is not zero, in each way to meet the conditions."""
    # Of a condition that may be met in several ways each one must do.
    ways = product(*(_excluded(condition, read, by) for condition in conditions))
    return all(
        any(
            component.is_nonzero
            or is_positive(component)
            or is_positive(-component)
            or _numerator_is_positive(component)
            or any(_vanishes_only_with(component, other) for other in chain(*way))
            for component in components
        )
        for way in ways
    )


def _excluded(condition: Condition, read: Read, by: Mapping[Basic, Basic]) -> list[list[Basic]]:
    """List what a condition says not to be zero, for each way to meet it."""
    holds = condition.holds
    return [
        [evaluate(each.lhs - each.rhs, read, by) for each in parts(way) if isinstance(each, Ne)]
        for way in (holds.args if isinstance(holds, Or) else (holds,))
    ]


def _numerator_is_positive(component: Expr) -> bool:
    """Whether a quotient cannot vanish; a tangent is any number at all."""
    numbers = {call: Dummy(real=True) for call in component.atoms(tan)}
    return is_positive(fraction(together(component.xreplace(numbers)))[0])


def _vanishes_only_with(component: Expr, excluded: Expr) -> bool:
    """Whether a component vanishes only where the excluded expression does."""
    if any(is_zero(component - sign * excluded) for sign in (1, -1)):
        return True
    factor = cancel(component / excluded)
    return bool(factor.is_nonzero and is_zero(component - factor * excluded))
