"""What the generated functions return at the edges: the ranges of their results, and what of NaN.

Tests call the functions of each language there.
"""

from dataclasses import dataclass

from chr_notes.codegen.lowering import Program


@dataclass(frozen=True)
class Range:
    """Between which numbers results lie, but for NaN.

    Parameters
    ----------
    names
        What they are called.
    places
        Which results.
    low, high
        The ends, as they are written; both are reached, but for rounding.
    """

    names: str
    places: tuple[int, ...]
    low: str
    high: str

    def __str__(self) -> str:
        """Write it as a part of a sentence."""
        return f"{self.names} from {self.low} to {self.high}"


_ANGLES = (Range("roll and yaw", (0, 2), "-pi", "pi"), Range("pitch", (1,), "-pi/2", "pi/2"))
_TILT = (Range("roll", (0,), "-pi", "pi"), Range("pitch", (1,), "-pi/2", "pi/2"))
_TURNS = (
    Range("first and third", (0, 2), "-pi", "pi"),
    Range("second", (1,), "-pi/2", "pi"),  # up to pi/2, or from 0 where the last axis is the first
)
_MATRIX = (Range("each", tuple(range(9)), "-1", "1"),)
_ATTITUDE = (Range("a", (0,), "0", "1"), Range("b, c and d", (1, 2, 3), "-1", "1"))

RANGES = {
    "matrix_from_euler": _MATRIX,
    "euler_from_matrix": _ANGLES,
    "wrap_angle": (Range("the angle", (0,), "-pi", "pi"),),
    "matrix_from_quaternion": _MATRIX,
    "quaternion_from_matrix": _ATTITUDE,
    "quaternion_from_euler": _ATTITUDE,
    "euler_from_quaternion": _ANGLES,
    "quaternion_from_axis_angle": _ATTITUDE,
    "axis_angle_from_quaternion": (
        Range("the axis", (0, 1, 2), "-1", "1"),
        Range("the angle", (3,), "0", "pi"),
    ),
    "inclination_from_quaternion": (Range("the angle", (0,), "0", "pi"),),
    "matrix_from_angles": _MATRIX,
    "angles_from_matrix": _TURNS,
    "quaternion_from_angles": _ATTITUDE,
    "angles_from_quaternion": _TURNS,
    "tilt_from_accelerometer": _TILT,
    "observer_step": _ANGLES,
    "heading_from_magnetometer": (Range("yaw", (0,), "-pi", "pi"),),
    "validation_factor": (Range("E, for a reference from -1 to 1", (0,), "0", "2"),),
}
"""By function; where none stands, a result may be any number."""

NOT_HEARD = "A reading that is zero, or has NaN or infinity, gives NaN."
HELD_OUT = (
    "Rates with NaN or infinity, or of 1e12 rad/s and more, are held out: the body stands still."
)
GAP = "Through a step longer than the longest the body stands still too."
ALONE = "Readings that are zero, or have NaN or infinity, are not heard: the gyros go on alone."

OF_NAN = {
    "tilt_from_accelerometer": (NOT_HEARD, "Straight up or down roll is 0."),
    "heading_from_magnetometer": (NOT_HEARD,),
    "validation_factor": (NOT_HEARD,),
    "gyro_step": (HELD_OUT, "Angles grow past half a turn."),
    "gyro_turn": (HELD_OUT,),
    "observer_turn": (HELD_OUT, ALONE),
    "observer_step": (HELD_OUT, ALONE, "At gimbal lock roll is set to 0 and yaw has the rest."),
    "euler_observer_step": (HELD_OUT, ALONE, "Angles grow past half a turn."),
    "averaging_turn": (HELD_OUT, GAP, ALONE),
    "averaging_heading_turn": (HELD_OUT, GAP, ALONE),
    "observer_heading_turn": (HELD_OUT, ALONE),
    "bias_at_rest": ("A sample with a reading that is none changes nothing.",),
    "averaging_bound": ("Nothing averaged, or more than pi, gives pi.",),
    "monitor_gain": ("NaN for the count gives the gain otherwise.",),
    "monitor_count": ("A factor of NaN leaves the count as it was.",),
    "monitored_turn": (HELD_OUT, ALONE, "A field that is zero or has NaN leaves the count."),
    "dead_reckoning_held": ("Accelerations with NaN or infinity change no velocity.",),
}
"""By function, what NaN and the like do to it; elsewhere NaN in gives NaN out."""


def edges(program: Program) -> list[str]:
    """Say of a function where its results lie, and what becomes of NaN."""
    name = program.target.name
    ranges = ", ".join(map(str, RANGES.get(name, ())))
    told = OF_NAN.get(name, ("NaN gives NaN in each result that it enters.",))
    return [*([f"{ranges[0].upper()}{ranges[1:]}."] if ranges else []), *told]
