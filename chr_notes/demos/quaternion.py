"""One axis, one angle, and the quaternion that holds half of it."""

import math

from chr_notes.demos.base import Control, Demo, entry, rounded
from chr_notes.generated.scalar.euler import matrix_from_euler
from chr_notes.generated.scalar.quaternions import (
    quaternion_conjugate,
    quaternion_from_axis_angle,
    quaternion_multiply,
)

__all__ = ["QuaternionDemo"]

Quaternion = tuple[float, float, float, float]


class QuaternionDemo(Demo):
    """An aircraft that turns about one axis, its quaternion, and the two products that turn it.

    The quaternion keeps its sign, so that it is -1 after one whole turn and 1 after two. The vector
    that it turns is the unit vector to the north, where the nose points before the turn. Its
    numbers come from the ledger entries quaternions.2.2, quaternions.3.2 and quaternions.3.a.

    Parameters
    ----------
    axis_yaw, axis_pitch : float, optional
        The axis, as the direction of a nose at this yaw, from -180 to 180, and this pitch, from
        -90 to 90, in degrees; 40 and 35 unless told. Each value follows its slider while a kernel
        runs.
    angle : float, optional
        Angle of the turn in degrees, from 0 to 720; 100 unless told.
    product : float, optional
        How far the products have come: 0 for v, 1 for q v, 2 for q v q*; 1 unless told. Between
        them the quaternion is that of a share of the turn.
    """

    element = "quaternion"
    controls = ("axis_yaw", "axis_pitch", "angle", "product")

    axis_yaw = Control(40.0, min=-180.0, max=180.0).tag(sync=True)
    axis_pitch = Control(35.0, min=-90.0, max=90.0).tag(sync=True)
    angle = Control(100.0, min=0.0, max=720.0).tag(sync=True)
    product = Control(1.0, min=0.0, max=2.0).tag(sync=True)

    def readouts(self) -> dict[str, float | Quaternion]:
        """Return half the angle in degrees, the quaternion, and what the products have made."""
        left, right = self._part(min(1.0, self.product)), self._part(max(0.0, self.product - 1))
        turned = quaternion_multiply(*left, 0.0, 1.0, 0.0, 0.0)
        return {
            "half_angle": self.angle / 2,
            "quaternion": self._part(1.0),
            "product": quaternion_multiply(*turned, *quaternion_conjugate(*right)),
        }

    def fallback(self) -> str:
        """Return the turn, its quaternion and the product in two sentences."""
        found = self.readouts()
        listed = {
            name: ", ".join(entry(element) for element in numbers)
            for name, numbers in found.items()
            if isinstance(numbers, tuple)
        }
        return (
            f"An aircraft that has turned by {rounded(self.angle)}° about the axis at yaw "
            f"{rounded(self.axis_yaw)}° and pitch {rounded(self.axis_pitch)}°. Half the angle is "
            f"{rounded(self.angle / 2)}°, the quaternion {listed['quaternion']}. After "
            f"{rounded(self.product)} of 2 products the vector is {listed['product']}."
        )

    def _part(self, share: float) -> Quaternion:
        """Return the quaternion of a share of the turn, its sign kept."""
        axis = matrix_from_euler(0.0, math.radians(self.axis_pitch), math.radians(self.axis_yaw))[
            :3
        ]
        quarter = quaternion_from_axis_angle(*axis, share * math.radians(self.angle) / 4)
        half = quaternion_multiply(*quarter, *quarter)
        return quaternion_multiply(*half, *half)
