"""The symbols that every layer shares, so that one letter means one thing everywhere."""

from sympy import Symbol, symbols


class Angle(Symbol):
    """An angle, radians. Equations between angles hold up to whole turns."""


class AngularRate(Symbol):
    """An angular rate, rad/s."""


# Euler angles, radians: roll about the vehicle-2 x-axis, pitch about the vehicle-1 y-axis,
# yaw about the inertial z-axis.
phi, theta, psi = symbols("phi theta psi", real=True, cls=Angle)
roll_rate, pitch_rate, yaw_rate = (
    AngularRate(f"{name}dot", real=True) for name in ("phi", "theta", "psi")
)

# Body rates, rad/s, about the body x, y and z axes.
p, q, r = symbols("p q r", real=True, cls=AngularRate)

# Magnitude of gravity, m/s², and mass of the body, kg.
g, m = symbols("g m", positive=True)

# Readings of an accelerometer (m/s²) and of a magnetometer (any unit) along the body axes.
ACCELEROMETER = symbols("a_x a_y a_z", real=True)
MAGNETOMETER = symbols("m_x m_y m_z", real=True)

# Sample period, s.
T = Symbol("T", positive=True)

# Elements of the attitude quaternion, scalar first, and of two quaternions in a product.
a, b, c, d = symbols("a b c d", real=True)
FIRST = symbols("a_1 b_1 c_1 d_1", real=True)
SECOND = symbols("a_2 b_2 c_2 d_2", real=True)

# Unit vector along the axis of a turn, the angle of the turn, and a vector that is turned.
AXIS = symbols("v_x v_y v_z", real=True)
alpha = Angle("alpha", real=True)
VECTOR = symbols("x y z", real=True)

EULER = (phi, theta, psi)
EULER_RATES = (roll_rate, pitch_rate, yaw_rate)
BODY_RATES = (p, q, r)
QUATERNION = (a, b, c, d)
