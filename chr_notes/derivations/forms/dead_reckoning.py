"""Forms of one step of dead reckoning."""

from functools import cache

from sympy import Abs, And, ImmutableMatrix, Symbol, symbols

from chr_notes.derivations import dead_reckoning, further
from chr_notes.derivations.computation import LARGEST, Choice, Computation, Let, otherwise
from chr_notes.derivations.estimation import euler_step
from chr_notes.symbols import T

# Acceleration at the end of the step.
NEXT = ImmutableMatrix(symbols("b_N b_E b_D", real=True))


@cache
def step() -> ImmutableMatrix:
    """Velocity and position one period later, with an acceleration that changes evenly.

    It goes from `ACCELERATION` at the start to `NEXT` at the end. Where the two are the same,
    the step is exact for a constant acceleration.
    """
    jerk = (NEXT - dead_reckoning.ACCELERATION) / T
    changes = dict(zip(dead_reckoning.JERK, jerk, strict=True))
    return ImmutableMatrix(
        [
            *(dead_reckoning.velocity_after_step().xreplace(changes)),
            *(dead_reckoning.position_after_step().xreplace(changes)),
        ]
    ).applyfunc(lambda value: value.expand().collect(T))


@cache
def held_step() -> Computation:
    """Velocity and position after the step of the notes.

    The position goes on by the velocity before the period, the velocity by the acceleration held
    through it. An acceleration that is NaN is held out: the velocity stays.
    """
    known = Symbol("known", real=True)
    held = symbols("held_north held_east held_down", real=True)
    numbers = [Abs(element) <= LARGEST for element in dead_reckoning.ACCELERATION]
    none = (0 * element for element in dead_reckoning.ACCELERATION)
    values = tuple(dead_reckoning.ACCELERATION)
    velocity = [euler_step(*pair) for pair in zip(dead_reckoning.VELOCITY, held, strict=True)]
    pairs = zip(dead_reckoning.POSITION, dead_reckoning.VELOCITY, strict=True)
    position = [euler_step(*pair) for pair in pairs]
    return Computation(
        (Let(known, And(*numbers)), Choice(held, ((known, values), otherwise(*none)))),
        ImmutableMatrix([*velocity, *position]),
    )


def position_errors() -> ImmutableMatrix:
    """Errors of position from each constant error, then variances from each noise."""
    return ImmutableMatrix([*dead_reckoning.position_errors(), *further.position_variances()])
