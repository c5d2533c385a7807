"""When two formulas are the same for all values of their symbols, and when one is larger."""

from functools import lru_cache
from typing import Self

from sympy import (
    Abs,
    Basic,
    Dummy,
    Expr,
    Integer,
    Limit,
    MatrixBase,
    MatrixExpr,
    Pow,
    Rational,
    S,
    Set,
    Subs,
    Symbol,
    cancel,
    cos,
    expand,
    expand_trig,
    floor,
    fraction,
    gcd,
    sec,
    simplify,
    sin,
    sqrt,
    tan,
    together,
)
from sympy import reduced as remainder
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.polys.domains import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

CLEARLY_NOT_ZERO = 1e-15  # against values computed with 30 digits
MANY_DIGITS = 60  # so that 30 are right even where digits cancel


class OnSphere(Symbol):
    """One of several numbers whose squares add up to 1."""

    def __new__(cls, name: str, sphere: tuple[str, ...]) -> Self:
        """Make the symbol that stands for one of the names of a sphere."""
        symbol = super().__new__(cls, rf"{name}_{{{' '.join(sphere)}}}", real=True)
        symbol.sphere = sphere
        return symbol

    @property
    def all(self) -> tuple["OnSphere", ...]:
        """All symbols of the sphere."""
        return tuple(OnSphere(name, self.sphere) for name in self.sphere)


def difference(left: Basic, right: Basic) -> tuple[Basic, ...]:
    """Take left minus right, element by element, not yet simplified."""
    if isinstance(left, MatrixBase) != isinstance(right, MatrixBase):
        msg = f"expected two matrices or two scalars, got {left} and {right}"
        raise TypeError(msg)
    return tuple(left - right) if isinstance(left, MatrixBase) else (left - right,)


def sample(expression: Basic) -> Basic:
    """Give the value of an expression at one point of no particular kind, with 30 digits."""
    names = sorted(expression.free_symbols, key=str)
    point = {name: Rational(2 * index + 3, 7 * index + 11) for index, name in enumerate(names)}
    for sphere in _spheres(expression):
        length = sqrt(sum(Rational(n + 2, 3) ** 2 for n in range(len(sphere))))
        point |= {name: Rational(n + 2, 3) / length for n, name in enumerate(sphere)}
    if expression.has(Limit, ExprWithLimits, Subs, floor):
        return expression.subs(point).evalf(30, chop=False)
    # Decimals are worked out on the way, where fractions would pile up.
    there = expression.xreplace({name: value.evalf(MANY_DIGITS) for name, value in point.items()})
    return there.evalf(30, chop=False)


def _spheres(expression: Basic) -> set[tuple[OnSphere, ...]]:
    return {name.all for name in expression.free_symbols if isinstance(name, OnSphere)}


@lru_cache(maxsize=4096)
def is_zero(expression: Basic) -> bool:
    """Whether an expression vanishes for all values of its symbols.

    A value clearly off zero settles that it does not. An expression that is rational in the
    sines and cosines of angles is then decided exactly; any other is left to SymPy's `simplify`.
    """
    if expression.is_Rational:
        return bool(expression == 0)
    if isinstance(expression, Abs):
        return is_zero(expression.args[0])
    value = sample(expression)
    if value.is_Float and abs(value) > CLEARLY_NOT_ZERO:
        return False
    if not expression.free_symbols:
        return bool(simplify(expression) == 0)
    on_circles = _is_zero_on_circles(expression)
    return bool(simplify(expression) == 0) if on_circles is None else on_circles


def _is_zero_on_circles(expression: Expr) -> bool | None:
    """Whether an expression vanishes, or nothing if it is not rational in sines and cosines.

    What is left of the numerator when the squares of each point add up to one is zero for nothing
    but zero.
    """
    circles = _Circles(expression)
    left_over = circles.reduced(_fraction(circles.algebraic)[0])
    return None if left_over is None else bool(left_over == 0)


def reduced(expression: Expr) -> Expr | None:
    """Shorten a quotient by cos² + sin² = 1, or give nothing if it is not rational in these."""
    circles = _Circles(expression)
    above, below = map(circles.reduced, _fraction(circles.algebraic))
    return None if above is None or below is None else cancel(above / below).xreplace(circles.back)


def _fraction(expression: Expr) -> tuple[Expr, Expr]:
    """Take numerator and denominator; where nothing is divided, nothing is brought together."""
    divided = any(power.exp.is_negative for power in expression.atoms(Pow))
    return fraction(together(expression)) if divided else (expression, Integer(1))


Point = tuple[Expr, Expr]


class _Circles:
    """An expression in terms of points on unit circles, and of names on spheres.

    An angle is a sum of whole multiples of some parts, and each part a point (cosine, sine) of
    the unit circle. Sines and cosines of all angles are polynomials in these.
    """

    def __init__(self, expression: Expr) -> None:
        angles = {call.args[0] for call in expression.atoms(sin, cos, tan)}
        points, whole = _points_of(angles)
        self.algebraic = (
            expression.replace(tan, lambda x: whole[x][1] / whole[x][0])
            .replace(sin, lambda x: whole[x][1])
            .replace(cos, lambda x: whole[x][0])
        )
        self.back = {
            coordinate: function(part)
            for part, point in points.items()
            for function, coordinate in zip((cos, sin), point, strict=True)
        }
        self.relations = [cosine**2 + sine**2 - 1 for cosine, sine in points.values()]
        self.unknowns = [*self.back]
        for sphere in _spheres(expression):
            self.relations.append(sum(name**2 for name in sphere) - 1)
            self.unknowns += sphere

    def reduced(self, polynomial: Expr) -> Expr | None:
        """Reduce a polynomial by what is known of the points; nothing if it is none."""
        # The unknowns come first, so that it is their squares which the relations put away.
        others = sorted(polynomial.free_symbols - {*self.unknowns}, key=str)
        polynomials = PolyRing([*self.unknowns, *others], QQ, lex)
        try:
            known = polynomials.from_expr(polynomial)
        except ValueError:
            return self._reduced_with_roots(polynomial)
        return known.rem([*map(polynomials.from_expr, self.relations)]).as_expr()

    def _reduced_with_roots(self, polynomial: Expr) -> Expr | None:
        """Do so where numbers are no fractions, such as roots."""
        polynomial = expand(polynomial)
        if not polynomial.is_polynomial(*polynomial.free_symbols):
            return None
        if not self.relations or polynomial == 0:
            return polynomial
        return remainder(polynomial, self.relations, *self.unknowns)[1]


def _points_of(angles: set[Expr]) -> tuple[dict[Expr, Point], dict[Expr, Point]]:
    """Give the points of the parts of angles, and those of the angles themselves in terms of them.

    Numbers are parts as well; their points are numbers, which have nothing unknown.
    """
    sums = {angle: expand(angle).as_coefficients_dict() for angle in angles}
    units: dict[Expr, Expr] = {}
    for terms in sums.values():
        for part, times in terms.items():
            units[part] = gcd(units.get(part, Integer(0)), times)
    points = {
        part: (Dummy("c"), Dummy("s"))
        if part.free_symbols
        else (cos(unit * part), sin(unit * part))
        for part, unit in units.items()
    }
    whole = {}
    for angle, terms in sums.items():
        at: Point = (Integer(1), Integer(0))
        for part, times in terms.items():
            cosine, sine = points[part]
            turns = int(times / units[part])
            for _ in range(abs(turns)):
                at = _further(at, (cosine, sine if turns > 0 else -sine))
        whole[angle] = at
    return {units[part] * part: point for part, point in points.items() if part.free_symbols}, whole


def _further(at: Point, by: Point) -> Point:
    """Go on round the circle: cosine and sine of a sum of two angles."""
    return at[0] * by[0] - at[1] * by[1], at[1] * by[0] + at[0] * by[1]


def equal(left: Basic, right: Basic) -> bool:
    """Whether two objects are the same: sets and names as such, formulas by their difference."""
    if left.has(S.NaN, S.ComplexInfinity) or right.has(S.NaN, S.ComplexInfinity):
        return False
    if left == right:
        return True
    if shape_of(left) != shape_of(right):
        return False
    infinite = {left, right} & {S.Infinity, S.NegativeInfinity}
    if infinite or isinstance(left, Set) or isinstance(right, Set):
        return False
    if isinstance(left, Abs) and isinstance(right, Abs):
        return any(is_zero(left.args[0] - sign * right.args[0]) for sign in (1, -1))
    return all(is_zero(element) for element in difference(left, right))


def shape_of(side: Basic) -> tuple[Basic, ...]:
    """Rows and columns of a matrix, nothing for a number; an element of a sequence is one."""
    return tuple(side.shape) if isinstance(side, MatrixBase | MatrixExpr) else ()


def same_angle(left: Expr, right: Expr) -> bool:
    """Whether two angles are the same up to whole turns: their difference has sine 0, cosine 1."""
    turn = left - right
    value = sample(turn)
    if value.is_Float and abs(sin(value / 2)) > CLEARLY_NOT_ZERO:
        return False
    return is_zero(expand_trig(sin(turn))) and is_zero(expand_trig(cos(turn)) - 1)


def is_positive(expression: Expr) -> bool:
    """Whether a rational expression is positive for all values that its symbols may take.

    Numerator and denominator are multiplied out; SymPy knows a sum of positive terms to be
    positive. An answer of no means only that this was not seen.
    """
    parts = [expand(part) for part in fraction(cancel(together(expression)))]
    return all(part.is_positive for part in parts) or all(part.is_negative for part in parts)


def settle(expression: Basic) -> Basic:
    """Work out what SymPy leaves standing: secants, floors, divisions by zero."""
    expression = expression.replace(sec, lambda x: 1 / cos(x)).replace(floor, _floor)
    divisors = (power.base for power in expression.atoms(Pow) if power.exp.is_negative)
    if not expression.free_symbols and any(is_zero(divisor) for divisor in divisors):
        return S.NaN
    return expression


def _floor(argument: Expr) -> Expr:
    """Round down an expression of which it can be shown between which integers it lies."""
    argument = cancel(expand(argument))
    guess = Integer(floor(sample(argument)))
    below = argument - guess
    if (below.is_nonnegative or is_positive(below)) and is_positive(1 - below):
        return guess
    return floor(argument)
