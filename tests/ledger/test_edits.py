"""A correction keeps what it does not correct, and is refused where the print is another."""

import pytest
from sympy import And, Eq, MatMul, MatrixSymbol, Mul, Symbol, cos, sin, symbols

from chr_notes.ledger.edits import Edit, edited, marked
from chr_notes.printed.statement import Approximately, Rotation

x, y, z = symbols("x y z", real=True)
M, V = MatrixSymbol("M", 3, 3), MatrixSymbol("v", 3, 1)
STATEMENT = Eq(z, x * sin(y) + cos(y), evaluate=False)


def test_a_part_is_replaced_and_the_rest_is_kept() -> None:
    assert edited(STATEMENT, (Edit(sin(y), cos(y)),)) == Eq(
        z, Mul(x, cos(y), evaluate=False) + cos(y), evaluate=False
    )
    turned = Eq(V, MatMul(Rotation("b", "i"), V))
    assert (
        edited(
            Eq(V, MatMul(Rotation("i", "b"), V)), (Edit(Rotation("i", "b"), Rotation("b", "i")),)
        )
        == turned
    )


def test_the_order_of_terms_does_not_matter_to_what_is_expected() -> None:
    printed = Eq(z, Mul(sin(y), x, evaluate=False), evaluate=False)
    assert edited(printed, (Edit(x * sin(y), y),)) == Eq(z, y, evaluate=False)


def test_what_is_put_in_stands_in_a_box() -> None:
    assert marked(STATEMENT, (Edit(sin(y), cos(y)),)) == (r"z = x \boxed{\cos {y}} + \cos {y}")
    number = Approximately(Symbol("r"), "17")
    assert marked(number, (Edit("17", "8.6"),)) == r"r \approx \boxed{8.6}"
    assert edited(number, (Edit("17", "8.6"),)) == Approximately(Symbol("r"), "8.6")


@pytest.mark.parametrize(
    ("edits", "says"),
    [
        ((Edit(x**2, x),), "expected in print 1 times, found 0 times"),
        ((Edit(y, x),), "expected in print 1 times, found 2 times"),
        ((Edit(y, x, times=3),), "expected in print 3 times, found 2 times"),
        ((Edit(STATEMENT, Eq(x, x, evaluate=False)),), "a whole statement"),
    ],
)
def test_what_is_not_printed_so_is_refused(edits: tuple[Edit, ...], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        edited(STATEMENT, edits)


def test_each_relation_of_several_is_edited() -> None:
    both = And(Eq(x, y), Eq(z, y), evaluate=False)
    assert edited(both, (Edit(y, x + 1, times=2),)) == And(
        Eq(x, x + 1, evaluate=False), Eq(z, x + 1), evaluate=False
    )
