"""Which errors of the attitude the factor E sees, and to which it is blind."""

import math
from typing import Final, NamedTuple

from chr_notes.demos.base import Control, Demo, rounded
from chr_notes.demos.noise import noise
from chr_notes.generated.scalar.euler import matrix_from_euler
from chr_notes.generated.scalar.quaternions import (
    euler_from_quaternion,
    inclination_from_quaternion,
    quaternion_from_axis_angle,
    quaternion_from_euler,
    quaternion_multiply,
    rotate_to_body,
)
from chr_notes.generated.scalar.validation import validation_factor
from chr_notes.sensors.coverage import evenly_spread

__all__ = ["SETTING", "Setting", "ValidationDemo"]

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


class Setting(NamedTuple):
    """What the demo does not let one change.

    Directions of an error all around, readings with noise, the noise of each axis as a part of the
    field, and its seed.
    """

    directions: int = 500
    readings: int = 200
    noise: float = 0.02
    seed: int = 3


SETTING: Final = Setting()


class ValidationDemo(Demo):
    """A level robot whose attitude is off by a turn about some axis, and the factor E.

    The globe shows about which axes such an error is seen. Beside E stand the angle between the
    true and the believed vertical, the share of axes of which a threshold misses the error, and
    the share of readings that it takes for an error through noise of 2 % of the field on each axis
    while the angles are right. Its numbers come from the ledger entry validation.17.

    Parameters
    ----------
    heading : float, optional
        True yaw in degrees, from -180 to 180; 0 unless told. Each value follows its slider while a
        kernel runs.
    axis_yaw, axis_pitch : float, optional
        The axis of the error, which turns with the robot: from the nose to the right, from -180 to
        180, and upwards, from -90 to 90, in degrees; the nose unless told, which is an error of
        roll.
    error : float, optional
        Angle of the error in degrees, from 0 to 30; 10 unless told.
    threshold : float, optional
        Of E, from 0 to 0.3; 0.05 unless told.
    iron : float, optional
        Field that the robot's own iron adds along its z-axis, a part of the Earth's, from -0.5 to
        0.5; 0 unless told.
    inclination : float, optional
        Of the field below the horizon in degrees, from -90 to 90; 66 unless told.
    """

    element = "validation"
    controls = (
        "heading", "axis_yaw", "axis_pitch", "error", "threshold", "iron", "inclination",
    )  # fmt: skip

    heading = Control(0.0, min=-180.0, max=180.0).tag(sync=True)
    axis_yaw = Control(0.0, min=-180.0, max=180.0).tag(sync=True)
    axis_pitch = Control(0.0, min=-90.0, max=90.0).tag(sync=True)
    error = Control(10.0, min=0.0, max=30.0).tag(sync=True)
    threshold = Control(0.05, min=0.0, max=0.3).tag(sync=True)
    iron = Control(0.0, min=-0.5, max=0.5).tag(sync=True)
    inclination = Control(66.0, min=-90.0, max=90.0).tag(sync=True)

    def readouts(self) -> dict[str, float]:
        """Return E, degrees between the verticals, and two shares in per cent."""
        axis = _direction(self.heading + self.axis_yaw, self.axis_pitch)
        around = [self._factor((x, y, z)) for x, y, z in evenly_spread(SETTING.directions).tolist()]
        quiet = self._through_noise()
        return {
            "factor": self._factor(axis),
            "tilt_error": math.degrees(inclination_from_quaternion(*self._turn(axis))),
            "missed": 100 * sum(each <= self.threshold for each in around) / len(around),
            "false_alarms": 100 * sum(each > self.threshold for each in quiet) / len(quiet),
        }

    def fallback(self) -> str:
        """Return the state and the numbers in two sentences."""
        found = self.readouts()
        return (
            f"A level robot that heads to {rounded(self.heading)}° in a field "
            f"{rounded(self.inclination)}° below the horizon, with iron of {rounded(self.iron)} of "
            f"the field, and an attitude that is off by {rounded(self.error)}° about the axis "
            f"{rounded(self.axis_yaw)}° from the nose and {rounded(self.axis_pitch)}° up. E is "
            f"{round(found['factor'], 3)}, the vertical is off by {rounded(found['tilt_error'])}°; "
            f"a threshold of {round(self.threshold, 3)} misses {rounded(found['missed'])} % of all "
            f"directions and gives {rounded(found['false_alarms'])} % false alarms."
        )

    def _field(self) -> Vector:
        return _direction(0.0, -self.inclination)

    def _truth(self) -> Quaternion:
        return quaternion_from_euler(0.0, 0.0, math.radians(self.heading))

    def _reading(self) -> Vector:
        """Return what the magnetometer reads, the field being 1."""
        x, y, z = rotate_to_body(*self._truth(), *self._field())
        return x, y, z + self.iron

    def _turn(self, axis: Vector) -> Quaternion:
        return quaternion_from_axis_angle(*axis, math.radians(self.error))

    def _factor(self, axis: Vector) -> float:
        """Return E when the attitude is off by the error about an inertial axis."""
        believed = quaternion_multiply(*self._turn(axis), *self._truth())
        roll, pitch, *_ = euler_from_quaternion(*believed)
        return abs(validation_factor(*self._reading(), roll, pitch, self._field()[2]))

    def _through_noise(self) -> list[float]:
        """Return E of readings with noise while the angles are right."""
        source, (x, y, z), down = noise(SETTING.seed), self._reading(), self._field()[2]
        size = SETTING.noise
        return [
            abs(
                validation_factor(
                    x + size * next(source),
                    y + size * next(source),
                    z + size * next(source),
                    0.0,
                    0.0,
                    down,
                )
            )
            for _ in range(SETTING.readings)
        ]


def _direction(yaw: float, pitch: float) -> Vector:
    """Return where a nose points at a yaw and a pitch in degrees."""
    return matrix_from_euler(0.0, math.radians(pitch), math.radians(yaw))[:3]
