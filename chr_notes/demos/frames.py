"""Three turns one after the other, and one wind in the axes of each frame."""

import math

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.demos.base import Control, Demo, entry, rounded
from chr_notes.generated.scalar.euler import matrix_from_euler

__all__ = ["FramesDemo"]


class FramesDemo(Demo):
    """An aircraft after none to three of its turns, and the components of one wind along its axes.

    On the left the turns are yaw, pitch, roll, on the right pitch, yaw, roll. The wind is level and
    of length 1. Its numbers come from the ledger entries euler.3.1, euler.4.1, euler.4.2 and
    euler.5.3.

    Parameters
    ----------
    frame : float, optional
        After how many turns: 0 inertial, 1 vehicle-1, 2 vehicle-2, 3 body, or a part of a turn
        more; 3 unless told. Each value follows its slider while a kernel runs.
    axis : float, optional
        Which row of the matrix is lit, 0 for x, 1 for y, 2 for z; 1 unless told.
    yaw, pitch, roll : float, optional
        Angles in degrees: yaw and roll from -180 to 180, pitch from -90 to 90; 40, 30 and 25 unless
        told.
    wind : float, optional
        Where the wind blows to, from north towards east, in degrees from -180 to 180; 0 unless
        told.

    Raises
    ------
    traitlets.TraitError
        For a state that is not a number, is outside the range of its slider, or an axis that is no
        whole number.
    """

    element = "frames"
    controls = ("frame", "axis", "yaw", "pitch", "roll", "wind")

    frame = Control(3.0, min=0.0, max=3.0).tag(sync=True)
    axis = Control(1.0, min=0.0, max=2.0, whole=True).tag(sync=True)
    yaw = Control(40.0, min=-180.0, max=180.0).tag(sync=True)
    pitch = Control(30.0, min=-90.0, max=90.0).tag(sync=True)
    roll = Control(25.0, min=-180.0, max=180.0).tag(sync=True)
    wind = Control(0.0, min=-180.0, max=180.0).tag(sync=True)

    def readouts(self) -> dict[str, float | list[float]]:
        """Return the wind's components in either order, and degrees between the two noses."""
        one, other = self._matrices()
        wind = _matrix(0.0, 0.0, self.wind)[0]
        across = np.linalg.norm(np.cross(one[0], other[0]))
        return {
            "components": (one @ wind).tolist(),
            "other_order": (other @ wind).tolist(),
            "apart": math.degrees(math.atan2(across, one[0] @ other[0])),
        }

    def fallback(self) -> str:
        """Return the state and the components in two sentences."""
        one, other = self._matrices()
        wind = _matrix(0.0, 0.0, self.wind)[0]
        listed = [", ".join(entry(part) for part in matrix @ wind) for matrix in (one, other)]
        return (
            f"A wind that blows to {rounded(self.wind)}°, and an aircraft with yaw "
            f"{rounded(self.yaw)}°, pitch {rounded(self.pitch)}°, roll {rounded(self.roll)}°. "
            f"After {rounded(self.frame)} of the three turns, along the axes of the frame, the "
            f"wind is ({listed[0]}); with pitch before yaw it would be ({listed[1]})."
        )

    def _matrices(self) -> tuple[Floats, Floats]:
        """Return the matrix to the frame with yaw first, and with pitch first."""
        first, second, third = (min(1.0, max(0.0, self.frame - turn)) for turn in range(3))
        rolled = _matrix(third * self.roll, 0.0, 0.0)
        one = rolled @ _matrix(0.0, second * self.pitch, first * self.yaw)
        other = _matrix(0.0, 0.0, second * self.yaw) @ _matrix(0.0, first * self.pitch, 0.0)
        return one, rolled @ other


def _matrix(roll: float, pitch: float, yaw: float) -> Floats:
    """Return the matrix of Euler angles in degrees."""
    angles = (math.radians(angle) for angle in (roll, pitch, yaw))
    return np.reshape(matrix_from_euler(*angles), (3, 3))
