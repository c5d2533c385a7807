"""What a small error of attitude does to dead reckoning as time goes by."""

import math

from chr_notes.conventions import NOTES_GRAVITY
from chr_notes.demos.base import Control, Demo, formatted
from chr_notes.generated.scalar.dead_reckoning import (
    drift_from_tilt_error,
    position_at_last_velocity,
)

__all__ = ["DriftDemo"]


class DriftDemo(Demo):
    """Growth of the errors of velocity and position at a constant error of the attitude.

    A map shows where a sensor that lies on a table believes to be, a chart how the errors grow.
    Beside the right position error stands the one that the note reckons, which takes the last
    velocity for the velocity all along and so loses a factor of one half. Its Table 1 prints that
    from an acceleration which was rounded first: 612 m for 615.7 m. The numbers come from the
    ledger entries dead_reckoning.4.g and dead_reckoning.t1.

    Parameters
    ----------
    view : float, optional
        0 for the map, 1 for the growth; 0 unless told.
    angle_error : float, optional
        Angle between the true and the estimated vertical in degrees, from 0 to 5; 1 unless told.
    time : float, optional
        Time since the last help from outside, from 1 to 3600 s; 10 unless told. All follow
        their controls while a kernel runs.
    """

    element = "drift"
    controls = ("view", "angle_error", "time")

    view = Control(0.0, min=0.0, max=1.0, whole=True).tag(sync=True)
    angle_error = Control(1.0, min=0.0, max=5.0).tag(sync=True)
    time = Control(10.0, min=1.0, max=3600.0).tag(sync=True)

    def readouts(self) -> dict[str, float]:
        """Return the errors in SI units."""
        given = (math.radians(self.angle_error), self.time, NOTES_GRAVITY)
        acceleration, velocity, position = drift_from_tilt_error(*given)
        return {
            "acceleration_error": acceleration,
            "velocity_error": velocity,
            "position_error": position,
            "printed_position_error": position_at_last_velocity(*given),
        }

    def fallback(self) -> str:
        """Return the errors in a sentence."""
        texts = {name: formatted(value) for name, value in self.readouts().items()}
        return (
            f"An attitude that is off by {formatted(self.angle_error)}°, after "
            f"{formatted(self.time)} s: acceleration is off by {texts['acceleration_error']} m/s², "
            f"velocity by {texts['velocity_error']} m/s, position by {texts['position_error']} m. "
            f"As the note reckons, position would be off by {texts['printed_position_error']} m."
        )
