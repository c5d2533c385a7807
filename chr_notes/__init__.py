"""Attitude representation, derived, checked and taught.

Importing the package loads NumPy alone; SymPy is loaded when something is derived.
"""

__version__ = "0.1.0"
