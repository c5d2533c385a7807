"""The usual misprints, made on purpose, one at a time."""

from collections.abc import Callable, Iterator

from sympy import (
    Add,
    Basic,
    Eq,
    Function,
    ImmutableMatrix,
    MatAdd,
    MatMul,
    MatrixBase,
    MatrixSymbol,
    Mul,
    Symbol,
    atan2,
    cos,
    sin,
)
from sympy.core.relational import Relational
from sympy.logic.boolalg import And

from chr_notes.printed.statement import Approximately, Rotation

SWAPPED_FUNCTION: dict[type[Function], type[Function]] = {sin: cos, cos: sin}


def misprints(statement: Basic) -> Iterator[tuple[str, Basic]]:
    """Yield (name, misprinted statement) for a relation or a conjunction of relations."""
    if isinstance(statement, And):
        for index, part in enumerate(statement.args):
            for name, wrong in misprints(part):
                rest = [other for place, other in enumerate(statement.args) if place != index]
                yield f"part {index}: {name}", And(wrong, *rest, evaluate=False)
        return
    if isinstance(statement, Approximately):
        yield from wrong_numbers(statement)
        return
    assert isinstance(statement, Relational)
    if not isinstance(statement, Eq):
        yield "turned round", statement.negated
        return
    for name, wrong in wrong_expressions(statement.rhs):
        if wrong != statement.rhs:
            yield name, Eq(statement.lhs, wrong, evaluate=False)


def wrong_numbers(statement: Approximately) -> Iterator[tuple[str, Basic]]:
    """Misprint a number: its sign, a factor of two, its last digit."""
    number, unit = statement.rhs, statement.unit
    for name, wrong in (
        ("negated", -number),
        ("twice as large", 2 * number),
        ("half as large", number / 2),
        ("last digit one up", number + unit),
        ("last digit one down", number - unit),
    ):
        # In units of the last digit, which a misprint leaves where it is.
        yield name, Approximately(statement.lhs / unit, str(round(wrong / unit)))


def wrong_expressions(expression: Basic) -> Iterator[tuple[str, Basic]]:
    """Yield the misprints of one side."""
    yield from swapped_symbols(expression)
    if isinstance(expression, MatrixBase):
        yield from wrong_matrices(expression)
    elif isinstance(expression, MatMul):
        if expression.rows == expression.cols:
            yield "factors in reverse order", MatMul(*reversed(expression.args))
        yield from wrong_parts(expression, wrong_factors)
    elif isinstance(expression, MatAdd):
        yield from wrong_parts(expression, wrong_expressions)
    elif getattr(expression, "is_Matrix", False):
        yield from wrong_factors(expression)
    else:
        yield from wrong_scalars(expression)


def wrong_matrices(matrix: MatrixBase) -> Iterator[tuple[str, Basic]]:
    """Misprint a matrix: transposed, or one of its elements."""
    if matrix.rows == matrix.cols:
        yield "transposed", ImmutableMatrix(matrix.T)
    for index, element in enumerate(matrix):
        for name, wrong in wrong_scalars(element):
            elements = list(matrix)
            elements[index] = wrong
            yield f"element {index}: {name}", ImmutableMatrix(matrix.rows, matrix.cols, elements)


def wrong_parts(
    whole: Basic, misprint: Callable[[Basic], Iterator[tuple[str, Basic]]]
) -> Iterator[tuple[str, Basic]]:
    """Misprint one part of a sum or a product of matrices."""
    for index, part in enumerate(whole.args):
        for name, wrong in misprint(part):
            args = list(whole.args)
            args[index] = wrong
            yield f"part {index} {name}", whole.func(*args)


def wrong_factors(factor: Basic) -> Iterator[tuple[str, Basic]]:
    """Misprint one factor of a product of matrices."""
    yield "negated", -factor
    if isinstance(factor, Rotation):
        source, target = factor.frames
        yield "in the other direction", Rotation(target, source, *factor.angles)
        for index, angle in enumerate(factor.angles):
            angles = list(factor.angles)
            angles[index] = -angle
            yield f"with angle {index} negated", Rotation(source, target, *angles)


def wrong_scalars(expression: Basic) -> Iterator[tuple[str, Basic]]:
    """Misprint a scalar: a sign, sin for cos, a factor of two."""
    if expression == 0:
        return
    yield "negated", -expression
    yield "twice as large", 2 * expression
    yield "half as large", expression / 2
    for path, node in nodes(expression):
        if type(node) in SWAPPED_FUNCTION:
            swapped = SWAPPED_FUNCTION[type(node)](*node.args)
            yield f"{swapped} for {node} at {path}", put(expression, path, swapped)
        if isinstance(node, Add):
            for index, term in enumerate(node.args):
                wrong = put(expression, (*path, index), -term)
                yield f"sign of {term} at {path}", wrong
        if isinstance(node, atan2):
            turned = atan2(*reversed(node.args))
            yield f"arguments swapped at {path}", put(expression, path, turned)
        if isinstance(node, Mul) and node.args[0] == 2:
            yield f"factor of two lost at {path}", put(expression, path, node / 2)


def swapped_symbols(expression: Basic) -> Iterator[tuple[str, Basic]]:
    """Swap each pair of symbols throughout."""
    names = sorted(
        (s for s in expression.free_symbols if isinstance(s, Symbol | MatrixSymbol)), key=str
    )
    for index, one in enumerate(names):
        for other in names[index + 1 :]:
            if getattr(one, "shape", ()) != getattr(other, "shape", ()):
                continue
            swap = {one: other, other: one}
            yield f"{one} and {other} swapped", expression.xreplace(swap)


def nodes(expression: Basic, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], Basic]]:
    """Yield all nodes of an expression with their paths."""
    yield path, expression
    for index, child in enumerate(expression.args):
        yield from nodes(child, (*path, index))


def put(expression: Basic, path: tuple[int, ...], new: Basic) -> Basic:
    """Replace the node at a path."""
    if not path:
        return new
    args = list(expression.args)
    args[path[0]] = put(args[path[0]], path[1:], new)
    return expression.func(*args)
