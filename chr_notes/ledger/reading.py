"""How a document is read: its symbols replaced by what they name, and what it presumes."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TypeAlias

from sympy import Basic, MatrixBase, preorder_traversal

from chr_notes.derivations.euler import FRAMES, TURNS, rotation
from chr_notes.ledger.condition import Presumed
from chr_notes.printed import BY_ID
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


class Read:
    """How a document is read: its symbols replaced by what they name.

    Parameters
    ----------
    meaning
        From each of the document's symbols to the derived quantity that it names, or to the
        derivation itself, which then runs when the symbol is first met.
    notation
        From a class of the document's notation to the function that works it out, once all that
        stands within is worked out.
    base
        The reading that this one adds names to; it is used first.
    presumed
        What the document presumes, if there is no base.
    """

    def __init__(
        self,
        meaning: Mapping[Basic, Meaning],
        notation: Notation,
        base: "Read | None" = None,
        presumed: tuple[Presumed, ...] = (),
    ) -> None:
        self.meaning = meaning
        self.notation = notation
        self.base = base
        self.presumed: tuple[Presumed, ...] = presumed if base is None else base.presumed
        self._worked_out: dict[Basic, Basic] = {}
        self._met: set[Basic] = set()  # names that are being worked out

    def __call__(self, expression: Basic) -> Basic:
        """Put the derived quantities in place of the symbols, unevaluated."""
        return self._work_out(self.with_names(expression))

    def also(self, meaning: Mapping[Basic, Meaning]) -> "Read":
        """Read more names, or free symbols of the derivations at some special values.

        Raises
        ------
        ValueError
            If a symbol is read already. A document has one reading.
        """
        twice = [name for name in meaning if name in self]
        if twice:
            msg = f"expected names that are not read yet, got {', '.join(map(str, twice))}"
            raise ValueError(msg)
        return Read(meaning, self.notation, base=self)

    def extends(self, other: "Read") -> bool:
        """Whether this is a reading with no more than names added to it."""
        return self is other or (self.base is not None and self.base.extends(other))

    @property
    def added(self) -> frozenset[Basic]:
        """The names that are read besides those of the document's own reading."""
        return frozenset() if self.base is None else self.base.added | self.meaning.keys()

    def __contains__(self, name: Basic) -> bool:
        """Whether a name has a meaning."""
        return name in self.meaning or (self.base is not None and name in self.base)

    def contested(self, other: "Read") -> tuple[frozenset[Basic], frozenset[type[Basic]]]:
        """Find the names, and the kinds of notation, that another reading takes otherwise."""
        one, two = self.meanings(), other.meanings()
        return (
            frozenset(name for name in one.keys() & two.keys() if one[name] != two[name]),
            frozenset(
                kind
                for kind in self.notation.keys() & other.notation.keys()
                if self.notation[kind] != other.notation[kind]
            ),
        )

    def meanings(self) -> dict[Basic, Meaning]:
        """List all names with what they are read as."""
        return {**(self.base.meanings() if self.base is not None else {}), **self.meaning}

    def defines(self, name: Basic, by: str) -> bool:
        """Whether a name has no other meaning than the one that a printed definition gives."""
        if name in self.meaning:
            return self.meaning[name] == Defined(by)
        return self.base is None or self.base.defines(name, by)

    def definition(self, name: Basic) -> "Defined | None":
        """Find the printed definition by which a name is read, if it is by one."""
        if name in self.meaning:
            meaning = self.meaning[name]
            return meaning if isinstance(meaning, Defined) else None
        return None if self.base is None else self.base.definition(name)

    def with_names(self, expression: Basic) -> Basic:
        """Put the derived quantities in place of the symbols, and leave the notation."""
        if self.base is not None:
            expression = self.base.with_names(expression)
        met = self.meaning.keys() & set(preorder_traversal(expression))
        return expression.xreplace({symbol: self._named(symbol) for symbol in met})

    def _named(self, symbol: Basic) -> Basic:
        if symbol not in self._worked_out:
            quantity = self.meaning[symbol]
            named = quantity if isinstance(quantity, Basic) else quantity()
            # A printed definition speaks in the document's own symbols.
            if isinstance(quantity, Defined):
                if symbol in self._met:
                    msg = f"{symbol} is defined by itself, in {quantity.id}"
                    raise ValueError(msg)
                self._met.add(symbol)
                named = self.with_names(named)
                self._met.remove(symbol)
            self._worked_out[symbol] = named
        return self._worked_out[symbol]

    def _work_out(self, node: Basic) -> Basic:
        if not node.has(*self.notation):
            return node
        whole = node.func(*(self._work_out(part) for part in node.args))
        return self.notation[type(node)](whole) if type(node) in self.notation else whole


def reading(
    meaning: Mapping[Basic, Meaning],
    notation: Notation = EULER_NOTATION,
    presumed: tuple[Presumed, ...] = (),
) -> Read:
    """Make the reading of a document; rotations are by Euler angles, if nothing else is said."""
    return Read(meaning, notation, presumed=presumed)


@dataclass(frozen=True)
class Defined:
    """The meaning that a printed definition gives to the name on its left side."""

    id: str

    def __call__(self) -> Basic:
        """Give the right side of the definition."""
        return BY_ID[self.id].statement.rhs


def defined(*ids: str) -> dict[Basic, Meaning]:
    """Read names by the definitions that a document prints: so each use is tied to the print.

    Parameters
    ----------
    ids
        Of printed equations that have the name alone on the left side.
    """
    return {BY_ID[each].statement.lhs: Defined(each) for each in ids}
