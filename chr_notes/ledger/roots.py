"""The errors behind the entries: each counts once, in however many places it shows."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

ROOTS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "quaternion-direction": "The quaternion note uses one quaternion in both directions: "
        "section 3 from the inertial frame to the body, section 4 and the sensors the other way.",
        "complex-for-imaginary": "A quaternion is said to have complex elements.",
        "inverse-is-conjugate": "The inverse of a quaternion is said to be its conjugate.",
    }
)
"""What is wrong, in our words, by the name that the cases give as `root`.

In the order of the documents.
"""
