"""Each step that a chapter tells is true of what the derivations have, and of nothing else."""

from collections.abc import Iterator
from importlib import import_module
from pkgutil import iter_modules

import numpy as np
import pytest
from sympy import Basic, Eq, Expr, Float, MatrixBase, preorder_traversal
from sympy.core.function import AppliedUndef

from chr_notes.derivations import told
from chr_notes.derivations.telling import Told
from chr_notes.typeset import latex

TOPICS = [import_module(f"{told.__name__}.{each.name}") for each in iter_modules(told.__path__)]
TELLINGS = {
    f"{topic.__name__.rsplit('.', 1)[-1]}.{name}": telling
    for topic in TOPICS
    for name, telling in vars(topic).items()
    if isinstance(telling, Told)
}
STEPS = {
    f"{name}.{place}": (telling, step.statement)
    for name, telling in TELLINGS.items()
    for place, step in enumerate(telling.steps, 1)
}
DIGITS = 40


def meant(side: Basic, telling: Told) -> list[Expr]:
    """Put in what the names stand for, and theirs in turn."""
    side = side.xreplace(telling.stands).xreplace(telling.stands).doit()
    return list(side) if isinstance(side, MatrixBase) else [side]


def gaps(telling: Told, statement: Eq) -> Iterator[Expr]:
    """Yield what the sides of a step differ by, at a point where no angle is special."""
    drawn = np.random.default_rng(4)
    left, right = (meant(side, telling) for side in statement.args)
    assert len(left) == len(right)
    point: dict[Basic, Float] = {}
    for difference in (a - b for a, b in zip(left, right, strict=True)):
        names = difference.free_symbols | difference.atoms(AppliedUndef)
        for name in sorted(names - point.keys(), key=str):
            point[name] = Float(str(drawn.uniform(0.1, 0.9)), DIGITS)
        values = {name: point[name] for name in names}
        yield difference.subs(values).evalf(DIGITS // 2)


@pytest.mark.parametrize("name", STEPS)
def test_each_step_is_true_and_says_something(name: str) -> None:
    telling, statement = STEPS[name]
    assert [gap for gap in gaps(telling, statement) if abs(gap) > 1e-18] == []
    assert latex(statement.lhs) != latex(statement.rhs)
    wrong = Eq(statement.lhs, -statement.rhs, evaluate=False)
    assert any(abs(gap) > 1e-3 for gap in gaps(telling, wrong))


@pytest.mark.parametrize("name", TELLINGS)
def test_each_name_is_told_of(name: str) -> None:
    told_of = {
        part for step in TELLINGS[name].steps for part in preorder_traversal(step.statement)
    } | {part for meaning in TELLINGS[name].stands.values() for part in preorder_traversal(meaning)}
    assert TELLINGS[name].stands.keys() <= told_of
