"""Heading from a magnetometer once roll and pitch are known, and a check of these two.

The field of the Earth is the same in the inertial frame wherever the body points. Conventions are
those of `chr_notes.conventions`.
"""

from functools import cache

from sympy import (
    Abs,
    Basic,
    Expr,
    ImmutableMatrix,
    Intersection,
    S,
    Set,
    atan2,
    cancel,
    cos,
    expand,
    factor_terms,
    pi,
    simplify,
    sin,
    solveset,
    sqrt,
    symbols,
)

from chr_notes.derivations.euler import Z, rotation
from chr_notes.derivations.quaternions import turned
from chr_notes.symbols import MAGNETOMETER, Angle, psi

# The field in the inertial frame: horizontal parts north and east, and the part down.
REFERENCE = ImmutableMatrix(symbols("m_N m_E m_D", real=True))
# The reading along the level axes of the vehicle-1 frame, forward and right.
LEVEL = symbols("x_level y_level", real=True)

# An error of attitude: unit axis in the inertial frame, angle.
ERROR_AXIS = symbols("n_N n_E n_D", real=True)
error_angle = Angle("epsilon", real=True)

# The Earth's field: magnitude, inclination, declination; a dipole's field at a latitude and a
# distance from the centre.
magnitude, radius, dipole_strength = symbols("M_e r K", positive=True)
inclination, declination, latitude = (
    Angle(name, real=True) for name in ("alpha", "delta", "lambda")
)


@cache
def yaws_of_gravity() -> Set:
    """Yaws at which gravity as it is in the body frame, taken back by them, points down."""
    tried = Angle(r"\psi_{\text{tried}}", real=True)
    in_body = rotation("I", "B") * Z
    back = rotation("v1", "I").subs(psi, tried) * rotation("B", "v1") * in_body
    north, east, _ = (simplify(part) for part in back)
    return Intersection(*(solveset(part, tried, S.Reals) for part in (north, east)))


@cache
def level_field() -> ImmutableMatrix:
    """Bring the reading `MAGNETOMETER` to the vehicle-1 frame, which is level but turned by yaw."""
    return ImmutableMatrix(rotation("B", "v1") * ImmutableMatrix(MAGNETOMETER))


@cache
def yaw_equations() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """State that the level reading, turned by yaw, is the horizontal field of the inertial frame.

    Returns
    -------
    ImmutableMatrix
        2 by 2 in `LEVEL`, what stands before the sine and the cosine of yaw.
    ImmutableMatrix
        2 by 1, what their sums make.
    """
    cosine, sine = symbols("cosine sine", real=True)
    turn = rotation("v1", "I").xreplace({cos(psi): cosine, sin(psi): sine})
    horizontal = (turn * ImmutableMatrix([*LEVEL, 0]))[:2, :]
    return ImmutableMatrix(horizontal.jacobian([sine, cosine])), ImmutableMatrix(REFERENCE[:2, :])


def from_reading(formula: Basic) -> Basic:
    """Put the reading `MAGNETOMETER`, brought to the level, in the place of `LEVEL`."""
    return formula.xreplace(dict(zip(LEVEL, level_field(), strict=False)))


@cache
def determinant() -> Expr:
    """Take the determinant of `yaw_equations`: minus the squared horizontal field as measured."""
    before, _ = yaw_equations()
    return before.det()


@cache
def sine_and_cosine_of_yaw() -> ImmutableMatrix:
    """Solve `yaw_equations` by Cramer's rule; both have the determinant as divisor."""
    before, sums = yaw_equations()
    return ImmutableMatrix(before.adjugate() * sums / determinant())


@cache
def heading() -> Expr:
    """Find yaw from the level field and the horizontal field (m_N, m_E) of the inertial frame.

    Sine and cosine of yaw have the same divisor, the `determinant`, which is negative: it drops
    out of atan2, its sign apart.
    """
    sine, cosine = (expand(-part * determinant()) for part in sine_and_cosine_of_yaw())
    return from_reading(atan2(sine, cosine))


def downward_gap(length: Expr = S.One) -> Expr:
    """Field down as it should be, less what a reading of some length says in units of it."""
    return REFERENCE[2] - expand(level_field()[2]) / length


@cache
def factor() -> Expr:
    """Difference E between the field down as it should be, m_D, and as it is measured.

    Both count in units of the whole field: the reading is divided by its magnitude, and m_D is
    the part that points down of a field of magnitude one. Yaw does not matter to it.
    """
    return Abs(downward_gap(sqrt(ImmutableMatrix(MAGNETOMETER).dot(ImmutableMatrix(MAGNETOMETER)))))


def factor_after_error() -> Expr:
    """Factor E for a faultless magnetometer whose attitude is off by a turn about an axis."""
    seen = turned(ImmutableMatrix(ERROR_AXIS), error_angle, REFERENCE)
    return Abs(REFERENCE[2] - seen[2])


@cache
def sensitivity() -> Expr:
    """Change of the signed E with a small error of attitude about an axis, per radian."""
    gap = factor_after_error().args[0]
    return expand(gap.diff(error_angle).subs(error_angle, 0))


@cache
def field_with_x_south() -> ImmutableMatrix:
    """Field of the Earth with x towards geographic south and z down, so that y points west.

    In north-east-down, inclination is the angle below the horizon and declination the angle of
    the horizontal part from north towards east.
    """
    level = cos(inclination)
    north_east_down = ImmutableMatrix(
        [level * cos(declination), level * sin(declination), sin(inclination)]
    )
    return ImmutableMatrix(magnitude * rotation("I", "v1").subs(psi, pi) * north_east_down)


@cache
def dipole_field() -> ImmutableMatrix:
    """Field of a dipole at the centre of the Earth, north, east and down: minus a gradient."""
    potential = -dipole_strength * sin(latitude) / radius**2
    north, up = -potential.diff(latitude) / radius, -potential.diff(radius)
    return ImmutableMatrix([north, 0, -up])


@cache
def dipole_magnitude() -> Expr:
    """Magnitude of `dipole_field`."""
    squared = dipole_field().dot(dipole_field()).subs(cos(latitude) ** 2, 1 - sin(latitude) ** 2)
    return sqrt(factor_terms(squared * radius**6)) / radius**3


@cache
def dipole_direction() -> ImmutableMatrix:
    """`dipole_field`, normalised: the distance drops out."""
    return ImmutableMatrix((dipole_field() / dipole_magnitude()).applyfunc(cancel))
