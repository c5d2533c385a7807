"""Names and a reading for statements that are tried on the judgement."""

from collections.abc import Callable

from sympy import (
    Eq,
    Symbol,
    symbols,
)

from chr_notes.ledger.entry import Entry
from chr_notes.ledger.reading import reading

x, y, z = symbols("x y z", real=True)
NAME, OTHER = Symbol("name", real=True), Symbol("other", real=True)
# y stands for x squared, phi for the angle of a point on a circle.
READ = reading({y: x**2})
Bring = dict[str, object]
Say = Callable[..., Entry]
ROOTED: Bring = {"root": "inverse-is-conjugate", "weight": "misleads"}
FALSE = Eq(y, x, evaluate=False)
