"""Functions of arrays in which no element is named: what is done to one axis is done to all."""

from sympy import Basic, Function, Symbol

from chr_notes.codegen.lowering import Program
from chr_notes.derivations.computation import Let

_AXES = 3


PRODUCTS = '''
def products(matrix: Floats, vector: Floats) -> Floats:
    """Multiply vectors by one matrix for all, which BLAS does fast, or by one for each."""
    one = matrix.size == 9
    found: Floats = (
        vector.dot(matrix.reshape(3, 3).T) if one else einsum("...ij,...j", matrix, vector)
    )
    return found
'''.strip()


class products(Function):  # noqa: N801 (its name in Python)
    """Vectors times a matrix."""


def together(program: Program) -> tuple[Let, ...] | None:
    """Write a function of vectors and matrices with these alone, not with their elements.

    Returns
    -------
    tuple of Let, or None
        Steps, the last of which is the result; None where the axes are not treated alike.
    """
    given = {
        Symbol(name): [Symbol(element.name, real=True) for element in elements]
        for name, elements in program.target.arrays
    }
    lets = [step for step in program.steps if isinstance(step, Let)]
    threes = [lets[at : at + _AXES] for at in range(0, len(lets), _AXES)]
    found: list[Let] = []
    for three in threes:
        name = Symbol(three[0].name.name.removesuffix("_x"))
        found.append(Let(name, _of_all_axes([let.value for let in three], given)))
        given[name] = [let.name for let in three]
    found.append(Let(Symbol("out"), _of_all_axes(list(program.results), given)))
    alike = len(lets) == len(program.steps) and None not in [let.value for let in found]
    return tuple(found) if alike else None


def _of_all_axes(values: list[Basic], given: dict[Symbol, list[Symbol]]) -> Basic | None:
    """Write three formulas as one; None where they are not the same for each axis."""
    if len(values) != _AXES:
        return None
    vectors = {name: each for name, each in given.items() if len(each) == _AXES}
    for name, matrix in given.items():
        if len(matrix) == _AXES**2:
            rows = [matrix[at : at + _AXES] for at in range(0, len(matrix), _AXES)]
            for vector, parts in vectors.items():
                sums = [sum(m * v for m, v in zip(row, parts, strict=True)) for row in rows]
                pairs = zip(values, sums, strict=True)
                values = [value.subs(each, products(name, vector)) for value, each in pairs]
    one, *others = (
        value.xreplace({parts[axis]: name for name, parts in vectors.items()})
        for axis, value in enumerate(values)
    )
    return (
        one if all(one == other for other in others) and one.free_symbols <= given.keys() else None
    )
