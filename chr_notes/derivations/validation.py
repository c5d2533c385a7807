"""Heading from a magnetometer once roll and pitch are known, and a check of these two.

The field of the Earth is the same in the inertial frame wherever the body points. Conventions are
those of `chr_notes.conventions`.
"""

from functools import cache

from sympy import (
    Abs,
    Expr,
    ImmutableMatrix,
    atan2,
    cos,
    expand,
    fraction,
    sin,
    solve,
    sqrt,
    symbols,
    together,
)

from chr_notes.derivations.euler import rotation
from chr_notes.symbols import MAGNETOMETER, psi

# The field in the inertial frame: horizontal parts north and east, and the part down.
REFERENCE = ImmutableMatrix(symbols("m_N m_E m_D", real=True))


@cache
def level_field() -> ImmutableMatrix:
    """Bring the reading `MAGNETOMETER` to the vehicle-1 frame, which is level but turned by yaw."""
    return ImmutableMatrix(rotation("B", "v1") * ImmutableMatrix(MAGNETOMETER))


@cache
def heading() -> Expr:
    """Find yaw from the level field and the horizontal field (m_N, m_E) of the inertial frame.

    `rotation("I", "v1")` takes one to the other; its two level rows are linear in the cosine and
    the sine of yaw. Both have the squared horizontal field as divisor, which drops out of atan2.
    """
    cosine, sine, x, y = symbols("cosine sine x_level y_level", real=True)
    turned = rotation("I", "v1").xreplace({cos(psi): cosine, sin(psi): sine}) * REFERENCE
    found = solve([turned[0] - x, turned[1] - y], [cosine, sine])
    level = dict(zip((x, y), level_field(), strict=False))
    return atan2(*(fraction(together(found[part]))[0].xreplace(level) for part in (sine, cosine)))


@cache
def factor() -> Expr:
    """Difference E between the field down as it should be, m_D, and as it is measured.

    Both count in units of the whole field: the reading is divided by its magnitude, and m_D is
    the part that points down of a field of magnitude one. Yaw does not matter to it.
    """
    magnitude = sqrt(ImmutableMatrix(MAGNETOMETER).dot(ImmutableMatrix(MAGNETOMETER)))
    return Abs(REFERENCE[2] - expand(level_field()[2]) / magnitude)
