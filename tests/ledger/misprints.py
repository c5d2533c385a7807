"""The usual misprints, made on purpose, one at a time."""

from collections.abc import Callable, Iterator

from sympy import (
    Add,
    Basic,
    Eq,
    Expr,
    FiniteSet,
    Function,
    ImmutableMatrix,
    Inverse,
    MatAdd,
    MatMul,
    MatrixBase,
    MatrixSymbol,
    Mul,
    Rational,
    Set,
    Symbol,
    Transpose,
    Union,
    atan2,
    cos,
    sin,
)
from sympy.core.relational import Relational
from sympy.logic.boolalg import And

from chr_notes.printed.hamilton import Conjugate, Product, Reciprocal
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
    for name, wrong in wrong_sides(statement):
        if rebuilt(wrong) != rebuilt(statement):
            yield name, wrong


def rebuilt(expression: Basic) -> Basic:
    """Let SymPy order what was left as it is printed, so that a swap of equals is seen as none."""
    if not expression.args:
        return expression
    parts = map(rebuilt, expression.args)
    as_printed = {"evaluate": False} if isinstance(expression, Eq) else {}
    return expression.func(*parts, **as_printed)


def wrong_sides(statement: Eq) -> Iterator[tuple[str, Basic]]:
    """Misprint what stands on the right, or on the left if the right side is zero."""
    left, right = statement.lhs, statement.rhs
    if right == 0:
        for name, wrong in wrong_signs(left):  # a factor would be nothing to a zero
            yield name, Eq(wrong, 0, evaluate=False)
    elif isinstance(right, Set):
        one_more = Union(right, FiniteSet(Rational(1, 7)))
        yield "one element more", Eq(left, one_more, evaluate=False)
    else:
        for name, wrong in wrong_expressions(right):
            yield name, Eq(left, wrong, evaluate=False)


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
    elif isinstance(expression, MatAdd):
        yield from wrong_parts(expression, wrong_expressions)
    elif getattr(expression, "is_Matrix", False):
        yield from wrong_products(expression)
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


def wrong_products(expression: Basic) -> Iterator[tuple[str, Basic]]:
    """Misprint a product or sum of matrices or quaternions."""
    yield "negated", -expression
    yield from wrong_signs(expression)
    for path, node in nodes(expression):
        squares = isinstance(node, MatMul) and all(
            not factor.is_Matrix or factor.is_square for factor in node.args
        )
        if isinstance(node, Product) or squares:
            turned = node.func(*reversed(node.args))
            yield f"factors in reverse order at {path}", put(expression, path, turned)
        if isinstance(node, Reciprocal | Conjugate | Inverse | Transpose):
            bare = put(expression, path, node.args[0])
            yield f"{type(node).__name__} lost at {path}", bare
        if isinstance(node, MatrixBase) and node.rows == node.cols:
            yield f"transposed at {path}", put(expression, path, ImmutableMatrix(node.T))
        if isinstance(node, Rotation):
            source, target = node.frames
            other_way = Rotation(target, source, *node.angles)
            yield f"{node.frames} in the other direction", put(expression, path, other_way)
            for index, angle in enumerate(node.angles):
                if isinstance(angle, Expr) and not angle.is_Matrix:
                    negated = put(expression, (*path, 2 + index), -angle)
                    yield f"{node.frames} with angle {index} negated", negated


def wrong_scalars(expression: Basic) -> Iterator[tuple[str, Basic]]:
    """Misprint a scalar: a sign, sin for cos, a factor of two."""
    if expression == 0:
        return
    yield "negated", -expression
    yield "twice as large", 2 * expression
    yield "half as large", expression / 2
    yield from wrong_signs(expression)
    for path, node in nodes(expression):
        if type(node) in SWAPPED_FUNCTION:
            swapped = SWAPPED_FUNCTION[type(node)](*node.args)
            yield f"{swapped} for {node} at {path}", put(expression, path, swapped)
        if isinstance(node, atan2):
            turned = atan2(*reversed(node.args))
            yield f"arguments swapped at {path}", put(expression, path, turned)
        if isinstance(node, Mul) and node.args[0] == 2:
            yield f"factor of two lost at {path}", put(expression, path, node / 2)


def wrong_signs(expression: Basic) -> Iterator[tuple[str, Basic]]:
    """Misprint the sign of one term."""
    for path, node in nodes(expression):
        if isinstance(node, Add | MatAdd):
            for index, term in enumerate(node.args):
                yield f"sign of {term} at {path}", put(expression, (*path, index), -term)


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
