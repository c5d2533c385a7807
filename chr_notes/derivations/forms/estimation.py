"""Forms of tilt, heading and the factor E."""

from functools import cache

from sympy import (
    Abs,
    And,
    Expr,
    ImmutableMatrix,
    Not,
    Symbol,
    atan2,
    collect,
    expand,
    pi,
    sin,
    sqrt,
    symbols,
)
from sympy.codegen.cfunctions import hypot

from chr_notes.derivations import estimation, validation
from chr_notes.derivations.computation import (
    LARGEST,
    NOTHING,
    Choice,
    Computation,
    Let,
    otherwise,
)
from chr_notes.symbols import ACCELEROMETER, MAGNETOMETER, Angle, theta

SQUARED = Symbol("length_squared", real=True)
KNOWN = Symbol("has_direction", real=True)


def with_direction(vector: tuple[Symbol, ...]) -> tuple[Let, ...]:
    """Tell whether a reading has a direction: it is neither zero nor infinite, nor NaN."""
    size = Symbol("size", real=True)
    return (
        Let(SQUARED, ImmutableMatrix(vector).dot(ImmutableMatrix(vector))),
        Let(size, sum(map(Abs, vector))),
        Let(KNOWN, And(size > 0, size <= LARGEST)),
    )


@cache
def tilt() -> Computation:
    """Roll in (-pi, pi] and pitch from an accelerometer at rest.

    Straight up or down, where roll is not determined, it is 0: there atan2 would go by the signs
    of zeros.
    """
    roll, pitch = estimation.tilt()
    sine, cosine = pitch.args
    side, down = (square.base for square in cosine.base.as_ordered_terms())
    across = Symbol("across", real=True)
    seen, found, steep = symbols("roll_seen roll pitch", real=True, cls=Angle)
    return Computation(
        (
            *with_direction(ACCELEROMETER),
            Let(across, hypot(side, down)),
            Let(seen, roll),
            Choice(
                (found,),
                (
                    (Not(KNOWN), (NOTHING,)),
                    (across <= 0, (across * 0,)),
                    (seen <= -pi, (pi,)),
                    otherwise(seen),
                ),
            ),
            Choice((steep,), ((KNOWN, (atan2(sine, across),)), otherwise(NOTHING))),
        ),
        ImmutableMatrix([found, steep]),
        guard=SQUARED,
    )


def _if_known(value: Expr) -> tuple[Choice, Symbol]:
    result = Symbol("result", real=True)
    return Choice((result,), ((KNOWN, (value,)), otherwise(NOTHING))), result


@cache
def heading() -> Computation:
    """Find yaw from the level parts of the magnetic field, which occur twice."""
    along, across = symbols("level_x level_y", real=True)
    level_x, level_y, _ = validation.level_field()
    yaw = validation.heading().xreplace({level_x: along, level_y: across})
    choice, result = _if_known(yaw)
    level_x = collect(expand(level_x), sin(theta))
    steps = (*with_direction(MAGNETOMETER), Let(along, level_x), Let(across, level_y))
    return Computation((*steps, choice), result, guard=SQUARED)


@cache
def factor() -> Computation:
    """Factor E; a field of zero has none."""
    down, size = symbols("level_z size", real=True)
    # In units in which no square overflows or vanishes.
    reading = symbols("reading_x reading_y reading_z", real=True)
    scaled = dict(zip(MAGNETOMETER, reading, strict=True))
    level_z = expand(validation.level_field()[2])
    field = ImmutableMatrix(MAGNETOMETER)
    value = validation.factor().xreplace({1 / sqrt(field.dot(field)): 1 / sqrt(SQUARED)})
    choice, result = _if_known(value.subs(level_z, down))
    _, *direction = with_direction(MAGNETOMETER)
    units = tuple(element / size for element in MAGNETOMETER)
    return Computation(
        (
            *direction,
            Choice(reading, ((KNOWN, units), otherwise(*(0 * part for part in reading)))),
            Let(SQUARED, field.dot(field).xreplace(scaled)),
            Let(down, level_z.xreplace(scaled)),
            choice,
        ),
        result,
        guard=size,
    )
