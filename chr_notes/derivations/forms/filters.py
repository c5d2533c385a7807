"""Forms of one step of each filter, with all that a sample may bring.

A sample with NaN, infinity or a rate that no gyro reads is held out: the estimate stays as if the
body had not turned. A reading of the accelerometer without a direction is not heard.
"""

from functools import cache

from sympy import Abs, And, Expr, Ge, ImmutableMatrix, Symbol, atan2, cos, pi, sqrt, symbols
from sympy.core.relational import Relational

from chr_notes.derivations import estimation, further, hamilton, quaternions
from chr_notes.derivations.computation import (
    LARGEST,
    Choice,
    Computation,
    Let,
    map_step,
    otherwise,
    step_names,
)
from chr_notes.derivations.forms import estimation as forms
from chr_notes.derivations.forms import monitor
from chr_notes.derivations.forms import quaternions as quaternion_forms
from chr_notes.derivations.forms.euler import euler_rates
from chr_notes.symbols import ACCELEROMETER, BODY_RATES, EULER, QUATERNION, VECTOR, Angle, T

WILD_RATE = 10**12
"""No gyro reads as much, rad/s: such rates come from damaged logs, and leave angles no digits."""
RATES = symbols("rate_x rate_y rate_z", real=True)
SPEED, WHOLE, TURN = symbols("speed_squared whole_turn_squared turn_squared", real=True)
MOVES, USUAL = symbols("moves usual", real=True)
PREDICTED = symbols("predicted_a predicted_b predicted_c predicted_d", real=True)
# In units in which no square overflows or vanishes.
READING = symbols("reading_x reading_y reading_z", real=True)
# What the squared sine and cosine of the angle between expected and taken reading are shares of:
# their sum, by Lagrange's identity, and known before either is.
SIDES = sum(name**2 for name in PREDICTED) ** 2 * sum(name**2 for name in READING)
SPEED_SQUARED = sum(rate**2 for rate in BODY_RATES)


def are_rates(speed_squared: Expr) -> Relational:
    """Say whether a gyro's reading can be one."""
    return speed_squared < WILD_RATE**2


def _steps_of_rates(*more: tuple[Symbol, Expr]) -> tuple[Let | Choice, ...]:
    """Take the rates where they are rates, none elsewhere, and so what more depends on them."""
    taken = (*zip(RATES, BODY_RATES, strict=True), *more)
    names, values = zip(*taken, strict=True)
    return (
        Let(SPEED, SPEED_SQUARED),
        Let(WHOLE, T**2 * SPEED),
        Let(MOVES, And(are_rates(SPEED), WHOLE <= LARGEST)),
        Choice(names, ((MOVES, values), otherwise(*(0 * value for value in values)))),
    )


def is_usual(heard: Symbol | And) -> Let:
    """Say of a sample that all of it is heard, and that it turns by less than half a turn."""
    forward = Ge(T, 0, evaluate=False)  # of a symbol that is positive, which a number may not be
    return Let(USUAL, And(forward, MOVES, pi**2 > WHOLE, heard))


@cache
def gyro_turn() -> Computation:
    """Attitude quaternion one period later: an exact turn by rates that are held for it."""
    rates = dict(zip(BODY_RATES, RATES, strict=True))
    turn = quaternion_forms.constant_rate_step().of(rates)
    # The squares are added up once.
    speed = sqrt(sum(rate**2 for rate in RATES))
    steps = (map_step(step, lambda value: value.subs(T * speed, sqrt(TURN))) for step in turn.steps)
    return Computation((*_steps_of_rates((TURN, WHOLE)), *steps), turn.results)


@cache
def gyro_step() -> Computation:
    """Euler angles one period later, by Euler integration of the gyros' readings."""
    rates = euler_rates().of(dict(zip(BODY_RATES, RATES, strict=True)))
    angles = zip(EULER, rates.results, strict=True)
    return Computation(
        (*_steps_of_rates(), *rates.steps),
        ImmutableMatrix([estimation.euler_step(angle, rate) for angle, rate in angles]),
    )


@cache
def observer_turn() -> Computation:
    """Attitude quaternion one period later: the gyros predict, the accelerometer corrects.

    The correction turns the body by the share L of the angle between the reading that is expected
    of a body at rest and the one that was taken. Where the two point in opposite directions, no
    axis is better than another, and none is taken.
    """
    step = gyro_turn()
    expected = further.gravity_seen().xreplace(dict(zip(QUATERNION, PREDICTED, strict=True)))
    size, known = symbols("size has_direction", real=True)
    scaled = tuple(element / size for element in ACCELEROMETER)
    # The derived turn, with what its parts have in common under a name.
    turn = further.turn_towards().xreplace(dict(zip(ACCELEROMETER, READING, strict=True)))
    off = ImmutableMatrix(READING).cross(ImmutableMatrix(further.EXPECTED))
    across = symbols("across_x across_y across_z", real=True)
    length, half, stays, factor = symbols("sine_off half_turn_back turn_back_a factor", real=True)
    angle = turn[0].args[0]
    # It stands there multiplied out, and as it is.
    lengths = dict.fromkeys((next(iter(angle.atoms(atan2))).args[0], sqrt(off.dot(off))), length)
    common = (turn[1] / off[0]).subs({angle: half}).subs(lengths)
    # The turn back is `stays + factor * across`; the product with the second part is ready early.
    moved = symbols("moved_a moved_b moved_c moved_d", real=True)
    with_across = hamilton.multiply(ImmutableMatrix(PREDICTED), ImmutableMatrix([0, *across]))
    return Computation(
        (
            *step.steps,
            *map(Let, PREDICTED, step.results),
            *map(Let, further.EXPECTED, expected),
            Let(size, sum(map(Abs, ACCELEROMETER))),
            Let(known, And(size > 0, size <= LARGEST)),
            Choice(READING, ((known, scaled), otherwise(*(0 * element for element in scaled)))),
            *map(Let, across, off),
            *map(Let, moved, with_across),
            Let(length, sqrt(sum(name**2 for name in across))),
            Let(half, angle.subs(lengths)),
            Choice(
                (stays, factor), ((length > 0, (cos(half), common)), otherwise(size**0, 0 * size))
            ),
            is_usual(known),
        ),
        stays * ImmutableMatrix(PREDICTED) + factor * ImmutableMatrix(moved),
        valid=USUAL,
    )


@cache
def observer_step() -> Computation:
    """`observer_turn` from Euler angles to Euler angles, whatever the sign of the quaternion."""
    start = symbols("start_a start_b start_c start_d", real=True)
    before = tuple(map(Let, start, quaternions.from_euler()))
    turn = observer_turn().of(dict(zip(QUATERNION, start, strict=True)))
    end = symbols("end_a end_b end_c end_d", real=True)
    after = quaternion_forms.euler_from_quaternion().of(
        dict(zip(QUATERNION, end, strict=True)), "end_"
    )
    steps = (*before, *turn.steps, *map(Let, end, turn.results), *after.steps)
    return Computation(steps, after.results, valid=USUAL)


@cache
def monitored_turn() -> Computation:
    """`observer_turn` by the gain that a watch over E asks for, and what E says afterwards.

    The state is the quaternion, and for how many samples E has been above its threshold.
    """
    asked = monitor.gain()
    turn = observer_turn().of({estimation.L: asked.results})
    after = symbols("after_a after_b after_c after_d", real=True)
    # E by the attitude itself, where `factor` has roll and pitch.
    judged = forms.factor().of({}, "field_")
    down = Symbol("field_level_z", real=True)
    reading = symbols("field_reading_x field_reading_y field_reading_z", real=True)
    level = quaternions.rotate_to_inertial()[2].xreplace(
        dict(zip((*QUATERNION, *VECTOR), (*after, *reading), strict=True))
    )
    judging = (Let(down, level) if step_names(s) == (down,) else s for s in judged.steps)
    watched = monitor.samples_above()
    return Computation(
        (
            *asked.steps,
            *turn.steps,
            *map(Let, after, turn.results),
            *judging,
            Let(monitor.FACTOR, judged.results),
            *watched.steps,
        ),
        ImmutableMatrix([*after, watched.results]),
    )


@cache
def euler_observer_step() -> Computation:
    """Euler angles one period later as the notes have it, angle by angle.

    The gyros predict by Euler integration, the accelerometer corrects roll and pitch, the shorter
    way round. Yaw comes from the gyros alone.
    """
    step = gyro_step()
    tilt = forms.tilt().of({}, "seen_")
    predicted = symbols("predicted_roll predicted_pitch", real=True, cls=Angle)
    turns = symbols("roll_to_measured pitch_to_measured", real=True, cls=Angle)
    shortest = symbols("roll_off pitch_off", real=True, cls=Angle)
    known = Symbol(f"seen_{forms.KNOWN.name}", real=True)
    off = [estimation.update(0, estimation.shortest_turn(turn)) for turn in turns]
    return Computation(
        (
            *step.steps,
            *tilt.steps,
            *map(Let, predicted, step.results),
            *map(
                Let,
                turns,
                (seen - guess for guess, seen in zip(predicted, tilt.results, strict=True)),
            ),
            Choice(shortest, ((known, tuple(off)), otherwise(*(0 * turn for turn in turns)))),
            is_usual(known),
        ),
        ImmutableMatrix(
            [
                *(guess + change for guess, change in zip(predicted, shortest, strict=True)),
                step.results[2],
            ]
        ),
        valid=USUAL,
    )
