"""How a document's notation is read: its symbols replaced by what they name."""

from collections.abc import Callable, Iterable, Mapping
from functools import cache
from types import MappingProxyType
from typing import TypeAlias

from sympy import Basic, MatrixBase, preorder_traversal

from chr_notes.derivations.euler import FRAMES, TURNS, rotation
from chr_notes.ledger.case import Read
from chr_notes.printed.statement import Rotation

# What a symbol names, or the derivation of it.
Meaning: TypeAlias = Basic | Callable[[], Basic]
Notation = Mapping[type[Basic], Callable[[Basic], Basic]]


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


EULER_NOTATION: Notation = MappingProxyType({Rotation: read_rotation})


def reading(meaning: Mapping[Basic, Meaning], notation: Notation = EULER_NOTATION) -> Read:
    """Make the function that reads a document.

    Parameters
    ----------
    meaning
        From each of the document's symbols to the derived quantity that it names, or to the
        derivation itself, which then runs when the symbol is first met.
    notation
        From a class of the document's notation to the function that works it out, once all that
        stands within is worked out. Rotations by Euler angles, if nothing else is said.
    """

    @cache
    def named(symbol: Basic) -> Basic:
        quantity = meaning[symbol]
        return quantity if isinstance(quantity, Basic) else quantity()

    def work_out(node: Basic) -> Basic:
        if not node.has(*notation):
            return node
        whole = node.func(*(work_out(part) for part in node.args))
        return notation[type(node)](whole) if type(node) in notation else whole

    def read(expression: Basic) -> Basic:
        met = meaning.keys() & set(preorder_traversal(expression))
        return work_out(expression.xreplace({symbol: named(symbol) for symbol in met}))

    return read
