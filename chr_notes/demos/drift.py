"""What a small error of attitude does to dead reckoning as time goes by."""

import math

from chr_notes.conventions import NOTES_GRAVITY
from chr_notes.demos.base import Control, Demo, formatted
from chr_notes.generated.scalar.dead_reckoning import (
    drift_from_tilt_error,
    position_at_last_velocity,
    position_errors,
)

__all__ = ["DriftDemo"]


class DriftDemo(Demo):
    """Growth of the errors of velocity and position by an error of the attitude, biases and noise.

    A map shows where a sensor that lies on a table believes to be, a chart how the errors grow.
    Beside the right position error stands the one that the note reckons, which takes the last
    velocity for the velocity all along and so loses a factor of one half. Its Table 1 prints that
    from an acceleration which was rounded first: 612 m for 615.7 m. The numbers come from the
    ledger entries dead_reckoning.4.a, dead_reckoning.4.g and dead_reckoning.t1. What the gyro's
    bias does is reckoned for small angles; the sentence beside the picture says where it has turned
    the vertical too far for that.

    Parameters
    ----------
    view : float, optional
        0 for the map, 1 for the growth; 0 unless told.
    angle_error : float, optional
        Angle between the true and the estimated vertical in degrees, from 0 to 5; 1 unless told.
    accel_bias : float, optional
        What the accelerometer reads too much along the ground, from 0 to 0.5 m/s²; 0 unless told,
        as are the next two.
    gyro_bias : float, optional
        What the gyro reads too much about a level axis, from 0 to 0.02 °/s.
    accel_noise : float, optional
        Density of the accelerometer's white noise, from 0 to 0.05 m/s²/√Hz.
    time : float, optional
        Time since the last help from outside, from 1 to 3600 s; 10 unless told. All follow
        their controls while a kernel runs.
    """

    element = "drift"
    controls = ("view", "angle_error", "accel_bias", "gyro_bias", "accel_noise", "time")

    view = Control(0.0, min=0.0, max=1.0, whole=True).tag(sync=True)
    angle_error = Control(1.0, min=0.0, max=5.0).tag(sync=True)
    accel_bias = Control(0.0, min=0.0, max=0.5).tag(sync=True)
    gyro_bias = Control(0.0, min=0.0, max=0.02).tag(sync=True)
    accel_noise = Control(0.0, min=0.0, max=0.05).tag(sync=True)
    time = Control(10.0, min=1.0, max=3600.0).tag(sync=True)

    def readouts(self) -> dict[str, float]:
        """Return the errors in SI units: of position by each cause, and all but noise together."""
        angle = math.radians(self.angle_error)
        acceleration, velocity, _ = drift_from_tilt_error(angle, self.time, NOTES_GRAVITY)
        position, accel, gyro, _, variance, _ = position_errors(
            angle, self.accel_bias, math.radians(self.gyro_bias), 0.0, 0.0, self.accel_noise, 0.0,
            self.time, NOTES_GRAVITY,
        )  # fmt: skip
        return {
            "acceleration_error": acceleration,
            "velocity_error": velocity,
            "position_error": position,
            "accel_bias_error": accel,
            "gyro_bias_error": gyro,
            "noise_error": math.sqrt(variance),
            "total_error": position + accel + gyro,
            "printed_position_error": position_at_last_velocity(angle, self.time, NOTES_GRAVITY),
        }

    def fallback(self) -> str:
        """Return the errors in a sentence, and those of the sensors in another where there are."""
        texts = {name: formatted(value) for name, value in self.readouts().items()}
        sensors = (
            f" The accelerometer's bias moves it by {texts['accel_bias_error']} m, the gyro's by "
            f"{texts['gyro_bias_error']} m, noise by {texts['noise_error']} m RMS."
        )
        quiet = self.accel_bias == self.gyro_bias == self.accel_noise == 0
        return (
            f"An attitude that is off by {formatted(self.angle_error)}°, after "
            f"{formatted(self.time)} s: acceleration is off by {texts['acceleration_error']} m/s², "
            f"velocity by {texts['velocity_error']} m/s, position by {texts['position_error']} m. "
            f"As the note reckons, position would be off by {texts['printed_position_error']} m."
            + ("" if quiet else sensors)
        )
