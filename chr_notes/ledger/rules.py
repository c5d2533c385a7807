"""From a condition to substitutions that state it, by one table of rules.

A condition is proved on by putting its symbols in terms of others that are free: the arc tangent
of any number is any angle short of ±90°, 1/(1 + s) with a positive s any fraction between 0 and 1.
The substitutions of a rule reach all that the condition allows, in one or several cases together;
that they go nowhere else is not needed, it would only make a proof fail.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from itertools import product
from types import MappingProxyType
from typing import Final

from sympy import (
    Abs,
    And,
    Basic,
    Dummy,
    Eq,
    Expr,
    Ge,
    Gt,
    Le,
    Lt,
    MatrixBase,
    Ne,
    Or,
    Symbol,
    asin,
    atan,
    cos,
    exp,
    pi,
    sin,
    sympify,
)
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from chr_notes.ledger.identities import OnSphere

By = Mapping[Basic, Basic]
Relations = tuple[Relational, ...]


@lru_cache(maxsize=256)
def substitutions(holds: Boolean) -> tuple[By, ...]:
    """Give the substitutions that state a condition, one mapping a case.

    Raises
    ------
    ValueError
        If no rule of the table covers a part of the condition.
    """
    if isinstance(holds, Or):
        return tuple(by for part in holds.args for by in substitutions(part))
    cases: list[dict[Basic, Basic]] = [{}]
    for relations in _groups(holds.args if isinstance(holds, And) else (holds,)):
        found = next(filter(None, (rule(relations) for rule in RULES.values())), None)
        if found is None:
            msg = f"no rule for the condition {' and '.join(map(str, relations))}"
            raise ValueError(msg)
        cases = [{**one, **other} for one, other in product(cases, found)]
    return tuple(cases)


def _groups(relations: tuple[Basic, ...]) -> Iterator[Relations]:
    """Put together what bounds the same quantity; a chain 0 < a < b < 1 is about one, too."""
    if _chain(relations) is not None:
        yield relations
        return
    by_quantity: dict[Basic, list[Relational]] = {}
    for relation in relations:
        by_quantity.setdefault(relation.lhs, []).append(relation)
    yield from map(tuple, by_quantity.values())


def _bounds(relations: Relations) -> tuple[Expr | None, Expr | None, bool, bool]:
    """Give the bounds of a quantity, below and above, and whether each of them is reached."""
    below = above = None
    reached_below = reached_above = False
    for relation in relations:
        if isinstance(relation, Gt | Ge):
            below, reached_below = relation.rhs, isinstance(relation, Ge)
        else:
            above, reached_above = relation.rhs, isinstance(relation, Le)
    return below, above, reached_below, reached_above


def _positive(*, or_zero: bool = False) -> Dummy:
    return Dummy("s", nonnegative=True) if or_zero else Dummy("s", positive=True)


def _solved(quantity: Expr, value: Expr) -> dict[Basic, Basic]:
    """Let a quantity have a value: a sum by the first of its terms that is a bare symbol."""
    for term in quantity.args if quantity.is_Add else ():
        rest = quantity - term
        if isinstance(term, Symbol) and term not in rest.free_symbols:
            return {term: value - rest}
    return {quantity: value}


def _equality(relations: Relations) -> tuple[By, ...] | None:
    """Put the right side in place of the left one, element by element."""
    (relation, *others) = relations
    if others or not isinstance(relation, Eq) or isinstance(relation.lhs, Abs):
        return None
    if isinstance(relation.lhs, MatrixBase):
        return (dict(zip(relation.lhs, relation.rhs, strict=True)),)
    return ({relation.lhs: relation.rhs},)


def _sphere(relations: Relations) -> tuple[By, ...] | None:
    """Take names of which it is known that their squares add up to 1."""
    (relation, *others) = relations
    if others or not isinstance(relation, Eq) or relation.rhs != 1 or not relation.lhs.is_Add:
        return None
    bases, powers = zip(*(term.as_base_exp() for term in relation.lhs.args), strict=True)
    if set(powers) != {2} or not all(isinstance(base, Symbol) for base in bases):
        return None
    names = tuple(base.name for base in bases)
    elements = {base: OnSphere(base.name, names) for base in bases}
    return ({relation.lhs: relation.rhs, **elements},)


def _size(relations: Relations) -> tuple[By, ...] | None:
    """Let x be c or -c for |x| = c."""
    (relation, *others) = relations
    if others or not isinstance(relation, Eq) or not isinstance(relation.lhs, Abs):
        return None
    return tuple({relation.lhs.args[0]: sign * relation.rhs} for sign in (1, -1))


def _short_of_right_angle(relations: Relations) -> tuple[By, ...] | None:
    """Take the arc tangent of any number for |x| < 90°."""
    (relation, *others) = relations
    if others or not _is_size_below(relation, Lt):
        return None
    return ({relation.lhs.args[0]: atan(Dummy("t", real=True))},)


def _up_to_right_angle(relations: Relations) -> tuple[By, ...] | None:
    """Take the arc sine of any number for |x| <= 90°."""
    (relation, *others) = relations
    if others or not _is_size_below(relation, Le):
        return None
    return ({relation.lhs.args[0]: asin(Dummy("s", real=True))},)


def _is_size_below(relation: Basic, kind: type[Relational]) -> bool:
    return isinstance(relation, kind) and isinstance(relation.lhs, Abs) and relation.rhs == pi / 2


def _chain(relations: tuple[Basic, ...]) -> tuple[By, ...] | None:
    """Take fractions with the numerator 1, a the larger divisor, for 0 < a < b < 1."""
    for between in relations:
        a, b = between.args
        if isinstance(a, Symbol) and isinstance(b, Symbol):
            s, d = _positive(), _positive()
            chain = {Gt(a, 0), Lt(a, b), Lt(b, 1)}
            return ({a: 1 / (1 + s + d), b: 1 / (1 + s)},) if set(relations) == chain else None
    return None


def _fraction(relations: Relations) -> tuple[By, ...] | None:
    """Take 1 - exp(-k) for 0 < x < 1, such that powers of 1 - x are seen to go to zero."""
    below, above, reached_below, reached_above = _bounds_or_none(relations)
    if (below, above) != (0, 1):
        return None
    x = relations[0].lhs
    ends = ((reached_below, below), (reached_above, above))
    return (
        _solved(x, 1 - exp(-Dummy("k", positive=True))),
        *(_solved(x, sympify(end)) for reached, end in ends if reached),
    )


def _between(relations: Relations) -> tuple[By, ...] | None:
    """Go from a a share s/(1 + s) of the way to b for a < x < b."""
    below, above, reached_below, reached_above = _bounds_or_none(relations)
    if below is None or above is None or (above - below).is_nonpositive:
        return None
    x, s = relations[0].lhs, _positive(or_zero=reached_below)
    inside = _solved(x, below + (above - below) * s / (1 + s))
    return (inside, _solved(x, above)) if reached_above else (inside,)


def _one_sided(relations: Relations) -> tuple[By, ...] | None:
    """Add a positive number to a for x > a, take one off b for x < b."""
    below, above, reached_below, reached_above = _bounds_or_none(relations)
    if below is not None and above is None:
        return (_solved(relations[0].lhs, below + _positive(or_zero=reached_below)),)
    if above is not None and below is None:
        return (_solved(relations[0].lhs, above - _positive(or_zero=reached_above)),)
    return None


def _bounds_or_none(relations: Relations) -> tuple[Expr | None, Expr | None, bool, bool]:
    bounds = all(isinstance(relation, Gt | Ge | Lt | Le) for relation in relations)
    sizes = any(isinstance(relation.lhs, Abs) for relation in relations)
    return _bounds(relations) if bounds and not sizes else (None, None, False, False)


def _cosine_not_one(relations: Relations) -> tuple[By, ...] | None:
    """Take a positive number off 1 for a cosine that is not 1."""
    (relation, *others) = relations
    if others or not isinstance(relation, Ne):
        return None
    if not isinstance(relation.lhs, cos) or relation.rhs != 1:
        return None
    return ({relation.lhs: 1 - _positive()},)


def _not_zero(relations: Relations) -> tuple[By, ...] | None:
    """Take a positive number or its negative for a symbol, sine or cosine that is not 0."""
    (relation, *others) = relations
    if others or not isinstance(relation, Ne) or relation.rhs != 0:
        return None
    if not isinstance(relation.lhs, Symbol | sin | cos):
        return None
    s = _positive()
    return {relation.lhs: s}, {relation.lhs: -s}


def _unequal(relations: Relations) -> tuple[By, ...] | None:
    """Substitute nothing: the proof finds the excluded difference in what must not vanish."""
    (relation, *others) = relations
    return ({},) if not others and isinstance(relation, Ne) else None


RULES: Final[Mapping[str, Callable[[Relations], tuple[By, ...] | None]]] = MappingProxyType(
    {
        "sphere": _sphere,
        "equality": _equality,
        "size": _size,
        "short of a right angle": _short_of_right_angle,
        "up to a right angle": _up_to_right_angle,
        "chain": _chain,
        "fraction": _fraction,
        "between": _between,
        "one-sided": _one_sided,
        "cosine not one": _cosine_not_one,
        "not zero": _not_zero,
        "unequal": _unequal,
    }
)
"""Tried in this order; each gives its cases, or nothing where it does not apply."""
