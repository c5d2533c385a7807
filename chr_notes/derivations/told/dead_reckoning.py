"""How an error of tilt becomes a distance, and what a gyro adds."""

from types import MappingProxyType

from sympy import Symbol, sin

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.dead_reckoning import gyro_bias, t, tilt_error
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.told import Told
from chr_notes.symbols import g

ACCELERATION, VELOCITY, POSITION = (Symbol(rf"\Delta {name}") for name in "avr")

DRIFT = Told(
    (
        Step(
            "As long as the attitude is off by the same angle, the phantom acceleration along the "
            "ground stays the same.",
            equation(ACCELERATION, g * sin(tilt_error)),
        ),
        Step(
            "What is constant adds up in proportion to time.",
            equation(VELOCITY, ACCELERATION * t),
        ),
        Step(
            "Now add up the velocity. It begins at zero and grows evenly, so that on average it "
            "was half of what it is in the end: here is the half.",
            equation(POSITION, ACCELERATION * t**2 / 2),
        ),
    ),
    MappingProxyType(dict(zip((ACCELERATION, VELOCITY, POSITION), derived.drift(), strict=True))),
)
"""From an angle to metres."""

GYRO = Told(
    (
        Step(
            "A gyro that reads too much about a level axis makes a tilt that grows evenly.",
            equation(tilt_error, gyro_bias * t),
        ),
        Step(
            "While it is small, the phantom acceleration grows with it.",
            equation(ACCELERATION, g * tilt_error),
        ),
        Step(
            "What grows evenly adds up to half its last value times the time, as before.",
            equation(VELOCITY, g * gyro_bias * t**2 / 2),
        ),
        Step(
            "Add up once more. The velocity grows with the square of the time, and was on average "
            "a third of what it is in the end.",
            equation(POSITION, g * gyro_bias * t**3 / 6),
        ),
    ),
    MappingProxyType(
        {
            tilt_error: gyro_bias * t,
            POSITION: derived.position_errors()[2],
            VELOCITY: derived.position_errors()[2].diff(t),
            ACCELERATION: derived.position_errors()[2].diff(t, 2),
        }
    ),
)
"""From a bias of a gyro to metres."""
