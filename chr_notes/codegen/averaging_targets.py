"""The table of generated functions, part three: averaging in a frame that does not turn, and gains.

No formula stands here: each target names the derivation that it comes from.
"""

from chr_notes.codegen import arguments as given
from chr_notes.codegen.target import Target
from chr_notes.derivations.forms import gains

TARGETS = (
    Target(
        "gain_from_time_constant",
        "estimation",
        "Gain that has, at a period, the effect of a time constant",
        (given.TIME_CONSTANT, given.PERIOD),
        gains.gain_from_time_constant,
        arrays=(("time_constant", (given.TIME_CONSTANT,)), ("dt", (given.PERIOD,))),
    ),
    Target(
        "time_constant_from_gain",
        "estimation",
        "Time constant that has, at a period, the effect of a gain, s",
        (given.GAIN, given.PERIOD),
        gains.time_constant_from_gain,
        arrays=(("gain", (given.GAIN,)), ("dt", (given.PERIOD,))),
    ),
)
