"""Attitude representation, derived, checked and taught.

Importing the package loads NumPy alone; SymPy is loaded when something is derived.
"""

from chr_notes.conventions import STANDARD_GRAVITY
from chr_notes.errors import GimbalLockError, GimbalLockWarning
from chr_notes.euler import (
    body_rates_from_euler_rates,
    euler_rates_from_body_rates,
    euler_rates_matrix,
    matrix_from_euler,
)

__version__ = "0.1.0"

__all__ = [
    "STANDARD_GRAVITY",
    "GimbalLockError",
    "GimbalLockWarning",
    "body_rates_from_euler_rates",
    "euler_rates_from_body_rates",
    "euler_rates_matrix",
    "matrix_from_euler",
]
