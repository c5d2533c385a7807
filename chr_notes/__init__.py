"""Attitude representation, derived, checked and taught.

Importing the package loads NumPy alone; SymPy is loaded when something is derived.
"""

from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.errors import GimbalLockError, GimbalLockWarning
from chr_notes.euler import (
    body_rates_from_euler_rates,
    euler_from_matrix,
    euler_rates_from_body_rates,
    euler_rates_matrix,
    matrix_from_euler,
    wrap_angle,
)
from chr_notes.quaternions import (
    axis_angle_from_quaternion,
    euler_from_quaternion,
    matrix_from_quaternion,
    quaternion_conjugate,
    quaternion_from_axis_angle,
    quaternion_from_euler,
    quaternion_from_matrix,
    quaternion_inverse,
    quaternion_multiply,
    rotate_to_body,
    rotate_to_inertial,
)

__version__ = "0.1.0"

__all__ = [
    "STANDARD_GRAVITY",
    "GimbalLockError",
    "GimbalLockWarning",
    "axis_angle_from_quaternion",
    "body_rates_from_euler_rates",
    "euler_from_matrix",
    "euler_from_quaternion",
    "euler_rates_from_body_rates",
    "euler_rates_matrix",
    "matrix_from_euler",
    "matrix_from_quaternion",
    "quaternion_conjugate",
    "quaternion_from_axis_angle",
    "quaternion_from_euler",
    "quaternion_from_matrix",
    "quaternion_inverse",
    "quaternion_multiply",
    "rotate_to_body",
    "rotate_to_inertial",
    "wrap_angle",
]
