"""Forms of one step of the averaging filter, with all that a sample may bring.

The state is kept in the frame that is levelled after each sample: there the mean of the specific
force points up, so that its length is enough. A mean over all that was heard begins; once it is as
long as the time constant, the low-pass goes on from there.

What was not seen shortens the mean: its bound becomes that of a mean that is as much shorter, see
`derivations.averaging.averaged_after`. A step longer than `LONGEST` is a gap: nobody knows how the
body turned in it, and its sample counts for no more than `LONGEST`. The low-pass forgets such a
turn by and by: what the bound is above that of the time constant decays as its weights do.

A body in free fall reads next to nothing. A low-pass that hears it forgets gravity, and overshoots
to its opposite. So while the mean is known, a force that is weak beside it is not heard.
"""

from functools import cache

from sympy import (
    Abs,
    And,
    Expr,
    ImmutableMatrix,
    Integer,
    Or,
    Rational,
    Symbol,
    exp,
    pi,
    simplify,
    sqrt,
    symbols,
)

from chr_notes.derivations import averaging, further, hamilton, quaternions
from chr_notes.derivations.computation import NOTHING, Choice, Computation, Let, otherwise
from chr_notes.derivations.forms import filters
from chr_notes.derivations.forms.gains import TIME_CONSTANT
from chr_notes.symbols import ACCELEROMETER, QUATERNION, VECTOR, T, g

Steps = tuple[Let | Choice, ...]
Names = tuple[Symbol, ...]

LENGTH = Symbol("mean_length", real=True)
SLOPES = symbols("slope_n slope_e slope_d", real=True)
AVERAGED, SETTLED = symbols("averaged settled", real=True)
STATE = (*QUATERNION, LENGTH, *SLOPES, AVERAGED, SETTLED)
LONGEST = Symbol("longest_step", real=True)

SLOW = {averaging.speed: Integer(1), g: Rational(980665, 100000)}
"""A body about its place: its speed stays below 1 m/s."""
UNSEEN_RATE = Integer(1)
"""At which a body may turn while no gyro tells, rad/s."""
UNSEEN_BIAS = Rational(1, 200)
"""That a gyro may have while no accelerometer tells, rad/s."""
MOST = Integer(50)
"""Times the mean, the three axes together count as no more: a sensor of ±16 g reads 48 g, and a
glitch reads anything."""
WEAK = Integer(4)
"""Times the three axes together have to read to be as much as the mean: in free fall a sensor of
±16 g reads less than this part of it, its own bias."""
RUN_IN = Rational(99, 100)
"""Of the time constant, which is all of it for a low-pass."""
WILD_FORCE = Integer(10**12)
"""No accelerometer reads as much, nor as little as its inverse, in any unit."""

COUNTED, HEARD, KNOWN = symbols("step_counted force_heard rates_known", real=True)
LOW, LEFT, LENGTH_OF_MEAN = symbols("low_pass averaged_left length_of_mean", real=True)
DECAY = Symbol("decay", real=True)
ZERO, ONE = Integer(0), Integer(1)


def turned(turn: Names, vector: Names) -> ImmutableMatrix:
    """Turn a vector by a unit quaternion."""
    values = dict(zip((*QUATERNION, *VECTOR), (*turn, *vector), strict=True))
    return ImmutableMatrix(quaternions.rotate_to_inertial().xreplace(values))


def share_of_mean(share: Symbol, step: Expr, length: Expr) -> Choice:
    """Weight of a sample in the mean over a time that it is the end of."""
    return Choice((share,), ((length > 0, (step / length,)), otherwise(ONE)))


def shortened(left: Symbol, length: Symbol, turn: Expr) -> Let:
    """Leave of a mean what is as good as all of it and a turn that was not seen."""
    after = averaging.averaged_after(turn).subs(SLOW)
    return Let(left, after.xreplace({averaging.t: length}))


def _predicted() -> tuple[Steps, Names]:
    """Turn by the gyros, where they tell."""
    seen = Symbol("step_seen", real=True)
    turn = filters.gyro_turn().of({T: seen})
    names = symbols("predicted_a predicted_b predicted_c predicted_d", real=True)
    steps: Steps = (
        Choice((seen, COUNTED), ((T <= LONGEST, (T, T)), otherwise(ZERO, LONGEST))),
        *turn.steps,
        Let(KNOWN, And(T <= LONGEST, filters.MOVES)),
        *map(Let, names, turn.results),
    )
    return steps, names


def _forces(attitude: Names) -> tuple[Steps, Names]:
    """Bring the specific force into the frame."""
    size, most, scale = symbols("force_size largest_size force_scale", real=True)
    reading = symbols("reading_x reading_y reading_z", real=True)
    found = symbols("force_n force_e force_d", real=True)
    scaled = tuple(scale * each for each in ACCELEROMETER)
    told = Or(WEAK * size >= LENGTH, 2 * AVERAGED < TIME_CONSTANT)
    steps: Steps = (
        Let(size, sum(map(Abs, ACCELEROMETER))),
        Let(HEARD, And(size > 1 / WILD_FORCE, size < WILD_FORCE, told)),
        Let(most, MOST * LENGTH),
        Choice((scale,), ((And(LENGTH > 0, size > most), (most / size,)), otherwise(ONE))),
        Choice(reading, ((HEARD, scaled), otherwise(ZERO, ZERO, ZERO))),
        *map(Let, found, turned(attitude, reading)),
    )
    return steps, found


def _lengths() -> Steps:
    """For how long has been averaged, before and after the sample; and which way to average."""
    unseen = Symbol("turn_unseen", real=True)
    branches = (
        (And(HEARD, KNOWN), (ZERO,)),
        (KNOWN, (UNSEEN_BIAS * T,)),
        otherwise(UNSEEN_RATE * T),
    )
    # Once it has run in, half of that is enough to go on.
    goes_on = And(SETTLED > 0, 2 * LEFT >= TIME_CONSTANT)
    return (
        Choice((unseen,), branches),
        shortened(LEFT, AVERAGED, unseen),
        Let(LENGTH_OF_MEAN, LEFT + COUNTED),
        Choice((LOW,), ((goes_on, (ONE,)), otherwise(ZERO))),
    )


def _taken_in(forces: Names) -> tuple[Steps, Names, Names]:
    """Take the force into the mean, each axis by itself, by the low-pass or as a share."""
    ratio, share = symbols("periods share", real=True)
    nearer, by_slope, bent, steeper = factors = symbols("nearer by_slope bent steeper", real=True)
    mean, slope = averaging.low_pass_step().subs(T, averaging.tau * ratio).subs(exp(-ratio), DECAY)
    # The step is linear in the state and in how far the force is off.
    low_pass = (
        mean.diff(averaging.force),
        mean.diff(averaging.slope),
        slope.diff(averaging.slope),
        slope.diff(averaging.force),
    )
    branches = (
        (And(HEARD, LOW > 0), low_pass),
        (HEARD, (share, ZERO, ZERO, ZERO)),
        otherwise(ZERO, ZERO, LOW, ZERO),
    )
    off = symbols("off_n off_e off_d", real=True)
    means = symbols("mean_n mean_e mean_d", real=True)
    slopes = symbols("slope_after_n slope_after_e slope_after_d", real=True)
    before = (ZERO, ZERO, -LENGTH)
    steps: Steps = (
        Choice((ratio,), ((TIME_CONSTANT > 0, (COUNTED / TIME_CONSTANT,)), otherwise(NOTHING))),
        Let(DECAY, exp(-ratio)),
        share_of_mean(share, COUNTED, LENGTH_OF_MEAN),
        Choice(factors, branches),
        *(Let(o, f - b) for o, f, b in zip(off, forces, before, strict=True)),
        *(
            Let(m, b + nearer * o + by_slope * s)
            for m, b, o, s in zip(means, before, off, SLOPES, strict=True)
        ),
        *(Let(n, bent * s + steeper * o) for n, s, o in zip(slopes, SLOPES, off, strict=True)),
    )
    return steps, means, slopes


def _levelled(attitude: Names, means: Names, slopes: Names) -> tuple[Steps, ImmutableMatrix]:
    """Turn everything such that the mean points up."""
    after = Symbol("mean_length_after", real=True)
    towards = further.level_turn().xreplace(dict(zip(further.UPWARD, means, strict=True)))
    upright, east, north, _ = towards
    length = sqrt(ImmutableMatrix(means).dot(ImmutableMatrix(means)))
    size, parts = Symbol("level_size", real=True), symbols("level_a level_b level_c", real=True)
    stand = Symbol("upright", real=True)
    turn = tuple(part / size for part in (stand, east, north))
    steps: Steps = (
        Let(after, length),
        Let(stand, upright.subs(length, after)),
        Let(size, sqrt(stand**2 + east**2 + north**2)),
        # Upside down, one way is as short as another.
        Choice(
            parts, ((size > 0, turn), (after > 0, (ZERO, ONE, ZERO)), otherwise(ONE, ZERO, ZERO))
        ),
    )
    level = (*parts, ZERO)
    q = hamilton.multiply(ImmutableMatrix(level), ImmutableMatrix(attitude))
    return steps, ImmutableMatrix([*q, after, *turned(level, slopes)])


@cache
def turn() -> Computation:
    """Give the state after a sample: attitude, mean and slopes, time averaged, whether run in."""
    predicted, attitude = _predicted()
    forces, force = _forces(attitude)
    taken, means, slopes = _taken_in(force)
    levelled, state = _levelled(attitude, means, slopes)
    averaged, settled = symbols("averaged_after settled_after", real=True)
    by_low_pass = Symbol("length_of_low_pass", real=True)
    # So much more than that of the time constant is the bound of a shorter mean, and it decays.
    more = (1 / LEFT - 1 / TIME_CONSTANT) * DECAY
    shorter = simplify(1 / (1 / TIME_CONSTANT + more))
    branches = (
        (And(HEARD, LOW > 0, by_low_pass < RUN_IN * TIME_CONSTANT), (by_low_pass, ONE)),
        (And(HEARD, Or(LOW > 0, LENGTH_OF_MEAN >= TIME_CONSTANT)), (TIME_CONSTANT, ONE)),
        (HEARD, (LENGTH_OF_MEAN, ZERO)),
        otherwise(LEFT, LOW),
    )
    return Computation(
        (
            *predicted,
            *forces,
            *_lengths(),
            *taken,
            *levelled,
            Choice((by_low_pass,), ((LEFT > 0, (shorter,)), otherwise(ZERO))),
            Choice((averaged, settled), branches),
            filters.is_usual(And(HEARD, KNOWN)),
        ),
        ImmutableMatrix([*state, averaged, settled]),
        valid=filters.USUAL,
    )


@cache
def bound() -> Computation:
    """Bound of the error of up: of a body of bounded speed, and gyros whose bias is bounded.

    Past what an angle can be off there is nothing to say.
    """
    told, found = symbols("bound_told bound", real=True)
    run_in = averaging.motion_error() + averaging.bias_error()
    # A mean that was shortened is as old as it was, so a bias turns it by as much.
    begun = averaging.mean_motion_error() + averaging.bias_error()
    real = {averaging.tau: TIME_CONSTANT, averaging.t: AVERAGED, g: SLOW[g]}
    branches = (
        (AVERAGED <= 0, (pi,)),
        (AVERAGED < TIME_CONSTANT, (begun.xreplace(real),)),
        (TIME_CONSTANT > 0, (run_in.xreplace(real),)),
        otherwise(NOTHING),
    )
    return Computation(
        (Choice((told,), branches), Choice((found,), ((told > pi, (pi,)), otherwise(told)))), found
    )
