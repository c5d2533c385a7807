"""An aircraft in three rings, what is left of them at a pitch of 90 degrees, and a way over it."""

import math

from chr_notes.demos.base import Control, Demo, formatted, rounded
from chr_notes.generated.scalar.euler import euler_rates_condition, euler_rates_determinant
from chr_notes.generated.scalar.quaternions import (
    euler_from_quaternion,
    quaternion_after_constant_rates,
    quaternion_from_euler,
)

__all__ = ["GimbalLockDemo"]


class GimbalLockDemo(Demo):
    """An aircraft in three rings, turned by 3-2-1 Euler angles.

    Each ring turns on the one outside it: yaw, then pitch, then roll. Two more views show a flight
    over the top, with the angles and the quaternion as curves, and the axes of the three angles,
    along which a turn of the aircraft is split. Beside the picture stand the determinant of D, its
    2-norm condition number, and what the view means. Its numbers come from the ledger entries
    euler.5.3, euler.7.2, euler.7.c and quaternions.4.b.

    Parameters
    ----------
    view : float, optional
        0 for the rings, 1 for the flight, 2 for the rates; 0 unless told, as are all below. Each
        follows its control while a kernel runs.
    yaw, pitch, roll : float, optional
        Angles in degrees: yaw and roll from -180 to 180, pitch from -90 to 90.
    flown : float, optional
        How far in the flight the aircraft has turned since about its own y-axis, nose up, from 0 to
        360 degrees. The other two views show it before.
    """

    element = "gimbal-lock"
    controls = ("view", "yaw", "pitch", "roll", "flown")

    view = Control(0.0, min=0.0, max=2.0, whole=True).tag(sync=True)
    yaw = Control(0.0, min=-180.0, max=180.0).tag(sync=True)
    pitch = Control(0.0, min=-90.0, max=90.0).tag(sync=True)
    roll = Control(0.0, min=-180.0, max=180.0).tag(sync=True)
    flown = Control(0.0, min=0.0, max=360.0).tag(sync=True)

    def fallback(self) -> str:
        """Return the attitude, the determinant and the condition number in a sentence."""
        roll, pitch, yaw = (math.degrees(angle) for angle in self._euler())
        angles = f"yaw {rounded(yaw)}°, pitch {rounded(pitch)}°, roll {rounded(roll)}°"
        theta = self._euler()[1]
        return (
            f"An aircraft in three rings: {angles}. "
            f"Determinant of D: {formatted(euler_rates_determinant(theta))}. "
            f"Condition number of D: {formatted(euler_rates_condition(theta))}."
        )

    def _euler(self) -> tuple[float, float, float]:
        """Return roll, pitch and yaw after the flight, radians."""
        start = (math.radians(self.roll), math.radians(self.pitch), math.radians(self.yaw))
        if self.view != 1 or self.flown == 0:
            return start
        q = quaternion_from_euler(*start)
        turn = math.radians(self.flown)
        after = quaternion_after_constant_rates(*q, 0.0, 1.0, 0.0, turn)
        return euler_from_quaternion(*after)[:3]
