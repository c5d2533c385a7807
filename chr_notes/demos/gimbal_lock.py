"""An aircraft in three rings, and what is left of them at a pitch of 90 degrees."""

import math

from chr_notes.demos.base import Control, Demo, formatted
from chr_notes.generated.scalar.euler import euler_rates_condition, euler_rates_determinant

__all__ = ["GimbalLockDemo"]


class GimbalLockDemo(Demo):
    """An aircraft in three rings, turned by 3-2-1 Euler angles.

    Each ring turns on the one outside it: yaw, then pitch, then roll. Beside the picture stand
    the determinant of D, its 2-norm condition number, and what the rings do to each other.
    Its numbers come from the ledger entries euler.5.3, euler.7.2 and euler.7.c.

    Parameters
    ----------
    yaw, pitch, roll : float, optional
        Angles in degrees: yaw and roll from -180 to 180, pitch from -90 to 90. Each is 0 unless
        told, and follows its slider while a kernel runs.
    """

    element = "gimbal-lock"
    controls = ("yaw", "pitch", "roll")

    yaw = Control(0.0, min=-180.0, max=180.0).tag(sync=True)
    pitch = Control(0.0, min=-90.0, max=90.0).tag(sync=True)
    roll = Control(0.0, min=-180.0, max=180.0).tag(sync=True)

    def fallback(self) -> str:
        """Return the attitude, the determinant and the condition number in a sentence."""
        pitch = math.radians(self.pitch)
        angles = ", ".join(f"{name} {formatted(value)}°" for name, value in self.state().items())
        return (
            f"An aircraft in three rings: {angles}. "
            f"Determinant of D: {formatted(euler_rates_determinant(pitch))}. "
            f"Condition number of D: {formatted(euler_rates_condition(pitch))}."
        )
