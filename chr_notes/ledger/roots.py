"""The errors behind the entries: each counts once, in however many places it shows."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

ROOTS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "rates-by-projection": "The Euler rates are said to come about by rotating each gyro's "
        "output into the frame of one turn; they come about by solving for the three together.",
        "body-to-inertial-symbol": "The symbol of the matrix from inertial to body stands in front "
        "of the one from body to inertial.",
        "opposite-at-the-lock": "At a pitch of +90° yaw and roll are said to move the sensor in "
        "the same fashion; they turn it about the same line in opposite senses.",
        "lock-without-a-cure": "Only another representation is said to cure the lock; another "
        "sequence of angles, or care near the lock, does as well.",
        "vehicle-3": "A caption names a frame that there is not.",
        "quaternion-direction": "The quaternion note uses one quaternion in both directions: "
        "section 3 from the inertial frame to the body, section 4 and the sensors the other way.",
        "complex-for-imaginary": "A quaternion is said to have complex elements.",
        "inverse-is-conjugate": "The inverse of a quaternion is said to be its conjugate.",
    }
)
"""What is wrong, in our words, by the name that the cases give as `root`.

In the order of the documents.
"""
