"""From what a three-axis sensor measures back to what is there, by solving its model.

The model of the notes: sensitivities S on the diagonal scale what is there, offsets are taken
away, and the misalignment M mixes the axes. Its inverse N is used as a matrix of its own, since
any invertible M has one. What is there comes first in each model, what is measured second.
"""

from sympy import Expr, ImmutableMatrix, Symbol, cos, diag, hessian, pi, sin, solve, sqrt, symbols

from chr_notes.symbols import ACCELEROMETER, VECTOR

MISALIGNMENT = ImmutableMatrix(3, 3, symbols("M_1(1:4) M_2(1:4) M_3(1:4)", real=True))
REALIGNMENT = ImmutableMatrix(3, 3, symbols("N_1(1:4) N_2(1:4) N_3(1:4)", real=True))
SENSITIVITY = symbols("S_x S_y S_z", real=True, nonzero=True)
BIAS = symbols("beta_x beta_y beta_z", real=True)
# How the acceleration along each axis adds to the reading of a rate gyro about each.
COUPLING = ImmutableMatrix(3, 3, symbols("C_1(1:4) C_2(1:4) C_3(1:4)", real=True))
SOFT_IRON = ImmutableMatrix(3, 3, symbols("D_1(1:4) D_2(1:4) D_3(1:4)", real=True))
HARD_IRON = symbols("h_x h_y h_z", real=True)

# The vector that goes in.
INPUT = ImmutableMatrix(VECTOR)
_NO_OFFSET = ImmutableMatrix.zeros(3, 1)


def _aligned(actual: ImmutableMatrix, offset: ImmutableMatrix) -> ImmutableMatrix:
    """Read along the sensor's own axes: scaled, less the bias, plus what else is added."""
    return ImmutableMatrix(diag(*SENSITIVITY) * actual - ImmutableMatrix(BIAS) + offset)


def measured(offset: ImmutableMatrix = _NO_OFFSET) -> ImmutableMatrix:
    """Measure the vector (x, y, z), by the model."""
    return ImmutableMatrix(MISALIGNMENT * _aligned(INPUT, offset))


def corrected(offset: ImmutableMatrix = _NO_OFFSET) -> ImmutableMatrix:
    """Solve the model for the vector that is there when (x, y, z) is measured."""
    actual = ImmutableMatrix(symbols("u_1:4"))
    return _solved(_aligned(actual, offset) - REALIGNMENT * INPUT, actual)


def coupled() -> ImmutableMatrix:
    """Add to a gyro's reading what the corrected acceleration makes of it."""
    return ImmutableMatrix(COUPLING * ImmutableMatrix(ACCELEROMETER))


def without_iron() -> ImmutableMatrix:
    """Take soft and hard iron out of a field (x, y, z) that both distort."""
    return ImmutableMatrix(SOFT_IRON * INPUT - ImmutableMatrix(HARD_IRON))


def with_iron() -> ImmutableMatrix:
    """Distort a field (x, y, z) by soft and hard iron; N is the inverse of the soft-iron matrix."""
    distorted = ImmutableMatrix(symbols("u_1:4"))
    # `without_iron` of the distorted field, brought to the matrix's other side
    return _solved(distorted - REALIGNMENT * (INPUT + ImmutableMatrix(HARD_IRON)), distorted)


def _solved(zero: ImmutableMatrix, unknowns: ImmutableMatrix) -> ImmutableMatrix:
    found: dict[Symbol, Expr] = solve(list(zero), list(unknowns))
    return ImmutableMatrix([found[unknown] for unknown in unknowns])


def sensitivity_matrix(sensitivities: tuple[Symbol, ...] = SENSITIVITY) -> ImmutableMatrix:
    """Matrix of a sensor each of whose axes scales what lies along it by its own sensitivity."""
    outputs = [factor * part for factor, part in zip(sensitivities, VECTOR, strict=True)]
    return ImmutableMatrix(ImmutableMatrix(outputs).jacobian(VECTOR))


def ellipsoid_shape() -> ImmutableMatrix:
    """Matrix Q of the ellipsoid x^T Q x on which readings lie, counted from their centre.

    What the soft-iron matrix makes of a reading has the length of the field, wherever it points.
    """
    field = SOFT_IRON * INPUT
    return ImmutableMatrix(hessian(field.dot(field), VECTOR) / 2)


def readings_centre() -> ImmutableMatrix:
    """Find the centre of the readings: it lies halfway between those of opposite fields."""
    distorted = with_iron()
    opposite = distorted.subs({part: -part for part in VECTOR}, simultaneous=True)
    return ImmutableMatrix((distorted + opposite) / 2)


def readings_mean() -> ImmutableMatrix:
    """Average the readings over all directions of a field of unit strength."""
    height, turn = symbols("z_0 lambda", real=True)
    ring = sqrt(1 - height**2)
    towards = dict(zip(VECTOR, (ring * cos(turn), ring * sin(turn), height), strict=True))
    # equal areas of a sphere have equal heights
    around = with_iron().xreplace(towards).applyfunc(lambda part: part.integrate((turn, 0, 2 * pi)))
    return ImmutableMatrix(
        around.applyfunc(lambda part: part.integrate((height, -1, 1))) / (4 * pi)
    )


# What brings readings back to a vector of length one: a symmetric matrix, and where they centre.
TO_SPHERE = symbols("A_xx A_xy A_xz A_yy A_yz A_zz", real=True)
CENTRE = symbols("c_x c_y c_z", real=True)


def norm_misfit() -> ImmutableMatrix:
    """Length of a reading (x, y, z) brought to the unit sphere, less 1, and its slopes.

    A rotation does not change lengths, so the matrix may be taken as symmetric. The slopes are
    those by `TO_SPHERE` and `CENTRE`, in their order: what least squares needs.

    Returns
    -------
    ImmutableMatrix
        10 by 1.
    """
    xx, xy, xz, yy, yz, zz = TO_SPHERE
    matrix = ImmutableMatrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    inside = matrix * (INPUT - ImmutableMatrix(CENTRE))
    length = sqrt(inside.dot(inside))
    # A length changes by the part of the vector's change that lies along it.
    slopes = (inside.diff(each).dot(inside / length) for each in (*TO_SPHERE, *CENTRE))
    return ImmutableMatrix([length - 1, *slopes])


def turned_reading() -> ImmutableMatrix:
    """Integrate what a gyro without bias reads over a turn about a fixed axis.

    The rate at any time is the axis times a speed, and the speeds add up to the angle: so the
    integral is what the sensor reads of the vector (x, y, z), axis times angle.
    """
    return measured().subs(dict.fromkeys(BIAS, 0))
