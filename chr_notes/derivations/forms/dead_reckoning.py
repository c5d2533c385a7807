"""Form of one step of dead reckoning."""

from functools import cache

from sympy import ImmutableMatrix, symbols

from chr_notes.derivations import dead_reckoning
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
