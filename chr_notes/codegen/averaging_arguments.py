"""Arguments of the averaging filter's generated functions."""

from chr_notes.codegen.arguments import QUATERNION_ARGUMENTS, axes
from chr_notes.codegen.target import Argument
from chr_notes.derivations import averaging as derived
from chr_notes.derivations import estimation
from chr_notes.derivations.forms import averaging, heading, rest

AVERAGING = (
    *QUATERNION_ARGUMENTS,
    Argument("mean_length", averaging.LENGTH, "length of the mean force, in its unit"),
    *(
        Argument(f"slope_{way[0]}", symbol, f"change of the mean {way} in a time constant")
        for way, symbol in zip(("north", "east", "down"), averaging.SLOPES, strict=True)
    ),
    Argument("averaged", averaging.AVERAGED, "time that the mean stands for, s"),
    Argument("settled", averaging.SETTLED, "whether the low-pass has run in, 0 or 1"),
)
LONGEST_STEP = Argument("longest_step", averaging.LONGEST, "beyond which a step is a gap, s")
HEADING = (
    Argument("heading_averaged", heading.HEADING_AVERAGED, "time that the heading stands for, s"),
    Argument("field_length", heading.FIELD_LENGTH, "length of the field so far, any unit"),
    Argument("field_down", heading.FIELD_DOWN, "its part down, the whole field being 1"),
    Argument("field_known", heading.FIELD_KNOWN, "time for which the two have held, s"),
)
HEADING_TIME_CONSTANT = Argument(
    "heading_time_constant", heading.TIME_CONSTANT, "mean age of the heading, s"
)
FIELD_TOLERANCE = Argument(
    "field_tolerance", heading.TOLERANCE, "by which a field may differ, as part of the whole"
)
FIELD_PATIENCE = Argument(
    "field_patience", heading.PATIENCE, "after which a field that differs is the field, s"
)
HEADING_GAIN = Argument(
    "heading_gain", heading.HEADING_GAIN, "weight of the magnetometer, from 0 to 1"
)
RESTS = (
    *axes("rest_rate_{}", rest.RATE_MEANS, "mean rate about {} over the rest so far, rad/s"),
    *axes("rest_force_{}", rest.FORCE_MEANS, "mean force along {} over the rest so far"),
    Argument("still", rest.STILL, "for how long it has been one, s"),
    *axes("learnt_{}", rest.LEARNT, "reading at rest about {} as learnt last, rad/s"),
)
REST = Argument("rest", rest.REST, "after which it is learnt, s")
SPEED = Argument("speed", derived.speed, "that the body stays below, m/s")
BIAS_BOUND = Argument("bias_bound", estimation.bias, "that a gyro's bias stays below, rad/s")
