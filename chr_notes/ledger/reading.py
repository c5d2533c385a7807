"""How a document's notation is read: its symbols replaced by what they name."""

from collections.abc import Callable, Iterable, Mapping
from functools import cache

from sympy import Basic, MatrixBase, preorder_traversal

from chr_notes.derivations.euler import FRAMES, TURNS, rotation
from chr_notes.ledger.case import Read
from chr_notes.printed.statement import Rotation


def read_rotation(symbol: Rotation) -> Basic:
    """Replace the symbol of a rotation by the derived matrix, at the angles that it is given.

    The documents list the angles from roll to yaw, whichever way the rotation goes.
    """
    source, target = symbol.frames
    matrix = rotation(source, target)
    first, last = sorted((FRAMES.index(source), FRAMES.index(target)))
    own = [TURNS[frame][1] for frame in FRAMES[last:first:-1]]
    if not symbol.angles:
        return matrix
    return matrix.subs(dict(zip(own, symbol.angles, strict=True)), simultaneous=True)


def elements(
    names: Iterable[Basic], vector: Callable[[], MatrixBase]
) -> dict[Basic, Callable[[], Basic]]:
    """Give each name the element of a derived vector that stands in its place."""

    def element(row: int) -> Callable[[], Basic]:
        return lambda: vector()[row]

    return {name: element(row) for row, name in enumerate(names)}


def reading(meaning: Mapping[Basic, Basic | Callable[[], Basic]]) -> Read:
    """Make the function that reads a document.

    Parameters
    ----------
    meaning
        From each of the document's symbols to the derived quantity that it names, or to the
        derivation itself, which then runs when the symbol is first met. Rotation symbols are
        read by their frames and need no mention.
    """

    @cache
    def named(symbol: Basic) -> Basic:
        quantity = meaning[symbol]
        return quantity if isinstance(quantity, Basic) else quantity()

    def read(expression: Basic) -> Basic:
        met = meaning.keys() & set(preorder_traversal(expression))
        understood = expression.xreplace({symbol: named(symbol) for symbol in met})
        rotations = understood.atoms(Rotation)
        return understood.xreplace({symbol: read_rotation(symbol) for symbol in rotations})

    return read
