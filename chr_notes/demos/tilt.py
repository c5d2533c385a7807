"""An aircraft that accelerates, and the tilt that its accelerometer believes in."""

import json
import math
from collections.abc import Sequence
from typing import Final

from chr_notes._texts import read
from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.demos.base import SOURCES, Control, Demo, rounded
from chr_notes.generated.scalar.dead_reckoning import accelerometer_from_acceleration
from chr_notes.generated.scalar.estimation import tilt_from_accelerometer
from chr_notes.generated.scalar.euler import matrix_from_euler, wrap_angle

__all__ = ["NOTHING", "VIBRATION", "TiltDemo"]

VIBRATION: Final[Sequence[Sequence[float]]] = json.loads(read(SOURCES / "vibration.json"))
"""What a vibration of 1 m/s² RMS on each axis adds to each of the hundred readings of a second:
white noise from a fixed seed, whose average is exactly zero."""


NOTHING: Final = 1e-9
"""A specific force below this, m/s², is what rounding leaves of none, and has no direction."""


class TiltDemo(Demo):
    """An aircraft from behind and from the side, and the vertical that its accelerometer feels.

    The accelerometer reads the acceleration of the body less gravity, and the angles are worked
    out as if the body were at rest. An estimate is the one from the average reading of a second,
    in which the vibration cancels; its error is the estimate less the truth; the scatter is how
    far, RMS, the estimates from single readings are from it. Its numbers come from the ledger
    entries estimation.2.5, estimation.2.6 and dead_reckoning.2.1.

    Parameters
    ----------
    roll, pitch : float, optional
        Attitude in degrees: roll from -180 to 180, pitch from -90 to 90. Each is 0 unless told,
        as are all below, and follows its slider while a kernel runs.
    forward_acceleration, lateral_acceleration : float, optional
        Acceleration of the body along its x-axis and its y-axis, from -10 to 10 m/s².
    vibration : float, optional
        Vibration on each axis, from 0 to 5 m/s² RMS.
    """

    element = "tilt"
    controls = ("roll", "pitch", "forward_acceleration", "lateral_acceleration", "vibration")

    roll = Control(0.0, min=-180.0, max=180.0).tag(sync=True)
    pitch = Control(0.0, min=-90.0, max=90.0).tag(sync=True)
    forward_acceleration = Control(0.0, min=-10.0, max=10.0).tag(sync=True)
    lateral_acceleration = Control(0.0, min=-10.0, max=10.0).tag(sync=True)
    vibration = Control(0.0, min=0.0, max=5.0).tag(sync=True)

    def readouts(self) -> dict[str, float]:
        """Return estimates, errors and scatter of roll and pitch, in degrees."""
        reading = self._reading()
        average = self._errors(reading)
        single = [
            self._errors([s + self.vibration * v for s, v in zip(reading, shake, strict=True)])
            for shake in VIBRATION
        ]
        found: dict[str, float] = {}
        estimates = tilt_from_accelerometer(*reading)
        for i, name in enumerate(("roll", "pitch")):
            apart = [wrap_angle(errors[i] - average[i]) for errors in single]
            found |= {
                f"{name}_estimate": math.degrees(-wrap_angle(-estimates[i])),  # in (-pi, pi]
                f"{name}_error": math.degrees(average[i]),
                f"{name}_scatter": math.degrees(math.hypot(*apart) / math.sqrt(len(apart))),
            }
        return found

    def undefined(self) -> dict[str, bool]:
        """Say of which angle the reading holds nothing, so that its estimate means nothing.

        Of roll when the reading lies along the roll axis, as it does at a pitch of 90 degrees
        at rest; of both when the body falls freely.
        """
        forward, right, down = self._reading()
        return {
            "roll": math.hypot(right, down) < NOTHING,
            "pitch": math.hypot(forward, right, down) < NOTHING,
        }

    def fallback(self) -> str:
        """Return the state and what the accelerometer makes of it, in two sentences."""
        texts = {name: rounded(value) for name, value in self.readouts().items()}
        angles = "; ".join(
            f"{name} undefined"
            if unknown
            else f"{name} {texts[f'{name}_estimate']}°, error {texts[f'{name}_error']}°, "
            f"scatter {texts[f'{name}_scatter']}°"
            for name, unknown in self.undefined().items()
        )
        return (
            f"An aircraft with roll {rounded(self.roll)}° and pitch {rounded(self.pitch)}° that "
            f"accelerates by {rounded(self.forward_acceleration)} m/s² forward and "
            f"{rounded(self.lateral_acceleration)} m/s² to the right, with a vibration of "
            f"{rounded(self.vibration)} m/s² RMS. Its accelerometer gives {angles}."
        )

    def _angles(self) -> tuple[float, float]:
        return math.radians(self.roll), math.radians(self.pitch)

    def _reading(self) -> tuple[float, float, float]:
        """Return the reading without vibration, in the body frame, m/s²."""
        roll, pitch = self._angles()
        rows = matrix_from_euler(roll, pitch, 0.0)
        forward, right = self.forward_acceleration, self.lateral_acceleration
        north, east, down = (forward * rows[i] + right * rows[3 + i] for i in range(3))
        return accelerometer_from_acceleration(
            north, east, down, roll, pitch, 0.0, STANDARD_GRAVITY
        )

    def _errors(self, reading: Sequence[float]) -> list[float]:
        """Return the errors of roll and pitch from a reading, radians."""
        estimates = tilt_from_accelerometer(*reading)
        return [wrap_angle(e - t) for e, t in zip(estimates, self._angles(), strict=True)]
