"""What the paper on validating Euler angles presumes: an undisturbed field, ranges, exact tilt."""

from sympy import Add, Eq, ImmutableMatrix, Ne, symbols

from chr_notes.derivations import validation as derived
from chr_notes.ledger import ranges
from chr_notes.ledger.condition import Condition, Presumed
from chr_notes.printed import validation as printed
from chr_notes.symbols import AngularRate, phi, theta

# The gyro's bias while at rest.
BIAS = AngularRate("b", real=True)

# The normalised field where the magnetometer is, iron and the magnetometer's own errors included,
# in the inertial frame. The paper's M_i is the field as it was when all angles were zero.
SEEN = ImmutableMatrix(symbols(r"\tilde{M}_{xi} \tilde{M}_{yi} \tilde{M}_{zi}", real=True))
UNDISTURBED = Condition(Eq(SEEN, printed.M_I))
NORMALISED = tuple(
    Condition(Eq(Add(*(part**2 for part in field)), 1)) for field in (printed.M_I, SEEN)
)
PRESUMED = (
    Presumed(
        UNDISTURBED,
        "what the compass reads when all angles are zero",
        "validation.n",
        ("validation.12", "validation.13", "validation.14"),
    ),
    *(Presumed(each, "normalised", "validation.n", ("validation.d",)) for each in NORMALISED),
    Presumed(
        Condition(Eq(printed.ROLL_COMP, phi) & Eq(printed.PITCH_COMP, theta)),
        "when roll and pitch are exact",
        "validation.d",
    ),
    Presumed(ranges.up_to_right_angle(theta), "Pitch", "validation.4"),
    # The quotient has no value where both components are zero.
    Presumed(ranges.acute(theta), "Roll from the accelerometer", "validation.3"),
    # The paper takes the arctangent of a quotient for it.
    Presumed(
        ranges.acute(printed.ROLL_ACCEL),
        "Roll from the accelerometer",
        "validation.3",
        ("validation.10",),
    ),
    Presumed(ranges.from_0_to_1(printed.ALPHA), "Complementary", "validation.10"),
    Presumed(ranges.between_0_and_1(printed.ALPHA), "converges", "validation.c"),
    Presumed(Condition(Ne(BIAS, 0)), "by the bias of the gyro", "validation.m"),
    # Its y component is zero.
    Presumed(Condition(Eq(derived.declination, 0)), "points south", "validation.e"),
)
