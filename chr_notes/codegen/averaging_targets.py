"""The table of generated functions, part three: averaging in a frame that does not turn, and gains.

No formula stands here: each target names the derivation that it comes from.
"""

from chr_notes.codegen import arguments as given
from chr_notes.codegen import array_arguments as array
from chr_notes.codegen import averaging_arguments as own
from chr_notes.codegen.target import Target
from chr_notes.derivations.forms import averaging, gains, heading, rest

TARGETS = (
    Target(
        "gain_from_time_constant",
        "estimation",
        "Gain that has, at a period, the effect of a time constant",
        (),
        gains.gain_from_time_constant,
        arrays=(array.TIME_CONSTANT, array.DT),
    ),
    Target(
        "time_constant_from_gain",
        "estimation",
        "Time constant that has, at a period, the effect of a gain, s",
        (),
        gains.time_constant_from_gain,
        arrays=(array.GAIN, array.DT),
    ),
    Target(
        "averaging_turn",
        "estimation",
        "Attitude quaternion and state of the averaging filter after one more sample",
        (),
        averaging.turn,
        arrays=(
            ("state", own.AVERAGING),
            array.BODY_RATES,
            array.ACCEL,
            array.DT,
            array.TIME_CONSTANT,
            ("longest_step", (own.LONGEST_STEP,)),
        ),
        over_samples=True,
    ),
    Target(
        "averaging_heading_turn",
        "estimation",
        "The same with a heading, and what is known of the magnetic field",
        (),
        heading.turn,
        arrays=(
            ("state", (*own.AVERAGING, *own.HEADING)),
            array.BODY_RATES,
            array.ACCEL,
            array.MAG,
            array.DT,
            array.TIME_CONSTANT,
            ("longest_step", (own.LONGEST_STEP,)),
            ("heading_time_constant", (own.HEADING_TIME_CONSTANT,)),
            ("north", (given.NORTH,)),
            ("east", (given.EAST,)),
            ("field_tolerance", (own.FIELD_TOLERANCE,)),
            ("field_patience", (own.FIELD_PATIENCE,)),
        ),
        over_samples=True,
    ),
    Target(
        "observer_heading_turn",
        "estimation",
        "Attitude quaternion one period later, two sensors heard with fixed gains",
        (),
        heading.observer_turn,
        arrays=(
            array.Q,
            array.BODY_RATES,
            array.ACCEL,
            array.MAG,
            array.DT,
            array.GAIN,
            ("heading_gain", (own.HEADING_GAIN,)),
            ("north", (given.NORTH,)),
            ("east", (given.EAST,)),
        ),
        over_samples=True,
    ),
    Target(
        "bias_at_rest",
        "estimation",
        "Means over a rest so far, for how long it has been one, and what the gyros read at rest",
        (),
        rest.bias,
        arrays=(
            ("state", own.RESTS),
            array.BODY_RATES,
            array.ACCEL,
            array.DT,
            ("rest", (own.REST,)),
            ("longest_step", (own.LONGEST_STEP,)),
        ),
        over_samples=True,
    ),
    Target(
        "averaging_bound",
        "estimation",
        "Bound of the angle between true and estimated vertical, radians",
        (),
        averaging.bound,
        arrays=(
            ("averaged", own.AVERAGING[8:9]),
            array.TIME_CONSTANT,
            ("speed", (own.SPEED,)),
            ("bias_bound", (own.BIAS_BOUND,)),
        ),
    ),
)
