"""Quaternions: the rotations that they stand for, conversions, kinematics.

Conventions are those of `chr_notes.conventions`: the attitude quaternion is the turn that takes
the inertial axes to the body axes, so `v_I = q v_B q*`; matrices are passive, `v_B = R v_I`.
The algebra is that of `chr_notes.derivations.hamilton`.
"""

from functools import cache

from sympy import (
    Expr,
    I,
    ImmutableMatrix,
    Interval,
    Matrix,
    Set,
    Union,
    atan2,
    cos,
    exp,
    expand,
    eye,
    factor,
    pi,
    sin,
    sinc,
    singularities,
    sqrt,
    symbols,
)

from chr_notes.derivations.euler import TURNS, rotation, yaw_last
from chr_notes.derivations.hamilton import conjugate, multiply, norm_squared, sandwich, vector_part
from chr_notes.symbols import BODY_RATES, QUATERNION, VECTOR, T, a, b, c, d, phi, psi, theta

ATTITUDE = ImmutableMatrix(QUATERNION)
MATRIX = ImmutableMatrix(3, 3, symbols("r_1(1:4) r_2(1:4) r_3(1:4)", real=True))

# Stand for a - c, b + d, a + c and d - b.
FACTORS = symbols("P Q R S", real=True)


def turned(axis: ImmutableMatrix, angle: Expr, vector: ImmutableMatrix) -> ImmutableMatrix:
    """Turn a vector about a unit axis, by geometry (Rodrigues' formula).

    The part along the axis stays. The part across it goes round a circle, towards the vector
    product of axis and vector, which is as long and at a right angle to both.
    """
    along = axis * axis.dot(vector)
    return ImmutableMatrix(along + cos(angle) * (vector - along) + sin(angle) * axis.cross(vector))


def from_axis_angle(axis: ImmutableMatrix, angle: Expr) -> ImmutableMatrix:
    """Quaternion whose `sandwich` is the turn about a unit axis by an angle.

    Take `q = s + t n` with the axis n. `q v q*` leaves v = n as it is and makes of a v across it
    `(s² - t²) v + 2 s t (n × v)`. So `s² - t²` must be the cosine and `2 s t` the sine of the
    angle: `s + i t` is a square root of `exp(i angle)`. The other root is -q, the same turn.
    """
    s, t = exp(I * angle / 2).as_real_imag()
    return ImmutableMatrix([s, *(t * axis)])


@cache
def matrix_from_quaternion() -> ImmutableMatrix:
    """Matrix from inertial to body frame of the unit quaternion (a, b, c, d).

    Its columns are what `v_B = q* v_I q`, the undoing of `v_I = q v_B q*`, makes of the basis.
    """
    columns = [sandwich(conjugate(ATTITUDE), ImmutableMatrix(eye(3).col(n))) for n in range(3)]
    return ImmutableMatrix(Matrix.hstack(*columns))


@cache
def matrix_from_any_quaternion() -> ImmutableMatrix:
    """Compute `matrix_from_quaternion` for a quaternion of any norm but zero: over its square."""
    return ImmutableMatrix(matrix_from_quaternion() / norm_squared(ATTITUDE))


@cache
def rotate_to_inertial() -> ImmutableMatrix:
    """Vector (x, y, z) of the body frame in the inertial frame, for a unit quaternion."""
    return sandwich(ATTITUDE, ImmutableMatrix(VECTOR))


@cache
def rotate_to_body() -> ImmutableMatrix:
    """Vector (x, y, z) of the inertial frame in the body frame, for a unit quaternion."""
    return sandwich(conjugate(ATTITUDE), ImmutableMatrix(VECTOR))


@cache
def from_euler() -> ImmutableMatrix:
    """Multiply the turns by yaw, pitch and roll, each about an axis of its own frame.

    `v_I = q_yaw v_1 q_yaw*`, `v_1 = q_pitch v_2 q_pitch*` and so on: put into one another, the
    later turn stands to the right.
    """
    whole = ImmutableMatrix([1, 0, 0, 0])
    for axis, angle in TURNS.values():
        turn = from_axis_angle(ImmutableMatrix(eye(3).col(axis)), angle)
        whole = multiply(whole, turn)
    return whole


def place(element: Expr, matrix: ImmutableMatrix) -> int:
    """Find where a matrix has an element, counted row by row."""
    return list(matrix).index(element)


def pitch_sine(matrix: ImmutableMatrix) -> Expr:
    """Sine of pitch, read off a matrix from inertial to body frame."""
    return -matrix[place(-sin(theta), rotation("I", "B"))]


def euler_from_matrix(matrix: ImmutableMatrix) -> ImmutableMatrix:
    """Roll, pitch and yaw of a matrix from inertial to body frame, off gimbal lock.

    One element of the matrix of Euler angles is the sine of pitch alone. Four others are the sine
    and cosine of roll and of yaw times the cosine of pitch, which is not negative from -90° to
    90°: it drops out of atan2, and the root of two squares gives it.
    """
    euler = rotation("I", "B")
    roll = [matrix[place(cos(theta) * part(phi), euler)] for part in (sin, cos)]
    yaw = [matrix[place(cos(theta) * part(psi), euler)] for part in (sin, cos)]
    pitch_cosine = sqrt(factor(expand(yaw[0] ** 2 + yaw[1] ** 2)))
    return ImmutableMatrix([atan2(*roll), atan2(pitch_sine(matrix), pitch_cosine), atan2(*yaw)])


def roll_turned_first(matrix: ImmutableMatrix) -> Expr:
    """Roll of a matrix from inertial to body frame, if it is the first of the turns, yaw the last.

    As in `euler_from_matrix`: sine and cosine of roll stand in it, times the cosine of pitch.
    """
    euler = yaw_last()
    places = (-cos(theta) * sin(phi), cos(theta) * cos(phi))
    sine, cosine = (matrix[place(part, euler)] for part in places)
    return atan2(-sine, cosine)


@cache
def euler_from_quaternion() -> ImmutableMatrix:
    """Roll, pitch and yaw of (a, b, c, d), of any norm but zero, off gimbal lock.

    In a - c, b + d, a + c and d - b the cosine of pitch, squared, is a product of two sums of
    squares, and no digits are lost near the lock. At the lock one of the two sums vanishes:
    upwards that of the first pair, downwards that of the second.
    """
    one, two, three, four = FACTORS
    back = {a: (three + one) / 2, c: (three - one) / 2, b: (two - four) / 2, d: (two + four) / 2}
    matrix = matrix_from_quaternion().xreplace(back).applyfunc(expand)
    forward = dict(zip(FACTORS, (a - c, b + d, a + c, d - b), strict=True))
    roll, pitch, yaw = euler_from_matrix(ImmutableMatrix(matrix)).xreplace(forward)
    # In the factors the sine of pitch would be a difference of squares.
    sine = factor(pitch_sine(matrix_from_quaternion()))
    return ImmutableMatrix([roll, atan2(sine, pitch.args[1]), yaw])


@cache
def axis_angle_from_quaternion() -> tuple[ImmutableMatrix, Expr]:
    """Find unit axis and angle of the turn of (a, b, c, d), which has any norm but zero."""
    vector = vector_part(ATTITUDE)
    length = sqrt(vector.dot(vector))
    return ImmutableMatrix(vector / length), 2 * atan2(length, a)


@cache
def inclination() -> Expr:
    """Angle between the body's z-axis and the vertical, by the tangent of its half.

    Its cosine is the last element of the matrix. As a sine or cosine the angle would be lost where
    it is small; `tan² = (1 - cos) / (1 + cos)` of the half keeps it.
    """
    cosine = matrix_from_quaternion()[2, 2]
    norm = norm_squared(ATTITUDE)
    return 2 * atan2(sqrt(expand((norm - cosine) / 2)), sqrt(expand((norm + cosine) / 2)))


@cache
def turn_of_one_step() -> ImmutableMatrix:
    """Quaternion of the turn that constant body rates p, q, r make in the time T, exactly."""
    rates = Matrix(BODY_RATES)
    half = sqrt(rates.dot(rates)) * T / 2
    # As in `from_axis_angle`, with sin(x) / x, which stays finite when the rates vanish.
    return ImmutableMatrix([cos(half), *(rates * T / 2 * sinc(half))])


@cache
def constant_rate_step() -> ImmutableMatrix:
    """Attitude after the time T at constant body rates: the turn is about axes of the body."""
    return multiply(ATTITUDE, turn_of_one_step())


@cache
def rates() -> ImmutableMatrix:
    """Differentiate (a, b, c, d) by time: half of q times the body rates as a quaternion.

    In a short time the body turns about its axis of rotation by rate times time, so q is
    multiplied from the right by a turn that starts at one.
    """
    body_rates = ImmutableMatrix(BODY_RATES)
    rate = sqrt(body_rates.dot(body_rates))
    turn = from_axis_angle(ImmutableMatrix(body_rates / rate), rate * T)
    return multiply(ATTITUDE, ImmutableMatrix(turn.diff(T).subs(T, 0)))


@cache
def pitches_without_rates() -> Set:
    """Pitch angles from -90° to 90° at which the derivative of the quaternion is not finite."""
    elements = dict(zip(QUATERNION, from_euler(), strict=True))
    pitches = Interval(-pi / 2, pi / 2)
    return Union(*(singularities(rate.subs(elements), theta, pitches) for rate in rates()))
