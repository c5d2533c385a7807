"""The table of generated functions, part three: averaging in a frame that does not turn, and gains.

No formula stands here: each target names the derivation that it comes from.
"""

from functools import partial

from chr_notes.codegen import arguments as given
from chr_notes.codegen import array_arguments as array
from chr_notes.codegen.target import Target
from chr_notes.derivations.forms import averaging, gains, heading, rest

ESTIMATION = partial(Target, "estimation")

TARGETS = (
    ESTIMATION(
        "gain_from_time_constant",
        "Gain that has, at a period, the effect of a time constant",
        gains.gain_from_time_constant,
        arrays=(array.TIME_CONSTANT, array.DT),
    ),
    ESTIMATION(
        "time_constant_from_gain",
        "Time constant that has, at a period, the effect of a gain, s",
        gains.time_constant_from_gain,
        arrays=(array.GAIN, array.DT),
    ),
    ESTIMATION(
        "averaging_turn",
        "Attitude quaternion and state of the averaging filter after one more sample",
        averaging.turn,
        arrays=(
            ("state", given.AVERAGING),
            array.BODY_RATES,
            array.ACCEL,
            array.DT,
            array.TIME_CONSTANT,
            *array.numbers(given.LONGEST_STEP),
        ),
        over_samples=True,
    ),
    ESTIMATION(
        "averaging_heading_turn",
        "The same with a heading, and what is known of the magnetic field",
        heading.turn,
        arrays=(
            ("state", (*given.AVERAGING, *given.HEADING)),
            array.BODY_RATES,
            array.ACCEL,
            array.MAG,
            array.DT,
            array.TIME_CONSTANT,
            *array.numbers(given.LONGEST_STEP, given.HEADING_TIME_CONSTANT),
            *array.numbers(given.NORTH, given.EAST, given.FIELD_TOLERANCE, given.FIELD_PATIENCE),
        ),
        over_samples=True,
    ),
    ESTIMATION(
        "observer_heading_turn",
        "Attitude quaternion one period later, two sensors heard with fixed gains",
        heading.observer_turn,
        arrays=(
            array.Q,
            array.BODY_RATES,
            array.ACCEL,
            array.MAG,
            array.DT,
            array.GAIN,
            *array.numbers(given.HEADING_GAIN, given.NORTH, given.EAST),
        ),
        over_samples=True,
    ),
    ESTIMATION(
        "bias_at_rest",
        "Means over a rest so far, for how long it has been one, and what the gyros read at rest",
        rest.bias,
        arrays=(
            ("state", given.RESTS),
            array.BODY_RATES,
            array.ACCEL,
            array.DT,
            *array.numbers(given.REST, given.LONGEST_STEP),
        ),
        over_samples=True,
    ),
    ESTIMATION(
        "averaging_bound",
        "Bound of the angle between true and estimated vertical, radians",
        averaging.bound,
        arrays=array.numbers(given.AVERAGED, given.TIME_CONSTANT, given.SPEED, given.BIAS_BOUND),
    ),
)
