"""Velocity and position from an accelerometer, and what an error of attitude makes of them.

The inertial frame is north-east-down, and taken as one in which Newton's second law holds.
"""

from functools import cache

from sympy import (
    Abs,
    Dummy,
    Expr,
    Function,
    ImmutableMatrix,
    Integral,
    Symbol,
    expand,
    expand_trig,
    factor,
    integrate,
    sin,
    solve,
    sqrt,
    summation,
    symbols,
    trigsimp,
)

from chr_notes.derivations.estimation import weight
from chr_notes.derivations.euler import Z, frame_rotation, rotation
from chr_notes.derivations.sensors import specific_force
from chr_notes.symbols import ACCELEROMETER, Angle, T, g, m

# Acceleration of the body in the inertial frame, how fast it changes, velocity and position.
ACCELERATION = ImmutableMatrix(symbols("a_N a_E a_D", real=True))
JERK = ImmutableMatrix(symbols("j_N j_E j_D", real=True))
VELOCITY = ImmutableMatrix(symbols("v_N v_E v_D", real=True))
POSITION = ImmutableMatrix(symbols("r_N r_E r_D", real=True))

# Time, s; number of steps; constant acceleration along one axis, m/s².
t = Symbol("t", positive=True)
n = Symbol("n", integer=True, positive=True)
a = Symbol("a", real=True)
# Angle between the true and the estimated vertical, the azimuth in which it lies, error of yaw.
tilt_error, azimuth, yaw_error = (
    Angle(name, real=True) for name in ("epsilon", "beta", r"\delta\psi")
)

_inner, _outer = symbols("tau s", positive=True)
_count = Symbol("k", integer=True, nonnegative=True)
_COMPONENTS = tuple(Function(name) for name in ("a_N", "a_E", "a_D"))


@cache
def accelerometer_reading() -> ImmutableMatrix:
    """Read an accelerometer on a body that accelerates by `ACCELERATION`, in the body frame."""
    return specific_force(m * rotation("I", "B") * ACCELERATION, weight(), m)


@cache
def inertial_acceleration() -> ImmutableMatrix:
    """Acceleration in the inertial frame from the reading `ACCELEROMETER`: solve it for it.

    The reading, rotated to the inertial frame, is the acceleration less gravity.
    """
    return ImmutableMatrix(rotation("B", "I") * ImmutableMatrix(ACCELEROMETER) + g * Z)


def acceleration_then() -> ImmutableMatrix:
    """Any acceleration a(t)."""
    return ImmutableMatrix([along(t) for along in _COMPONENTS])


def velocity_gained() -> ImmutableMatrix:
    """Integral from 0 to t of any acceleration a(t)."""
    return ImmutableMatrix([Integral(along(_inner), (_inner, 0, t)) for along in _COMPONENTS])


def position_gained() -> ImmutableMatrix:
    """Integral from 0 to t of the velocity gained by any acceleration a(t)."""
    gained = (Integral(along(_inner), (_inner, 0, _outer)) for along in _COMPONENTS)
    return ImmutableMatrix([Integral(velocity, (_outer, 0, t)) for velocity in gained])


def velocity_after(gained: ImmutableMatrix) -> ImmutableMatrix:
    """Velocity at t: the one at the start, and what the acceleration has added since."""
    return ImmutableMatrix(VELOCITY + gained)


def position_after(gained: ImmutableMatrix) -> ImmutableMatrix:
    """Position at t: the one at the start, the way at the first velocity, and what was gained."""
    return ImmutableMatrix(POSITION + VELOCITY * t + gained)


@cache
def velocity_after_step() -> ImmutableMatrix:
    """Velocity one period T later, with an acceleration that changes at the constant rate JERK."""
    return ImmutableMatrix(VELOCITY + (ACCELERATION + JERK * _inner).integrate((_inner, 0, T)))


@cache
def position_after_step() -> ImmutableMatrix:
    """Position one period T later, with an acceleration that changes at the constant rate JERK."""
    gained = velocity_after_step().subs(T, _inner).integrate((_inner, 0, T))
    return ImmutableMatrix(POSITION + gained)


@cache
def velocity_by_steps() -> Expr:
    """Sum n steps `v[k+1] = v[k] + T a` from rest."""
    return summation(T * a, (_count, 0, n - 1))


@cache
def position_by_steps() -> Expr:
    """Sum n steps `r[k+1] = r[k] + T v[k]` from rest, with the velocity by its own steps."""
    velocity = velocity_by_steps().subs(n, _count)
    return factor(summation(T * velocity, (_count, 0, n - 1)))


@cache
def constant_acceleration(time: Expr = t) -> tuple[Expr, Expr]:
    """Velocity and position after a time at the constant acceleration a, from rest at 0."""
    velocity = integrate(a, (_inner, 0, _outer))
    return velocity.subs(_outer, time), integrate(velocity, (_outer, 0, time))


def _error_of_attitude() -> ImmutableMatrix:
    """Turn an attitude into a wrong one: about z, about y, about z again, as any two differ."""
    return ImmutableMatrix(
        frame_rotation(2, -azimuth)
        * frame_rotation(1, tilt_error)
        * frame_rotation(2, azimuth - yaw_error)
    )


def error_of_acceleration() -> ImmutableMatrix:
    """Error of the acceleration in the inertial frame when the estimated attitude is wrong.

    What the accelerometer reads is the acceleration less gravity; the error of attitude turns
    both.
    """
    reading = ACCELERATION - g * Z
    return ImmutableMatrix(_error_of_attitude() * reading - reading)


@cache
def residual_acceleration() -> ImmutableMatrix:
    """Acceleration that a body at rest seems to have when its estimated attitude is wrong.

    The reading at rest is minus gravity; brought to the estimated inertial frame, it does not
    quite cancel the gravity that is added there.

    Returns
    -------
    ImmutableMatrix
        3 by 1 in the estimated inertial frame, m/s².
    """
    return ImmutableMatrix(_error_of_attitude() * (-g * Z) + g * Z)


@cache
def residual_magnitude() -> Expr:
    """Magnitude of the residual acceleration, for tilt errors from 0 to pi."""
    squared = trigsimp(expand(residual_acceleration().dot(residual_acceleration())))
    half = Dummy("h", positive=True)
    # 1 - cos(2 h) = 2 sin(h)², and sin(h) is not negative
    root = sqrt(trigsimp(expand_trig(squared.subs(tilt_error, 2 * half))))
    return root.subs(Abs(sin(half)), sin(half)).subs(half, tilt_error / 2)


def drift() -> ImmutableMatrix:
    """Errors of acceleration, velocity and position along the ground, from a tilt error.

    The residual acceleration is constant as long as the attitude and its error are. Its part
    along the ground is `g sin(tilt_error)`; the vertical part `g (1 - cos(tilt_error))` is left
    out, being of second order.
    """
    acceleration = residual_acceleration().subs({azimuth: 0, yaw_error: 0})[0]
    return ImmutableMatrix(
        [acceleration, *(part.subs(a, acceleration) for part in constant_acceleration())]
    )


def position_at_last_velocity() -> Expr:
    """Error of position from a tilt error, had its last error of velocity been there all along.

    That is twice the position of `drift`, in which the velocity grows from zero.
    """
    return drift()[1] * t


# Constant errors: bias of the accelerometer, bias of the gyro, relative error of the sensitivity of
# the accelerometer; the acceleration along the ground that it is an error of.
accel_bias, gyro_bias, scale_error = symbols("b_a b_g k", real=True)
moving = Symbol("a_m", real=True)
# Spectral densities of white noise of the accelerometer and of the gyro.
accel_noise, gyro_noise = symbols("n_a n_g", positive=True)


@cache
def position_errors() -> ImmutableMatrix:
    """Errors of position after a time t, from each constant error alone, along the ground.

    A tilt error, a bias and a wrong sensitivity each make a constant error of acceleration. A gyro
    bias makes a tilt error that grows with time, taken as small.

    Returns
    -------
    ImmutableMatrix
        From the tilt error, the accelerometer's bias, the gyro's bias, and the motion.
    """
    tilt, bias, motion = (
        constant_acceleration()[1].subs(a, error)
        for error in (drift()[0], accel_bias, scale_error * moving)
    )
    growing = drift()[0].diff(tilt_error).subs(tilt_error, 0) * gyro_bias * _inner
    velocity = integrate(growing, (_inner, 0, _outer))
    return ImmutableMatrix([tilt, bias, integrate(velocity, (_outer, 0, t)), motion])


def acceleration_error_between_rests() -> Expr:
    """Constant error of acceleration that explains a velocity `v_N` where there was rest.

    The body rested a time t before too, and without the error its velocity would be zero now.
    """
    error = Dummy("error")
    left_over = VELOCITY[0] - constant_acceleration()[0].subs(a, error)
    return solve(left_over, error)[0]
