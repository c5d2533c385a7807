"""How a document's notation is read: its symbols replaced by what they name."""

from collections.abc import Mapping

from sympy import Basic

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


def reading(meaning: Mapping[Basic, Basic]) -> Read:
    """Make the function that reads a document.

    Parameters
    ----------
    meaning
        From each of the document's symbols to the derived quantity that it names. Rotation
        symbols are read by their frames and need no mention.
    """

    def read(expression: Basic) -> Basic:
        named = expression.xreplace(dict(meaning))
        return named.xreplace({symbol: read_rotation(symbol) for symbol in named.atoms(Rotation)})

    return read
