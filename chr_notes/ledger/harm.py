"""What an error that misleads does on a device."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

HARM: Final[Mapping[str, str]] = MappingProxyType(
    {
        "quaternion-direction": "Every attitude comes out undone: a nose to the east as one to "
        "the west, a climb as a dive. Level and to the north it looks right, so a first try on "
        "the table does not find it.",
        "gravity-or-reading": "Two signs are wrong, and in pitch they cancel. Mend one alone, and "
        "an aircraft that climbs is said to dive. Put the reading into an arctangent of two "
        "arguments, and one that lies level is said to be on its back.",
        "roll-quadrant": "An aircraft on its back is shown upright, and an autopilot that wants "
        "to roll it level pushes the wrong way.",
        "seam": "Beyond ±180° the estimate does not go on but runs back through the whole circle, "
        "a little with each sample, past level flight.",
        "matrix-label": "A program that takes the nine elements the way their label says turns "
        "each vector the wrong way: with the nose up it finds gravity towards the nose.",
        "south-field": "With this for a reference every heading is off by half a turn.",
        "accelerometer-for-magnetometer": "Typed in as printed, the compass follows gravity: its "
        "heading goes with the tilt and not with the field.",
        "rates-by-projection": "The steeper the nose, the slower a filter built by these words "
        "lets yaw go on, while its true rate grows without bound. With nose and wings "
        "level nobody notices.",
        "missing-half": "A budget of errors made from the table doubles each distance. One buys a "
        "sensor twice as good as is needed, or looks for a fault in a drift that is as it "
        "should be.",
        "bias-stays": "The angles stay beside the true ones as long as the bias does, the farther "
        "the smaller the gain is, and nothing in them shows it.",
        "factor-blind": "A robot whose heading is wrong drives the wrong way while its monitor "
        "says that all is well.",
        "factor-needs-field": "A monitor that trusts this raises its alarm beside each car and "
        "steel beam, and blames angles that are right.",
        "no-information": "A program that computes it divides rounding errors by rounding errors: "
        "yaw jumps from sample to sample, or is no number at all.",
        "kilometre": "One plans for three times the error that there is, and gives up a task for "
        "which 308 m would do.",
    }
)
"""By the name of the error, as in `roots.ROOTS`: all of those that mislead somewhere.

In the order of the errata, by our judgement: first what turns an attitude round and raises no
error, then wrong sizes, then what a monitor misses, then what shows itself.
"""
