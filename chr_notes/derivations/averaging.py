"""Up as a mean of the specific force in a frame that does not turn, and gains as time constants.

The idea is that of D. Laidig and T. Seel, VQF: Highly accurate IMU orientation estimation with
bias estimation and magnetic disturbance rejection, Information Fusion 91 (2023), 187-204. Gyros
alone bring the specific force into a frame that does not turn. There gravity stands still, and
the mean of a true acceleration goes to nothing. What is left of it is up, which levels the
attitude.

`tau` is the mean age of what is averaged. Conventions are those of `chr_notes.conventions`.
"""

from functools import cache

from sympy import (
    Dummy,
    Expr,
    Function,
    I,
    ImmutableMatrix,
    Integer,
    Symbol,
    collect,
    cos,
    diff,
    exp,
    expand,
    factor,
    integrate,
    oo,
    pi,
    simplify,
    sin,
    solve,
    symbols,
)

from chr_notes.derivations import estimation
from chr_notes.symbols import T, g

tau = Symbol("tau", positive=True)
t = Symbol("t", positive=True)
# The Laplace variable; what goes into a filter.
s = Symbol("s")
force = Symbol("f", real=True)
# Output of the low-pass, and its derivative times the time constant.
mean, slope = symbols("mean slope", real=True)
# A speed that the body stays below, m/s.
speed = Symbol("V", positive=True)


@cache
def mean_acceleration() -> Expr:
    """Mean of a true acceleration over a time t: velocity gained, divided by the time.

    A body that stays about its place has a bounded velocity, so that this goes to nothing.
    """
    velocity, time = Function("v"), Dummy("t", positive=True)
    return integrate(velocity(time).diff(time), (time, 0, t)) / t


@cache
def low_pass() -> Expr:
    """Transfer function of the flattest low-pass of second order, Butterworth's, of mean age `tau`.

    Of `1/(1 + a s + b s²)` the mean age, minus the slope at s = 0, is a. The squared magnitude of
    the divisor at `s = i omega` is `1 + (a² - 2 b) omega² + b² omega⁴`; the flattest has no term
    in omega².
    """
    a, b = symbols("a b", positive=True)
    trial = 1 / (1 + a * s + b * s**2)
    age = -trial.diff(s).subs(s, 0)
    below = 1 / trial.subs(s, I * estimation.omega)
    power = expand(below * below.subs(I, -I))
    flattest = solve(power.coeff(estimation.omega, 2), b)[0]
    return trial.subs(b, flattest).subs(a, solve(age - tau, a)[0])


@cache
def corner() -> Expr:
    """Angular frequency at which half the power of `low_pass` is left, rad/s."""
    frequency = Symbol("omega_c", positive=True)
    return next(iter(solve(power_left(frequency) - Integer(1) / 2, frequency)))


def power_left(frequency: Expr = estimation.omega) -> Expr:
    """Power of a vibration of an angular frequency that `low_pass` leaves, per power put in."""
    response = low_pass().subs(s, I * frequency)
    return factor(expand(1 / expand(1 / (response * response.subs(I, -I)))))


@cache
def low_pass_step() -> ImmutableMatrix:
    """`mean` and `slope` after a period T through which the input stays as it is, exactly.

    What is `mean - force` before decays by the equation of the low-pass without input: its
    solutions are `exp(-t/tau)` times sine and cosine of t/tau, and the two that begin as the
    state does are told by their values and slopes at t = 0. Periods may differ: each step is
    exact.
    """
    first, second = symbols("c_1 c_2")
    gap = exp(-t / tau) * (first * cos(t / tau) + second * sin(t / tau))
    start = (gap.subs(t, 0) - (mean - force), tau * gap.diff(t).subs(t, 0) - slope)
    begun = solve(start, (first, second))
    changing = collect(expand(tau * gap.diff(t) * exp(t / tau)), (sin(t / tau), cos(t / tau)))
    after = (force + gap.subs(begun), changing.subs(begun) * exp(-t / tau))
    return ImmutableMatrix([value.subs(t, T) for value in after])


@cache
def impulse_response() -> Expr:
    """Weight that `low_pass` gives to what came in a time t ago: the slope of its step response."""
    start = {mean: 0, slope: 0, force: 1}
    return simplify((low_pass_step()[1] / tau).subs(start).subs(T, t))


def lag(response: Expr) -> Expr:
    """Mean age of what a filter gives out, by the weights that it gives to each age."""
    return simplify(integrate(t * response, (t, 0, oo)))


def bias_error(bias: Expr = estimation.bias) -> Expr:
    """Error of up for a gyro with a constant small bias: gravity turns by it in the frame.

    What turns evenly comes out as it was the mean age ago.
    """
    return bias * lag(impulse_response())


@cache
def noise_share() -> Expr:
    """Variance of the output for white noise of variance 1 in samples T apart, T small to tau."""
    return simplify(T * integrate(impulse_response() ** 2, (t, 0, oo)))


@cache
def motion_error() -> Expr:
    """Bound of the error of up, in radians, for a body whose speed stays below `speed`.

    By parts, the weights on an acceleration are their slopes on its velocity, so that the output
    is at most the speed times the way that the weights go up and down. They rise to a first
    extreme at t = tau pi/4 and have others of falling size every tau pi after it.
    """
    response = impulse_response()
    first = abs(response.subs(t, tau * pi / 4))
    ratio = abs(simplify(response.subs(t, tau * pi * 5 / 4) / response.subs(t, tau * pi / 4)))
    return speed * simplify(2 * first / (1 - ratio)) / g


@cache
def mean_motion_error() -> Expr:
    """Bound of the error of up after a plain mean over t: the velocity changes by 2 V at most."""
    velocities = list(mean_acceleration().atoms(Function))
    signs = {each: speed * (1 if each.args[0] == t else -1) for each in velocities}
    return mean_acceleration().subs(signs) / g


def averaged_after(turn: Expr) -> Expr:
    """Length of a mean that has the error of one over t and of a turn that was not seen."""
    length = Symbol("length", positive=True)
    worse = mean_motion_error() + turn
    return simplify(solve(mean_motion_error().subs(t, length) - worse, length)[0])


@cache
def best_time_constant() -> Expr:
    """Time constant with the least squared error of a constant bias and white noise."""
    error = bias_error() ** 2 + estimation.accel_noise**2 * noise_share()
    return next(root for root in solve(diff(error, tau), tau) if root.is_positive)


@cache
def relaxation() -> Expr:
    """Part of a gap that is left after T when a first-order low-pass closes it."""
    gap, time = Function("gap"), Dummy("t", positive=True)
    decay = solve(tau * gap(time).diff(time) + gap(time), gap(time).diff(time))[0] / gap(time)
    return exp(integrate(decay, (time, 0, T)))


@cache
def gain_from_time_constant() -> Expr:
    """Gain of `estimation.update` with the same effect, at a period T, as a time constant."""
    return 1 - relaxation()


@cache
def time_constant_from_gain() -> Expr:
    """Solve `gain_from_time_constant` for the time constant."""
    return solve(gain_from_time_constant() - estimation.L, tau)[0]
