"""Forms of the steps of the filters, and of tilt, heading and the factor E."""

from functools import cache

from sympy import ImmutableMatrix, Or, Symbol, atan2, collect, expand, pi, sqrt, symbols
from sympy.codegen.cfunctions import hypot

from chr_notes.derivations import estimation, validation
from chr_notes.derivations.computation import Choice, Computation, Let, otherwise
from chr_notes.derivations.forms.euler import euler_rates
from chr_notes.symbols import EULER, MAGNETOMETER, Angle, phi, psi, theta

# Roll and pitch that the accelerometer shows.
ROLL_ACCEL, PITCH_ACCEL = symbols("phi_accel theta_accel", real=True, cls=Angle)
MEASURED_SQUARED = Symbol("field_squared", real=True)


@cache
def tilt() -> Computation:
    """Roll and pitch from an accelerometer at rest."""
    roll, pitch = estimation.tilt()
    sine, cosine = pitch.args
    across, down = (square.base for square in cosine.base.as_ordered_terms())
    return Computation((), ImmutableMatrix([roll, atan2(sine, hypot(across, down))]))


@cache
def gyro_step() -> Computation:
    """Euler angles one period later, by Euler integration of the gyros' readings."""
    rates = euler_rates()
    return Computation(
        rates.steps,
        ImmutableMatrix(
            [
                estimation.euler_step(angle, rate)
                for angle, rate in zip(EULER, rates.results, strict=True)
            ]
        ),
    )


@cache
def observer_step() -> Computation:
    """Euler angles one period later: the gyros predict, the accelerometer corrects roll and pitch.

    The correction goes the shorter way round. Yaw comes from the gyros alone.
    """
    step = gyro_step()
    predicted = symbols("predicted_roll predicted_pitch", real=True, cls=Angle)
    turns = symbols("roll_to_measured pitch_to_measured", real=True, cls=Angle)
    shortest = symbols("roll_off pitch_off", real=True, cls=Angle)
    measured = zip(predicted, tilt().results, strict=True)
    updated = [
        guess + estimation.update(0, off) for guess, off in zip(predicted, shortest, strict=True)
    ]
    return Computation(
        (
            *step.steps,
            *map(Let, predicted, step.results),
            *map(Let, turns, (seen - guess for guess, seen in measured)),
            *map(Let, shortest, map(estimation.shortest_turn, turns)),
        ),
        ImmutableMatrix([*updated, step.results[2]]),
    )


@cache
def correct_tilt() -> Computation:
    """Roll and pitch once the accelerometer's have been heard; only a long way round is wrapped."""
    turn, shortest = symbols("turn shortest_turn", real=True, cls=Angle)
    beyond = Or(turn < -pi, turn > pi)
    pitch = collect(estimation.update(theta, PITCH_ACCEL), estimation.L)
    return Computation(
        (
            Let(turn, ROLL_ACCEL - phi),
            Choice((shortest,), ((beyond, (estimation.shortest_turn(turn),)), otherwise(turn))),
        ),
        ImmutableMatrix([phi + estimation.update(0, shortest), pitch]),
    )


@cache
def correct_steep_tilt() -> Computation:
    """Roll, pitch and yaw so corrected: a correction of roll leaves the body's heading alone."""
    tilt_alone = correct_tilt()
    change = Symbol("roll_change", real=True)
    roll, pitch = tilt_alone.results
    return Computation(
        (*tilt_alone.steps, Let(change, roll - phi)),
        ImmutableMatrix([phi + change, pitch, psi + estimation.yaw_for_roll(change)]),
    )


@cache
def heading() -> Computation:
    """Find yaw from the level parts of the magnetic field, which occur twice."""
    along, across = symbols("level_x level_y", real=True)
    level_x, level_y, _ = validation.level_field()
    yaw = validation.heading().xreplace({level_x: along, level_y: across})
    return Computation((Let(along, level_x), Let(across, level_y)), yaw)


@cache
def factor() -> Computation:
    """Factor E; the field must not be zero."""
    down = Symbol("level_z", real=True)
    field = ImmutableMatrix(MAGNETOMETER)
    squared = field.dot(field)
    level_z = expand(validation.level_field()[2])
    value = validation.factor().xreplace({1 / sqrt(squared): 1 / sqrt(MEASURED_SQUARED)})
    return Computation(
        (Let(MEASURED_SQUARED, squared), Let(down, level_z)),
        value.subs(level_z, down),
        guard=MEASURED_SQUARED,
    )
