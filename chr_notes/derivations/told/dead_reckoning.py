"""How a tilt error becomes a distance, and where a half gets lost."""

from types import MappingProxyType

from sympy import Symbol, sin

from chr_notes.derivations import dead_reckoning as derived
from chr_notes.derivations.dead_reckoning import t, tilt_error
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.telling import Told
from chr_notes.symbols import g

ACCELERATION, VELOCITY, POSITION = (Symbol(rf"\Delta {name}") for name in "avr")
AT_LAST = Symbol(r"\Delta r_{\text{at the last velocity}}")

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
        Step(
            "Whoever multiplies the last velocity by the time believes that it was there all "
            "along. That is twice the distance.",
            equation(AT_LAST, 2 * POSITION),
        ),
    ),
    MappingProxyType(
        {
            **dict(zip((ACCELERATION, VELOCITY, POSITION), derived.drift(), strict=True)),
            AT_LAST: derived.position_at_last_velocity(),
        }
    ),
)
"""From an angle to metres."""
