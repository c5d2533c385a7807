"""Each step that a chapter tells is true of what the derivations have, and of nothing else."""

from collections.abc import Iterator
from importlib import import_module
from pkgutil import iter_modules

import numpy as np
import pytest
from sympy import Basic, Eq, Expr, Float, Inverse, MatrixBase, MatrixExpr, preorder_traversal
from sympy.core.function import AppliedUndef

from chr_notes.derivations import told
from chr_notes.derivations.told import Told
from chr_notes.typeset import latex

TOPICS = [each.name for each in iter_modules(told.__path__)]
DIGITS = 40


def meant(side: Basic, telling: Told) -> list[Expr]:
    """Put in what the names stand for, and theirs in turn."""
    side = side.xreplace(telling.stands).xreplace(telling.stands)
    side = side.replace(Inverse, inverted).doit()
    return list(side) if isinstance(side, MatrixBase) else [side]


def inverted(matrix: MatrixExpr, _: Expr) -> MatrixBase:
    """Invert by cofactors: SymPy's elimination would ask of each pivot whether it is zero."""
    known = matrix.doit()
    return known.adjugate() / known.det()


def numbers(telling: Told, statement: Eq) -> Iterator[tuple[Expr, Expr]]:
    """Yield what the sides of a step come to, part by part, where no angle is special."""
    drawn = np.random.default_rng(4)
    left, right = (meant(side, telling) for side in statement.args)
    point: dict[Basic, Float] = {}
    for sides in zip(left, right, strict=True):
        names = {name for side in sides for name in side.free_symbols | side.atoms(AppliedUndef)}
        for name in sorted(names - point.keys(), key=str):
            point[name] = Float(str(drawn.uniform(0.1, 0.9)), DIGITS)
        values = {name: point[name] for name in names}
        yield sides[0].subs(values).evalf(DIGITS), sides[1].subs(values).evalf(DIGITS)


def tellings(topic: str) -> dict[str, Told]:
    """What a topic tells, derived only now: collecting tests is to cost nothing."""
    module = import_module(f"{told.__name__}.{topic}")
    found = {name: value for name, value in vars(module).items() if isinstance(value, Told)}
    assert found
    return found


@pytest.mark.parametrize("topic", TOPICS)
def test_each_step_is_true_and_says_something(topic: str) -> None:
    for name, telling in tellings(topic).items():
        for place, step in enumerate(telling.steps, 1):
            statement = step.statement
            where = f"step {place} of {name}"
            pairs = list(numbers(telling, statement))
            assert [pair for pair in pairs if abs(pair[0] - pair[1]) > 1e-18] == [], where
            assert latex(statement.lhs) != latex(statement.rhs), where
            # With the other sign it would be false.
            assert any(abs(left + right) > 1e-3 for left, right in pairs), where


@pytest.mark.parametrize("topic", TOPICS)
def test_each_name_is_told_of(topic: str) -> None:
    for name, telling in tellings(topic).items():
        told_of = {part for step in telling.steps for part in preorder_traversal(step.statement)}
        told_of |= {
            part for meaning in telling.stands.values() for part in preorder_traversal(meaning)
        }
        assert telling.stands.keys() <= told_of, name
