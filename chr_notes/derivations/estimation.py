"""Roll and pitch from an accelerometer, from gyros, and from both with a fixed gain.

The error of an estimate is the estimate less the truth. Conventions are those of
`chr_notes.conventions`.
"""

from functools import cache

from sympy import (
    Dummy,
    Expr,
    Function,
    I,
    ImmutableMatrix,
    Rational,
    S,
    Symbol,
    atan2,
    cancel,
    collect,
    conjugate,
    cos,
    expand,
    factor,
    floor,
    integrate,
    pi,
    rsolve,
    simplify,
    sin,
    solve,
    sqrt,
    tan,
)

from chr_notes.derivations.euler import Z, rotation
from chr_notes.derivations.sensors import specific_force
from chr_notes.symbols import ACCELEROMETER, Angle, AngularRate, T, g, m, phi, psi, theta

# Gain of the observer; number of steps; error at the start.
L = Symbol("L", real=True)
n = Symbol("n", integer=True, positive=True)
start_error = Angle("e_0", real=True)
# Constant bias of the gyro; standard deviations of its noise and of the accelerometer's angle.
bias = AngularRate("b", positive=True)
gyro_noise = AngularRate(r"\sigma_{\text{gyro}}", positive=True)
accel_noise = Angle(r"\sigma_{\text{accel}}", positive=True)
# Angular frequency of a vibration, rad/s.
omega = Symbol("omega", real=True)

# An angle and its rate before the step, the predicted and the measured angle after it.
angle, predicted, measured = (
    Angle(f"{name}", real=True) for name in (r"\alpha", r"\alpha^{+}", r"\alpha_{\text{accel}}")
)
rate = AngularRate(r"\dot{\alpha}", real=True)


@cache
def weight() -> ImmutableMatrix:
    """Gravity's force on a body of mass m: down in the inertial frame, brought to the body."""
    return ImmutableMatrix(rotation("I", "B") * (m * g * Z))


@cache
def accelerometer_at_rest() -> ImmutableMatrix:
    """Read an accelerometer at rest, m/s²: there is no net force, for its support holds it up."""
    return specific_force(ImmutableMatrix.zeros(3, 1), weight(), m)


@cache
def tilt() -> ImmutableMatrix:
    """Roll in (-pi, pi] and pitch in [-pi/2, pi/2] of an accelerometer at rest, from its reading.

    At rest the reading is `k (sin(pitch), -cos(pitch) sin(roll), -cos(pitch) cos(roll))` with
    some k > 0, and the cosine of pitch is not negative. So -y and -z are sine and cosine of roll
    with one common factor, and x and the length of (y, z) are sine and cosine of pitch with
    another. Factors do not matter to an angle: the reading's scale drops out.
    """
    x, y, z = ACCELEROMETER
    return ImmutableMatrix([atan2(-y, -z), atan2(x, sqrt(y**2 + z**2))])


def roll_in_level_turn(bank: Expr, time: Expr = S.Zero) -> Expr:
    """Roll that an accelerometer shows in a level turn, flown such that nothing slides sideways.

    The heading goes round at an even rate and the velocity with it. The turn is such that it takes
    an acceleration `g tan(bank)` towards its centre, to the right.
    """
    turning, at = Symbol("omega", positive=True), Symbol("t", real=True)
    speed = g * tan(bank) / turning
    velocity = speed * ImmutableMatrix([cos(turning * at), sin(turning * at), 0])
    reading = rotation("I", "B").subs({phi: bank, theta: 0, psi: turning * at}) * (
        velocity.diff(at) - g * Z
    )
    there = (simplify(part).subs(at, time) for part in reading)
    return tilt()[0].subs(dict(zip(ACCELEROMETER, there, strict=True)))


def euler_step(before: Expr = angle, slope: Expr = rate) -> Expr:
    """Euler integration: the angle after one period T through which its rate is held."""
    time = Dummy("t")
    return before + integrate(slope, (time, 0, T))


def update(prediction: Expr = predicted, measurement: Expr = measured) -> Expr:
    """Angle that fits prediction and measurement best, by squares weighted 1 - L and L."""
    return _best_fit().subs({predicted: prediction, measured: measurement}, simultaneous=True)


@cache
def _best_fit() -> Expr:
    best = Dummy("x")
    misfit = (1 - L) * (best - predicted) ** 2 + L * (best - measured) ** 2
    return collect(expand(solve(misfit.diff(best), best)[0]), L)


def shortest_turn(turn: Expr) -> Expr:
    """Turn less whole turns, into [-pi, pi): the way round that is shorter."""
    return turn - 2 * pi * floor(turn / (2 * pi) + Rational(1, 2))


def update_on_circle(prediction: Expr = predicted, measurement: Expr = measured) -> Expr:
    """`update` for an angle that goes all the way round: counted from the prediction."""
    return prediction + update(Rational(0), shortest_turn(measurement - prediction))


@cache
def error_step() -> tuple[Expr, dict[str, Symbol]]:
    """Error after one step of the observer, from the error before it.

    The truth moves on with its rate. The gyro reads the rate and an error, the accelerometer
    gives the new angle and an error.

    Returns
    -------
    Expr
        The new error, linear in the three below.
    dict
        Symbols of the error `before`, of the `gyro` and of the `accel`.
    """
    errors = {name: Dummy(name) for name in ("before", "gyro", "accel")}
    truth = euler_step()
    prediction = euler_step(angle + errors["before"], rate + errors["gyro"])
    new = update(prediction, truth + errors["accel"]) - truth
    return expand(simplify(new)), errors


@cache
def error_after() -> Expr:
    """Error after n steps with a constant gyro bias and an exact accelerometer, solved."""
    error = Function("e")
    new, errors = error_step()
    step = new.subs({errors["gyro"]: bias, errors["accel"]: 0, errors["before"]: error(n)})
    return rsolve(error(n + 1) - step, error(n), {error(0): start_error})


@cache
def error_growth() -> Expr:
    """Change of `error_after` in the step after the n-th, written without a division by L."""
    error, power = error_after(), Dummy("power")
    growth = expand(error.subs(n, n + 1) - error).subs((1 - L) ** n, power)
    return factor(growth).subs(power, (1 - L) ** n)


@cache
def gyro_error_after() -> Expr:
    """Error after n steps of a gyro alone (L = 0) with a constant bias: it grows for ever."""
    error = Function("e")
    step = euler_step(error(n), bias)
    return expand(rsolve(error(n + 1) - step, error(n), {error(0): start_error}))


def steady_bias_error(gain: Expr = L) -> Expr:
    """Error at which the observer with a constant gyro bias comes to rest."""
    new, errors = error_step()
    before = errors["before"]
    step = new.subs({errors["gyro"]: bias, errors["accel"]: 0})
    return _by_what_is_kept(solve(step - before, before)[0]).subs(L, gain)


def _variance_step(variance: Expr) -> Expr:
    """Variance of the error after one step: independent errors add up by their squares."""
    new, errors = error_step()
    variances = {"before": variance, "gyro": gyro_noise**2, "accel": accel_noise**2}
    return sum(new.coeff(errors[name]) ** 2 * variances[name] for name in errors)


@cache
def gyro_variance_after() -> Expr:
    """Variance of the error after n steps of a gyro alone, whose noise is independent."""
    variance = Function("V")
    step = _variance_step(variance(n)).subs(L, 0)
    return rsolve(variance(n + 1) - step, variance(n), {variance(0): 0})


@cache
def _steady_variance() -> Expr:
    variance = Dummy("V")
    return solve(_variance_step(variance) - variance, variance)[0]


def steady_variance(gain: Expr = L) -> Expr:
    """Variance of the observer's error once it has settled: white noise on both sensors."""
    return _steady_variance().subs(L, gain)


def gyro_share(gain: Expr = L) -> Expr:
    """Part of the steady variance that gyro noise of one (rad/s)² leaves."""
    return _share(gyro_noise, gain)


def accel_share(gain: Expr = L) -> Expr:
    """Part of the steady variance that accelerometer noise of one rad² leaves."""
    return _share(accel_noise, gain)


def _share(source: Symbol, gain: Expr) -> Expr:
    other = {gyro_noise, accel_noise} - {source}
    only = steady_variance().subs(dict.fromkeys(other, 0))
    return _by_what_is_kept(only / source**2).subs(L, gain)


def _by_what_is_kept(expression: Expr) -> Expr:
    """Write with 1 - L, the part of the prediction that is kept, not with L - 1."""
    kept = Dummy("kept")
    return factor(expression.subs(L, 1 - kept)).subs(kept, 1 - L)


def vibration_share(gain: Expr = L) -> Expr:
    """Power of a vibration of angular frequency omega in the estimate, per power measured.

    A vibration `z^n` in the accelerometer's angle, with `z = exp(i omega T)`, comes out as
    `h z^n`: the error before the step is h, the accelerometer's one step later z, the new error
    h z.
    """
    new, errors = error_step()
    z, h = Dummy("z"), Dummy("h")
    step = new.subs({errors["before"]: h, errors["gyro"]: 0, errors["accel"]: z})
    response = cancel(solve(step - h * z, h)[0])
    above, below = (
        part.subs(z, cos(omega * T) + I * sin(omega * T)) for part in response.as_numer_denom()
    )
    return (_power(above) / _power(below)).subs(L, gain)


def _power(amplitude: Expr) -> Expr:
    """Squared magnitude of a complex amplitude."""
    power = expand(amplitude * conjugate(amplitude))
    return expand(power.subs(sin(omega * T) ** 2, 1 - cos(omega * T) ** 2))


@cache
def best_gain() -> Expr:
    """Gain between 0 and 1 with the least steady variance."""
    return _between_0_and_1(solve(steady_variance().diff(L), L))


@cache
def kalman_gain() -> Expr:
    """Steady gain of the Kalman filter for one angle, driven by gyro noise.

    The variance grows by that of one gyro step, and the measurement, weighted by the inverse
    variances, brings it back to where it was.
    """
    before = Dummy("P", positive=True)
    predicted_variance = before + (T * gyro_noise) ** 2
    gain = predicted_variance / (predicted_variance + accel_noise**2)
    settled = solve((1 - gain) * predicted_variance - before, before)[0]
    return simplify(gain.subs(before, settled))


def _between_0_and_1(roots: list[Expr]) -> Expr:
    values = dict.fromkeys((gyro_noise, accel_noise, T), 1)
    return next(root for root in roots if 0 < root.subs(values) < 1)
