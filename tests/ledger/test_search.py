"""The search outside a condition finds points there, and nowhere else."""

import pytest
from sympy import And, Eq, Gt, Lt, Ne, Or, cos, symbols
from sympy.logic.boolalg import Boolean

from chr_notes import printed
from chr_notes.ledger.case import Case
from chr_notes.ledger.condition import Condition
from chr_notes.ledger.reading import reading
from chr_notes.ledger.search import outside
from chr_notes.printed import Printed
from chr_notes.symbols import phi

x, y = symbols("x y", real=True)


@pytest.mark.parametrize(
    "holds",
    [
        Eq(x, y),
        Ne(x, y),
        Ne(cos(phi), 1),
        Gt(x, y),
        And(Gt(x, 0), Lt(x, 1)),
        And(Ne(x, 0), Ne(y, 0), evaluate=False),
        Or(Eq(x, 1), Gt(y, 1), evaluate=False),
    ],
)
def test_points_lie_outside_the_condition_and_within_what_is_given(
    holds: Boolean, monkeypatch: pytest.MonkeyPatch
) -> None:
    statement = Printed("tried.1", "equation", "nowhere", "A statement.", Eq(x, y, evaluate=False))
    monkeypatch.setitem(printed.BY_ID, "tried.1", statement)
    given = (Condition(Lt(x, 2)), Condition(Ne(y, 3)))
    case = Case("tried.1", read=reading({}), given=given)
    points = list(outside(case, Condition(holds)))
    assert points
    for point in points:
        assert not holds.subs(point)
        assert point[x] < 2
        assert point[y] != 3
    assert points == list(outside(case, Condition(holds))), "the same points each time"
