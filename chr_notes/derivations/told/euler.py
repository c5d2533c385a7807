"""Rates of the Euler angles, solved for one after the other."""

from types import MappingProxyType

from sympy import ImmutableMatrix, MatMul, MatrixSymbol, Symbol, cos, sin

from chr_notes.derivations import euler as derived
from chr_notes.derivations.steps import Step, equation
from chr_notes.derivations.told import Told
from chr_notes.symbols import (
    EULER_RATES,
    p,
    phi,
    pitch_rate,
    q,
    r,
    roll_rate,
    theta,
    yaw_rate,
)

AXES = MatrixSymbol("A", 3, 3)
VOLUME = Symbol(r"\det A", real=True)

RATES = Told(
    (
        Step(
            "The second and the third line of the sum are one plane vector, turned by roll.",
            equation(
                ImmutableMatrix([q, r]),
                MatMul(
                    ImmutableMatrix([[cos(phi), sin(phi)], [-sin(phi), cos(phi)]]),
                    ImmutableMatrix([pitch_rate, yaw_rate * cos(theta)]),
                ),
            ),
        ),
        Step(
            "Turn it back. Its first component is the rate of pitch,",
            equation(pitch_rate, q * cos(phi) - r * sin(phi)),
        ),
        Step(
            "and its second what a raised nose leaves of the rate of yaw.",
            equation(yaw_rate * cos(theta), q * sin(phi) + r * cos(phi)),
        ),
        Step(
            "Here is the division: of yaw's axis only the part at right angles to the nose, cos θ "
            "long, can be told from roll.",
            equation(yaw_rate, (q * sin(phi) + r * cos(phi)) / cos(theta)),
        ),
        Step(
            "The rest of yaw's axis lies along the nose. The gyro x reads it along with roll, so "
            "roll is what it reads without that.",
            equation(roll_rate, p + yaw_rate * sin(theta)),
        ),
    ),
    MappingProxyType(dict(zip(EULER_RATES, derived.euler_rates(), strict=True))),
)
"""What the rows of D say, one after the other, from the gyros' readings."""

LOCK = Told(
    (
        Step(
            "The axes of roll, pitch and yaw, in the body frame, are the columns of the matrix "
            "that D inverts.",
            equation(
                AXES,
                ImmutableMatrix(
                    [
                        [1, 0, -sin(theta)],
                        [0, cos(phi), sin(phi) * cos(theta)],
                        [0, -sin(phi), cos(phi) * cos(theta)],
                    ]
                ),
            ),
        ),
        Step(
            "Its determinant is the volume of the box with these axes for edges. At a pitch of 90° "
            "the box is flat, and there is no inverse.",
            equation(VOLUME, cos(theta)),
        ),
    ),
    MappingProxyType(
        {AXES: derived.body_rates_matrix(), VOLUME: derived.body_rates_matrix().det()}
    ),
)
"""Where D does not exist."""
