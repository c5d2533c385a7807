"""Forms of a heading that a magnetometer corrects, while its field is as it has been.

The field is brought to the frame of the attitude, which is level. There its direction says how far
yaw is off, and its length and its part down, which yaw does not matter to, whether it is the
Earth's: both are compared with their own means over the field heard so far. What differs is held
out. A field that differs for as long as the means are old replaces them.
"""

from functools import cache

from sympy import (
    Abs,
    And,
    Expr,
    ImmutableMatrix,
    Or,
    Symbol,
    cos,
    sin,
    sqrt,
    symbols,
)

from chr_notes.derivations import hamilton, quaternions, validation
from chr_notes.derivations.computation import NOTHING, Choice, Computation, Let, otherwise
from chr_notes.derivations.euler import Z
from chr_notes.derivations.forms import averaging, filters
from chr_notes.derivations.forms.averaging import COUNTED, KNOWN, ONE, ZERO, turned
from chr_notes.derivations.forms.gains import gain
from chr_notes.symbols import MAGNETOMETER, Angle, T, phi, theta

TIME_CONSTANT = Symbol("heading_time_constant", real=True)
HEADING_AVERAGED = Symbol("heading_averaged", real=True)
FIELD_LENGTH, FIELD_DOWN, FIELD_KNOWN = FIELD = symbols(
    "field_length field_down field_known", real=True
)
STATE = (*averaging.STATE, HEADING_AVERAGED, *FIELD)
TOLERANCE, PATIENCE = symbols("tolerance patience", real=True)
# Gain of the heading in the fixed-gain observer.
HEADING_GAIN = Symbol("heading_gain", real=True)

SURE = ONE
"""Seconds of a field that stays as it is, before which only a first heading is taken from it."""

MAG_HEARD, USED = symbols("field_heard field_used", real=True)
SHARE, OFF = Symbol("heading_share", real=True), Angle("heading_off", real=True)
Steps = averaging.Steps
Names = averaging.Names


def _level_field(attitude: Names) -> tuple[Steps, Names]:
    """Bring the direction of the field to the frame of an attitude."""
    size = Symbol("field_size", real=True)
    reading = symbols("field_x field_y field_z", real=True)
    level = symbols("field_n field_e field_d", real=True)
    scaled = tuple(each / size for each in MAGNETOMETER)
    steps: Steps = (
        Let(size, sum(map(Abs, MAGNETOMETER))),
        Let(MAG_HEARD, And(size > 1 / averaging.WILD_FORCE, size < averaging.WILD_FORCE)),
        Choice(reading, ((MAG_HEARD, scaled), otherwise(ZERO, ZERO, ZERO))),
        *map(Let, level, turned(attitude, reading)),
    )
    return steps, level


def _yaw_off(level: Names) -> Let:
    """Find the yaw that the attitude lacks, as heading is found from a level field."""
    along, across, _ = validation.level_field()
    yaw = validation.heading().xreplace({along: level[0], across: level[1]})
    return Let(OFF, yaw)


def _turned_about_down(attitude: Names, angle: Expr) -> tuple[Steps, Names, ImmutableMatrix]:
    """Turn an attitude about the vertical."""
    half = Angle("half_heading_turn", real=True)
    turn = quaternions.from_axis_angle(ImmutableMatrix(Z), angle)
    half_value = next(iter(turn[0].atoms(cos))).args[0]
    named = turn.xreplace({cos(half_value): cos(half), sin(half_value): sin(half)})
    parts = symbols("heading_a heading_d", real=True)
    about = (parts[0], ZERO, ZERO, parts[1])
    steps = (Let(half, half_value), Let(parts[0], named[0]), Let(parts[1], named[3]))
    return steps, about, hamilton.multiply(ImmutableMatrix(about), ImmutableMatrix(attitude))


def _judged(level: Names) -> tuple[Steps, Names]:
    """Say whether the field is the one known so far, and what is known of it then."""
    unit, length, down = symbols("field_unit_size length_now down_now", real=True)
    known, share = symbols("field_known_after field_share", real=True)
    means = symbols("field_length_after field_down_after", real=True)
    same = Symbol("field_is_the_same", real=True)
    size = Symbol("field_size", real=True)
    field = ImmutableMatrix(level)
    whole = sqrt(ImmutableMatrix(MAGNETOMETER).dot(ImmutableMatrix(MAGNETOMETER)))
    # By an attitude that is level, and the part down as it has been.
    factor = validation.factor().subs({phi: 0, theta: 0}).subs(MAGNETOMETER[2] / whole, down)
    factor = factor.xreplace({validation.REFERENCE[2]: FIELD_DOWN})
    near = And(Abs(length - FIELD_LENGTH) <= TOLERANCE * FIELD_LENGTH, factor <= TOLERANCE)
    grown, shrunk = FIELD_KNOWN + COUNTED, FIELD_KNOWN - COUNTED
    steps: Steps = (
        Choice((unit,), ((MAG_HEARD, (sqrt(field.dot(field)),)), otherwise(ONE))),
        Let(length, size * unit),
        Let(down, level[2] / unit),
        Let(same, And(MAG_HEARD, Or(FIELD_KNOWN <= 0, near))),
        Choice(
            (known,),
            (
                (And(same, grown <= PATIENCE), (grown,)),
                (Or(same, ~MAG_HEARD), (FIELD_KNOWN,)),
                (shrunk > 0, (shrunk,)),
                otherwise(ZERO),
            ),
        ),
        averaging.share_of_mean(share, COUNTED, grown),
        Choice(
            means,
            (
                (
                    same,
                    (
                        FIELD_LENGTH + share * (length - FIELD_LENGTH),
                        FIELD_DOWN + share * (down - FIELD_DOWN),
                    ),
                ),
                otherwise(FIELD_LENGTH, FIELD_DOWN),
            ),
        ),
        Let(USED, And(same, Or(known >= SURE, HEADING_AVERAGED <= 0))),
    )
    return steps, (*means, known)


def _shares() -> tuple[Steps, Symbol]:
    """Weigh the heading in a mean at first, later as the time constant says."""
    unseen, left, length = symbols("heading_unseen heading_left heading_length", real=True)
    least, mean, after = symbols("least_share mean_share heading_averaged_after", real=True)
    weight = gain(TIME_CONSTANT).subs(T, COUNTED)
    branches = (
        (And(USED, KNOWN), (ZERO,)),
        (KNOWN, (averaging.UNSEEN_BIAS * T,)),
        otherwise(averaging.UNSEEN_RATE * T),
    )
    return (
        (
            Choice((unseen,), branches),
            averaging.shortened(left, HEADING_AVERAGED, unseen),
            Let(length, left + COUNTED),
            Choice((least,), ((TIME_CONSTANT > 0, (weight,)), otherwise(NOTHING))),
            averaging.share_of_mean(mean, COUNTED, length),
            Choice(
                (SHARE,),
                ((~USED, (ZERO,)), (mean > least, (mean,)), otherwise(least)),
            ),
            Choice(
                (after,),
                ((~USED, (left,)), (length <= TIME_CONSTANT, (length,)), otherwise(TIME_CONSTANT)),
            ),
        ),
        after,
    )


@cache
def turn() -> Computation:
    """Give the state of `averaging.turn` with a heading, and what is known of the field."""
    step = averaging.turn()
    attitude = symbols(
        "level_attitude_a level_attitude_b level_attitude_c level_attitude_d", real=True
    )
    slopes = symbols("level_slope_n level_slope_e level_slope_d", real=True)
    seen, level = _level_field(attitude)
    judged, field = _judged(level)
    shares, averaged = _shares()
    turns, about, state = _turned_about_down(attitude, SHARE * OFF)
    return Computation(
        (
            *step.steps,
            *map(Let, attitude, step.results[:4]),
            *map(Let, slopes, step.results[5:8]),
            *seen,
            _yaw_off(level),
            *judged,
            *shares,
            *turns,
        ),
        ImmutableMatrix(
            [*state, step.results[4], *turned(about, slopes), *step.results[8:], averaged, *field]
        ),
        valid=step.valid,
    )


@cache
def observer_turn() -> Computation:
    """Correct the yaw of `filters.observer_turn` too, by a share of what a magnetometer says."""
    step = filters.observer_turn()
    attitude = symbols(
        "level_attitude_a level_attitude_b level_attitude_c level_attitude_d", real=True
    )
    seen, level = _level_field(attitude)
    share = Choice((SHARE,), ((MAG_HEARD, (HEADING_GAIN,)), otherwise(ZERO)))
    turns, _, state = _turned_about_down(attitude, SHARE * OFF)
    return Computation(
        (
            *step.steps,
            *map(Let, attitude, step.results),
            *seen,
            _yaw_off(level),
            share,
            *turns,
        ),
        state,
        valid=step.valid,
    )
