"""All that a document says, corrected, is applied together and gives the right numbers.

No reading of the ledger is used here. Some quantities are given numbers, and a statement whose
left side is a name without a number yet gives it one; any other statement must then hold. What
comes out is compared with the package's own functions.
"""

import functools
import operator
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, ClassVar

import numpy as np
import pytest
from sympy import (
    Basic,
    Eq,
    Identity,
    Inverse,
    MatMul,
    MatrixBase,
    MatrixSymbol,
    Symbol,
    atan,
    atan2,
    fraction,
)
from sympy.matrices.expressions.matexpr import MatrixElement

import chr_notes
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.edits import in_order
from chr_notes.ledger.evaluation import parts
from chr_notes.printed import euler, euler_claims
from chr_notes.printed import quaternions as quaternion
from chr_notes.printed.hamilton import Conjugate, Product, Pure, Reciprocal
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, FIRST, QUATERNION, SECOND

ATTITUDES = 10


def equations(document: str, *left_out: str) -> Iterator[tuple[str, Eq]]:
    """Yield the equations of a document as they should read, in its order."""
    for name, case in CASES.items():
        if case.printed.document == document and name not in left_out:
            right = case.right if case.right is not None else case.printed.statement
            yield from ((name, part) for part in parts(in_order(right)) if isinstance(part, Eq))


class Known(dict[Basic, Any]):
    """The numbers that names have, and what expressions of these names come to."""

    def value(self, expression: Basic) -> Any:  # noqa: ANN401 (a number or an array)
        """Compute an expression."""
        if expression in self:
            return self[expression]
        kind = next((kind for kind in self.KINDS if isinstance(expression, kind)), None)
        if kind is not None:
            return self.KINDS[kind](self, expression)
        return float(expression.subs({n: v for n, v in self.items() if isinstance(v, float)}))

    def _rotation(self, symbol: Rotation) -> np.ndarray:
        source, target = symbol.frames
        if isinstance(symbol.angles[0], Conjugate):  # the opposite turn
            return self.value(Rotation(target, source, *symbol.angles[0].args))
        if symbol.angles[0].could_extract_minus_sign():
            return self[Rotation(source, target, *(-angle for angle in symbol.angles))].T
        return self[Rotation(target, source, *symbol.angles)].T

    def _matrix(self, matrix: MatrixBase) -> np.ndarray:
        rows = np.array([[self.value(element) for element in row] for row in matrix.tolist()])
        return rows[:, 0] if matrix.cols == 1 else rows

    def _product(self, product: MatMul) -> np.ndarray:
        return functools.reduce(operator.matmul, map(self.value, product.args))

    def _quaternion_product(self, product: Product) -> np.ndarray:
        return functools.reduce(chr_notes.quaternion_multiply, map(self.value, product.args))

    KINDS: ClassVar[Mapping[type, Callable[["Known", Any], Any]]] = {
        Rotation: _rotation,
        MatrixBase: _matrix,
        MatMul: _product,
        Inverse: lambda self, m: np.linalg.inv(self.value(m.args[0])),
        Identity: lambda _, m: np.eye(int(m.rows)),
        Product: _quaternion_product,
        Pure: lambda self, v: np.concatenate(([0.0], self.value(v.args[0]))),
        Reciprocal: lambda self, q: chr_notes.quaternion_inverse(self.value(q.args[0])),
        Conjugate: lambda self, q: chr_notes.quaternion_conjugate(self.value(q.args[0])),
        MatrixElement: lambda self, e: self.value(e.parent)[e.i],
    }


def apply(statements: Iterable[tuple[str, Eq]], numbers: Known) -> list[str]:
    """Give names their numbers, and list the statements that contradict those given before."""
    wrong = []
    for name, statement in statements:
        left, right = statement.args
        found = numbers.value(right)
        named = isinstance(left, Symbol | MatrixSymbol | Rotation)
        back = isinstance(left, Rotation) and Rotation(*left.frames[::-1], *left.angles) in numbers
        if named and left not in numbers and not back:
            numbers[left] = found
        elif not np.allclose(numbers.value(left), found, rtol=0, atol=1e-9):
            wrong.append(name)
    return wrong


@pytest.mark.parametrize("seed", range(ATTITUDES))
def test_quaternion_note(seed: int) -> None:
    rng = np.random.default_rng(seed)
    q = rng.normal(size=4)
    q /= np.linalg.norm(q)
    v = rng.normal(size=3)
    pair = rng.normal(size=(2, 4))
    numbers = Known(
        {
            **dict(zip(QUATERNION, map(float, q), strict=True)),
            **dict(zip((*FIRST, *SECOND), map(float, pair.ravel()), strict=True)),
            quaternion.Q_1: pair[0],
            quaternion.Q_2: pair[1],
            quaternion.V_I: v,
            quaternion.V_B: chr_notes.rotate_to_body(q, v),
            quaternion.V_B_AS_QUATERNION: np.concatenate(([0.0], chr_notes.rotate_to_body(q, v))),
        }
    )
    # Of dimensions, of a turn about an axis, at the lock, and of any quaternion.
    others = ("quaternions.2.2", "quaternions.2.a", "quaternions.2.b", "quaternions.4.b")
    statements = (
        # The arctangent is taken as the note says after its formulas.
        (name, each.replace(atan, lambda quotient: atan2(*fraction(quotient))))
        for name, each in equations("quaternions", *others)
    )
    assert apply(statements, numbers) == []
    np.testing.assert_allclose(numbers[quaternion.Q], q)
    np.testing.assert_allclose(
        numbers.value(Rotation("i", "b", quaternion.Q)), chr_notes.matrix_from_quaternion(q)
    )
    roll, pitch, yaw = chr_notes.euler_from_quaternion(q)
    assert [numbers[angle] for angle in EULER] == pytest.approx([roll, pitch, yaw])


@pytest.mark.parametrize("seed", range(ATTITUDES))
def test_euler_note(seed: int) -> None:
    rng = np.random.default_rng(seed)
    angles = rng.uniform((-np.pi, -1.5, -np.pi), (np.pi, 1.5, np.pi))
    gyros, (v, field) = rng.normal(size=3), rng.normal(size=(2, 3))
    matrix = chr_notes.matrix_from_euler(angles)
    rates = chr_notes.euler_rates_from_body_rates(angles, gyros)
    numbers = Known(
        {
            **dict(zip(EULER, map(float, angles), strict=True)),
            **dict(zip(BODY_RATES, map(float, gyros), strict=True)),
            **dict(zip(EULER_RATES, map(float, rates), strict=True)),
            euler.V_I: v,
            euler.V_B: matrix @ v,
            euler_claims.FIELD_I: field,
            euler_claims.FIELD_B: matrix @ field,
        }
    )
    # Names of frames and sets of angles; any rotation; and what is said of the lock.
    others = ("4.b", "7.d", "1.a", "6.a", "6.b", "6.c", "6.e", "7.c")
    statements = list(equations("euler", *(f"euler.{name}" for name in others)))
    assert apply(statements, numbers) == []
    np.testing.assert_allclose(numbers[euler.R_IB], matrix)
    np.testing.assert_allclose(numbers.value(euler.R_BI), matrix.T)
    np.testing.assert_allclose(numbers[euler.D], chr_notes.euler_rates_matrix(angles))
    assert {"euler.5.3", "euler.5.5", "euler.7.a", "euler.7.e"} < {name for name, _ in statements}
