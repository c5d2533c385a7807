"""The usual misprints, made on purpose, one at a time: a table of kinds."""

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType

from sympy import (
    Abs,
    Add,
    Basic,
    Eq,
    Expr,
    FiniteSet,
    Ge,
    Integer,
    Inverse,
    Le,
    MatAdd,
    MatMul,
    MatrixBase,
    MatrixSymbol,
    Mul,
    Number,
    Pow,
    Rational,
    Set,
    Symbol,
    Transpose,
    Union,
    acos,
    asin,
    atan,
    atan2,
    cos,
    sin,
)
from sympy.core.relational import Relational
from sympy.core.symbol import Str

from chr_notes.ledger.edits import in_order, rebuilt
from chr_notes.printed.hamilton import Conjugate, Product, Reciprocal
from chr_notes.printed.statement import Approximately, Rotation

Wrong = Iterator[Basic]
SWAPPED = {sin: cos, cos: sin, asin: acos}
FRAMES = ({"I", "v1", "v2", "B"}, {"i", "b"})
STEPS = (("k + 1", "k"), ("k+1", "k"), ("n-1", "n"), ("n - 1", "n"))


def sign(node: Basic, _: Basic) -> Wrong:
    """Yield a sum with the sign of one term changed, a product or function with its own."""
    if isinstance(node, Add | MatAdd):
        for place, term in enumerate(node.args):
            yield replaced(node, place, negative(term))
    elif isinstance(node, MatrixBase):
        yield from (with_element(node, place, negative(each)) for place, each in enumerate(node))
    elif isinstance(node, Eq):
        yield replaced(node, 1, negative(node.rhs))


def sine_for_cosine(node: Basic, _: Basic) -> Wrong:
    """Yield the other function of the same angle."""
    if type(node) in SWAPPED:
        yield SWAPPED[type(node)](*node.args, evaluate=False)


def transposed(node: Basic, _: Basic) -> Wrong:
    """Yield a square matrix on its other diagonal."""
    if isinstance(node, MatrixBase) and node.rows == node.cols:
        yield node.T
    if isinstance(node, MatrixSymbol | Rotation) and node.is_square:
        yield Transpose(node)


def swapped_symbols(node: Basic, whole: Basic) -> Wrong:
    """Yield another symbol of the statement, of the same shape, in one place."""
    if isinstance(node, Symbol | MatrixSymbol):
        others = whole.atoms(Symbol, MatrixSymbol) - {node}
        for other in sorted(others, key=str):
            if alike(node, other):
                yield other


def swapped_throughout(node: Basic, whole: Basic) -> Wrong:
    """Yield the whole with two symbols exchanged everywhere."""
    if node is whole:
        plain = (name for name in whole.free_symbols if isinstance(name, Symbol | MatrixSymbol))
        names = sorted(plain, key=str)
        for place, one in enumerate(names):
            for other in names[place + 1 :]:
                if alike(one, other):
                    yield whole.xreplace({one: other, other: one})


def lost_factor(node: Basic, _: Basic) -> Wrong:
    """Yield a product without one of its factors, and a fraction upside down in one of them."""
    if isinstance(node, Mul | MatMul | Product) and len(node.args) > 1:
        for place, factor in enumerate(node.args):
            rest = [each for other, each in enumerate(node.args) if other != place]
            if getattr(factor, "shape", ()) in ((), (3, 3), (4, 1)) or not node.is_Matrix:
                yield rest[0] if len(rest) == 1 else rebuilt(node, rest)


def reversed_factors(node: Basic, _: Basic) -> Wrong:
    """Yield factors that do not commute in reverse order."""
    if isinstance(node, Product) or (
        isinstance(node, MatMul) and all(getattr(f, "is_square", True) for f in node.args)
    ):
        yield rebuilt(node, list(reversed(node.args)))


def lost_root_or_inverse(node: Basic, _: Basic) -> Wrong:
    """Yield what stands under a root, a power, an inverse, a conjugate, a magnitude."""
    if isinstance(node, Pow | Reciprocal | Conjugate | Inverse | Transpose | Abs):
        yield node.args[0]


def wrong_quadrant(node: Basic, _: Basic) -> Wrong:
    """Yield an arctangent of swapped or negated arguments, or one that forgets the quadrant."""
    if isinstance(node, atan2):
        sine, cosine = node.args
        yield atan2(cosine, sine, evaluate=False)
        yield atan2(negative(sine), negative(cosine), evaluate=False)
        yield atan(rebuilt(Mul(sine, cosine, evaluate=False), [sine, Pow(cosine, -1)]))
    if isinstance(node, atan):
        yield atan(Pow(node.args[0], -1, evaluate=False), evaluate=False)


def wrong_frame(node: Basic, _: Basic) -> Wrong:
    """Yield a rotation in the other direction, or from or to another frame."""
    if isinstance(node, Rotation):
        source, target = node.frames
        yield Rotation(target, source, *node.angles)
        known = next(frames for frames in FRAMES if source in frames)
        for other in sorted(known - {source, target}):
            yield Rotation(other, target, *node.angles)
            yield Rotation(source, other, *node.angles)


def added_term(node: Basic, whole: Basic) -> Wrong:
    """Yield a side with one term too many."""
    if not isinstance(node, Eq):
        return
    numbers = sorted(
        (s for s in whole.free_symbols if isinstance(s, Symbol) and s.is_real), key=str
    )
    extra: Basic = Mul(*numbers[:2], evaluate=False) if numbers else Integer(1)
    right = node.rhs
    if isinstance(right, MatrixBase):
        yield replaced(node, 1, with_element(right, 0, Add(right[0], extra, evaluate=False)))
    elif getattr(right, "is_Matrix", False):
        yield replaced(node, 1, MatAdd(right, right))
    elif not isinstance(right, Set):
        yield replaced(node, 1, Add(right, extra, evaluate=False))


def wrong_step(node: Basic, _: Basic) -> Wrong:
    """Yield k for k + 1, and the other way round."""
    if isinstance(node, Symbol | MatrixSymbol):
        for one, other in (*STEPS, *(step[::-1] for step in STEPS)):
            name = node.name.replace(f"[{one}]", f"[{other}]").replace(f"({one})", f"({other})")
            if name != node.name:
                shape = getattr(node, "shape", ())
                yield MatrixSymbol(name, *shape) if shape else type(node)(name, **assumed(node))


def digit(node: Basic, _: Basic) -> Wrong:
    """Yield a number with its last digit one up or down, twice, half or minus itself."""
    if isinstance(node, Approximately):
        unit, number = node.unit, node.rhs
        for wrong in (number + unit, number - unit, 2 * number, number / 2, -number):
            # In units of the last digit, which a misprint leaves where it is.
            yield Approximately(node.lhs / unit, str(round(wrong / unit)))
    elif isinstance(node, Number) and node not in (0, -1) and node.is_finite:
        yield node + (1 if node.is_Integer else Rational(1, 10))


def wrong_set(node: Basic, _: Basic) -> Wrong:
    """Yield a set with one element more."""
    if isinstance(node, Set):
        yield Union(node, FiniteSet(Rational(1, 7)))


def wrong_word(node: Basic, _: Basic) -> Wrong:
    """Yield another word, or no word."""
    if isinstance(node, Symbol) and node.name.startswith(r"\text{"):
        yield Symbol(r"\text{another word}")


def made_inequality(node: Basic, _: Basic) -> Wrong:
    """Yield an inequality in place of an equation between numbers."""
    if isinstance(node, Eq) and all(isinstance(e, Expr) and not e.is_Matrix for e in node.args):
        yield Ge(*node.args, evaluate=False)
        yield Le(*node.args, evaluate=False)


def turned_round(node: Basic, _: Basic) -> Wrong:
    """Yield the opposite of a relation that is no equation."""
    if isinstance(node, Relational) and not isinstance(node, Eq):
        yield node.negated


KINDS: Mapping[str, Callable[[Basic, Basic], Wrong]] = MappingProxyType(
    {
        "sign": sign,
        "sine for cosine": sine_for_cosine,
        "transposed": transposed,
        "swapped symbols, in one place": swapped_symbols,
        "swapped symbols, throughout": swapped_throughout,
        "lost factor": lost_factor,
        "factors in reverse order": reversed_factors,
        "lost root or inverse": lost_root_or_inverse,
        "wrong quadrant": wrong_quadrant,
        "wrong frame": wrong_frame,
        "added term": added_term,
        "k for k + 1": wrong_step,
        "digit": digit,
        "set": wrong_set,
        "word": wrong_word,
        "turned round": turned_round,
        "made an inequality": made_inequality,
    }
)
"""Each kind gives, for a node of a statement, what a misprint puts in its place."""


def misprints(statement: Basic) -> Iterator[tuple[str, Basic]]:
    """Yield (kind and number, misprinted statement), each one once."""
    seen = {in_order(statement)}
    for kind, wrongs in KINDS.items():
        number = 0
        for path, node in nodes(statement):
            for wrong in wrongs(node, statement):
                try:
                    misprinted = put(statement, path, wrong)
                except IndexError:
                    continue  # an element that the matrix does not have cannot be written down
                if in_order(misprinted) not in seen:
                    seen.add(in_order(misprinted))
                    number += 1
                    yield f"{kind} {number}", misprinted


def nodes(expression: Basic, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], Basic]]:
    """Yield all nodes of a statement with their paths; matrices element by element."""
    yield path, expression
    if isinstance(expression, Str):
        return
    parts = list(expression) if isinstance(expression, MatrixBase) else expression.args
    if isinstance(expression, Symbol | MatrixSymbol | Rotation):
        return
    for index, child in enumerate(parts):
        yield from nodes(child, (*path, index))


def put(expression: Basic, path: tuple[int, ...], new: Basic) -> Basic:
    """Replace the node at a path, and leave the rest as it is printed."""
    if not path:
        return new
    place, *further = path
    if isinstance(expression, MatrixBase):
        return with_element(expression, place, put(expression[place], tuple(further), new))
    return replaced(expression, place, put(expression.args[place], tuple(further), new))


def replaced(node: Basic, place: int, new: Basic) -> Basic:
    """Replace one of the parts of a node."""
    return rebuilt(node, [new if n == place else part for n, part in enumerate(node.args)])


def with_element(matrix: MatrixBase, place: int, new: Basic) -> MatrixBase:
    """Replace one of the elements of a matrix."""
    return type(matrix)(*matrix.shape, [new if n == place else e for n, e in enumerate(matrix)])


def alike(one: Basic, other: Basic) -> bool:
    """Whether one symbol may stand where the other does: two vectors, numbers, or words."""
    shapes = [getattr(symbol, "shape", ()) for symbol in (one, other)]
    return shapes[0] == shapes[1] and getattr(one, "is_real", 0) == getattr(other, "is_real", 0)


def negative(expression: Basic) -> Basic:
    """Put a minus in front."""
    if getattr(expression, "is_Matrix", False):
        return -expression if isinstance(expression, MatrixBase) else MatMul(-1, expression)
    if isinstance(expression, Set | Str) or not hasattr(expression, "__neg__"):
        return expression
    return Mul(-1, expression, evaluate=False)


def assumed(symbol: Symbol) -> dict[str, bool]:
    """Return what a symbol was declared to be."""
    return dict(symbol._assumptions_orig)  # noqa: SLF001 (SymPy has no other way to ask)
