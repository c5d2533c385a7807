"""LaTeX as one writes it by hand."""

import pytest
from sympy import (
    And,
    Basic,
    Eq,
    Function,
    Integral,
    MatMul,
    MatrixSymbol,
    Rational,
    Symbol,
    atan2,
    cos,
    evaluate,
    pi,
    sin,
    sqrt,
    symbols,
)
from sympy.matrices.expressions.matexpr import MatrixElement

from chr_notes.typeset import formula, latex

x, y, z = symbols("x y z", real=True)


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (-x + y - 2 * z, "y - x - 2 z"),
        (-x - y, "- x - y"),
        (-1 + x, "x - 1"),
        ((x - y) * (z - 1) - x, r"\left(x - y\right) \left(z - 1\right) - x"),
        (x + Integral(y, y), r"x + \int y\, dy"),
        (Function("a_N")(x), r"a_{N}\left(x\right)"),
        (atan2(-x, y), r"\mathrm{atan2}\left(- x, y\right)"),
    ],
)
def test_expressions(expression: Basic, expected: str) -> None:
    assert latex(expression) == expected


with evaluate(x=False):
    AS_WRITTEN = [
        (y + x - z, "y + x - z"),
        (-y + x, "- y + x"),
        (z * y * x, "z y x"),
        (z - (y - x), r"z - \left(y - x\right)"),
        ((y + x) * (y + x), r"\left(y + x\right) \left(y + x\right)"),
        (-(y + x) * z, r"- \left(y + x\right) z"),
        (2 * (y * x) / (z - x), r"\frac{2 y x}{z - x}"),
        (-1 / y, r"- \frac{1}{y}"),
        (z * (-2 * x), r"z \left(- 2 x\right)"),
        (x / sqrt(y), r"\frac{x}{\sqrt{y}}"),
    ]


V, W = MatrixSymbol("v", 3, 1), MatrixSymbol("w", 3, 1)


def test_sums_products_and_elements_of_columns() -> None:
    assert latex(V - 2 * W) == "v - 2 w"
    assert latex(MatMul(Rational(1, 2), V)) == r"\frac{1}{2} v"
    assert latex(MatMul(-1, V)) == "- v"
    assert latex(MatrixElement(V, 1, 0)) == r"\left[v\right]_{2}"
    assert latex(MatrixElement(MatrixSymbol("m", 3, 3), 1, 0)) == r"\left[m\right]_{21}"


def test_factors_stand_in_the_order_of_their_angles() -> None:
    shown = formula(x, sin(x) * sin(z) * sin(y) - cos(x / 2) * cos(y) * sin(z), (z, x, y))
    assert shown.latex == (
        r"x = \sin {z} \sin {x} \sin {y} - \sin {z} \cos {\frac{1}{2} x} \cos {y}"
    )
    assert formula(x, sin(z) * sin(y)).latex == r"x = \sin {y} \sin {z}"


@pytest.mark.parametrize(("expression", "expected"), AS_WRITTEN)
def test_as_written_terms_and_factors_keep_their_places(expression: Basic, expected: str) -> None:
    assert latex(expression, as_written=True) == expected


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        (And(x > 0, x <= 1), r"0 < x \leq 1"),
        (And(x > -pi, x < y, y < 1), r"- \pi < x < y < 1"),
        (And(x - y >= -pi, x - y < pi), r"- \pi \leq x - y < \pi"),
        (And(x < 1, y < 1), r"x < 1 \quad\text{and}\quad y < 1"),
        (And(x > 0, y < 1), r"x > 0 \quad\text{and}\quad y < 1"),
        (And(Eq(x, 1), Eq(y, 2)), r"x = 1 \quad\text{and}\quad y = 2"),
        (And(x < y, x < Symbol("w", real=True)), r"x < w \quad\text{and}\quad x < y"),
    ],
)
def test_statements(statement: Basic, expected: str) -> None:
    assert latex(statement) == expected
