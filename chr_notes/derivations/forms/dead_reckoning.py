"""Forms of one step of dead reckoning."""

from functools import cache

from sympy import ImmutableMatrix, symbols

from chr_notes.derivations import dead_reckoning
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


def velocity_step() -> ImmutableMatrix:
    """Velocity after a period through which the acceleration is held: the step of the notes."""
    pairs = zip(dead_reckoning.VELOCITY, dead_reckoning.ACCELERATION, strict=True)
    return ImmutableMatrix([euler_step(*pair) for pair in pairs])


def position_step() -> ImmutableMatrix:
    """Position after a period through which the velocity is held: the step of the notes."""
    pairs = zip(dead_reckoning.POSITION, dead_reckoning.VELOCITY, strict=True)
    return ImmutableMatrix([euler_step(*pair) for pair in pairs])
