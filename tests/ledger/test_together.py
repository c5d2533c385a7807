"""All that a document says, corrected, is applied together and gives the right numbers.

No reading of the ledger is used here. Some quantities are given numbers, and a statement whose
left side is a name without a number yet gives it one; any other statement must then hold. What
comes out is compared with the package's own functions.
"""

import functools
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, ClassVar

import numpy as np
import pytest
from sympy import (
    Basic,
    Eq,
    Identity,
    Inverse,
    MatAdd,
    MatMul,
    MatrixBase,
    MatrixSymbol,
    Symbol,
    Transpose,
    atan,
    atan2,
    fraction,
    preorder_traversal,
)
from sympy.matrices.expressions.matexpr import MatrixElement

import chr_notes
from chr_notes.ledger.cases import CASES
from chr_notes.ledger.edits import in_order
from chr_notes.ledger.evaluation import parts
from chr_notes.printed import euler, euler_claims, sensors, sensors_claims
from chr_notes.printed import quaternions as quaternion
from chr_notes.printed.hamilton import Conjugate, Product, Pure, Reciprocal
from chr_notes.printed.statement import Rotation
from chr_notes.symbols import BODY_RATES, EULER, EULER_RATES, FIRST, QUATERNION, SECOND, m

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
        found = self.keys() & {*preorder_traversal(expression)}
        return float(expression.subs({n: self[n] for n in found if isinstance(self[n], float)}))

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
        factors = map(self.value, product.args)
        return functools.reduce(lambda x, y: x @ y if np.ndim(x) and np.ndim(y) else x * y, factors)

    def _quaternion_product(self, product: Product) -> np.ndarray:
        return functools.reduce(chr_notes.quaternion_multiply, map(self.value, product.args))

    KINDS: ClassVar[Mapping[type, Callable[["Known", Any], Any]]] = {
        Rotation: _rotation,
        MatrixBase: _matrix,
        MatMul: _product,
        Inverse: lambda self, m: np.linalg.inv(self.value(m.args[0])),
        MatAdd: lambda self, total: sum(map(self.value, total.args)),
        Transpose: lambda self, m: self.value(m.args[0]).T,
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


@pytest.mark.parametrize("seed", range(ATTITUDES))
def test_sensor_note(seed: int) -> None:
    rng = np.random.default_rng(seed)
    matrices = {name: np.eye(3) + rng.uniform(-0.1, 0.1, (3, 3)) for name in "agbd"}
    scales, biases = rng.uniform(0.5, 2, (3, 3)), rng.normal(size=(3, 3))
    weight = chr_notes.rotate_to_body(rng.normal(size=4), [0, 0, chr_notes.STANDARD_GRAVITY])
    force, gyros, field, hard = rng.normal(size=(4, 3))
    coupling = rng.normal(scale=0.1, size=(3, 3))
    sensor, gyro, compass = ((matrices[name], scales[n], biases[n]) for n, name in enumerate("agb"))
    to_field = matrices["d"] @ np.diag(1 / scales[2]) @ np.linalg.inv(matrices["b"])
    numbers = Known(
        {
            m: 1.5,
            sensors.F: force,
            sensors.F_G: 1.5 * weight,
            **dict(zip(sensors.SENSITIVITIES, map(float, scales[0]), strict=True)),
            sensors.M_A: matrices["a"],
            sensors.S_A: np.diag(scales[0]),
            sensors.BETA: biases[0],
            sensors.BETA_A: biases[0],
            **dict(zip(BODY_RATES, map(float, gyros), strict=True)),
            sensors.M_G: matrices["g"],
            sensors.S_G: np.diag(scales[1]),
            sensors.BETA_G: biases[1],
            sensors.C_GA: coupling,
            sensors.P_M: chr_notes.RateGyroCalibration(*gyro, coupling).measure(
                gyros, force / 1.5 - weight
            ),
            sensors.B: field,
            sensors.M_B: matrices["b"],
            sensors.S_B: np.diag(scales[2]),
            sensors.BETA_B: biases[2],
            sensors.B_M: chr_notes.ThreeAxisCalibration(*compass).measure(field),
            sensors.D_S: matrices["d"],
            sensors.BETA_H: hard,
            sensors_claims.COMBINED: to_field,
            sensors_claims.OFFSET: hard - to_field @ matrices["b"] @ biases[2],
        }
    )
    # The other meaning of the reading, special circumstances, spheres, numbers of terms.
    others = ("2.1", "2.2", "2.a", "2.b", "2.c", "2.d", "2.f", "2.g", "2.i", "4.a", "4.b", "4.c")
    more = ("4.f", "4.g")
    statements = list(equations("sensors", *(f"sensors.{name}" for name in (*others, *more))))
    assert apply(statements, numbers) == []
    calibration = chr_notes.ThreeAxisCalibration(*sensor)
    np.testing.assert_allclose(numbers[sensors.A_M], calibration.measure(force / 1.5 - weight))
    np.testing.assert_allclose(numbers[sensors.A_MC], calibration.correct(numbers[sensors.A_M]))
    iron = chr_notes.MagnetometerCalibration(matrices["d"], hard)
    np.testing.assert_allclose(numbers[sensors.B_C], iron.correct(field))
    np.testing.assert_allclose(numbers[sensors_claims.ACTUAL], force / 1.5)
    assert {"sensors.4.3", "sensors.4.d", "sensors.2.h", "sensors.3.2"} < {n for n, _ in statements}
